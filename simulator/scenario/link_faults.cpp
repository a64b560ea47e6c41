// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/scenario/names.hpp"
#include "simulator/scenario/parts.hpp"

// Faults of the link between two CPUs. What each key may hold is the schema's. [SRS_SIM_057]
namespace counterpoint::simulator
{
namespace
{
constexpr Range kMessageBits{0U, 0xFFFFU};

void ReadChoice(Fields& fields, FaultSetup& fault)
{
    ReadSpan(fields, fault);
    FrameChoice& choice = fault.frames;
    choice.from = fault.at;
    choice.until = fault.until;
    choice.on = fault.on;
    choice.off = fault.off;
    choice.first = fields.Require("first").Checked();
    choice.every = fields.Require("every").Checked();
    choice.count = fields.Require("count").Checked();
    choice.probability_ppm = fields.Require("probability_ppm").Checked();
}

void ReadInsertion(Fields& fields, FaultSetup& fault)
{
    fault.at = fields.Require("at").Duration();
    if (fields.Require("what").Choice(kInsertedWords))
    {
        fault.back = fields.Require("back").Checked();
    }
    fault.times = fields.Require("times").Checked();
    if (const auto by = fields.Find("every"))
    {
        fault.by = by->Lasting();
    }
    if (fault.times > 1U && fault.by == 0)
    {
        fields.Value().Refuse("several messages without key 'every'", "the time between two messages");
    }
}

void ReadBits(Fields& fields, FaultSetup& fault)
{
    const YamlValue bits = fields.Require("bits");
    for (const YamlValue& bit : bits.Items("a list of numbers"))
    {
        fault.message_bits.push_back(static_cast<std::uint32_t>(bit.Number(kMessageBits)));
    }
    if (fault.message_bits.empty())
    {
        bits.Refuse("an empty list", "one bit or more");
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
    switch (fault.kind)
    {
    case FaultKind::kLinkDelay:
        fault.by = fields.Require("by").Lasting();
        return;
    case FaultKind::kLinkRepetition:
        fault.times = fields.Require("times").Checked();
        fault.by = fields.Require("after").Duration();
        return;
    case FaultKind::kLinkCorruption:
        ReadBits(fields, fault);
        return;
    default:
        return;
    }
}
} // namespace counterpoint::simulator
