// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/scenario/names.hpp"
#include "simulator/scenario/parts.hpp"

// Faults of the link between two CPUs. What each key may hold is the schema's. [SRS_SIM_057]
namespace counterpoint::simulator
{
namespace
{
void ReadChoice(Fields& fields, FaultSetup& fault)
{
    ReadSpan(fields, fault);
    FrameChoice& choice = fault.frames;
    choice.from = fault.at;
    choice.until = fault.until;
    choice.on = fault.on;
    choice.off = fault.off;
    ReadTurns(fields, choice);
}

void ReadInsertion(Fields& fields, FaultSetup& fault)
{
    fields.Into("at", fault.at);
    if (fields.Require("what").Choice(kInsertedWords))
    {
        fields.Need("back", fault.back);
    }
    fields.Into("times", fault.times);
    fields.Into("every", fault.by);
    if (fault.times > 1U && fault.by == 0)
    {
        fields.Value().Refuse("several messages without key 'every'", "the time between two messages");
    }
}
} // namespace

void ReadLinkFault(Fields& fields, const Scenario& scenario, FaultSetup& fault)
{
    const YamlValue node = fields.Require("node");
    fault.node = NodeNamed(scenario, node);
    if (!IsTwoCpus(scenario, node))
    {
        node.Refuse("node " + runtime::Shown(node.Node().scalar), "a node with 'structure: two_cpu'");
    }
    const Side sender = fields.Require("sender").Choice(kCounterWords);
    fault.hits_from_a = sender != Side::kSecond;
    fault.hits_from_b = sender != Side::kFirst;
    if (fault.kind == FaultKind::kLinkInsertion)
    {
        ReadInsertion(fields, fault);
        return;
    }
    ReadChoice(fields, fault);
    fields.Into("by", fault.by);
    fields.Into("times", fault.times);
    fields.Into("after", fault.by);
    if (fault.kind == FaultKind::kLinkCorruption)
    {
        ReadBits(fields, fault.message_bits);
    }
}
} // namespace counterpoint::simulator
