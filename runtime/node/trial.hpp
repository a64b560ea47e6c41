// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NODE_TRIAL_HPP
#define RUNTIME_NODE_TRIAL_HPP

#include "canopen/cia306/file/device.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// @brief What `counterpoint node` would refuse of a file: the device is built and switched on as there, with kernel,
/// channels, services and self tests, on a bus on which nobody is. An error: it would not run, or an SRDO would not; a
/// warning: a service does without the value, or the self tests do not fit. A file without node-ID is tried with 127.
/// [SRS_CLI_030]
[[nodiscard]] std::vector<cia306::Finding> TryDevice(const cia306::Device& device, std::optional<std::uint8_t> node_id);
} // namespace counterpoint::runtime

#endif // RUNTIME_NODE_TRIAL_HPP
