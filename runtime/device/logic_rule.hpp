// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_DEVICE_LOGIC_RULE_HPP
#define RUNTIME_DEVICE_LOGIC_RULE_HPP

#include "runtime/yaml/value.hpp"

#include "safety_core/kernel/object_access.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace counterpoint::runtime
{
/// How an output is computed from its inputs.
enum class LogicOperation : std::uint8_t
{
    kCopy = 1U,
    kAnd = 2U,
    kOr = 3U,
    kNot = 4U,
};

/// Whether a device can follow a rule.
enum class RuleFinding : std::uint8_t
{
    kNone = 0U,        ///< It can.
    kNoPair = 1U,      ///< The target is no pair that the device sends, or an input none that it receives.
    kOtherLength = 2U, ///< An input has not the length of the target.
};

/// Whether two addresses are one object.
[[nodiscard]] inline bool IsSame(const ObjectAddress& one, const ObjectAddress& other) noexcept
{
    return one.index == other.index && one.sub == other.sub;
}

/// A rule by which an application computes an object of a producer from objects of consumers.
struct LogicRule
{
    std::size_t node{0U};
    ObjectAddress target{0U, 0U};
    LogicOperation operation{LogicOperation::kCopy};
    std::vector<ObjectAddress> inputs;
    Source source;
};
} // namespace counterpoint::runtime

#endif // RUNTIME_DEVICE_LOGIC_RULE_HPP
