// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_LIMITS_HPP
#define VERIFICATION_CAMPAIGN_LIMITS_HPP

#include "runtime/device/model.hpp"
#include "safety_core/crosslink/link_config.hpp"
#include "verification/campaign/experiment.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace counterpoint::campaign
{
/// Behind a limit a run goes on for so many more.
constexpr std::size_t kMoreCycles = 50U;

/// Of an SRDO that the device consumes. [SRS_CMG_817]
struct BusLimit
{
    std::uint32_t cob_id_1{0U};
    std::uint32_t cob_id_2{0U};
    std::uint32_t lost_us{0U};        ///< No normal frame comes any more.
    std::uint32_t next_normal_us{0U}; ///< The next normal frame still comes.
};

/// Longest times from a fault to the safe output, by part, from the configuration. [SRS_CMG_007]
struct Limits
{
    std::array<std::uint32_t, kPartCount> us{};
    std::uint32_t wrong_frame_us{0U};   ///< Of a frame that is wrong in itself.
    std::uint32_t wrong_channel_us{0U}; ///< Of one channel.
    std::uint32_t drift_us{0U};         ///< Of the clock of one CPU of two.
    std::uint32_t stuck_latch_us{0U};   ///< Of a bit that sticks at what it is: the test of RAM finds it.
    std::vector<BusLimit> bus{};        ///< Of each SRDO by itself; none: of all the longest.

    /// @brief By part and kind. [SRS_CMG_020]
    [[nodiscard]] std::uint32_t Of(const Part part, const FaultKind kind) const
    {
        if (part == Part::kCpu && kind != FaultKind::kStopped)
        {
            return drift_us;
        }
        if (part == Part::kLatch && IsStuck(kind))
        {
            return stuck_latch_us;
        }
        const bool is_wrong = part == Part::kBus && kind == FaultKind::kWrongLength;
        return is_wrong ? wrong_frame_us : us.at(static_cast<std::size_t>(part));
    }
    /// @brief The same, and of what neither guard nor comparator reads of a channel: that of a wrong channel.
    /// Of a frame that of its own SRDO, by what is wrong with it. [SRS_CMG_022, SRS_CMG_817]
    [[nodiscard]] std::uint32_t Of(const Experiment& experiment, const Recording& recording) const;

  private:
    [[nodiscard]] std::uint32_t OfFrames(const Experiment& experiment, const Recording& recording) const;
    [[nodiscard]] std::uint32_t OfConcerned(std::size_t first, const Experiment& experiment,
                                            const Recording& recording) const;
    [[nodiscard]] std::uint32_t OfAllLost(std::size_t frame, const Recording& recording) const;
    [[nodiscard]] const BusLimit* Find(const CanFrame& frame) const;
};

/// @brief By ComputeLimit of the kernel, of all SRDOs the longest.
[[nodiscard]] Limits LimitsOf(const runtime::DeviceModel& model, const DeviceConfig& config);
/// @brief The same of a device of two CPUs. [SRS_CMG_064]
[[nodiscard]] Limits LimitsOf(const runtime::DeviceModel& model, const DeviceConfig& config, const LinkConfig& link);
/// @brief For so many cycles behind its fault a run may go on: all limits, and some more.
[[nodiscard]] std::size_t HorizonOf(const Limits& limits, const DeviceConfig& config);

} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_LIMITS_HPP
