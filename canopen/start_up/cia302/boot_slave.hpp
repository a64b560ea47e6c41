// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_CIA302_BOOT_SLAVE_HPP
#define CANOPEN_START_UP_CIA302_BOOT_SLAVE_HPP

#include "canopen/start_up/cia302/boot_identity.hpp"
#include "canopen/start_up/cia302/boot_nmt.hpp"
#include "canopen/start_up/cia302/boot_writer.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// Is told how boots end, and asked whether the master is OPERATIONAL.
class BootListener
{
  public:
    /// @brief The boot of a slave ended well: without a letter, or with L.
    virtual void OnBooted(NodeId node, const BootTime& time) noexcept = 0;
    /// @brief The boot of a slave ended with another letter, which is in its record.
    virtual void OnBootFailed(NodeId node, const BootTime& time) noexcept = 0;
    /// @brief Whether the master is OPERATIONAL.
    [[nodiscard]] virtual bool IsMasterOperational() const noexcept = 0;

  protected:
    BootListener() noexcept = default;
    ~BootListener() noexcept = default;
    BootListener(const BootListener&) = default;
    BootListener& operator=(const BootListener&) = default;
};

/// Boots slaves after CiA 302-2, each independently of the others and all at the same time. `records` has kNodeRoom
/// elements by node-ID; they and the parts are kept by reference. `node` is always that of a listed slave. Not
/// reentrant. What follows which state is the table kRows in boot_states.hpp; BootNmt, BootIdentity and
/// BootWriter do the work of the states.
class BootSlave
{
  public:
    /// @brief No boot runs at first.
    BootSlave(const StartUpParts& parts, BootRecord* records, BootListener& listener) noexcept;

    /// @brief Boots now, without waiting for a boot-up message. [SRS_BOOT_004, SRS_BOOT_005, SRS_BOOT_006,
    /// SRS_BOOT_007, SRS_BOOT_008, SRS_BOOT_009, SRS_BOOT_010, SRS_BOOT_011, SRS_BOOT_012, SRS_BOOT_013, SRS_BOOT_014]
    void Ask(NodeId node, const BootTime& time) noexcept;
    /// @brief As Ask, but a start that was ordered is still wanted. [SRS_BOOT_018]
    void AskAgain(NodeId node, const BootTime& time) noexcept;
    /// @brief As Ask, but what was written to the slave stays: the state check does not reset it, and no defaults are
    /// restored. [SRS_SFS_214]
    void Resume(NodeId node, const BootTime& time) noexcept;
    /// @brief Boots when the boot-up message comes; mandatory slaves and those kept alive also without one, after
    /// kResetUs. [SRS_BOOT_002]
    void Await(NodeId node, const BootTime& time) noexcept;
    /// @brief Resets the node, then as Await. [SRS_BOOT_017]
    void Reset(NodeId node, const BootTime& time) noexcept;
    /// @brief The boot-up message of the node: the boot waits for it, or begins with it. [SRS_BOOT_018]
    void OnBootUp(NodeId node, const BootTime& time) noexcept;
    /// @brief Writes the configuration, and nothing else. [SRS_NMM_009]
    void Configure(NodeId node, const BootTime& time) noexcept;
    /// @brief Starts a booted slave, after verification if it is a safety slave. [SRS_BOOT_023]
    void Start(NodeId node, const BootTime& time) noexcept;
    /// @brief Verifies a safety slave that was found OPERATIONAL. [SRS_BOOT_013]
    void Verify(NodeId node, const BootTime& time) noexcept;
    /// @brief A safety slave runs whose boot-up message is waited for: it is supervised and verified, and its boot ends
    /// as that of one that was OPERATIONAL already. [SRS_BOOT_013]
    void TakeOver(NodeId node, const BootTime& time) noexcept;
    /// @brief A command holds the slave: no start-up starts it before Free, Release or Start. [SRS_BOOT_030,
    /// SRS_BOOT_033]
    void Hold(NodeId node) noexcept;
    /// @brief Its boot or its reset was ordered: what is begun behind it may start it. [SRS_BOOT_032]
    void Free(NodeId node) noexcept;
    /// @brief A start of the slave was ordered and sent.
    void Release(NodeId node, const BootTime& time) noexcept;
    /// @brief Ends whatever runs, and takes the slave for another device until a boot has found the expected one.
    /// [SRS_BOOT_017]
    void Doubt(NodeId node, const BootTime& time) noexcept;
    /// @brief Ends whatever runs.
    void End(NodeId node) noexcept;
    /// @brief Ends whatever runs; nothing is known of the slave any more, but whether a command holds it.
    void Forget(NodeId node) noexcept;
    /// @brief Does what can be done now. Call it once a cycle, and after each frame of the node.
    void OnCycle(NodeId node, const BootTime& time) noexcept;

    /// @brief A slave whose boot ended with an error, and that nobody started all the same: a start of several leaves
    /// it out. No safety slave: that is asked and read again before its start. [SRS_BOOT_470]
    [[nodiscard]] bool IsRefused(NodeId node) const noexcept;
    /// @brief Record of a slave; `node` is 1 to 127, checked by the caller.
    [[nodiscard]] BootRecord& Record(NodeId node) noexcept;
    /// @brief The same, to look at.
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
    BootNmt nmt_;
    BootIdentity identity_;
    BootWriter writer_;
};

} // namespace counterpoint::cia302

#endif
