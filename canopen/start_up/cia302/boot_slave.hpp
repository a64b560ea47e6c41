// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_CIA302_BOOT_SLAVE_HPP
#define CANOPEN_START_UP_CIA302_BOOT_SLAVE_HPP

#include "canopen/start_up/cia302/boot_configuration.hpp"
#include "canopen/start_up/cia302/boot_identity.hpp"
#include "canopen/start_up/cia302/boot_release.hpp"
#include "canopen/start_up/cia302/boot_reset.hpp"
#include "canopen/start_up/cia302/boot_software.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// Is told how boots end, and asked whether the master is OPERATIONAL.
class BootListener
{
  public:
    /// @brief The boot ended without letter, or with L.
    virtual void OnBooted(NodeId node, const BootTime& time) noexcept = 0;
    /// @brief It ended with another letter; the record tells.
    virtual void OnBootFailed(NodeId node, const BootTime& time) noexcept = 0;
    [[nodiscard]] virtual bool IsMasterOperational() const noexcept = 0;

  protected:
    BootListener() noexcept = default;
    ~BootListener() noexcept = default;
    BootListener(const BootListener&) = default;
    BootListener& operator=(const BootListener&) = default;
};

/// Boots slaves after CiA 302-2, each by itself and all at the same time: `records` has kNodeRoom elements by node-ID,
/// kept by reference as the parts. `node` is always that of a listed slave. Not reentrant. The course of a boot is
/// kRows of boot_states.hpp; reset, identity, software, configuration and release do the work of its states.
class BootSlave
{
  public:
    BootSlave(const StartUpParts& parts, BootRecord* records, BootListener& listener) noexcept;

    /// @brief Boots now, without waiting for a boot-up message. [SRS_BOOT_004, SRS_BOOT_005, SRS_BOOT_006,
    /// SRS_BOOT_007, SRS_BOOT_008, SRS_BOOT_009, SRS_BOOT_010, SRS_BOOT_011, SRS_BOOT_012, SRS_BOOT_013, SRS_BOOT_014]
    void Ask(NodeId node, const BootTime& time) noexcept;
    /// @brief As Ask, and what was written stays: no reset by the state check, nothing is restored. [SRS_SFS_005]
    void Resume(NodeId node, const BootTime& time) noexcept;
    /// @brief Boots when the boot-up message comes; mandatory slaves and those kept alive also without one, after
    /// kResetUs. [SRS_BOOT_002]
    void Await(NodeId node, const BootTime& time) noexcept;
    /// @brief Resets the node, then as Await. [SRS_BOOT_017]
    void Reset(NodeId node, const BootTime& time) noexcept;
    /// @brief The boot-up message of the node: what the boot waits for, or its begin. [SRS_BOOT_018]
    void OnBootUp(NodeId node, const BootTime& time) noexcept;
    /// @brief Writes the configuration, and nothing else. [SRS_NMM_009]
    void Configure(NodeId node, const BootTime& time) noexcept;
    /// @brief Starts a booted slave, after verification if it is a safety slave. [SRS_BOOT_023]
    void Start(NodeId node, const BootTime& time) noexcept;
    /// @brief Verifies a safety slave that was found OPERATIONAL. [SRS_BOOT_013]
    void Verify(NodeId node, const BootTime& time) noexcept;
    /// @brief Gives up whatever runs, and takes the slave for another device until a boot has asked it. [SRS_BOOT_017]
    void Doubt(NodeId node, const BootTime& time) noexcept;
    /// @brief Gives up whatever runs.
    void End(NodeId node) noexcept;
    /// @brief Goes on as far as it can. Once a cycle, and after each frame of the node.
    void OnCycle(NodeId node, const BootTime& time) noexcept;

    /// @brief `node` is 1 to 127, checked by the caller.
    [[nodiscard]] BootRecord& Record(NodeId node) noexcept;
    [[nodiscard]] const BootRecord& Record(NodeId node) const noexcept;

  private:
    [[nodiscard]] BootJob JobOf(NodeId node, const BootTime& time) noexcept;
    void Clear(const BootJob& job) noexcept;
    void Rest(NodeId node, BootEvent event) noexcept;
    void Go(const BootJob& job, BootEvent event) noexcept;
    void EnterStep(const BootJob& job, StartUpStep step) noexcept;
    void Fail(const BootJob& job, char letter) noexcept;
    void Finish(const BootJob& job) noexcept;
    void Act(const BootJob& job, const BootFinding& finding) noexcept;
    [[nodiscard]] BootFinding Work(const BootJob& job) noexcept;

    StartUpParts parts_;
    BootRecord* records_;
    BootListener& listener_;
    BootReset reset_;
    BootIdentity identity_;
    BootSoftware software_;
    BootConfiguration configuration_;
    BootRelease release_;
};

} // namespace counterpoint::cia302

#endif
