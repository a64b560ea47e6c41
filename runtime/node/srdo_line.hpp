// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NODE_SRDO_LINE_HPP
#define RUNTIME_NODE_SRDO_LINE_HPP

#include "runtime/console/node_report.hpp"

#include "runtime/device/model.hpp"

#include <cstdint>

namespace counterpoint::runtime
{
/// @brief What an SRDO is: of a consumer the limit of its output, of a producer its refresh time. [SRS_NODE_004]
void TellSrdo(NodeReport& report, std::uint64_t at_ns, const DeviceConfig& config, const runtime::SrdoModel& srdo);
/// @brief The SRDO in a slot as the kernel has it now, by what the file says of it.
[[nodiscard]] runtime::SrdoModel ConfiguredSrdo(Kernel& kernel, const runtime::SrdoModel& of_file);
/// @brief Whether both lead to the same line.
[[nodiscard]] bool IsSameSrdo(const runtime::SrdoModel& one, const runtime::SrdoModel& other);
} // namespace counterpoint::runtime

#endif // RUNTIME_NODE_SRDO_LINE_HPP
