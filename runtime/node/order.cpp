// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/order.hpp"

#include "canopen/cia306/text/input_error.hpp"
#include "canopen/cia306/text/number.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <optional>
#include <sstream>
#include <vector>

namespace counterpoint::runtime
{
namespace
{
constexpr std::uint64_t kHighestNode = 127U;
constexpr std::uint64_t kHighestSrdo = 64U;

struct CommandWord
{
    const char* text;
    std::uint8_t command;
};
constexpr std::array<CommandWord, 5U> kCommandWords{
    {{"start", 1U}, {"stop", 2U}, {"pre-operational", 128U}, {"reset-node", 129U}, {"reset-communication", 130U}}};

/// Orders of one word.
struct PlainWord
{
    const char* text;
    OrderKind kind;
};
constexpr std::array<PlainWord, 6U> kPlainWords{{{"gfc", OrderKind::kGfc},
                                                 {"nmt", OrderKind::kNmt},
                                                 {"state", OrderKind::kState},
                                                 {"time", OrderKind::kTime},
                                                 {"help", OrderKind::kHelp},
                                                 {"quit", OrderKind::kQuit}}};

NodeOrder Problem(const std::string& wrong, const std::string& expected)
{
    NodeOrder order;
    order.kind = OrderKind::kProblem;
    order.problem = wrong + ", expected " + expected;
    return order;
}

NodeOrder ParseSet(const std::vector<std::string>& words)
{
    const std::optional<ObjectAddress> object = (words.size() == 3U) ? ParseObject(words[1U]) : std::nullopt;
    const bool is_negative = object && words[2U].front() == '-';
    const std::string digits = object ? words[2U].substr(is_negative ? 1U : 0U) : "";
    const bool is_pattern = digits.rfind("0x", 0U) == 0U || digits.rfind("0X", 0U) == 0U;
    const auto value = cia306::ParseTyped(digits, std::numeric_limits<std::uint64_t>::max());
    const bool is_sign_twice = is_negative && value && std::isdigit(static_cast<unsigned char>(digits.front())) == 0;
    if (!value || is_sign_twice || (is_negative && is_pattern))
    {
        return Problem("'set' with something else than an object and a number", "set 0x2000:01 1");
    }
    NodeOrder order{OrderKind::kSet, *object, *value, 0U, {}};
    order.is_negative = is_negative && *value != 0U;
    order.is_pattern = is_pattern;
    return order;
}

NodeOrder ParseGet(const std::vector<std::string>& words)
{
    const std::optional<ObjectAddress> object = (words.size() == 2U) ? ParseObject(words[1U]) : std::nullopt;
    return object ? NodeOrder{OrderKind::kGet, *object, 0U, 0U, {}}
                  : Problem("'get' with something else than an object", "get 0x1018:01");
}

NodeOrder ParseAcknowledge(const std::vector<std::string>& words)
{
    const auto number = (words.size() == 2U) ? cia306::ParseTyped(words[1U], kHighestSrdo) : std::nullopt;
    return (number && *number != 0U)
               ? NodeOrder{OrderKind::kAcknowledge, {0U, 0U}, *number, 0U, {}}
               : Problem("'ack' with something else than an SRDO", "ack 1: a number from 1 to 64");
}

/// nmt start [NODE]: all nodes at once cannot be meant, each safety slave is started for itself.
NodeOrder ParseCommand(const std::vector<std::string>& words)
{
    const auto word = std::find_if(kCommandWords.begin(), kCommandWords.end(),
                                   [&words](const CommandWord& each) { return words[1U] == each.text; });
    const std::string expected = "nmt start, stop, pre-operational, reset-node or reset-communication, for another "
                                 "node with its node-ID, 1 to 127";
    if (word == kCommandWords.end())
    {
        return Problem(cia306::Quoted(words[1U]) + " is no NMT command", expected);
    }
    if (words.size() > 3U)
    {
        return Problem(cia306::Quoted(words[3U]) + " behind the node-ID of an NMT command", expected);
    }
    std::uint8_t node = 0U;
    if (words.size() == 3U)
    {
        const auto number = cia306::ParseTyped(words[2U], kHighestNode);
        if (!number || *number == 0U)
        {
            return Problem(cia306::Quoted(words[2U]) + " is no node-ID", expected);
        }
        node = static_cast<std::uint8_t>(*number);
    }
    return {OrderKind::kCommand, {0U, 0U}, word->command, node, {}};
}
/// read NODE OBJECT, write NODE OBJECT VALUE BYTES.
NodeOrder ParseTransfer(const std::vector<std::string>& words)
{
    constexpr std::uint64_t kLongestNumber = 8U;
    const bool is_read = words.front() == "read";
    const bool is_whole = words.size() == (is_read ? 3U : 5U);
    const auto node = is_whole ? cia306::ParseTyped(words[1U], kHighestNode) : std::nullopt;
    const std::optional<ObjectAddress> object = is_whole ? ParseObject(words[2U]) : std::nullopt;
    NodeOrder order{is_read ? OrderKind::kRead : OrderKind::kWrite, {0U, 0U}, 0U, 0U, {}};
    bool is_usable = node && *node != 0U && object;
    if (is_usable && !is_read)
    {
        const auto size = cia306::ParseTyped(words[4U], kLongestNumber);
        const bool is_size = size && *size != 0U;
        const auto greatest = ~std::uint64_t{0U} >> (is_size ? 8U * (kLongestNumber - *size) : 0U);
        const auto value = is_size ? cia306::ParseTyped(words[3U], greatest) : std::nullopt;
        is_usable = value.has_value();
        order.value = value.value_or(0U);
        order.size_bytes = static_cast<std::uint8_t>(size.value_or(0U));
    }
    if (!is_usable)
    {
        return Problem(cia306::Quoted(words.front()) + " with something else than node, object" +
                           (is_read ? "" : ", number and its bytes"),
                       is_read ? "read 5 0x1018:01" : "write 5 0x2000:01 1 2");
    }
    order.node = static_cast<std::uint8_t>(*node);
    order.object = *object;
    return order;
}
} // namespace

std::optional<ObjectAddress> ParseObject(const std::string& text)
{
    const std::size_t colon = text.find(':');
    if (text.rfind("0x", 0U) != 0U || colon == std::string::npos)
    {
        return std::nullopt;
    }
    const auto index = cia306::ParseTyped(text.substr(0U, colon), std::numeric_limits<std::uint16_t>::max());
    const auto sub = cia306::ParseTyped("0x" + text.substr(colon + 1U), std::numeric_limits<std::uint8_t>::max());
    if (!index || !sub)
    {
        return std::nullopt;
    }
    return ObjectAddress{static_cast<std::uint16_t>(*index), static_cast<std::uint8_t>(*sub)};
}

NodeOrder ParseOrder(const std::string& line)
{
    std::istringstream stream(line);
    std::vector<std::string> words;
    for (std::string word; stream >> word;)
    {
        words.push_back(word);
    }
    if (words.empty() || words.front().front() == '#')
    {
        return {};
    }
    const auto plain = std::find_if(kPlainWords.begin(), kPlainWords.end(),
                                    [&words](const PlainWord& each) { return words.front() == each.text; });
    if (plain != kPlainWords.end() && words.size() == 1U)
    {
        return {plain->kind, {0U, 0U}, 0U, 0U, {}};
    }
    if (words.front() == "set")
    {
        return ParseSet(words);
    }
    if (words.front() == "get")
    {
        return ParseGet(words);
    }
    if (words.front() == "ack")
    {
        return ParseAcknowledge(words);
    }
    if (words.front() == "nmt")
    {
        return ParseCommand(words);
    }
    if (words.front() == "read" || words.front() == "write")
    {
        return ParseTransfer(words);
    }
    return Problem(cia306::Quoted(line) + " is no order",
                   "set, get, ack, gfc, nmt, state, read, write, time, help or quit");
}

std::string OrderHelp()
{
    return "  set 0x2000:01 1      value of an input, or of another object of the device\n"
           "  get 0x1018:01        value of an object, as its data type has it\n"
           "  ack 1                press the acknowledge button of SRDO 1\n"
           "  gfc                  send the global fail-safe command\n"
           "  nmt                  state of the node\n"
           "  nmt start [NODE]     also stop, pre-operational, reset-node, reset-communication\n"
           "  state                SRDOs, outputs, values\n"
           "  read 5 0x1018:01     an object of node 5, by the SDO client of 0x1280 to 0x12FF that has this node\n"
           "  write 5 0x2000:01 1 2  the same: value and its bytes\n"
           "  time                 send the time of this machine\n"
           "  quit                 close the outputs and end\n";
}
} // namespace counterpoint::runtime
