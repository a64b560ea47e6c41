// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/network_scenario.hpp"

#include "canopen/cia306/number.hpp"
#include "canopen/network/cpj_reader.hpp"
#include "hal/host/bit_rate.hpp"
#include "tools/manager_order.hpp"
#include "tools/yaml_map.hpp"

#include <filesystem>
#include <limits>
#include <sstream>

namespace counterpoint::tools
{
namespace
{
using simulator::ScenarioValue;
using simulator::Word;
using Action = NetworkActionKind;
using Expected = NetworkExpectationKind;

constexpr std::uint64_t kHighestNode = 127U;
constexpr std::uint64_t kHighestNumber = std::numeric_limits<std::uint32_t>::max();

constexpr Word<Action> kActionWords[] = {{"pull", Action::kPull},
                                         {"insert", Action::kInsert},
                                         {"reset", Action::kReset},
                                         {"replace", Action::kReplace},
                                         {"duplicate", Action::kDuplicate},
                                         {"emcy_storm", Action::kEmcyStorm},
                                         {"babble", Action::kBabble},
                                         {"order", Action::kOrder},
                                         {"kill_manager", Action::kKillManager},
                                         {"store", Action::kStore},
                                         {"acknowledge", Action::kAcknowledge},
                                         {"send", Action::kSend},
                                         {"bus_off", Action::kBusOff},
                                         {"no_controller", Action::kNoController}};
constexpr Word<Expected> kExpectedWords[] = {
    {"state", Expected::kState},   {"device", Expected::kDevice}, {"letter", Expected::kLetter},
    {"code", Expected::kCode},     {"gate", Expected::kGate},     {"finding", Expected::kFinding},
    {"output", Expected::kOutput}, {"event", Expected::kEvent},   {"no_event", Expected::kNoEvent},
    {"active", Expected::kActive}, {"flying", Expected::kFlying}};

std::uint64_t TimeIn(const YamlMap& map, const char* key, const std::uint64_t otherwise)
{
    const auto value = map.Find(key);
    return value ? static_cast<std::uint64_t>(value->Duration()) : otherwise;
}

std::uint64_t NumberIn(const YamlMap& map, const char* key, const std::uint64_t lowest, const std::uint64_t highest,
                       const std::uint64_t otherwise)
{
    const auto value = map.Find(key);
    return value ? value->Number({lowest, highest}) : otherwise;
}

std::string FileIn(const std::string& file, const YamlMap& map, const char* key)
{
    const ScenarioValue value = map.Require(key);
    const std::string path = network::BesideFile(file, value.Text("a file name"));
    if (!std::filesystem::exists(path))
    {
        value.Refuse("there is no file " + simulator::Shown(path), "one of the scenario");
    }
    return path;
}

ScenarioManager ReadManager(const std::string& file, const ScenarioValue& value)
{
    const YamlMap map(file, value.Node(), {"network", "node", "at"});
    return {FileIn(file, map, "network"), static_cast<std::uint8_t>(NumberIn(map, "node", 1U, kHighestNode, 0U)),
            TimeIn(map, "at", 0U), value.Where().place};
}

ScenarioDevice ReadDevice(const std::string& file, const ScenarioValue& value)
{
    const YamlMap map(file, value.Node(), {"node", "dcf", "serial", "at"});
    ScenarioDevice device;
    device.place = value.Where().place;
    device.node = static_cast<std::uint8_t>(map.Require("node").Number({1U, kHighestNode}));
    device.dcf = FileIn(file, map, "dcf");
    device.at_ns = TimeIn(map, "at", 0U);
    if (const auto serial = map.Find("serial"))
    {
        device.serial = static_cast<std::uint32_t>(serial->Number({0U, kHighestNumber}));
    }
    return device;
}

/// "01 21": up to 8 bytes in hexadecimal.
std::vector<std::uint8_t> DataIn(const YamlMap& map)
{
    constexpr std::size_t kMost = 8U;
    std::vector<std::uint8_t> data;
    if (const auto value = map.Find("data"))
    {
        std::istringstream words(value->Text("bytes such as 01 21"));
        for (std::string word; words >> word;)
        {
            const auto byte = (word.size() == 2U) ? cia306::ParseUnsigned("0x" + word, 0xFFU) : std::nullopt;
            if (!byte || data.size() == kMost)
            {
                value->Refuse(simulator::Shown(word), "up to 8 bytes of two hexadecimal digits");
            }
            data.push_back(static_cast<std::uint8_t>(*byte));
        }
    }
    return data;
}

/// What only some actions have.
void ReadMore(const YamlMap& map, NetworkAction& action)
{
    constexpr std::uint64_t kHighestIdentifier = 0x7FFU;
    constexpr std::uint64_t kMillisecondNs = 1000000U;
    constexpr std::uint64_t kUsualCode = 0x1000U;
    action.until_ns = TimeIn(map, "until", action.at_ns);
    const auto every = map.Find("every");
    action.every_ns = every ? static_cast<std::uint64_t>(every->Lasting()) : kMillisecondNs;
    action.serial = static_cast<std::uint32_t>(NumberIn(map, "serial", 0U, kHighestNumber, 0U));
    action.identifier = static_cast<std::uint32_t>(NumberIn(map, "identifier", 0U, kHighestIdentifier, 0U));
    action.code = static_cast<std::uint16_t>(NumberIn(map, "code", 0U, 0xFFFFU, kUsualCode));
    action.value = static_cast<std::uint32_t>(NumberIn(map, "value", 0U, kHighestNumber, 0U));
    action.srdo = static_cast<std::uint8_t>(NumberIn(map, "srdo", 1U, 64U, 1U));
    action.data = DataIn(map);
    if (const auto object = map.Find("object"))
    {
        action.object = object->Object();
    }
    if (const auto order = map.Find("order"))
    {
        action.order = order->Text("an order such as start 33");
        const ManagerOrder parsed = ParseManagerOrder(action.order);
        if (parsed.kind == ManagerOrderKind::kProblem)
        {
            const std::size_t comma = parsed.problem.find(", expected ");
            order->Refuse(parsed.problem.substr(0U, comma), parsed.problem.substr(comma + 11U));
        }
    }
}

NetworkAction ReadAction(const std::string& file, const ScenarioValue& value)
{
    const YamlMap map(file, value.Node(),
                      {"at", "do", "node", "until", "every", "serial", "identifier", "code", "order", "object", "value",
                       "srdo", "data"});
    NetworkAction action;
    action.place = value.Where().place;
    action.kind = map.Require("do").Choice(kActionWords);
    action.at_ns = static_cast<std::uint64_t>(map.Require("at").Duration());
    const bool is_bus = action.kind == Action::kBusOff || action.kind == Action::kNoController;
    const bool is_frame = action.kind == Action::kBabble || action.kind == Action::kSend;
    const bool needs_node = !is_frame && !is_bus && action.kind != Action::kOrder;
    action.node = needs_node ? static_cast<std::uint8_t>(map.Require("node").Number({1U, kHighestNode}))
                             : static_cast<std::uint8_t>(NumberIn(map, "node", 1U, kHighestNode, 0U));
    const bool needs_until = is_bus || action.kind == Action::kBabble || action.kind == Action::kEmcyStorm;
    static_cast<void>(needs_until ? map.Require("until") : map.Require("at"));
    static_cast<void>((action.kind == Action::kOrder) ? map.Require("order") : map.Require("at"));
    static_cast<void>((action.kind == Action::kSend) ? map.Require("identifier") : map.Require("at"));
    static_cast<void>((action.kind == Action::kStore) ? map.Require("object") : map.Require("at"));
    ReadMore(map, action);
    return action;
}

NetworkExpectation ReadExpectation(const std::string& file, const ScenarioValue& value, const std::uint64_t end_ns)
{
    const YamlMap map(file, value.Node(), {"that", "node", "manager", "srdo", "is", "at", "from", "until"});
    NetworkExpectation expectation;
    expectation.place = value.Where().place;
    expectation.kind = map.Require("that").Choice(kExpectedWords);
    const bool is_event = expectation.kind == Expected::kEvent || expectation.kind == Expected::kNoEvent;
    const bool is_of_manager = expectation.kind == Expected::kActive || expectation.kind == Expected::kFlying;
    expectation.node = (is_event || is_of_manager)
                           ? static_cast<std::uint8_t>(NumberIn(map, "node", 1U, kHighestNode, 0U))
                           : static_cast<std::uint8_t>(map.Require("node").Number({1U, kHighestNode}));
    expectation.manager = static_cast<std::uint8_t>(NumberIn(map, "manager", 1U, kHighestNode, 0U));
    expectation.srdo = static_cast<std::uint8_t>(NumberIn(map, "srdo", 1U, 64U, 1U));
    expectation.is = map.Require("is").Text("a word");
    expectation.from_ns = TimeIn(map, "from", 0U);
    expectation.at_ns = is_event ? TimeIn(map, "until", end_ns) : TimeIn(map, "at", end_ns);
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

std::uint32_t BitRateIn(const YamlMap& map)
{
    constexpr std::uint32_t kUsual = 500000U;
    const auto value = map.Find("bitrate");
    const std::uint64_t rate = value ? value->Number({0U, kHighestNumber}) : kUsual;
    if (!host::BitRateFrom(static_cast<std::uint32_t>(rate)))
    {
        value->Refuse(std::to_string(rate), "10000, 20000, 50000, 100000, 125000, 250000, 500000, 800000 or 1000000");
    }
    return static_cast<std::uint32_t>(rate);
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
    const simulator::YamlNode document = simulator::ParseYaml(path, simulator::ReadScenarioText(path));
    bool is_one = false;
    for (std::size_t place = 0U; place + 1U < document.items.size(); place += 2U)
    {
        is_one = is_one || (document.kind == simulator::YamlKind::kMap && document.items[place].scalar == "managers");
    }
    return is_one;
}

NetworkScenario ReadNetworkScenario(const std::string& path)
{
    const simulator::YamlNode document = simulator::ParseYaml(path, simulator::ReadScenarioText(path));
    const YamlMap map(path, document,
                      {"title", "description", "bitrate", "duration", "managers", "devices", "events", "expect"});
    NetworkScenario scenario;
    scenario.file = path;
    scenario.title = map.Require("title").Text("a text");
    const auto description = map.Find("description");
    scenario.description = description ? description->Paragraph("a text") : "";
    scenario.bitrate = BitRateIn(map);
    scenario.duration_ns = static_cast<std::uint64_t>(map.Require("duration").Lasting());
    for (const ScenarioValue& manager : map.Require("managers").Items("a list of managers"))
    {
        scenario.managers.push_back(ReadManager(path, manager));
    }
    const auto list = [&map](const char* key)
    { return map.Find(key) ? map.Find(key)->Items("a list") : std::vector<ScenarioValue>{}; };
    for (const ScenarioValue& device : list("devices"))
    {
        scenario.devices.push_back(ReadDevice(path, device));
    }
    for (const ScenarioValue& action : list("events"))
    {
        scenario.actions.push_back(ReadAction(path, action));
    }
    for (const ScenarioValue& expectation : list("expect"))
    {
        scenario.expectations.push_back(ReadExpectation(path, expectation, scenario.duration_ns));
    }
    RequireSense(scenario);
    AddReturns(scenario.actions);
    return scenario;
}
} // namespace counterpoint::tools
