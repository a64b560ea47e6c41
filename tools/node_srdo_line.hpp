// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_NODE_SRDO_LINE_HPP
#define TOOLS_NODE_SRDO_LINE_HPP

#include "tools/node_report.hpp"

#include "verification/simulator/device_model.hpp"

#include <cstdint>

namespace counterpoint::tools
{
/// @brief What an SRDO is: of a consumer the limit of its output, of a producer its refresh time. [SRS-NODE-004]
void TellSrdo(NodeReport& report, std::uint64_t at_ns, const DeviceConfig& config, const simulator::SrdoModel& srdo);
/// @brief The SRDO in a slot as the kernel has it now, by what the file says of it.
[[nodiscard]] simulator::SrdoModel ConfiguredSrdo(Kernel& kernel, const simulator::SrdoModel& of_file);
/// @brief Whether both lead to the same line.
[[nodiscard]] bool IsSameSrdo(const simulator::SrdoModel& one, const simulator::SrdoModel& other);
} // namespace counterpoint::tools

#endif // TOOLS_NODE_SRDO_LINE_HPP
