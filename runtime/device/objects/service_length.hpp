// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_DEVICE_OBJECTS_SERVICE_LENGTH_HPP
#define RUNTIME_DEVICE_OBJECTS_SERVICE_LENGTH_HPP

#include "canopen/cia301/dictionary/entry.hpp"

#include <cstdint>
#include <vector>

namespace counterpoint::runtime
{
/// @brief Gives an entry that a service keeps the length that the service has, for reading and writing, whatever data
/// type the file has for it. [SRS_NODE_043]
void TakeServiceLength(cia301::Entry& entry) noexcept;

/// @brief A number of this type in so many bytes without a sign; one that they cannot hold stays as it is. Nothing is
/// left of what is no number, so that it is refused whatever its length. [SRS_NODE_043]
void FitNumber(std::vector<std::uint8_t>& value, cia301::DataType type, std::uint32_t size_bytes);
} // namespace counterpoint::runtime

#endif // RUNTIME_DEVICE_OBJECTS_SERVICE_LENGTH_HPP
