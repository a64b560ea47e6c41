// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/scenario/names.hpp"
#include "simulator/scenario/parts.hpp"

#include <string>

namespace counterpoint::simulator
{
namespace
{
/// The fault by its name, or by its place counted from 1; the only one if nothing is said.
std::size_t ReadFaultIndex(Fields& fields, const Scenario& scenario)
{
    const auto value = fields.Find("fault");
    if (!value && scenario.faults.size() == 1U)
    {
        return 0U;
    }
    if (!value)
    {
        fields.Value().Refuse("expectation without key 'fault'", "the name of one of the faults");
    }
    const std::string name = value->Text("the name of a fault");
    std::string expected;
    std::vector<std::string> known;
    for (std::size_t index = 0U; index < scenario.faults.size(); ++index)
    {
        if (scenario.faults[index].name == name)
        {
            return index;
        }
        expected += (expected.empty() ? "" : ", ") + scenario.faults[index].name;
        known.push_back(scenario.faults[index].name);
    }
    value->Refuse("fault " + runtime::Shown(name) + cia306::DidYouMean(name, known),
                  expected.empty() ? "a fault of 'faults', which has none" : "one of " + expected);
}

void ReadLimit(Fields& fields, const Scenario& scenario, Expectation& expectation)
{
    if (const auto limit = fields.Find("limit"))
    {
        expectation.fault_class = limit->Choice(kFaultClassWords);
        const bool is_link = expectation.fault_class == FaultClass::kCrossLink;
        if (is_link && scenario.nodes[expectation.node].role == runtime::CpuRole::kWhole)
        {
            limit->Refuse("cross_link of a node with one CPU", "another row, or a node with 'structure: two_cpu'");
        }
    }
}

/// What its section has of these keys.
void ReadOfNodes(Fields& fields, const Scenario& scenario, Expectation& expectation)
{
    if (fields.Has("fault"))
    {
        expectation.fault = ReadFaultIndex(fields, scenario);
    }
    if (const auto node = fields.Find("node"))
    {
        expectation.node = NodeNamed(scenario, *node);
        expectation.is_series = IsTwoCpus(scenario, *node);
    }
    fields.Into("srdo", expectation.srdo);
    fields.Into("object", expectation.object);
    if (expectation.kind == ExpectationKind::kValue)
    {
        fields.Into("is", expectation.value);
    }
    if (expectation.kind == ExpectationKind::kCause)
    {
        expectation.cause = fields.Require("is").Choice(runtime::kCauseWords);
    }
    if (expectation.kind == ExpectationKind::kDeviceFault)
    {
        expectation.device_fault = fields.Require("is").Choice(runtime::kDeviceFaultWords);
    }
    fields.Into("at", expectation.at);
    if (fields.Has("by"))
    {
        for (const YamlValue& party : OneOrMore(fields.Require("by"), "one party or more"))
        {
            expectation.parties.push_back(party.Choice(kPartyWords));
        }
    }
    ReadLimit(fields, scenario, expectation);
}
} // namespace

void ReadExpectation(Fields& fields, const Scenario& scenario, Expectation& expectation)
{
    expectation.kind = fields.Require("that").Choice(kExpectationWords);
    expectation.is_of_profile = IsOfProfile(fields, scenario);
    fields.Extend(NameOf(kExpectationWords, expectation.kind));
    IsOfNetwork(expectation.kind) ? ReadOfNetwork(fields, scenario, expectation)
                                  : ReadOfNodes(fields, scenario, expectation);
}
} // namespace counterpoint::simulator
