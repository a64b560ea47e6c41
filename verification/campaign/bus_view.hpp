// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_BUS_VIEW_HPP
#define VERIFICATION_CAMPAIGN_BUS_VIEW_HPP

#include "runtime/device/model.hpp"
#include "verification/campaign/recording.hpp"

#include <cstdint>
#include <vector>

namespace counterpoint::campaign
{
/// A complete valid pair that was on the bus.
struct BusPair
{
    Nanoseconds normal_at{0};
    Nanoseconds inverse_at{0};
    std::uint64_t data{0U}; ///< Byte 0 of the frame is the lowest.
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

    /// @brief Whether an output may use `data` in this cycle, of the bits in `mask`. A pair that was followed by
    /// another one counts until the channels had to agree on the newer one.
    [[nodiscard]] bool Allows(std::size_t cycle, std::uint64_t data, std::uint64_t mask, Nanoseconds discrepancy) const;

  private:
    const Recording& recording_;
    Nanoseconds greatest_age_;
    std::vector<BusPair> pairs_{};
    std::vector<std::size_t> ends_{}; ///< Pairs before this one were complete, by cycle.
};
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_BUS_VIEW_HPP
