// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NODE_ORDER_HPP
#define RUNTIME_NODE_ORDER_HPP

#include "safety_core/kernel/object_access.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace counterpoint::runtime
{
/// Kinds of orders, and which members of NodeOrder each uses.
enum class OrderKind : std::uint8_t
{
    kNothing = 0U,     ///< An empty line or a comment.
    kSet = 1U,         ///< object, value, is_negative, is_pattern
    kGet = 2U,         ///< object
    kAcknowledge = 3U, ///< value: number of the SRDO
    kGfc = 4U,
    kNmt = 5U,     ///< Shows the state.
    kCommand = 6U, ///< value: NMT command; node: 0 is this one.
    kState = 7U,
    kHelp = 8U,
    kQuit = 9U,
    kProblem = 10U, ///< `problem` tells.
    kTime = 11U,    ///< Sends the time of the system.
    kRead = 12U,    ///< node, object
    kWrite = 13U,   ///< node, object, value, size_bytes
};

/// An order of a person or a script to a live node.
struct NodeOrder
{
    OrderKind kind{OrderKind::kNothing};
    ObjectAddress object{0U, 0U};
    std::uint64_t value{0U};
    std::uint8_t node{0U};
    std::string problem; ///< What is wrong and what was expected.
    std::uint8_t size_bytes{0U};
    bool is_negative{false}; ///< The number is minus `value`, which is not 0.
    bool is_pattern{false};  ///< `value` was written hexadecimal: bits of the object, not a number.
};

/// @brief Reads 0x2000:01, both parts hexadecimal; nothing for any other text.
[[nodiscard]] std::optional<ObjectAddress> ParseObject(const std::string& text);
/// @brief Reads one line: set 0x2000:01 1, get 0x1018:01, ack 1, gfc, nmt, nmt start [NODE], state, read 5 0x1018:01,
/// write 5 0x2000:01 1 2, time, help, quit. A line that is no order gives kProblem. [SRS_NODE_003, SRS_NODE_012]
[[nodiscard]] NodeOrder ParseOrder(const std::string& line);
/// @brief The help: all orders, a line each.
[[nodiscard]] std::string OrderHelp();
} // namespace counterpoint::runtime

#endif // RUNTIME_NODE_ORDER_HPP
