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
/// @brief 1010h and 1011h.
[[nodiscard]] bool IsStore(std::uint16_t index);
/// @brief 5F00h to 5F05h: what the kernel was started with.
[[nodiscard]] bool IsFixedAtStart(std::uint16_t index);
/// @brief The types of both rooms have the numbers of CiA 301. BIT1 to BIT8 are small numbers.
[[nodiscard]] cia301::DataType TypeOf(const cia306::Entry& entry);
/// @brief Process data go where they may be read, and come where they may be written.
[[nodiscard]] std::uint8_t UsesOf(const cia306::Entry& entry);
[[nodiscard]] cia301::Access AccessOf(const cia306::Entry& entry);
/// @brief Octets as "0A 1B" or "0A1B"; every other text stands for its own bytes.
[[nodiscard]] std::vector<std::uint8_t> OctetsOf(const std::string& text);
} // namespace counterpoint::runtime

#endif // RUNTIME_DEVICE_OBJECTS_ENTRY_HPP
