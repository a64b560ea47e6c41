// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NODE_OBJECT_VALUE_HPP
#define RUNTIME_NODE_OBJECT_VALUE_HPP

#include "canopen/cia301/dictionary/dictionary.hpp"
#include "canopen/cia306/file/device.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace counterpoint::runtime
{
/// The value of an object, or why it has none.
struct ObjectValue
{
    cia301::SdoAbort abort{cia301::SdoAbort::kNone};
    std::string text;               ///< For people.
    nlohmann::ordered_json details; ///< For programs: `value`, of strings and octets `size_bytes`, too.
};

/// @brief Reads an object of a device, for the device itself, and tells it by its data type. [SRS_NODE_552]
[[nodiscard]] ObjectValue ValueOf(const cia306::Device& file, cia301::Dictionary& dictionary,
                                  const ObjectAddress& object);
} // namespace counterpoint::runtime

#endif // RUNTIME_NODE_OBJECT_VALUE_HPP
