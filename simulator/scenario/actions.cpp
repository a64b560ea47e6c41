// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The sections `managers` and `events`. [SRS_MGR_012, SRS_MGR_155]
#include "canopen/cia306/text/number.hpp"
#include "simulator/scenario/names.hpp"
#include "simulator/scenario/network_names.hpp"
#include "simulator/scenario/parts.hpp"

#include <optional>
#include <sstream>

namespace counterpoint::simulator
{
namespace
{
/// "01 21": up to 8 bytes in hexadecimal.
std::vector<std::uint8_t> DataOf(const std::optional<YamlValue>& value)
{
    constexpr std::size_t kMost = 8U;
    std::vector<std::uint8_t> data;
    std::istringstream words(value ? value->Text("bytes such as 01 21") : std::string{});
    for (std::string word; words >> word;)
    {
        const auto byte = (word.size() == 2U) ? cia306::ParseUnsigned("0x" + word, 0xFFU) : std::nullopt;
        if (!byte || data.size() == kMost)
        {
            value->Refuse(runtime::Shown(word), "up to 8 bytes of two hexadecimal digits");
        }
        data.push_back(static_cast<std::uint8_t>(*byte));
    }
    return data;
}

/// What only storms and frames of somebody else have.
void ReadFrames(Fields& fields, const Scenario& scenario, Action& action)
{
    const auto every = fields.Find("every");
    const auto until = fields.Find("until");
    if (action.kind == ActionKind::kSend && every.has_value() != until.has_value())
    {
        (every ? every : until)->Refuse("one of 'every' and 'until'", "both, or neither for a single frame");
    }
    action.every = 1;
    fields.Into("every", action.every);
    action.until = action.at;
    fields.Into("until", action.until);
    if (action.kind == ActionKind::kEmcyStorm)
    {
        action.node_id = NodeIdNamed(scenario, fields.Require("node"));
        fields.Into("code", action.code);
    }
    else
    {
        fields.Into("identifier", action.identifier);
    }
    action.data = (action.kind == ActionKind::kSend) ? DataOf(fields.Find("data")) : action.data;
}

void ReadOfManager(Fields& fields, Action& action)
{
    fields.Into("node", action.node_id);
    fields.Into("until", action.until);
    if (action.kind == ActionKind::kOrder)
    {
        const YamlValue order = fields.Require("order");
        action.order = order.Text("an order such as start 33");
        action.order_source = order.Where();
    }
}

void ReadOfDevice(Fields& fields, const Scenario& scenario, Action& action)
{
    action.node = NodeNamed(scenario, fields.Require("node"));
    fields.Into("serial", action.serial);
    fields.Into("object", action.object);
    fields.Into("value", action.value);
    fields.Into("srdo", action.srdo);
}

/// "0x1018:4" and "0x1018:04" are one object.
std::string ObjectIn(const YamlValue& value)
{
    const std::string text = value.Text("an object such as 0x1018:04, or none");
    return (text == "none") ? text : ObjectText(value.Object());
}

/// Numbers of events of the election with one space between them.
std::string FlyingEventsIn(const YamlValue& value)
{
    constexpr std::uint64_t kLastEvent = 5U;
    const std::string expected = "none, or numbers from 1 to 5 such as 3 4";
    std::istringstream words(value.Text(expected));
    std::string events;
    for (std::string word; words >> word;)
    {
        const auto number = cia306::ParseUnsigned(word, kLastEvent);
        const bool is_none = word == "none" && events.empty() && words.peek() == std::istringstream::traits_type::eof();
        if (!is_none && (!number || *number == 0U))
        {
            value.Refuse(runtime::Shown(word), expected);
        }
        events += (events.empty() ? "" : " ") + (is_none ? word : std::to_string(*number));
    }
    if (events.empty())
    {
        value.Refuse("no word", expected);
    }
    return events;
}
} // namespace

void ReadManager(Fields& fields, const Scenario& /*scenario*/, ManagerSetup& manager)
{
    const YamlValue network = fields.Require("network");
    manager.network = Beside(network.FileName(), network.Node().scalar);
    RequireFile(manager.network, network.Where(), "a network file");
    fields.Into("node", manager.node_id);
    fields.Into("at", manager.at);
}

void ReadAction(Fields& fields, const Scenario& scenario, Action& action)
{
    action.kind = fields.Require("do").Choice(kActionWords);
    fields.Into("at", action.at);
    action.is_of_profile = IsOfProfile(fields, scenario);
    fields.Extend((kActionPrefix + std::string(NameOf(kActionWords, action.kind))).c_str());
    if (IsStorm(action.kind))
    {
        ReadFrames(fields, scenario, action);
    }
    else if (IsOfManager(action.kind))
    {
        ReadOfManager(fields, action);
    }
    else
    {
        ReadOfDevice(fields, scenario, action);
    }
}

void AddReturns(std::vector<Action>& actions)
{
    std::vector<Action> returns;
    for (const Action& action : actions)
    {
        if (action.kind == ActionKind::kBusOff || action.kind == ActionKind::kNoController)
        {
            returns.push_back(action);
            returns.back().kind = ActionKind::kBusBack;
            returns.back().at = action.until;
        }
    }
    actions.insert(actions.end(), returns.begin(), returns.end());
}

void ReadOfNetwork(Fields& fields, const Scenario& scenario, Expectation& expectation)
{
    const auto node = fields.Find("node");
    if (IsOfManager(expectation.kind))
    {
        expectation.node_id = node ? NodeIdNamed(scenario, *node) : std::uint8_t{0U};
        fields.Into("manager", expectation.manager);
    }
    else
    {
        expectation.node = NodeNamed(scenario, *node);
        fields.Into("srdo", expectation.srdo);
    }
    const YamlValue is = fields.Require("is");
    expectation.is = (expectation.kind == ExpectationKind::kFinding)  ? ObjectIn(is)
                     : (expectation.kind == ExpectationKind::kFlying) ? FlyingEventsIn(is)
                                                                      : is.Text("a word");
    expectation.at = kNever;
    fields.Into("from", expectation.from);
    fields.Into(IsOfEvents(expectation.kind) ? "until" : "at", expectation.at);
}
} // namespace counterpoint::simulator
