// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_DEVICE_OBJECTS_ENTRY_HPP
#define RUNTIME_DEVICE_OBJECTS_ENTRY_HPP

#include "canopen/cia301/dictionary/entry.hpp"
#include "canopen/cia306/file/device.hpp"

#include <cstdint>
#include <string>
#include <vector>

// What an entry of an EDS or DCF is as an entry of a dictionary. [SRS_NODE_001]
namespace counterpoint::runtime
{
/// @brief Whether this is 1010h or 1011h.
[[nodiscard]] bool IsStore(std::uint16_t index);
/// @brief Whether this is one of 5F00h to 5F05h, which the kernel takes at its start.
[[nodiscard]] bool IsFixedAtStart(std::uint16_t index);
/// @brief Its data type for the dictionary. Types have the numbers of CiA 301 there, too; BIT1 to BIT8 become small
/// numbers.
[[nodiscard]] cia301::DataType TypeOf(const cia306::Entry& entry);
/// @brief Into which PDOs it may be mapped: process data are sent if they may be read, and received if they may be
/// written.
[[nodiscard]] std::uint8_t UsesOf(const cia306::Entry& entry);
/// @brief Its access right for the dictionary.
[[nodiscard]] cia301::Access AccessOf(const cia306::Entry& entry);
/// @brief The bytes of an octet string: "0A 1B" or "0A1B" are two bytes, any other text is its own bytes.
[[nodiscard]] std::vector<std::uint8_t> OctetsOf(const std::string& text);
} // namespace counterpoint::runtime

#endif // RUNTIME_DEVICE_OBJECTS_ENTRY_HPP
