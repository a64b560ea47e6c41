// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/manager/start_answer.hpp"

#include "runtime/manager/report/texts.hpp"

namespace counterpoint::runtime
{
namespace
{
using cia302::NodeId;
using cia302::SlaveState;
using network_plan::StartProfile;

StartProfile ProfileOf(const ManagerAssembly& assembly)
{
    return assembly.Net().Plan().manager.profile;
}

/// The start that an order is; kInvalid as command: it is none.
ManagerOrder StartIn(const ManagerOrder& order)
{
    constexpr std::uint16_t kNmt = 0x1F82U;
    constexpr std::uint8_t kAllSub = 0x80U;
    constexpr std::uint64_t kStart = 5U;
    constexpr std::uint64_t kStartOfEach = 0x85U;
    const bool is_command = order.kind == ManagerOrderKind::kCommand && order.command == cia302::NmtCommand::kStart;
    const bool is_of_each = order.value == kStartOfEach && order.object.sub == kAllSub;
    const bool is_set =
        order.kind == ManagerOrderKind::kSet && order.object.index == kNmt && (order.value == kStart || is_of_each);
    ManagerOrder start;
    start.command = (is_command || is_set) ? cia302::NmtCommand::kStart : cia302::NmtCommand::kInvalid;
    start.node = is_command ? order.node : order.object.sub;
    start.node = (is_set && order.object.sub == kAllSub) ? std::uint8_t{0U} : start.node;
    return start;
}

/// Whether this slave will not take the start.
bool IsLeftOut(const ManagerAssembly& assembly, const NodeId node)
{
    const cia302::NodeStatus status = assembly.Core().Status(node);
    const bool is_safety = assembly.Net().Setup().IsSafetySlave(node);
    bool is_left_out = is_safety && status.is_other; // One that can be asked is asked again.
    switch (ProfileOf(assembly))
    {
    case StartProfile::kPlcDesigner:
        is_left_out = status.code != cia302::kPlcConfigured && status.code != cia302::kPlcStarted &&
                      status.code != cia302::kPlcLost;
        break;
    case StartProfile::kCia302:
        is_left_out = is_left_out || assembly.Profile().IsLeftOut(node);
        break;
    case StartProfile::kEl6751:
    default:
        break;
    }
    return is_left_out;
}

/// Whether something is wrong with this slave, which is no safety slave, that its start-up found and an order does not
/// ask for. [SRS_ELM_520, SRS_PLC_587]
bool IsRefused(const ManagerAssembly& assembly, const NodeId node)
{
    const cia302::NodeStatus status = assembly.Core().Status(node);
    bool is_wrong = status.letter != 0 && status.letter != 'L';
    switch (ProfileOf(assembly))
    {
    case StartProfile::kEl6751:
        is_wrong = status.has_failed;
        break;
    case StartProfile::kPlcDesigner:
        is_wrong = status.abort != cia301::SdoAbort::kNone && !IsLeftOut(assembly, node);
        break;
    case StartProfile::kCia302:
    default:
        break;
    }
    return is_wrong && !assembly.Net().Setup().IsSafetySlave(node);
}

/// Whether a start changes nothing for this slave: it was started already and has not left OPERATIONAL since.
bool IsRunning(const ManagerAssembly& assembly, const NodeId node)
{
    constexpr auto kOperational = static_cast<std::uint8_t>(SlaveState::kOperational);
    return assembly.Core().Status(node).is_started && assembly.Core().Table().RequestValue(node) == kOperational;
}

/// Who takes the start though something is wrong with it. A start of its own is sent again to one that runs, but with
/// el6751.
std::vector<NamedSlave> DespiteWhat(const ManagerOrder& start, const ManagerAssembly& assembly)
{
    const StartProfile profile = ProfileOf(assembly);
    std::vector<NamedSlave> named;
    for (const auto& slave : assembly.Net().Slaves())
    {
        const NodeId node{slave->plan.node};
        const bool is_sent = !IsRunning(assembly, node) || (start.node != 0U && profile != StartProfile::kEl6751);
        const bool is_taken = start.node == node.value || (start.node == 0U && !IsLeftOut(assembly, node));
        const cia302::NodeStatus status = assembly.Core().Status(node);
        if (is_taken && is_sent && !status.is_busy && IsRefused(assembly, node))
        {
            named.push_back({node.value, "node " + std::to_string(node.value) + ": " + StatusText(profile, status)});
        }
    }
    return named;
}

/// Each slave that does not take the order, and why.
std::string LeftOut(const ManagerOrder& start, const ManagerAssembly& assembly, const bool is_by_state)
{
    const StartProfile profile = ProfileOf(assembly);
    std::string left_out;
    for (const auto& slave : assembly.Net().Slaves())
    {
        const NodeId node{slave->plan.node};
        const cia302::NodeStatus status = assembly.Core().Status(node);
        const std::string number = (left_out.empty() ? "node " : ", node ") + std::to_string(node.value);
        std::string reason = StatusText(profile, status);
        if (assembly.Net().Setup().IsSafetySlave(node) && status.is_other)
        {
            reason = "not known to be the expected device" + (reason.empty() ? "" : " (" + reason + ")");
        }
        const std::string code = std::to_string(status.code) + ": " + CodeText(profile, status.code);
        if ((start.node == 0U || start.node == node.value) && IsLeftOut(assembly, node))
        {
            left_out += number + (is_by_state ? " (" + code + ")" : ": " + reason);
        }
    }
    return left_out;
}

/// Whether this safety slave is not started because its node-ID may be that of two devices.
bool IsDoubted(const ManagerAssembly& assembly, const NodeId node)
{
    return assembly.Net().Setup().IsSafetySlave(node) && assembly.Core().Watched().Of(node).is_duplicate;
}

/// Behind the answer to a start: slaves of which nothing is heard. It went to them, too, and nobody can say that they
/// took it. [SRS_MGR_080]
std::string NotHeard(const ManagerOrder& start, const ManagerAssembly& assembly)
{
    const StartProfile profile = ProfileOf(assembly);
    std::string named;
    for (const auto& slave : assembly.Net().Slaves())
    {
        const NodeId node{slave->plan.node};
        const SlaveState state = assembly.Core().Table().Record(node).state;
        const cia302::NodeStatus status = assembly.Core().Status(node);
        const bool is_silent = state == SlaveState::kMissing || state == SlaveState::kUnknown;
        const bool is_meant = (start.node == 0U || start.node == node.value);
        const bool is_sent = !IsLeftOut(assembly, node) && !IsDoubted(assembly, node);
        if (is_meant && is_silent && !status.is_started && is_sent)
        {
            const std::string reason = StatusText(profile, status);
            named += (named.empty() ? "node " : ", node ") + std::to_string(node.value) + ": " +
                     (reason.empty() ? WordOf(status.step) : reason);
        }
    }
    return named.empty() ? named : "; nothing is heard of, so perhaps not started: " + named;
}

/// Safety slaves that are not started because their node-ID may be that of two devices; 0: of all. [SRS_MGR_472]
std::string Doubted(const std::uint8_t whom, const ManagerAssembly& assembly)
{
    std::string named;
    for (const auto& slave : assembly.Net().Slaves())
    {
        const NodeId node{slave->plan.node};
        const bool is_meant = whom == 0U || whom == node.value;
        if (is_meant && IsDoubted(assembly, node) && assembly.Core().IsActive())
        {
            named += "node " + std::to_string(node.value) + ": two devices seem to have this node-ID, ";
        }
    }
    return named.empty() ? named : named + "expected one and a reset";
}

/// Who is left out, and what is expected of them.
std::string Refused(const StartOutlook& outlook, const bool is_by_state)
{
    return is_by_state ? outlook.left_out_by_state + ", expected each in state 4, 5 or 99"
                       : outlook.left_out + ", expected that one, and boot NODE";
}
} // namespace

StartOutlook OutlookOf(const ManagerOrder& order, const ManagerAssembly& assembly)
{
    const ManagerOrder start = StartIn(order);
    StartOutlook outlook;
    if (start.command == cia302::NmtCommand::kStart)
    {
        outlook.is_all = start.node == 0U;
        outlook.left_out = LeftOut(start, assembly, false);
        outlook.left_out_by_state = LeftOut(start, assembly, true);
        outlook.despite = DespiteWhat(start, assembly);
        outlook.not_heard = NotHeard(start, assembly);
        outlook.doubted = Doubted(start.node, assembly);
    }
    return outlook;
}

std::string PartlyTaken(const StartOutlook& outlook, const bool is_by_state)
{
    return (is_by_state ? "taken, but not by " : "taken but for ") + Refused(outlook, is_by_state);
}

std::string NotTaken(const StartOutlook& outlook, const bool is_by_state)
{
    return "not taken by " + Refused(outlook, is_by_state);
}

/// A slave of which the start has taken away what was found is asked again first.
std::string BehindTaken(const StartOutlook& outlook, const ManagerAssembly& assembly)
{
    std::string despite;
    for (const NamedSlave& slave : outlook.despite)
    {
        const bool is_asked_first = !IsRefused(assembly, NodeId{slave.node});
        despite += is_asked_first ? "" : (despite.empty() ? "; started all the same: " : ", ") + slave.text;
    }
    return despite + outlook.not_heard + (outlook.doubted.empty() ? "" : "; not started: " + outlook.doubted);
}

std::string AnswerToSet(const StartOutlook& outlook, const ManagerAssembly& assembly, const std::string& answer)
{
    const bool is_plc = assembly.Net().Plan().manager.profile == network_plan::StartProfile::kPlcDesigner;
    if (!outlook.is_all && !outlook.doubted.empty())
    {
        return "not taken by " + outlook.doubted;
    }
    const bool is_other = answer == WordOf(cia302::NmtAnswer::kOtherDevice); // The others were started. [SRS_MGR_544]
    const bool is_done = answer == "taken" || (outlook.is_all && is_other);
    const bool is_partly = is_done && outlook.is_all && !outlook.left_out.empty();
    const std::string text = is_partly ? PartlyTaken(outlook, is_plc && !is_other) : answer;
    return is_done ? text + BehindTaken(outlook, assembly) : answer;
}
} // namespace counterpoint::runtime
