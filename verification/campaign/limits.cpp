// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/limits.hpp"

#include "safety_core/kernel/limits.hpp"
#include "verification/campaign/variants.hpp"

#include <algorithm>
#include <initializer_list>
#include <limits>

namespace counterpoint::campaign
{
namespace
{
std::uint32_t LongestOf(const runtime::DeviceModel& model, const DeviceConfig& config,
                        const std::initializer_list<FaultClass> classes)
{
    std::uint32_t longest = 0U;
    for (const runtime::SrdoModel& srdo : model.Srdos())
    {
        for (const FaultClass each : classes)
        {
            const Limit limit = ComputeLimit(config, srdo.times, each);
            longest = (limit.result == Result::kSuccessful) ? std::max(longest, limit.us) : longest;
        }
    }
    return longest;
}

std::vector<BusLimit> BusLimitsOf(const runtime::DeviceModel& model, const DeviceConfig& config)
{
    std::vector<BusLimit> limits;
    for (const runtime::SrdoModel& srdo : model.Srdos())
    {
        if (srdo.direction == kDirectionConsumer)
        {
            const std::uint32_t lost = ComputeLimit(config, srdo.times, FaultClass::kBus).us;
            const std::uint32_t next = ComputeLimit(config, srdo.times, FaultClass::kBusNextNormal).us;
            limits.push_back({srdo.cob_id_1, srdo.cob_id_2, lost, std::max(lost, next)});
        }
    }
    return limits;
}

/// From a normal frame to the next inverse one: only then its pair is wrong.
std::uint32_t UntilInverse(const std::size_t normal, const std::uint32_t inverse, const Recording& recording)
{
    for (std::size_t index = normal + 1U; index < recording.frames.size(); ++index)
    {
        if (recording.frames[index].stamped.frame.identifier == inverse)
        {
            const Nanoseconds distance = recording.frames[index].at - recording.frames[normal].at;
            return static_cast<std::uint32_t>(distance / runtime::kNanosecondsPerMicrosecond) + 1U;
        }
    }
    return 0U;
}

/// Frames that a fault concerns: one, or all that it loses or exchanges.
std::size_t LastFrameOf(const std::size_t first, const Experiment& experiment, const Recording& recording)
{
    const bool is_order = experiment.kind == FaultKind::kWrongOrder;
    const bool is_burst = experiment.kind == FaultKind::kLost && experiment.variant < kLosesIdentifier;
    const std::size_t more = is_order ? experiment.variant + 1U : (is_burst ? experiment.variant : 0U);
    return std::min(first + more, recording.frames.size() - 1U);
}

/// From the first thing that a fault does to the last: frames that come later do something when they come.
std::uint32_t UntilLast(const std::size_t first, const Experiment& experiment, const Recording& recording)
{
    const bool is_delayed = experiment.kind == FaultKind::kDelayed || experiment.kind == FaultKind::kPairDelayed;
    const std::size_t last = LastFrameOf(first, experiment, recording);
    const Nanoseconds distance = is_delayed ? kGrid * (Nanoseconds{experiment.variant} + 1)
                                            : recording.frames[last].at - recording.frames[first].at;
    return static_cast<std::uint32_t>(distance / runtime::kNanosecondsPerMicrosecond);
}
} // namespace

Limits LimitsOf(const runtime::DeviceModel& model, const DeviceConfig& config)
{
    const std::uint32_t of_channel =
        LongestOf(model, config,
                  {FaultClass::kBus, FaultClass::kBusNextNormal, FaultClass::kChannel, FaultClass::kConfiguration});
    const std::uint32_t of_kernel =
        std::max(of_channel, LongestOf(model, config, {FaultClass::kSupervisor, FaultClass::kClock}));
    Limits limits;
    limits.bus = BusLimitsOf(model, config);
    limits.us.fill(of_kernel);
    limits.us[static_cast<std::size_t>(Part::kChannelA)] = of_channel;
    limits.us[static_cast<std::size_t>(Part::kChannelB)] = of_channel;
    limits.us[static_cast<std::size_t>(Part::kVariables)] = of_channel;
    limits.us[static_cast<std::size_t>(Part::kLatch)] =
        LongestOf(model, config, {FaultClass::kChannel}); // F-L01: cycle.
    limits.stuck_latch_us = of_kernel;
    limits.us[static_cast<std::size_t>(Part::kTables)] = LongestOf(model, config, {FaultClass::kSharedSource});
    const std::uint32_t of_bus = LongestOf(model, config, {FaultClass::kBus, FaultClass::kBusNextNormal});
    const std::uint32_t of_steps =
        std::max(of_bus, LongestOf(model, config, {FaultClass::kSupervisor, FaultClass::kChannel, FaultClass::kClock}));
    limits.wrong_frame_us = LongestOf(model, config, {FaultClass::kWrongFrame});
    limits.wrong_channel_us = std::max(of_bus, LongestOf(model, config, {FaultClass::kChannel}));
    limits.us[static_cast<std::size_t>(Part::kBus)] = of_bus;
    limits.us[static_cast<std::size_t>(Part::kKernelCalls)] = of_bus;
    limits.us[static_cast<std::size_t>(Part::kCallsOfA)] = of_channel;
    limits.us[static_cast<std::size_t>(Part::kCallsOfB)] = of_channel;
    limits.us[static_cast<std::size_t>(Part::kBothChannels)] = of_channel;
    limits.us[static_cast<std::size_t>(Part::kSteps)] = of_steps;
    limits.us[static_cast<std::size_t>(Part::kCycle)] = of_steps;
    limits.us[static_cast<std::size_t>(Part::kInputs)] = of_steps;
    limits.us[static_cast<std::size_t>(Part::kCounters)] = LongestOf(model, config, {FaultClass::kClock});
    return limits;
}

Limits LimitsOf(const runtime::DeviceModel& model, const DeviceConfig& config, const LinkConfig& link)
{
    Limits limits = LimitsOf(model, config);
    const std::uint32_t of_link = ComputeLimit(config, LinkTime{link.timeout_us}).us;
    // A copy of the configuration is compared with that of the other CPU.
    const std::uint32_t of_copy = LongestOf(model, config, {FaultClass::kSharedSource});
    for (std::size_t part = 0U; part < kMemoryPartCount; ++part)
    {
        limits.us[part] = std::max(limits.us[part], of_link);
    }
    limits.stuck_latch_us = std::max(limits.stuck_latch_us, of_link);
    for (const Part part : {Part::kChannelA, Part::kChannelB, Part::kTables})
    {
        limits.us[static_cast<std::size_t>(part)] = std::max(of_copy, of_link);
    }
    for (const Part part : {Part::kKernelCalls, Part::kCallsOfA, Part::kCallsOfB, Part::kSteps, Part::kCycle,
                            Part::kInputs, Part::kCommands})
    {
        limits.us[static_cast<std::size_t>(part)] = std::max(limits.us[static_cast<std::size_t>(part)], of_link);
    }
    limits.wrong_channel_us = std::max(limits.wrong_channel_us, of_link);
    limits.us[static_cast<std::size_t>(Part::kLink)] = of_link;
    limits.us[static_cast<std::size_t>(Part::kCpu)] = of_link;
    // A drift shows within an interval in which the clocks are compared.
    limits.drift_us = ComputeLimit(config, LinkTime{link.timeout_us + link.clock_interval_us}).us;
    limits.us[static_cast<std::size_t>(Part::kCounters)] = limits.drift_us;
    return limits;
}

const BusLimit* Limits::Find(const CanFrame& frame) const
{
    const auto found = std::find_if(bus.begin(), bus.end(), [&frame](const BusLimit& each)
                                    { return frame.identifier == each.cob_id_1 || frame.identifier == each.cob_id_2; });
    return (found == bus.end()) ? nullptr : &*found;
}

/// Whoever waits least has to close first. Where the next frame of an SRDO would have been the inverse one, its normal
/// frame still came.
std::uint32_t Limits::OfAllLost(const std::size_t frame, const Recording& recording) const
{
    std::uint32_t shortest = std::numeric_limits<std::uint32_t>::max();
    for (const BusLimit& each : bus)
    {
        const auto next = std::find_if(recording.frames.begin() + static_cast<std::ptrdiff_t>(frame),
                                       recording.frames.end(), [this, &each](const RecordedFrame& candidate)
                                       { return Find(candidate.stamped.frame) == &each; });
        const bool is_normal = next == recording.frames.end() || next->stamped.frame.identifier == each.cob_id_1;
        shortest = std::min(shortest, is_normal ? each.lost_us : each.next_normal_us);
    }
    return shortest;
}

/// What concerns frames of several SRDOs has the longest limit of these.
std::uint32_t Limits::OfFrames(const Experiment& experiment, const Recording& recording) const
{
    const std::size_t first =
        IsOfPair(experiment.kind) ? recording.pairs[experiment.subject].normal : experiment.subject;
    const CanFrame& frame = recording.frames[first].stamped.frame;
    const BusLimit* const own = Find(frame);
    if (experiment.kind == FaultKind::kWrongLength)
    {
        return wrong_frame_us;
    }
    if (experiment.kind == FaultKind::kCorrupted)
    {
        const bool is_normal = own != nullptr && frame.identifier == own->cob_id_1;
        return wrong_frame_us + (is_normal ? UntilInverse(first, own->cob_id_2, recording) : 0U);
    }
    if (experiment.kind == FaultKind::kLost && experiment.variant > kLosesIdentifier)
    {
        return OfAllLost(first, recording);
    }
    if (experiment.kind == FaultKind::kLost && experiment.variant == kLosesIdentifier && own != nullptr)
    {
        return (frame.identifier == own->cob_id_1) ? own->lost_us : own->next_normal_us;
    }
    const std::uint32_t longest = OfConcerned(first, experiment, recording);
    return (longest == 0U) ? us.at(static_cast<std::size_t>(Part::kBus))
                           : longest + UntilLast(first, experiment, recording);
}

/// Of the SRDOs of all frames that a fault concerns the longest; 0: none of theirs.
std::uint32_t Limits::OfConcerned(const std::size_t first, const Experiment& experiment,
                                  const Recording& recording) const
{
    std::uint32_t longest = 0U;
    const auto take = [this, &longest](const CanFrame& frame)
    {
        const BusLimit* const each = Find(frame);
        longest = std::max(longest, (each == nullptr) ? 0U : each->next_normal_us);
    };
    for (std::size_t index = first; index <= LastFrameOf(first, experiment, recording); ++index)
    {
        take(recording.frames[index].stamped.frame);
    }
    if (experiment.kind == FaultKind::kWrongIdentifier)
    {
        CanFrame changed = recording.frames[first].stamped.frame;
        Masquerade(recording, experiment.variant, changed);
        take(changed);
    }
    return longest;
}

std::uint32_t Limits::Of(const Experiment& experiment, const Recording& recording) const
{
    if (experiment.part == Part::kBus && !bus.empty())
    {
        return OfFrames(experiment, recording);
    }
    const bool is_call = experiment.part == Part::kCallsOfA || experiment.part == Part::kCallsOfB;
    const auto call = static_cast<ChannelCall>(experiment.subject / kTurns);
    // What guard and comparator read is found by their own checks.
    const bool is_read = call == ChannelCall::kHeld || call == ChannelCall::kLoad || call == ChannelCall::kRecheck;
    return (is_call && !is_read) ? wrong_channel_us : Of(experiment.part, experiment.kind);
}

std::size_t HorizonOf(const Limits& limits, const DeviceConfig& config)
{
    return (*std::max_element(limits.us.begin(), limits.us.end()) / config.cycle_us) + kMoreCycles;
}
} // namespace counterpoint::campaign
