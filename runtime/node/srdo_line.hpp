// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NODE_SRDO_LINE_HPP
#define RUNTIME_NODE_SRDO_LINE_HPP

#include "runtime/console/node_report.hpp"

#include "runtime/device/model.hpp"

#include <cstdint>

namespace counterpoint::runtime
{
/// @brief Writes the line about an SRDO: for a consumer the limit of its output, for a producer its refresh time.
/// [SRS_NODE_004]
void TellSrdo(NodeReport& report, std::uint64_t at_ns, const DeviceConfig& config, const runtime::SrdoModel& srdo);
/// @brief The SRDO of a slot as the kernel has it now; `of_file` is what the file says of it.
[[nodiscard]] runtime::SrdoModel ConfiguredSrdo(Kernel& kernel, const runtime::SrdoModel& of_file);
/// @brief Whether TellSrdo writes the same line for both.
[[nodiscard]] bool IsSameSrdo(const runtime::SrdoModel& one, const runtime::SrdoModel& other);
} // namespace counterpoint::runtime

#endif // RUNTIME_NODE_SRDO_LINE_HPP
