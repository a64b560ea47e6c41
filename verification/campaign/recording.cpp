// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/recording.hpp"

#include "verification/campaign/course.hpp"

#include <algorithm>

namespace counterpoint::campaign
{
namespace
{
constexpr std::int64_t kMillion = 1000000;
constexpr std::size_t kNoFrame = ~std::size_t{0U};
constexpr std::int64_t kFrameBits = 111 + 24; ///< Eight bytes, and stuffed as far as can be.

bool IsSafetyFrame(const CanFrame& frame)
{
    return frame.identifier == kGfcIdentifier ||
           (frame.identifier >= kFirstSrdoIdentifier && frame.identifier <= kLastSrdoIdentifier);
}

bool IsReset(const cia301::NmtCommand command)
{
    return command == cia301::NmtCommand::kResetNode || command == cia301::NmtCommand::kResetCommunication;
}
} // namespace

Counters::Counters(const simulator::NodeSetup& setup)
    : a_(setup.counter_a.start_us), b_(setup.counter_b.start_us), rate_a_(kMillion + setup.counter_a.drift_ppm),
      rate_b_(kMillion + setup.counter_b.drift_ppm)
{
    a_.SetRate(0, static_cast<std::uint32_t>(rate_a_));
    b_.SetRate(0, static_cast<std::uint32_t>(rate_b_));
}

void Counters::Disturb(const std::size_t which, const Nanoseconds at, const std::int64_t rate_ppm,
                       const std::int32_t jump_us)
{
    const auto disturb = [at, rate_ppm, jump_us](host::HostClock& clock, const std::int64_t rate)
    {
        clock.SetRate(at, static_cast<std::uint32_t>(rate * (kMillion + rate_ppm) / kMillion));
        clock.Jump(at, jump_us);
    };
    if (which != 1U)
    {
        disturb(a_, rate_a_);
    }
    if (which != 0U)
    {
        disturb(b_, rate_b_);
    }
}

RecordedScenario::RecordedScenario(const std::string& file, const runtime::YamlValue& device)
    : run_(file, std::nullopt, std::nullopt, true), node_(Find(device))
{
    RequireThatItCanBeRecorded(device);
    run_.Simulate(nullptr);
    if (HasTwoCpus())
    {
        second_ = RecordOf(node_ + 1U);
    }
    recording_ = RecordOf(node_);
    if (HasTwoCpus())
    {
        CountByFirst();
    }
}

/// Frames of a cycle of CPU B are those that have come at the end of CPU A's, by which cycles are counted.
void RecordedScenario::CountByFirst()
{
    const std::size_t lead = CycleOf(recording_, second_.cycles.front().at);
    for (std::size_t cycle = 0U; cycle < second_.cycles.size(); ++cycle)
    {
        const std::size_t same = std::min(cycle + lead, recording_.cycles.size() - 1U);
        second_.cycles[cycle].frames_end = recording_.cycles[same].frames_end;
    }
}

/// Of one CPU.
Recording RecordedScenario::RecordOf(const simulator::NodeIndex node)
{
    const simulator::NodeIndex first = node_;
    node_ = node;
    recording_ = Recording{};
    RecordCycles();
    RecordFrames();
    RecordPairs();
    RecordInputs();
    RecordCommands();
    RecordPeers();
    node_ = first;
    return recording_;
}

/// Of two CPUs either.
bool RecordedScenario::IsOwn(const simulator::NodeIndex node) const
{
    const auto& nodes = run_.Setting().nodes;
    return node < nodes.size() && nodes[node].device == nodes[node_].device;
}

simulator::NodeIndex RecordedScenario::Find(const runtime::YamlValue& device) const
{
    const std::string name = device.Text("the name of a node");
    const auto& nodes = run_.Setting().nodes;
    const auto found = std::find_if(nodes.begin(), nodes.end(),
                                    [&name](const auto& node) { return node.name == name || node.device == name; });
    if (found == nodes.end())
    {
        device.Refuse("node " + runtime::Shown(name), "a node of the scenario");
    }
    return static_cast<simulator::NodeIndex>(found - nodes.begin());
}

void RecordedScenario::RequireThatItCanBeRecorded(const runtime::YamlValue& device) const
{
    const simulator::Scenario& scenario = run_.Setting();
    const auto is_of_device = [this](const auto& each) { return IsOwn(each.node); };
    if (!scenario.faults.empty() || !scenario.managers.empty() || !scenario.actions.empty())
    {
        device.Refuse("a scenario with faults, managers or actions", "devices, inputs and commands alone");
    }
    if (std::any_of(scenario.nmt.begin(), scenario.nmt.end(), [this](const simulator::NmtEvent& event)
                    { return IsReset(event.command) && (event.node == simulator::kNoNode || event.node == node_); }))
    {
        device.Refuse("a device that an NMT command resets", "one that is started and stopped alone");
    }
    if (scenario.nodes[node_].controllers != 1U)
    {
        device.Refuse("a device with two controllers", "one with one controller, or with two CPUs");
    }
    if (HasTwoCpus() && (scenario.nodes[node_].device != device.Node().scalar || Link().jitter != 0))
    {
        device.Refuse("one CPU of two, or a cross link with jitter",
                      "the device of both, and a link with a delay alone");
    }
    if (std::any_of(scenario.logic.begin(), scenario.logic.end(), is_of_device) ||
        std::any_of(scenario.power.begin(), scenario.power.end(), is_of_device))
    {
        device.Refuse("a device with logic or power cycles", "one that senses or acts, with its supply always on");
    }
}

/// As the simulator has it: the counters run from the beginning, cycles begin with the supply, and their distance is
/// that of the node's oscillator, which is counter A's.
void RecordedScenario::RecordCycles()
{
    const simulator::NodeSetup& setup = run_.Setting().nodes[node_];
    const Counters counters(setup);
    recording_.counters = counters;
    recording_.power_on = setup.phase;
    recording_.frame_ns = kFrameBits * runtime::kNanosecondsPerSecond / run_.Setting().bitrate;
    const std::int64_t oscillator = kMillion + setup.counter_a.drift_ppm;
    const std::int64_t scaled =
        std::int64_t{Model().Config().cycle_us} * runtime::kNanosecondsPerMicrosecond * kMillion;
    std::int64_t rest = 0;
    Nanoseconds at = setup.phase;
    const auto& acknowledges = run_.Setting().acknowledges;
    for (;;)
    {
        at += scaled / oscillator;
        rest += scaled % oscillator;
        at += (rest >= oscillator) ? 1 : 0;
        rest -= (rest >= oscillator) ? oscillator : 0;
        if (at > run_.Setting().duration)
        {
            break;
        }
        RecordedCycle cycle;
        cycle.at = at;
        cycle.call.now = counters.At(at);
        for (const simulator::Acknowledge& acknowledge : acknowledges)
        {
            if (acknowledge.node == node_ && acknowledge.at <= at && at < acknowledge.at + acknowledge.pulse)
            {
                const SrdoMask bit = SrdoMask{1U} << Model().SlotOf(acknowledge.srdo).value_or(0U);
                cycle.call.acknowledge_a |= bit;
                cycle.call.acknowledge_b |= bit;
            }
        }
        for (const simulator::Event& event : run_.Record().Events())
        {
            if (event.node == node_ && event.kind == simulator::EventKind::kNmt && event.at <= at)
            {
                cycle.nmt = static_cast<NmtState>(event.value);
            }
        }
        recording_.cycles.push_back(cycle);
    }
}

void RecordedScenario::RecordFrames()
{
    const Counters counters(run_.Setting().nodes[node_]);
    for (const simulator::FrameEntry& entry : run_.Record().Frames())
    {
        if (!IsOwn(entry.sender) && entry.fate == host::FrameFate::kComplete && IsSafetyFrame(entry.frame))
        {
            recording_.frames.push_back({entry.end, {entry.frame, counters.At(entry.end)}});
        }
    }
    std::size_t next = 0U;
    for (RecordedCycle& cycle : recording_.cycles)
    {
        while (next < recording_.frames.size() && recording_.frames[next].at <= cycle.at)
        {
            ++next;
        }
        cycle.frames_end = next;
    }
}

/// A normal frame and the inverse one behind it, of each consumer.
void RecordedScenario::RecordPairs()
{
    for (const runtime::SrdoModel& srdo : Model().Srdos())
    {
        if (srdo.direction != kDirectionConsumer)
        {
            continue;
        }
        std::size_t normal = kNoFrame;
        for (std::size_t index = 0U; index < recording_.frames.size(); ++index)
        {
            const std::uint32_t identifier = recording_.frames[index].stamped.frame.identifier;
            if (identifier == srdo.cob_id_1)
            {
                normal = index;
            }
            else if (identifier == srdo.cob_id_2 && normal != kNoFrame)
            {
                recording_.pairs.push_back({normal, index});
                normal = kNoFrame;
            }
            else
            {
                // Of another SRDO.
            }
        }
    }
    for (const RecordedFrame& frame : recording_.frames)
    {
        const std::uint32_t identifier = frame.stamped.frame.identifier;
        auto& known = recording_.identifiers;
        if (std::find(known.begin(), known.end(), identifier) == known.end())
        {
            known.push_back(identifier);
        }
    }
}

void RecordedScenario::RecordInputs()
{
    for (const simulator::Stimulus& stimulus : run_.Setting().stimuli)
    {
        if (stimulus.node == node_)
        {
            const auto seen = std::find_if(recording_.cycles.begin(), recording_.cycles.end(),
                                           [&stimulus](const RecordedCycle& cycle) { return cycle.at >= stimulus.at; });
            recording_.inputs.push_back(
                {static_cast<std::size_t>(seen - recording_.cycles.begin()), stimulus.object, stimulus.value});
        }
    }
    std::stable_sort(recording_.inputs.begin(), recording_.inputs.end(),
                     [](const RecordedInput& left, const RecordedInput& right) { return left.cycle < right.cycle; });
}

/// Changes of the NMT state, and the GFC that the device itself is to send.
void RecordedScenario::RecordCommands()
{
    std::vector<RecordedCommand>& commands = recording_.commands;
    NmtState known = NmtState::kInvalid;
    for (std::size_t cycle = 0U; cycle < recording_.cycles.size(); ++cycle)
    {
        if (recording_.cycles[cycle].nmt != known)
        {
            known = recording_.cycles[cycle].nmt;
            commands.push_back({cycle, {false, known}});
        }
    }
    for (const simulator::Event& event : run_.Record().Events())
    {
        const bool is_call = event.kind == simulator::EventKind::kGfc && event.value <= 1U; // Else it was heard of.
        const std::size_t cycle = CycleOf(recording_, event.at);
        if (event.node == node_ && is_call && cycle < recording_.cycles.size())
        {
            commands.push_back({cycle, {true, NmtState::kInvalid}});
        }
    }
    std::stable_sort(commands.begin(), commands.end(), [](const RecordedCommand& left, const RecordedCommand& right)
                     { return left.cycle < right.cycle; });
}

void RecordedScenario::RecordPeers()
{
    constexpr std::uint32_t kNobody = ~std::uint32_t{0U};
    for (const runtime::SrdoModel& own : Model().Srdos())
    {
        std::uint32_t shortest = kNobody;
        for (std::size_t node = 0U; node < run_.Setting().nodes.size(); ++node)
        {
            for (const runtime::SrdoModel& other : run_.ModelOf(static_cast<simulator::NodeIndex>(node)).Srdos())
            {
                if (other.direction == kDirectionConsumer && other.cob_id_1 == own.cob_id_1)
                {
                    shortest = std::min(shortest, other.times.sct_ms * kMicrosecondsPerMillisecond);
                }
            }
        }
        recording_.peer_scts.push_back(shortest);
    }
}
} // namespace counterpoint::campaign
