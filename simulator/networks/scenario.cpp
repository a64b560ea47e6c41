// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/networks/scenario.hpp"

#include "canopen/cia306/text/input_error.hpp"
#include "canopen/cia306/text/number.hpp"
#include "canopen/network/cpj_reader.hpp"
#include "hal/host/virtual/bit_rate.hpp"
#include "runtime/manager/order.hpp"
#include "simulator/scenario/fields.hpp"
#include "simulator/scenario/names.hpp"

#include <optional>
#include <sstream>

namespace counterpoint::simulator
{
namespace
{
using simulator::Fields;
using Action = NetworkActionKind;
using Expected = NetworkExpectationKind;

std::uint64_t TimeOf(const std::optional<YamlValue>& value, const std::uint64_t otherwise)
{
    return value ? static_cast<std::uint64_t>(value->Duration()) : otherwise;
}

/// The schema has checked its range.
template <typename Number> Number NumberOf(const std::optional<YamlValue>& value, const Number otherwise)
{
    return value ? static_cast<Number>(value->Checked()) : otherwise;
}

std::string FileOf(const YamlValue& value, const std::string& expected)
{
    const std::string path = network::BesideFile(value.FileName(), value.Text("a file name"));
    const std::string problem = network::ProblemOfFile(path);
    if (!problem.empty())
    {
        value.Refuse(problem, expected);
    }
    return path;
}

ScenarioManager ReadManager(const YamlValue& value)
{
    Fields fields(value, "network.managers");
    ScenarioManager manager;
    manager.place = value.Where().place;
    manager.network = FileOf(fields.Require("network"), "a network file");
    manager.node = NumberOf<std::uint8_t>(fields.Find("node"), 0U);
    manager.at_ns = TimeOf(fields.Require("at"), 0U);
    fields.Close();
    return manager;
}

ScenarioDevice ReadDevice(const YamlValue& value)
{
    Fields fields(value, "network.devices");
    ScenarioDevice device;
    device.place = value.Where().place;
    device.node = NumberOf<std::uint8_t>(fields.Require("node"), 0U);
    device.dcf = FileOf(fields.Require("dcf"), "a DCF");
    device.at_ns = TimeOf(fields.Require("at"), 0U);
    if (const auto serial = fields.Find("serial"))
    {
        device.serial = serial->Checked();
    }
    fields.Close();
    return device;
}

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

/// One that acts: what only asks has nobody here to read the answer.
std::string OrderOf(const YamlValue& value)
{
    const std::string text = value.Text("an order such as start 33");
    const runtime::ManagerOrder parsed = runtime::ParseManagerOrder(text);
    if (parsed.kind == runtime::ManagerOrderKind::kProblem)
    {
        const std::string expected = ", expected ";
        const std::size_t comma = parsed.problem.find(expected);
        value.Refuse(parsed.problem.substr(0U, comma), parsed.problem.substr(comma + expected.size()));
    }
    const bool is_idle =
        parsed.kind == runtime::ManagerOrderKind::kNothing || parsed.kind == runtime::ManagerOrderKind::kStatus ||
        parsed.kind == runtime::ManagerOrderKind::kHelp || parsed.kind == runtime::ManagerOrderKind::kQuit;
    if (is_idle)
    {
        value.Refuse("order " + runtime::Shown(text) + ", which does nothing here", "an order such as start 33");
    }
    return text;
}

/// What only storms and frames of somebody else have.
void ReadFrames(Fields& fields, NetworkAction& action)
{
    const auto every = fields.Find("every");
    const auto until = fields.Find("until");
    if (action.kind == Action::kSend && every.has_value() != until.has_value())
    {
        (every ? every : until)->Refuse("one of 'every' and 'until'", "both, or neither for a single frame");
    }
    action.every_ns = TimeOf(every, 1U);
    action.until_ns = TimeOf(until, action.at_ns);
    if (action.kind == Action::kEmcyStorm)
    {
        action.node = NumberOf<std::uint8_t>(fields.Require("node"), 0U);
        action.code = NumberOf<std::uint16_t>(fields.Require("code"), 0U);
    }
    else
    {
        action.identifier = NumberOf<std::uint32_t>(fields.Require("identifier"), 0U);
    }
    action.data = (action.kind == Action::kSend) ? DataOf(fields.Find("data")) : action.data;
}

void ReadContent(Fields& fields, NetworkAction& action)
{
    if (IsStorm(action.kind))
    {
        ReadFrames(fields, action);
        return;
    }
    action.node = NumberOf<std::uint8_t>(fields.Find("node"), 0U);
    if (action.kind == Action::kBusOff || action.kind == Action::kNoController)
    {
        action.until_ns = TimeOf(fields.Require("until"), action.at_ns);
    }
    if (action.kind == Action::kReplace)
    {
        action.serial = fields.Require("serial").Checked();
    }
    if (action.kind == Action::kStore)
    {
        action.object = fields.Require("object").Object();
        action.value = fields.Require("value").Checked();
    }
    if (action.kind == Action::kAcknowledge)
    {
        action.srdo = NumberOf<std::uint8_t>(fields.Require("srdo"), 0U);
    }
    if (action.kind == Action::kOrder)
    {
        action.order = OrderOf(fields.Require("order"));
    }
}

NetworkAction ReadAction(const YamlValue& value)
{
    Fields fields(value, "network.events");
    NetworkAction action;
    action.place = value.Where().place;
    action.kind = fields.Require("do").Choice(simulator::kNetworkActionWords);
    action.at_ns = TimeOf(fields.Require("at"), 0U);
    const std::string section =
        std::string(simulator::kNetworkPrefix) + NameOf(simulator::kNetworkActionWords, action.kind);
    fields.Extend(section.c_str());
    ReadContent(fields, action);
    fields.Close();
    return action;
}

/// "0x1018:4" and "0x1018:04" are one object.
std::string ObjectIn(const YamlValue& value)
{
    const std::string text = value.Text("an object such as 0x1018:04, or none");
    if (text == "none")
    {
        return text;
    }
    const ObjectAddress object = value.Object();
    return cia306::ObjectName(object.index, object.sub);
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

std::string FoundIn(const YamlValue& value, const Expected kind)
{
    std::string text = value.Text("a word");
    text = (kind == Expected::kFinding) ? ObjectIn(value) : text;
    return (kind == Expected::kFlying) ? FlyingEventsIn(value) : text;
}

NetworkExpectation ReadExpectation(const YamlValue& value, const std::uint64_t end_ns)
{
    Fields fields(value, "network.expect");
    NetworkExpectation expectation;
    expectation.place = value.Where().place;
    expectation.kind = fields.Require("that").Choice(simulator::kNetworkExpectationWords);
    const std::string section =
        std::string(simulator::kNetworkPrefix) + NameOf(simulator::kNetworkExpectationWords, expectation.kind);
    fields.Extend(section.c_str());
    const bool is_event = expectation.kind == Expected::kEvent || expectation.kind == Expected::kNoEvent;
    expectation.node = NumberOf<std::uint8_t>(fields.Find("node"), 0U);
    expectation.manager = NumberOf<std::uint8_t>(fields.Find("manager"), 0U);
    expectation.srdo = NumberOf<std::uint8_t>(fields.Find("srdo"), 0U);
    expectation.is = FoundIn(fields.Require("is"), expectation.kind);
    expectation.from_ns = is_event ? TimeOf(fields.Require("from"), 0U) : 0U;
    expectation.at_ns = TimeOf(fields.Find(is_event ? "until" : "at"), end_ns);
    fields.Close();
    if (expectation.at_ns > end_ns)
    {
        value.Refuse("a time after the end of the scenario", "one within its duration");
    }
    return expectation;
}

/// A controller that comes back is an action of its own.
void AddReturns(std::vector<NetworkAction>& actions)
{
    std::vector<NetworkAction> returns;
    for (const NetworkAction& action : actions)
    {
        if (action.kind == Action::kBusOff || action.kind == Action::kNoController)
        {
            returns.push_back(action);
            returns.back().kind = Action::kBusBack;
            returns.back().at_ns = action.until_ns;
        }
    }
    actions.insert(actions.end(), returns.begin(), returns.end());
}

std::uint32_t BitRateOf(const YamlValue& value)
{
    const std::uint32_t rate = value.Checked();
    if (!host::BitRateFrom(rate))
    {
        value.Refuse(std::to_string(rate), "10000, 20000, 50000, 100000, 125000, 250000, 500000, 800000 or 1000000");
    }
    return rate;
}

std::vector<YamlValue> ListOf(Fields& fields, const char* const key)
{
    const auto value = fields.Find(key);
    return value ? value->Items("a list") : std::vector<YamlValue>{};
}
} // namespace

bool IsOfManager(const NetworkActionKind kind) noexcept
{
    return kind == Action::kOrder || kind == Action::kKillManager || kind == Action::kBusOff ||
           kind == Action::kNoController || kind == Action::kBusBack;
}

bool IsStorm(const NetworkActionKind kind) noexcept
{
    return kind == Action::kEmcyStorm || kind == Action::kBabble || kind == Action::kSend;
}

bool IsNetworkScenario(const std::string& path)
{
    const runtime::YamlNode document = runtime::ParseYaml(path, runtime::ReadYamlText(path));
    bool is_one = false;
    for (std::size_t place = 0U; place + 1U < document.items.size(); place += 2U)
    {
        is_one = is_one || (document.kind == runtime::YamlKind::kMap && document.items[place].scalar == "managers");
    }
    return is_one;
}

NetworkScenario ReadNetworkScenario(const std::string& path)
{
    const runtime::YamlNode document = runtime::ParseYaml(path, runtime::ReadYamlText(path));
    Fields fields(YamlValue(path, document), "network");
    NetworkScenario scenario;
    scenario.file = path;
    scenario.title = fields.Require("title").Text("a text");
    const auto description = fields.Find("description");
    scenario.description = description ? description->Paragraph("a text") : "";
    scenario.bitrate = BitRateOf(fields.Require("bitrate"));
    scenario.duration_ns = static_cast<std::uint64_t>(fields.Require("duration").Lasting());
    const YamlValue managers = fields.Require("managers");
    for (const YamlValue& manager : managers.Items("a list of managers"))
    {
        scenario.managers.push_back(ReadManager(manager));
    }
    if (scenario.managers.empty())
    {
        managers.Refuse("an empty list of managers", "at least one");
    }
    for (const YamlValue& device : ListOf(fields, "devices"))
    {
        scenario.devices.push_back(ReadDevice(device));
    }
    for (const YamlValue& action : ListOf(fields, "events"))
    {
        scenario.actions.push_back(ReadAction(action));
    }
    for (const YamlValue& expectation : ListOf(fields, "expect"))
    {
        scenario.expectations.push_back(ReadExpectation(expectation, scenario.duration_ns));
    }
    fields.Close();
    RequireSense(scenario);
    AddReturns(scenario.actions);
    return scenario;
}
} // namespace counterpoint::simulator
