// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/manager/report/status.hpp"

#include "canopen/cia306/text/column.hpp"
#include "canopen/cia306/text/input_error.hpp"
#include "runtime/manager/report/journal.hpp"
#include "runtime/manager/report/texts.hpp"

#include <algorithm>
#include <array>

namespace counterpoint::runtime
{
namespace
{
using cia302::NodeId;

constexpr std::uint32_t kUsPerMs = 1000U;
constexpr std::size_t kNameWidth = 20U;
constexpr std::uint64_t kFreshUs = 1000000U; ///< So long what an unsupervised node said is its state.

std::string MsText(const std::uint64_t age_us)
{
    return std::to_string(age_us / kUsPerMs) + " ms";
}

std::uint64_t AgeUs(const ManagerStation& station, const NodeId node, const std::uint64_t now_us)
{
    const std::uint64_t sign_us = station.LastSignUs(node);
    return (now_us > sign_us) ? now_us - sign_us : 0U;
}

/// As last heard. Silence of a node that nobody supervises is told by nobody: what it said once is its state for a
/// while only, and as long as its start-up runs, which misses its answers. [SRS_MGR_081]
std::string StateText(const ManagerStation& station, const NodeId node, const std::uint64_t now_us)
{
    const ManagerAssembly& assembly = station.Assembly();
    const cia302::NodeRecord& record = assembly.Core().Table().Record(node);
    const std::uint64_t consumer_us =
        std::uint64_t{kUsPerMs} * assembly.Net().Setup().Slave(node).heartbeat.consumer_ms;
    const bool is_supervised = record.watch != cia302::Watch::kNone || assembly.Core().Status(node).is_busy;
    const bool is_fresh = AgeUs(station, node, now_us) <= std::max(kFreshUs, consumer_us);
    const bool is_known = is_supervised || is_fresh || record.state == cia302::SlaveState::kMissing;
    return WordOf(is_known ? record.state : cia302::SlaveState::kUnknown);
}

std::string ResultOf(const network_plan::StartProfile profile, const cia302::NodeStatus& status)
{
    const std::string letter = (status.letter == 0) ? "" : std::string(1U, status.letter);
    return (profile == network_plan::StartProfile::kCia302) ? letter : std::to_string(status.code);
}

/// As in all texts of the manager.
std::string UpperOf(const cia302::SlaveState state)
{
    return (state == cia302::SlaveState::kStopped) ? "STOPPED" : "PRE-OPERATIONAL";
}

std::string FaultText(const std::uint16_t code)
{
    return "device fault: emergency " + cia306::Hex(code, 4) + ", expected its end or a restart of the device";
}

/// A slave that was told to start and sends no heartbeat, behind the time in which one is due. Supervision began with
/// its start, or before; that counter comes round, the age of the last sign does not. [SRS_MGR_082]
std::string SilenceText(const ManagerStation& station, const NodeId node, const std::uint64_t now_us)
{
    constexpr std::uint64_t kLongUs = 600000000U; ///< Longer than any start-up, shorter than the counter.
    const cia302::NodeRecord& record = station.Assembly().Core().Table().Record(node);
    const std::uint32_t waited_us = static_cast<std::uint32_t>(now_us) - record.since.us;
    const std::uint64_t age_us = AgeUs(station, node, now_us);
    const bool is_over = age_us > record.time_us && (waited_us > record.time_us || age_us > kLongUs);
    return (station.Assembly().IsUnheard(node) && is_over)
               ? "no heartbeat since its start, expected one each " + MsText(record.time_us) + " at least"
               : "";
}

/// A slave that was started, and is not OPERATIONAL by what it says, or by what somebody else told it last. NodeState
/// of el6751 says that by itself. [SRS_MGR_523]
std::string NotRunningText(const ManagerAssembly& assembly, const NodeId node)
{
    using cia302::SlaveState;
    const cia302::NodeTable& table = assembly.Core().Table();
    const cia302::NodeRecord& record = table.Record(node);
    const cia302::NodeStatus status = assembly.Core().Status(node);
    const bool is_el6751 = assembly.Net().Plan().manager.profile == network_plan::StartProfile::kEl6751;
    const bool is_under_way = status.is_busy || assembly.Core().Role().Commands().IsStarting(node);
    const bool is_started = status.is_started && !is_under_way && !(is_el6751 && status.code != 0);
    const bool is_other = record.state == SlaveState::kPreOperational || record.state == SlaveState::kStopped;
    const bool is_said = is_other && !record.is_presumed && record.asked != SlaveState::kOperational;
    std::string text;
    if (is_started && (is_said || cia302::DeniesStart(table, node)))
    {
        text = "started, but says " + UpperOf(record.state);
    }
    else if (is_started && cia302::HasLeft(table, node))
    {
        text = "started, but told by somebody else to be " + UpperOf(record.asked);
    }
    return text;
}

/// Two findings, of which each may be empty.
std::string Both(const std::string& first, const std::string& second)
{
    return first + (first.empty() || second.empty() ? "" : "; ") + second;
}

std::string EmergencyText(const cia302::EmergencyRecord& emergency)
{
    return (emergency.count == 0U) ? "" : cia306::Hex(emergency.code, 4) + " (" + std::to_string(emergency.count) + ")";
}

StatusRow RowOf(const ManagerStation& station, const network_plan::LoadedSlave& slave, const std::uint64_t now_us)
{
    const ManagerAssembly& assembly = station.Assembly();
    const NodeId node{slave.plan.node};
    const cia302::Manager& manager = assembly.Core();
    const cia302::NodeStatus status = manager.Status(node);
    const network_plan::StartProfile profile = assembly.Net().Plan().manager.profile;
    const bool is_safety = assembly.Net().Setup().IsSafetySlave(node);
    StatusRow row;
    row.node = node.value;
    row.name = slave.plan.name;
    row.state = StateText(station, node, now_us);
    row.age = manager.Table().Record(node).was_seen ? MsText(AgeUs(station, node, now_us)) : "-";
    row.result = ResultOf(profile, status);
    row.step = WordOf(status.step);
    row.emergency = EmergencyText(manager.Watched().Of(node).emergency);
    row.safety = is_safety ? WordOf(manager.Gate().State(node)) : "";
    const bool is_refused = is_safety && (manager.Gate().State(node) == cia302::GateState::kDiffers ||
                                          manager.Gate().State(node) == cia302::GateState::kFailed);
    row.finding =
        is_refused ? "safety configuration: " + FindingText(manager.Gate().Finding(node)) : ResultText(profile, status);
    const std::uint16_t fault = is_safety ? manager.Watched().Of(node).fault : std::uint16_t{0U};
    row.finding = manager.Watched().Of(node).is_duplicate ? "two devices with this node-ID?" : row.finding;
    row.finding = Both(NotRunningText(assembly, node), row.finding);
    row.finding = Both(SilenceText(station, node, now_us), row.finding);
    row.finding = Both((fault != 0U) ? FaultText(fault) : "", row.finding);
    row.is_good = assembly.IsGood(node);
    return row;
}

/// Who is heard on the bus and is no slave.
std::vector<NodeId> UnlistedNodes(const ManagerAssembly& assembly)
{
    std::vector<NodeId> nodes;
    for (std::uint8_t id = 1U; id <= cia302::kLastNode; ++id)
    {
        const NodeId node{id};
        const bool is_ours = assembly.Net().Setup().IsListed(node) || id == assembly.Net().Setup().own.value;
        if (assembly.Core().Table().Record(node).was_seen && !is_ours)
        {
            nodes.push_back(node);
        }
    }
    return nodes;
}

/// And two spaces to the next one.
std::string Column(const std::string& text, const std::size_t width)
{
    return cia306::Column(text, width) + "  ";
}

std::string Line(const std::array<std::string, 9U>& cells)
{
    constexpr std::array<std::size_t, 9U> kWidths{4U, kNameWidth, 15U, 6U, 18U, 10U, 12U, 8U, 0U};
    std::string line;
    for (std::size_t cell = 0U; cell < cells.size(); ++cell)
    {
        line += (kWidths.at(cell) == 0U) ? cells.at(cell) : Column(cells.at(cell), kWidths.at(cell));
    }
    line.erase(line.find_last_not_of(' ') + 1U);
    return line + "\n";
}
} // namespace

std::vector<StatusRow> StatusRows(const ManagerStation& station, const std::uint64_t now_us)
{
    std::vector<StatusRow> rows;
    for (const auto& slave : station.Assembly().Net().Slaves())
    {
        rows.push_back(RowOf(station, *slave, now_us));
    }
    std::sort(rows.begin(), rows.end(),
              [](const StatusRow& left, const StatusRow& right) { return left.node < right.node; });
    return rows;
}

std::string UnlistedText(const ManagerStation& station, const std::uint64_t now_us)
{
    std::string text;
    for (const NodeId node : UnlistedNodes(station.Assembly()))
    {
        text += (text.empty() ? "not in the network list (A): node " : ", node ") + std::to_string(node.value) + " " +
                StateText(station, node, now_us);
    }
    return text;
}

std::string ManagerLine(const ManagerAssembly& assembly)
{
    const cia302::Manager& manager = assembly.Core();
    const network_plan::StartProfile profile = assembly.Net().Plan().manager.profile;
    std::string role = manager.IsActive() ? "active master" : "not the active master";
    if (manager.Role().Flying() != nullptr && manager.Role().Flying()->Master().node.value != 0U && !manager.IsActive())
    {
        role += " (that is node " + std::to_string(manager.Role().Flying()->Master().node.value) + ")";
    }
    const std::string twice = assembly.HasDouble() ? "; another device has its node-ID, expected one and a reset" : "";
    return "manager, node " + std::to_string(assembly.Net().Setup().own.value) + ": " + WordOf(manager.OwnState()) +
           ", " + role + ", profile " + WordOf(profile) + ", " + MasterText(profile, manager.MasterState()) + twice;
}

/// Who looks at a value wants to know how old it is.
std::string AgeOf(const PdoValue& value, const std::uint64_t now_us)
{
    return value.is_output ? "" : MsText(now_us - value.at_us);
}

std::string PdoTable(const ManagerPdos& pdos, const std::uint64_t now_us)
{
    std::string table;
    for (const PdoValue& value : pdos.Values())
    {
        const std::string shown = value.was_seen ? BytesText(value.bytes) : "-";
        table += Column(std::to_string(value.node), 4U) + Column(NameOf(value), 10U) + Column(shown, 24U) +
                 (value.was_seen ? AgeOf(value, now_us) : "");
        table.erase(table.find_last_not_of(' ') + 1U);
        table += "\n";
    }
    return table.empty() ? "" : "\nnode  PDO         value                     age\n" + table;
}

std::string StatusTable(const ManagerStation& station, const std::uint64_t now_us)
{
    const ManagerAssembly& assembly = station.Assembly();
    std::string table = ManagerLine(assembly) + "\n";
    table += Line({"node", "name", "state", "result", "step", "heartbeat", "emergency", "safety", "finding"});
    for (const StatusRow& row : StatusRows(station, now_us))
    {
        table += Line({std::to_string(row.node), row.name, row.state, row.result, row.step, row.age, row.emergency,
                       row.safety, row.finding});
    }
    const std::string unlisted = UnlistedText(station, now_us);
    return table + unlisted + (unlisted.empty() ? "" : "\n") + PdoTable(station.Pdos(), now_us);
}

/// In milliseconds; null where there is none.
nlohmann::ordered_json AgeJson(const bool is_known, const std::uint64_t age_us)
{
    return is_known ? nlohmann::ordered_json(age_us / kUsPerMs) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json PdosJson(const ManagerPdos& pdos, const std::uint64_t now_us)
{
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const PdoValue& value : pdos.Values())
    {
        rows.push_back({{"node", value.node},
                        {"pdo", NameOf(value)},
                        {"data", value.was_seen ? BytesText(value.bytes) : ""},
                        {"age_ms", AgeJson(value.was_seen && !value.is_output, now_us - value.at_us)}});
    }
    return rows;
}

nlohmann::ordered_json StatusJson(const ManagerStation& station, const std::uint64_t now_us)
{
    const ManagerAssembly& assembly = station.Assembly();
    nlohmann::ordered_json slaves = nlohmann::ordered_json::array();
    for (const StatusRow& row : StatusRows(station, now_us))
    {
        const NodeId node{row.node};
        const cia302::NodeStatus status = assembly.Core().Status(node);
        const bool was_seen = assembly.Core().Table().Record(node).was_seen;
        const cia302::EmergencyRecord& emergency = assembly.Core().Watched().Of(node).emergency;
        slaves.push_back({{"node", row.node},
                          {"name", row.name},
                          {"state", row.state},
                          {"letter", (status.letter == 0) ? "" : std::string(1U, status.letter)},
                          {"code", status.code},
                          {"step", row.step},
                          {"heartbeat_age_ms", AgeJson(was_seen, AgeUs(station, node, now_us))},
                          {"emergency_code", emergency.code},
                          {"emergency_count", emergency.count},
                          {"safety", row.safety},
                          {"finding", row.finding},
                          {"good", row.is_good}});
    }
    nlohmann::ordered_json unlisted = nlohmann::ordered_json::array();
    for (const NodeId node : UnlistedNodes(assembly))
    {
        unlisted.push_back({{"node", node.value},
                            {"state", StateText(station, node, now_us)},
                            {"heartbeat_age_ms", AgeJson(true, AgeUs(station, node, now_us))}});
    }
    const cia302::Manager& manager = assembly.Core();
    return {{"format", kManagerFormat},
            {"event", "table"},
            {"manager", assembly.Net().Setup().own.value},
            {"state", WordOf(manager.OwnState())},
            {"active", manager.IsActive()},
            {"duplicate", assembly.HasDouble()},
            {"profile", WordOf(assembly.Net().Plan().manager.profile)},
            {"master_state", manager.MasterState()},
            {"slaves", slaves},
            {"unlisted", unlisted},
            {"pdos", PdosJson(station.Pdos(), now_us)}};
}
} // namespace counterpoint::runtime
