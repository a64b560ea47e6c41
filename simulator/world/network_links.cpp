// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/scenario/names.hpp"
#include "simulator/world/network.hpp"

#include <string>

// What devices with two CPUs need, and what nobody but the other CPU sends. [SRS_SIM_056, SRS_SIM_057]
namespace counterpoint::simulator
{
namespace
{
/// What half the range of a counter of microseconds holds, and more than any device can use.
constexpr Nanoseconds kLongestLinkTime = 536 * kNanosecondsPerSecond;

/// What CheckLinkConfig found, for people: what is wrong and what was expected.
std::pair<const char*, const char*> TextOf(const LinkConfigFault fault)
{
    switch (fault)
    {
    case LinkConfigFault::kTimeout:
        return {"link time-out", "3 cycles of the device or more"};
    case LinkConfigFault::kClock:
        return {"clock tolerance or interval of the link",
                "a tolerance above 0 and up to half the time-out, an interval above the time-out and up to 536 s"};
    case LinkConfigFault::kStampTolerance:
        return {"stamp tolerance of the link", "less than the time-out"};
    case LinkConfigFault::kDiscrepancy:
        return {"discrepancy time 0x5F00:03 of a device with two CPUs", "2 cycles or more"};
    default:
        return {"link", "one that the device accepts"};
    }
}
} // namespace

void Network::RequireLinks() const
{
    for (NodeIndex node = 0U; node < scenario_.nodes.size(); ++node)
    {
        const NodeSetup& setup = scenario_.nodes[node];
        if (setup.role == runtime::CpuRole::kWhole)
        {
            continue;
        }
        for (const Nanoseconds time :
             {setup.link.timeout, setup.link.clock_tolerance, setup.link.clock_interval, setup.link.stamp_tolerance})
        {
            if (time > kLongestLinkTime)
            {
                throw YamlError(setup.source.file, setup.source.place,
                                "a time of the link of " + MillisecondsText(time),
                                "at most " + MillisecondsText(kLongestLinkTime));
            }
        }
        const LinkConfigFault fault = CheckLinkConfig(models_[node]->Config(), LinkConfigOf(setup));
        if (fault != LinkConfigFault::kNone)
        {
            const auto [wrong, expected] = TextOf(fault);
            throw YamlError(setup.source.file, setup.source.place, wrong, expected);
        }
        if (setup.link.delay + setup.link.jitter >= setup.link.timeout)
        {
            throw YamlError(setup.source.file, setup.source.place, "delay of the link with its jitter",
                            "less than its time-out");
        }
        if (models_[node]->ControllerCount() > 1U)
        {
            throw YamlError(setup.source.file, setup.source.place, "a DCF with two controllers",
                            "one for all frames: each CPU has a controller of its own");
        }
    }
}

void Network::RequireOfCpu(const FaultSetup& fault) const
{
    if (fault.node == kNoNode || scenario_.nodes[fault.node].role == runtime::CpuRole::kWhole)
    {
        return;
    }
    const NodeSetup& setup = scenario_.nodes[fault.node];
    const bool is_a = setup.role == runtime::CpuRole::kA;
    if (fault.part == (is_a ? Part::kChannelB : Part::kChannelA))
    {
        throw YamlError(fault.source.file, fault.source.place,
                        std::string("channel_") + (is_a ? "b" : "a") + " of " + setup.name,
                        "the channel of this CPU, or the other CPU");
    }
    if (fault.kind == FaultKind::kClock && fault.hits_counter_b)
    {
        throw YamlError(fault.source.file, fault.source.place, "counter b of " + setup.name,
                        "counter a: a CPU of two has one");
    }
}

void Network::PlanInsertedMessages(const std::size_t index)
{
    const FaultSetup& fault = scenario_.faults[index];
    for (std::uint32_t time = 0U; time < fault.times; ++time)
    {
        Plan(fault.at + fault.by * time, [this, index, &fault]() { wires_.at(fault.node)->Insert(index, Now()); });
    }
}
} // namespace counterpoint::simulator
