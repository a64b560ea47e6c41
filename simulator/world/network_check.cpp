// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/world/network_check.hpp"

#include "simulator/scenario/names.hpp"

#include "runtime/device/time_text.hpp"

#include <string>

// What a scenario names has to exist in the DCFs. [SRS_SIM_010, SRS_SIM_056, SRS_SIM_057, SRS_NODE_160]
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
        return {
            "clock tolerance or interval of the link",
            "a tolerance above 0 and up to half the time-out, an interval of four time-outs or more and up to 536 s"};
    case LinkConfigFault::kStampTolerance:
        return {"stamp tolerance of the link", "less than the time-out"};
    case LinkConfigFault::kDiscrepancy:
        return {"discrepancy time 0x5F00:03 of a device with two CPUs", "2 cycles or more"};
    default:
        return {"link", "one that the device accepts"};
    }
}

std::string ListOf(const runtime::DeviceModel& model, const bool is_consumer)
{
    std::string list;
    for (const runtime::VariablePair& pair : model.Pairs())
    {
        if (pair.is_consumer == is_consumer)
        {
            const MappableObject& object = model.Objects()[pair.normal];
            list += (list.empty() ? "" : ", ") + ObjectText({object.index, object.sub});
        }
    }
    return list.empty() ? "(this node has none)" : list;
}

const runtime::DeviceModel& ModelOf(const World& world, const NodeIndex node)
{
    return *world.models[node];
}

void RequirePair(const World& world, const NodeIndex node, const ObjectAddress& object, const bool is_consumer,
                 const Source& source)
{
    const runtime::DeviceModel& model = ModelOf(world, node);
    const runtime::VariablePair* const pair = model.PairOf(object);
    if (pair == nullptr || pair->is_consumer != is_consumer)
    {
        const char* const side = is_consumer ? "a normal object that an SRDO of direction 2 is mapped to: "
                                             : "a normal object that an SRDO of direction 1 is mapped to: ";
        throw YamlError(source.file, source.place, "object " + ObjectText(object) + " in " + model.File(),
                        side + ListOf(model, is_consumer));
    }
}

void RequireSrdo(const World& world, const NodeIndex node, const std::uint8_t number, const bool needs_consumer,
                 const Source& source)
{
    const runtime::DeviceModel& model = ModelOf(world, node);
    std::string list;
    for (const runtime::SrdoModel& srdo : model.Srdos())
    {
        const bool fits = !needs_consumer || srdo.direction == kDirectionConsumer;
        if (fits && srdo.number == number)
        {
            return;
        }
        list += fits ? (list.empty() ? "" : ", ") + std::to_string(srdo.number) : "";
    }
    throw YamlError(source.file, source.place, "SRDO " + std::to_string(number) + " in " + model.File(),
                    std::string(needs_consumer ? "an SRDO of direction 2: " : "an SRDO: ") +
                        (list.empty() ? "(this node has none)" : list));
}

/// The value fits into the bits of the object, which exists.
void RequireValue(const World& world, const NodeIndex node, const ObjectAddress& object, const std::uint64_t value,
                  const Source& source)
{
    const runtime::DeviceModel& model = ModelOf(world, node);
    const std::uint8_t bits = model.Objects()[model.PairOf(object)->normal].length_bits;
    if ((value >> (bits - 1U)) > 1U)
    {
        throw YamlError(source.file, source.place,
                        "value " + std::to_string(value) + " for object " + ObjectText(object),
                        "a value of " + std::to_string(bits) + " bits");
    }
}

/// Inputs as long as the target: of a shorter one the inverse would be too short, a longer one would be cut.
void RequireLengths(const World& world, const runtime::LogicRule& rule)
{
    const runtime::DeviceModel& model = ModelOf(world, rule.node);
    const auto bits_of = [&model](const ObjectAddress& object)
    { return std::uint32_t{model.Objects()[model.PairOf(object)->normal].length_bits}; };
    const std::uint32_t bits = bits_of(rule.target);
    for (const ObjectAddress& input : rule.inputs)
    {
        if (bits_of(input) != bits)
        {
            throw YamlError(rule.source.file, rule.source.place,
                            "object " + ObjectText(input) + " of " + std::to_string(bits_of(input)) + " bits",
                            "one of " + std::to_string(bits) + " bits, as " + ObjectText(rule.target) + " has");
        }
    }
}

/// Of two who write an object the last one would win without a word. [SRS_SIM_711]
void RequireOneWriter(const Scenario& scenario, const runtime::LogicRule& rule)
{
    const auto refuse = [&scenario, &rule](const char* const what, const Source& source)
    {
        throw YamlError(source.file, source.place,
                        what + ObjectText(rule.target) + " of node " + runtime::Shown(scenario.nodes[rule.node].name) +
                            ", which the rule at " + cia306::PlaceText(rule.source.file, rule.source.place) + " sets",
                        "one writer of each object");
    };
    for (const runtime::LogicRule& other : scenario.logic)
    {
        if (&other > &rule && other.node == rule.node && runtime::IsSame(other.target, rule.target))
        {
            refuse("a rule for object ", other.source);
        }
    }
    for (const Stimulus& stimulus : scenario.stimuli)
    {
        if (stimulus.node == rule.node && runtime::IsSame(stimulus.object, rule.target))
        {
            refuse("an input of object ", stimulus.source);
        }
    }
}

void RequireNodeIds(const World& world)
{
    for (NodeIndex node = 1U; node < world.scenario.nodes.size(); ++node)
    {
        for (NodeIndex other = 0U; other < node; ++other)
        {
            const std::uint8_t id = ModelOf(world, node).Config().node_id;
            const bool is_one_device = world.scenario.nodes[other].device == world.scenario.nodes[node].device;
            if (ModelOf(world, other).Config().node_id == id && !is_one_device)
            {
                const NodeSetup& setup = world.scenario.nodes[node];
                throw YamlError(setup.source.file, setup.source.place,
                                "node-ID " + std::to_string(id) + ", which " + world.scenario.nodes[other].name +
                                    " has",
                                "a node-ID of its own for each node; the event 'duplicate' brings another one");
            }
        }
    }
}

void RequireOfCpu(const World& world, const FaultSetup& fault)
{
    if (fault.node == kNoNode || world.scenario.nodes[fault.node].role == runtime::CpuRole::kWhole)
    {
        return;
    }
    const NodeSetup& setup = world.scenario.nodes[fault.node];
    const bool is_a = setup.role == runtime::CpuRole::kA;
    if (fault.part == (is_a ? Part::kChannelB : Part::kChannelA))
    {
        throw YamlError(fault.source.file, fault.source.place,
                        std::string("channel_") + (is_a ? "b" : "a") + " of " + setup.name,
                        "the channel of this CPU, or the other CPU");
    }
    if (fault.hits_counter_b)
    {
        throw YamlError(fault.source.file, fault.source.place, "counter b of " + setup.name,
                        "counter a: a CPU of two has one");
    }
}

void RequireOfFault(const World& world, const FaultSetup& fault)
{
    RequireOfCpu(world, fault);
    if (fault.kind == FaultKind(NodeFault::kNotInverse))
    {
        RequirePair(world, fault.node, fault.object, false, fault.source);
        for (const std::uint8_t bit : fault.bits)
        {
            RequireValue(world, fault.node, fault.object, std::uint64_t{1U} << bit, fault.source);
        }
    }
    if (fault.controller > 1U && ModelOf(world, fault.node).ControllerCount() == 1U)
    {
        throw YamlError(fault.source.file, fault.source.place, "controller 2 of a node with one",
                        "'controllers: 2' of that node, or a DCF that names two");
    }
    if (fault.part == Part::kSelfTest && !world.scenario.nodes[fault.node].self_tests)
    {
        throw YamlError(fault.source.file, fault.source.place, "the self test of a node without one",
                        "a node without 'self_tests: false'");
    }
    if (fault.frames.srdo_of)
    {
        RequireSrdo(world, *fault.frames.srdo_of, fault.frames.srdo, false, fault.source);
    }
    if (fault.srdo != 0U)
    {
        RequireSrdo(world, fault.node, fault.srdo, false, fault.source);
    }
    if (fault.config && fault.config->slot != 0U)
    {
        RequireSrdo(world, fault.node, fault.config->slot, false, fault.source);
    }
}

void RequireOfExpectation(const World& world, const Expectation& expectation)
{
    switch (expectation.kind)
    {
    case ExpectationKind::kReleased:
    case ExpectationKind::kSafe:
    case ExpectationKind::kSafeWithin:
        RequireSrdo(world, expectation.node, expectation.srdo, true, expectation.source);
        return;
    case ExpectationKind::kCause:
        RequireSrdo(world, expectation.node, expectation.srdo, false, expectation.source);
        return;
    case ExpectationKind::kValue:
        RequirePair(world, expectation.node, expectation.object, true, expectation.source);
        RequireValue(world, expectation.node, expectation.object, expectation.value, expectation.source);
        return;
    default:
        return;
    }
}

/// What devices with two CPUs need.
void RequireLinks(const World& world)
{
    for (NodeIndex node = 0U; node < world.scenario.nodes.size(); ++node)
    {
        const NodeSetup& setup = world.scenario.nodes[node];
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
                                "a time of the link of " + runtime::ExactText(time),
                                "at most " + MillisecondsText(kLongestLinkTime));
            }
        }
        const LinkConfigFault fault = CheckLinkConfig(ModelOf(world, node).Config(), LinkConfigOf(setup));
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
        if (ModelOf(world, node).ControllerCount() > 1U)
        {
            throw YamlError(setup.source.file, setup.source.place, "a DCF with two controllers",
                            "one for all frames: each CPU has a controller of its own");
        }
    }
}
} // namespace

void RequireThatEverythingExists(const World& world)
{
    RequireNodeIds(world);
    RequireLinks(world);
    for (const NodeSetup& node : world.scenario.nodes)
    {
        if (node.start_at <= node.phase)
        {
            throw YamlError(node.source.file, node.source.place, "start_at not after phase",
                            "a node that is on before it starts");
        }
    }
    for (const Action& action : world.scenario.actions)
    {
        if (action.kind == ActionKind::kDuplicate && world.scenario.nodes[action.node].role != runtime::CpuRole::kWhole)
        {
            throw YamlError(action.source.file, action.source.place, "a duplicate of a device with two CPUs",
                            "a device with one: the second one would need a link of its own");
        }
    }
    for (const Stimulus& stimulus : world.scenario.stimuli)
    {
        RequirePair(world, stimulus.node, stimulus.object, false, stimulus.source);
        RequireValue(world, stimulus.node, stimulus.object, stimulus.value, stimulus.source);
    }
    for (const runtime::LogicRule& rule : world.scenario.logic)
    {
        RequirePair(world, rule.node, rule.target, false, rule.source);
        for (const ObjectAddress& input : rule.inputs)
        {
            RequirePair(world, rule.node, input, true, rule.source);
        }
        RequireLengths(world, rule);
        RequireOneWriter(world.scenario, rule);
    }
    for (const Acknowledge& acknowledge : world.scenario.acknowledges)
    {
        const bool is_of_file = world.scenario.managers.empty(); // A manager may turn a producer round.
        RequireSrdo(world, acknowledge.node, acknowledge.srdo, is_of_file, acknowledge.source);
    }
    for (const FaultSetup& fault : world.scenario.faults)
    {
        RequireOfFault(world, fault);
    }
    for (const Expectation& expectation : world.scenario.expectations)
    {
        RequireOfExpectation(world, expectation);
    }
}
} // namespace counterpoint::simulator
