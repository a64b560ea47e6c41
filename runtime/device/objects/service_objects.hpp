// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_DEVICE_OBJECTS_SERVICE_OBJECTS_HPP
#define RUNTIME_DEVICE_OBJECTS_SERVICE_OBJECTS_HPP

#include "canopen/cia306/file/device.hpp"

#include <cstdint>

namespace counterpoint::runtime
{
/// @brief Whether the service of emergencies, heartbeat and guarding keeps this object.
[[nodiscard]] bool IsOfServiceObjects(std::uint16_t index) noexcept;

/// @brief Whether a service of the device keeps this object, where the file has it.
[[nodiscard]] bool IsOfAService(std::uint16_t index) noexcept;

/// @brief What is told of an object of a service that is a variable of SRDOs: the kernel has it, and the service works
/// without it. [SRS_NODE_044]
[[nodiscard]] cia306::Finding KeptByTheKernel(const cia306::Entry& entry);
} // namespace counterpoint::runtime

#endif // RUNTIME_DEVICE_OBJECTS_SERVICE_OBJECTS_HPP
