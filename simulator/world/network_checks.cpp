// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/scenario/names.hpp"
#include "simulator/world/network.hpp"

#include <string>

// What a scenario names has to exist in the DCFs. [SRS_SIM_010]
namespace counterpoint::simulator
{
namespace
{
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
} // namespace

void Network::RequirePair(const NodeIndex node, const ObjectAddress& object, const bool is_consumer,
                          const Source& source) const
{
    const runtime::DeviceModel& model = *models_[node];
    const runtime::VariablePair* const pair = model.PairOf(object);
    if (pair == nullptr || pair->is_consumer != is_consumer)
    {
        const char* const side = is_consumer ? "a normal object that an SRDO of direction 2 is mapped to: "
                                             : "a normal object that an SRDO of direction 1 is mapped to: ";
        throw YamlError(source.file, source.place, "object " + ObjectText(object) + " in " + model.File(),
                        side + ListOf(model, is_consumer));
    }
}

void Network::RequireSrdo(const NodeIndex node, const std::uint8_t number, const bool needs_consumer,
                          const Source& source) const
{
    const runtime::DeviceModel& model = *models_[node];
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
void Network::RequireValue(const NodeIndex node, const ObjectAddress& object, const std::uint64_t value,
                           const Source& source) const
{
    const runtime::DeviceModel& model = *models_[node];
    const std::uint8_t bits = model.Objects()[model.PairOf(object)->normal].length_bits;
    if ((value >> (bits - 1U)) > 1U)
    {
        throw YamlError(source.file, source.place,
                        "value " + std::to_string(value) + " for object " + ObjectText(object),
                        "a value of " + std::to_string(bits) + " bits");
    }
}

void Network::RequireNodeIds() const
{
    for (NodeIndex node = 1U; node < models_.size(); ++node)
    {
        for (NodeIndex other = 0U; other < node; ++other)
        {
            const std::uint8_t id = models_[node]->Config().node_id;
            const bool is_one_device = scenario_.nodes[other].device == scenario_.nodes[node].device;
            if (models_[other]->Config().node_id == id && !is_one_device)
            {
                const NodeSetup& setup = scenario_.nodes[node];
                throw YamlError(setup.source.file, setup.source.place,
                                "node-ID " + std::to_string(id) + ", which " + scenario_.nodes[other].name + " has",
                                "a node-ID of its own for each node");
            }
        }
    }
}

void Network::RequireOfFault(const FaultSetup& fault) const
{
    RequireOfCpu(fault);
    if (fault.kind == FaultKind::kNotInverse)
    {
        RequirePair(fault.node, fault.object, false, fault.source);
        for (const std::uint8_t bit : fault.bits)
        {
            RequireValue(fault.node, fault.object, std::uint64_t{1U} << bit, fault.source);
        }
    }
    if (fault.controller > 1U && models_[fault.node]->ControllerCount() == 1U)
    {
        throw YamlError(fault.source.file, fault.source.place, "controller 2 of a node with one",
                        "'controllers: 2' of that node, or a DCF that names two");
    }
    if (fault.part == Part::kSelfTest && !scenario_.nodes[fault.node].self_tests)
    {
        throw YamlError(fault.source.file, fault.source.place, "the self test of a node without one",
                        "a node without 'self_tests: false'");
    }
    if (fault.frames.srdo_of)
    {
        RequireSrdo(*fault.frames.srdo_of, fault.frames.srdo, false, fault.source);
    }
    if (fault.srdo != 0U)
    {
        RequireSrdo(fault.node, fault.srdo, false, fault.source);
    }
    if (fault.config && fault.config->slot != 0U)
    {
        RequireSrdo(fault.node, fault.config->slot, false, fault.source);
    }
}

void Network::RequireOfExpectation(const Expectation& expectation) const
{
    switch (expectation.kind)
    {
    case ExpectationKind::kReleased:
    case ExpectationKind::kSafe:
    case ExpectationKind::kSafeWithin:
        RequireSrdo(expectation.node, expectation.srdo, true, expectation.source);
        return;
    case ExpectationKind::kCause:
        RequireSrdo(expectation.node, expectation.srdo, false, expectation.source);
        return;
    case ExpectationKind::kValue:
        RequirePair(expectation.node, expectation.object, true, expectation.source);
        RequireValue(expectation.node, expectation.object, expectation.value, expectation.source);
        return;
    case ExpectationKind::kDeviceFault:
    case ExpectationKind::kDetectedBy:
    case ExpectationKind::kNoFault:
    default:
        return;
    }
}

void Network::RequireThatEverythingExists() const
{
    RequireNodeIds();
    RequireLinks();
    for (const NodeSetup& node : scenario_.nodes)
    {
        if (node.start_at <= node.phase)
        {
            throw YamlError(node.source.file, node.source.place, "start_at not after phase",
                            "a node that is on before it starts");
        }
    }
    for (const Stimulus& stimulus : scenario_.stimuli)
    {
        RequirePair(stimulus.node, stimulus.object, false, stimulus.source);
        RequireValue(stimulus.node, stimulus.object, stimulus.value, stimulus.source);
    }
    for (const runtime::LogicRule& rule : scenario_.logic)
    {
        RequirePair(rule.node, rule.target, false, rule.source);
        for (const ObjectAddress& input : rule.inputs)
        {
            RequirePair(rule.node, input, true, rule.source);
        }
    }
    for (const Acknowledge& acknowledge : scenario_.acknowledges)
    {
        RequireSrdo(acknowledge.node, acknowledge.srdo, false, acknowledge.source);
    }
    for (const FaultSetup& fault : scenario_.faults)
    {
        RequireOfFault(fault);
    }
    for (const Expectation& expectation : scenario_.expectations)
    {
        RequireOfExpectation(expectation);
    }
}
} // namespace counterpoint::simulator
