// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NODE_SRDO_REPORT_HPP
#define RUNTIME_NODE_SRDO_REPORT_HPP

#include "runtime/console/node_report.hpp"

#include "runtime/device/model.hpp"
#include "safety_core/contract/configuration.hpp"
#include "safety_core/kernel/kernel.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// Tells what the SRDOs of a node are: of a consumer the limit of its output, of a producer its refresh time, or that
/// it is off. From entering OPERATIONAL on, what was told of an SRDO last is what holds. [SRS_NODE_004, SRS_NODE_024,
/// SRS_NODE_052]
class SrdoReport
{
  public:
    /// @brief All outlive it.
    SrdoReport(const DeviceModel& model, const DeviceConfig& config, NodeReport& report);

    /// @brief Tells the SRDOs that are on in the file.
    void TellFile(std::uint64_t at_ns);
    /// @brief A store was loaded behind the file: tells each SRDO that is not as it was told last, and that it is off
    /// where the configuration does not hold. [SRS_NODE_330, SRS_NODE_532]
    void TellSaved(Kernel& kernel, std::uint64_t at_ns);
    /// @brief OPERATIONAL was entered: tells each SRDO that is not as it was told last. `is_told_invalid`: the kernel
    /// has just told that the configuration does not hold. [SRS_NODE_052, SRS_NODE_053]
    void Follow(Kernel& kernel, std::uint64_t at_ns, bool is_told_invalid);

  private:
    [[nodiscard]] bool IsValid(Kernel& kernel) const;
    void TellConfigured(Kernel& kernel, std::uint64_t at_ns);
    void Tell(std::uint64_t at_ns, const SrdoModel& srdo);

    const DeviceModel& model_;
    const DeviceConfig& config_;
    NodeReport& report_;
    std::vector<std::string> told_; ///< The last line of each SRDO, by slot; empty: none yet.
};
} // namespace counterpoint::runtime

#endif // RUNTIME_NODE_SRDO_REPORT_HPP
