// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/manager/order.hpp"

#include "canopen/cia306/text/input_error.hpp"
#include "canopen/cia306/text/number.hpp"
#include "runtime/manager/pdos.hpp"
#include "runtime/manager/report/texts.hpp"
#include "runtime/manager/start_answer.hpp"
#include "runtime/node/order.hpp"

#include <limits>
#include <optional>
#include <sstream>
#include <vector>

namespace counterpoint::runtime
{
namespace
{
struct OrderWord
{
    const char* text;
    ManagerOrderKind kind;
    bool has_node;
};
constexpr OrderWord kOrderWords[] = {{"status", ManagerOrderKind::kStatus, false},
                                     {"boot", ManagerOrderKind::kBoot, true},
                                     {"write-safety", ManagerOrderKind::kWriteSafety, true},
                                     {"negotiate", ManagerOrderKind::kNegotiate, false},
                                     {"help", ManagerOrderKind::kHelp, false},
                                     {"quit", ManagerOrderKind::kQuit, false}};

ManagerOrder Problem(const std::string& wrong, const std::string& expected)
{
    ManagerOrder order;
    order.kind = ManagerOrderKind::kProblem;
    order.problem = wrong + ", expected " + expected;
    return order;
}

/// 1 to 127, or with `all` 0.
std::optional<std::uint8_t> NodeOf(const std::string& text, const bool may_be_all)
{
    if (may_be_all && text == "all")
    {
        return std::uint8_t{0U};
    }
    const auto number = cia306::ParseTyped(text, cia302::kLastNode);
    return (number && *number > 0U) ? std::optional(static_cast<std::uint8_t>(*number)) : std::nullopt;
}

ManagerOrder WithNode(ManagerOrder order, const std::vector<std::string>& words, const bool may_be_all)
{
    const std::string expected = may_be_all ? "a node-ID from 1 to 127, or all" : "a node-ID from 1 to 127";
    if (words.size() != 2U)
    {
        return Problem(words[0] + (words.size() < 2U ? ": no node" : ": too many words"), expected);
    }
    const auto node = NodeOf(words[1], may_be_all);
    if (!node)
    {
        return Problem(words[0] + ": " + cia306::Quoted(words[1]), expected);
    }
    order.node = *node;
    return order;
}

/// control NODE ADS DEVICE
ManagerOrder ControlOf(const std::vector<std::string>& words)
{
    constexpr std::uint64_t kHighest = 0xFFFFU;
    const std::string expected = "a node-ID from 1 to 127, ADS state and device state from 0 to 65535";
    if (words.size() != 4U)
    {
        return Problem(words[0] + ": " + std::to_string(words.size() - 1U) + " numbers", expected);
    }
    const auto node = NodeOf(words[1], false);
    const auto ads_state = cia306::ParseTyped(words[2], kHighest);
    const auto device_state = cia306::ParseTyped(words[3], kHighest);
    if (!node || !ads_state || !device_state)
    {
        const std::string& wrong = !node ? words[1] : !ads_state ? words[2] : words[3];
        return Problem(words[0] + ": " + cia306::Quoted(wrong), expected);
    }
    ManagerOrder order;
    order.kind = ManagerOrderKind::kControl;
    order.node = *node;
    order.ads_state = static_cast<std::uint16_t>(*ads_state);
    order.device_state = static_cast<std::uint16_t>(*device_state);
    return order;
}
/// get OBJECT, set OBJECT VALUE
ManagerOrder ObjectOf(const std::vector<std::string>& words)
{
    const bool is_set = words[0] == "set";
    const std::size_t count = is_set ? 3U : 2U;
    const auto object = (words.size() == count) ? ParseObject(words[1]) : std::nullopt;
    const auto value = (object && is_set) ? cia306::ParseTyped(words[2], std::numeric_limits<std::uint32_t>::max())
                                          : std::optional<std::uint64_t>(0U);
    if (!object || !value)
    {
        return Problem("'" + words[0] + "' with something else than an object" + (is_set ? " and a number" : ""),
                       is_set ? "set 0x1F90:03 1" : "get 0x1F80:00");
    }
    ManagerOrder order;
    order.kind = is_set ? ManagerOrderKind::kSet : ManagerOrderKind::kGet;
    order.object = *object;
    order.value = *value;
    return order;
}

/// output NODE PDO BYTES
ManagerOrder OutputOf(const std::vector<std::string>& words)
{
    constexpr std::uint64_t kHighestPdo = 512U;
    const auto node = (words.size() >= 4U) ? NodeOf(words[1], false) : std::nullopt;
    const std::uint64_t pdo = node ? cia306::ParseTyped(words[2], kHighestPdo).value_or(0U) : 0U;
    std::string text;
    for (std::size_t place = 3U; place < words.size(); ++place)
    {
        text += words[place] + " ";
    }
    const auto bytes = (pdo > 0U) ? BytesFrom(text.substr(0U, text.size() - 1U)) : std::nullopt;
    if (!bytes)
    {
        return Problem("'output' with something else than a node-ID, an RxPDO and 1 to 8 bytes", "output 10 1 01 FF");
    }
    ManagerOrder order;
    order.kind = ManagerOrderKind::kOutput;
    order.node = *node;
    order.pdo = static_cast<std::uint16_t>(pdo);
    order.bytes = *bytes;
    return order;
}

/// What became of a command, and who did not take a start.
std::string AnswerTo(const ManagerOrder& order, ManagerAssembly& assembly, const Instant now)
{
    using cia302::NmtAnswer;
    const StartOutlook outlook = OutlookOf(order, assembly);
    if (order.node != 0U && !outlook.doubted.empty())
    {
        return "not taken by " + outlook.doubted;
    }
    const NmtAnswer answer = assembly.Core().Role().Command(order.command, cia302::NodeId{order.node}, now);
    const bool is_plc = assembly.Net().Plan().manager.profile == network_plan::StartProfile::kPlcDesigner;
    const bool is_partly = answer == NmtAnswer::kPartly || (order.node == 0U && answer == NmtAnswer::kOtherDevice);
    const bool is_refused = is_plc && answer == NmtAnswer::kWrong;
    const bool is_by_state = is_plc && answer != NmtAnswer::kOtherDevice;
    const bool is_named = (is_partly || is_refused) && !outlook.left_out.empty();
    const std::string named = is_partly ? PartlyTaken(outlook, is_by_state) : NotTaken(outlook, is_by_state);
    const std::string text = is_named ? named : WordOf(answer);
    return text + ((answer == NmtAnswer::kTaken || is_partly) ? BehindTaken(outlook, assembly) : "");
}

/// The table of the manual network management has a row for each state and pair.
std::string ControlAnswer(const ManagerOrder& order, ManagerAssembly& assembly, const Instant now)
{
    const cia302::NodeId node{order.node};
    const network_plan::StartProfile profile = assembly.Net().Plan().manager.profile;
    const cia302::NmtAnswer answer = assembly.Control(node, order.ads_state, order.device_state, now);
    const std::string pair = std::to_string(order.ads_state) + "/" + std::to_string(order.device_state);
    std::string text = WordOf(answer);
    if (profile != network_plan::StartProfile::kEl6751)
    {
        text = "the profile " + WordOf(profile) + " has no control, expected el6751";
    }
    else if (answer == cia302::NmtAnswer::kWrong)
    {
        text = "control " + pair + " is no command for node " + std::to_string(order.node) + ", which is " +
               WordOf(assembly.ControlState(node)) + " with NodeState " +
               StatusText(profile, assembly.Core().Status(node)) +
               ", expected no start-up that runs, and 5/0 or 6/0 while OPERATIONAL, 5/1 or 6/0 while PRE-OPERATIONAL, "
               "5/1, 5/2 or 5/3 while STOPPED";
    }
    return text;
}
} // namespace

ManagerOrder ParseManagerOrder(const std::string& line)
{
    if (line.size() > kLongestManagerOrder)
    {
        return Problem("an order of more than " + std::to_string(kLongestManagerOrder) + " bytes",
                       "at most so many in one line");
    }
    std::istringstream stream(line);
    std::vector<std::string> words;
    for (std::string word; stream >> word && word[0] != '#';)
    {
        words.push_back(word);
    }
    ManagerOrder order;
    if (words.empty())
    {
        return order;
    }
    order.command = CommandOf(words[0]);
    if (order.command != cia302::NmtCommand::kInvalid)
    {
        order.kind = ManagerOrderKind::kCommand;
        return WithNode(order, words, true);
    }
    if (words[0] == "control")
    {
        return ControlOf(words);
    }
    if (words[0] == "get" || words[0] == "set")
    {
        return ObjectOf(words);
    }
    if (words[0] == "output")
    {
        return OutputOf(words);
    }
    for (const OrderWord& row : kOrderWords)
    {
        if (words[0] == row.text)
        {
            order.kind = row.kind;
            return row.has_node          ? WithNode(order, words, false)
                   : (words.size() > 1U) ? Problem(words[0] + ": too many words", "it alone")
                                         : order;
        }
    }
    return Problem("order " + cia306::Quoted(words[0]),
                   "status, start, stop, preop, reset, reset-comm, boot, write-safety, control, output, "
                   "get, set, negotiate, help or quit");
}

std::string ManagerOrderHelp()
{
    return "  status              the table of all slaves\n"
           "  start NODE|all      NMT start; a safety slave is verified first, all are started singly where there is "
           "one\n"
           "  stop NODE|all       NMT stop\n"
           "  preop NODE|all      NMT enter PRE-OPERATIONAL\n"
           "  reset NODE|all      NMT reset node\n"
           "  reset-comm NODE|all NMT reset communication\n"
           "  boot NODE           start-up of this slave anew\n"
           "  write-safety NODE   write the safety configuration of its DCF, read it back, declare it valid\n"
           "  control NODE A D    write control of the EL6751 profile: ADS state A, device state D\n"
           "  output NODE PDO BYTES what an RxPDO of the EL6751 profile carries, as hexadecimal digits: output 10 1 01 "
           "FF\n"
           "  get OBJECT          an object of the manager itself, hexadecimal: get 0x1F82:0A is that of node 10\n"
           "  set OBJECT NUMBER   writes one: set 0x1F90:03 1\n"
           "  negotiate           the flying master begins its negotiation (start: by_order)\n"
           "  help                this\n"
           "  quit                end\n" +
           ResultHelp();
}

namespace
{
std::string WriteSafety(ManagerAssembly& assembly, const cia302::NodeId node, const Instant now)
{
    constexpr auto kOperational = static_cast<std::uint8_t>(cia302::SlaveState::kOperational);
    const bool is_safety = assembly.Net().Setup().IsSafetySlave(node);
    const cia302::NodeTable& table = assembly.Core().Table();
    const std::string name = "node " + std::to_string(node.value);
    std::string answer = "taken";
    if (!is_safety)
    {
        answer = name + " is no safety slave, expected one";
    }
    else if (!assembly.Core().IsActive())
    {
        answer = "the manager is not the active master, expected the order at that one";
    }
    else if (assembly.Core().Status(node).is_other)
    {
        answer = name + " is not known to be the expected device, expected that one, and boot NODE";
    }
    else if ((table.RequestValue(node) == kOperational) && !cia302::HasLeft(table, node))
    {
        answer = name + " is OPERATIONAL, expected it stopped or PRE-OPERATIONAL";
    }
    else if (!assembly.Core().WriteSafety(node, now))
    {
        answer = "the start-up of the slave runs, expected it later";
    }
    return answer;
}

/// Why an order for this node, which is none of ours or cannot take it, is not carried out.
std::string NotOurs(const ManagerAssembly& assembly, const cia302::NodeId node)
{
    const std::string name = "node " + std::to_string(node.value);
    std::string answer = "the start-up of the network has not begun, expected the order later";
    if (node.value == assembly.Net().Setup().own.value)
    {
        answer = name + " is this manager, expected a slave";
    }
    else if (!assembly.Net().Setup().IsListed(node))
    {
        answer = name + " is not in the network file, expected a slave";
    }
    else if (!assembly.Core().IsActive())
    {
        answer = WordOf(cia302::NmtAnswer::kNotActive);
    }
    else
    {
        // A slave of ours.
    }
    return answer;
}
} // namespace

std::string CarryOut(const ManagerOrder& order, ManagerAssembly& assembly, const Instant now)
{
    const cia302::NodeId node{order.node};
    const bool is_listed = assembly.Net().Setup().IsListed(node);
    std::string answer;
    if (order.kind == ManagerOrderKind::kCommand)
    {
        const bool is_known = order.node == 0U || is_listed || order.node == assembly.Net().Setup().own.value;
        answer = is_known ? AnswerTo(order, assembly, now) : NotOurs(assembly, node);
    }
    else if (order.kind == ManagerOrderKind::kControl)
    {
        answer = is_listed ? ControlAnswer(order, assembly, now) : NotOurs(assembly, node);
    }
    else if (order.kind == ManagerOrderKind::kBoot)
    {
        answer = assembly.Core().Role().Boot(node, now) ? "taken" : NotOurs(assembly, node);
    }
    else if (order.kind == ManagerOrderKind::kNegotiate)
    {
        answer = assembly.Negotiate();
    }
    else if (order.kind == ManagerOrderKind::kWriteSafety)
    {
        answer = WriteSafety(assembly, node, now);
    }
    else
    {
        // Of the owner. [SRS_MGR_540]
    }
    return answer;
}
} // namespace counterpoint::runtime
