// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NODE_SCRIPT_HPP
#define RUNTIME_NODE_SCRIPT_HPP

#include "runtime/node/order.hpp"

#include "runtime/device/logic_rule.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// An order with its time after the start; `every_ns` 0: it is given once.
struct ScriptStep
{
    std::uint64_t at_ns{0U};
    std::uint64_t every_ns{0U};
    NodeOrder order;
};

/// What the application of a live node does by itself. Whether the device has the objects of the rules is checked by
/// the node.
struct NodeScript
{
    std::string file;
    std::vector<runtime::LogicRule> rules;
    std::vector<ScriptStep> steps;
};

/// @brief Reads
///     logic: [{set: 0x2000:01, op: and, from: [0x2200:01, 0x2200:02]}]
///     steps: [{at: 1 s, do: set 0x2000:01 1, every: 500 ms}]
/// Throws runtime::YamlError. [SRS_NODE_003, SRS_NODE_009]
[[nodiscard]] NodeScript ReadNodeScript(const std::string& file);
} // namespace counterpoint::runtime

#endif // RUNTIME_NODE_SCRIPT_HPP
