// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_BUS_VIEW_HPP
#define VERIFICATION_CAMPAIGN_BUS_VIEW_HPP

#include "runtime/device/model.hpp"
#include "verification/campaign/recording.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace counterpoint::campaign
{
/// A complete valid pair that was on the bus.
struct BusPair
{
    Nanoseconds normal_at{0};
    Nanoseconds inverse_at{0};
    std::uint64_t data{0U};      ///< Byte 0 of the frame is the lowest.
    Nanoseconds sent_at{kNever}; ///< When the normal frame of the pair was sent that this one is.

    static constexpr Nanoseconds kNever = -1;
};

/// So many pairs before the newest one may still be in place: as many as may come within the discrepancy time.
constexpr std::size_t kKeptPairs = 8U;

/// What a device got of one SRDO so far. Plain memory. [SRS_CMG_815]
struct Received
{
    BusPair newest{};
    std::array<BusPair, kKeptPairs> before{}; ///< The latest one first.
    Nanoseconds normal_at{0};
    std::uint64_t normal{0U};
    std::size_t sent{0U}; ///< The latest one that was sent, of those that were got.
    std::uint32_t count{0U};
    bool waits{false}; ///< For the inverse frame of `normal`.
    bool runs{false};  ///< SCT, from the newest pair.
};

/// Whether an output may use data.
enum class Leave : std::uint8_t
{
    kNone = 0U,
    kGiven = 1U,
    kListed = 2U, ///< By a complete valid pair, which nobody sent, or which is older than it may be. [SRS_CMG_021]
};

/// @brief Bytes of a frame as a number, byte 0 the lowest.
[[nodiscard]] std::uint64_t NumberIn(const CanFrame& frame);

/// What an SRDO of the device may be released with, from its frames on the bus alone: reckoned without kernel and
/// channels. [SRS_CMG_005]
class BusView
{
  public:
    /// @brief For one consumer.
    BusView(const Recording& recording, const runtime::SrdoModel& srdo, std::uint32_t mapped_bits);

    /// @brief A frame that the device got.
    void Take(Received& received, const RecordedFrame& came) const;
    /// @brief Whether an output may use `data` now, of the bits in `mask`. A pair that was followed by another one
    /// counts until the channels had to agree on the newer one.
    [[nodiscard]] Leave Allows(const Received& received, Nanoseconds now, std::uint64_t data, std::uint64_t mask,
                               Nanoseconds discrepancy) const;

  private:
    [[nodiscard]] bool HasExpired(const Received& received, Nanoseconds now) const;
    [[nodiscard]] bool Complete(Received& received, const RecordedFrame& came) const;

    std::uint32_t cob_id_1_;
    std::uint32_t cob_id_2_;
    std::uint32_t bytes_;
    bool is_late_;
    Nanoseconds sct_;
    Nanoseconds srvt_;
    Nanoseconds greatest_age_;
    std::vector<BusPair> pairs_{}; ///< That were sent.
};
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_BUS_VIEW_HPP
