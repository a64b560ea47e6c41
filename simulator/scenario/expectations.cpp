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
    for (std::size_t index = 0U; index < scenario.faults.size(); ++index)
    {
        if (scenario.faults[index].name == name)
        {
            return index;
        }
        expected += (expected.empty() ? "" : ", ") + scenario.faults[index].name;
    }
    value->Refuse("fault " + runtime::Shown(name),
                  expected.empty() ? "a fault of 'faults', which has none" : "one of " + expected);
}

void ReadParties(Fields& fields, Expectation& expectation)
{
    for (const YamlValue& party : OneOrMore(fields.Require("by"), "one party or more"))
    {
        expectation.parties.push_back(party.Choice(kPartyWords));
    }
}

void ReadPlace(const YamlValue& name, const Scenario& scenario, Expectation& expectation)
{
    expectation.node = NodeNamed(scenario, name);
    expectation.is_series = IsTwoCpus(scenario, name);
}

void ReadOutputOf(Fields& fields, const Scenario& scenario, Expectation& expectation)
{
    ReadPlace(fields.Require("node"), scenario, expectation);
    fields.Into("srdo", expectation.srdo);
}

void ReadContent(Fields& fields, const Scenario& scenario, Expectation& expectation)
{
    switch (expectation.kind)
    {
    case ExpectationKind::kReleased:
    case ExpectationKind::kSafe:
        ReadOutputOf(fields, scenario, expectation);
        fields.Into("at", expectation.at);
        return;
    case ExpectationKind::kValue:
        ReadPlace(fields.Require("node"), scenario, expectation);
        fields.Into("object", expectation.object);
        fields.Into("is", expectation.value);
        fields.Into("at", expectation.at);
        return;
    case ExpectationKind::kCause:
        ReadOutputOf(fields, scenario, expectation);
        expectation.cause = fields.Require("is").Choice(runtime::kCauseWords);
        return;
    case ExpectationKind::kDeviceFault:
        ReadPlace(fields.Require("node"), scenario, expectation);
        expectation.device_fault = fields.Require("is").Choice(runtime::kDeviceFaultWords);
        return;
    case ExpectationKind::kDetectedBy:
        expectation.fault = ReadFaultIndex(fields, scenario);
        ReadPlace(fields.Require("node"), scenario, expectation);
        ReadParties(fields, expectation);
        return;
    case ExpectationKind::kSafeWithin:
        expectation.fault = ReadFaultIndex(fields, scenario);
        ReadOutputOf(fields, scenario, expectation);
        if (const auto limit = fields.Find("limit"))
        {
            expectation.fault_class = limit->Choice(kFaultClassWords);
            const bool is_link = expectation.fault_class == FaultClass::kCrossLink;
            if (is_link && scenario.nodes[expectation.node].role == runtime::CpuRole::kWhole)
            {
                limit->Refuse("cross_link of a node with one CPU", "another row, or a node with 'structure: two_cpu'");
            }
        }
        return;
    case ExpectationKind::kNoFault:
        if (const auto node = fields.Find("node"))
        {
            ReadPlace(*node, scenario, expectation);
        }
        return;
    default:
        ReadOfNetwork(fields, scenario, expectation);
        return;
    }
}
} // namespace

void ReadExpectation(Fields& fields, const Scenario& scenario, Expectation& expectation)
{
    expectation.kind = fields.Require("that").Choice(kExpectationWords);
    expectation.is_of_profile = IsOfProfile(fields, scenario);
    fields.Extend(NameOf(kExpectationWords, expectation.kind));
    ReadContent(fields, scenario, expectation);
}
} // namespace counterpoint::simulator
