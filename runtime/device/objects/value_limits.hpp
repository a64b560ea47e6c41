// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_DEVICE_OBJECTS_VALUE_LIMITS_HPP
#define RUNTIME_DEVICE_OBJECTS_VALUE_LIMITS_HPP

#include "canopen/cia301/dictionary/entry.hpp"
#include "canopen/cia306/file/device.hpp"
#include "canopen/cia306/file/value.hpp"

#include <cstdint>
#include <functional>
#include <optional>

namespace counterpoint::runtime
{
/// Is told of a limit that the data type cannot have; the device does without it.
using OnNoLimit = std::function<void(const cia306::Text& limit, const cia306::Problem& problem)>;

/// @brief What a number of the file may be: its LowLimit and HighLimit, and no more than the bits of its data type
/// hold; nothing: all that its bytes hold. `type` is the one that the dictionary has for it. [SRS_NODE_045]
[[nodiscard]] std::optional<cia301::ValueLimits> LimitsOf(const cia306::Entry& source, cia301::DataType type,
                                                          std::uint8_t node_id, const OnNoLimit& on_no_limit);

/// @brief What a number begins with to which the file gives no value: 0, or the limit next to it. [SRS_NODE_045]
[[nodiscard]] std::uint64_t FirstValue(const cia301::ValueLimits& limits, cia301::DataType type) noexcept;
} // namespace counterpoint::runtime

#endif // RUNTIME_DEVICE_OBJECTS_VALUE_LIMITS_HPP
