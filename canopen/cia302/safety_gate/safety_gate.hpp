// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA302_SAFETY_GATE_SAFETY_GATE_HPP
#define CANOPEN_CIA302_SAFETY_GATE_SAFETY_GATE_HPP

#include "canopen/cia302/safety_gate/safety_check.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// One safety slave. Zero-filled at first.
struct SafetySlot
{
    NodeId node;
    std::uint32_t permit; ///< Derived from the node-ID while the gate is open; everything else grants nothing.
    SafetyCheck check;
    bool is_doubted;        ///< Two devices may have this node-ID: nothing that it says is believed.
    ObjectAddress download; ///< Of the last one to it that was begun, by whomever; 0000h: none.
};

/// Room for as many slaves as have an expectation, kept by reference.
struct SafetySlots
{
    SafetySlot* slots;
    std::uint8_t count;
};

/// Lets a safety slave be started only after all its safety objects were read and found as expected, since it last
/// booted up, was reset or was lost. A slave for which there is no slot is never let through, nor is one in doubt:
/// State is kFailed, Finding names object 0000h and kGeneral. Slaves are verified independently of each other. Not
/// reentrant. [SRS_SFS_001, SRS_SFS_002, SRS_SFS_154, SRS_SFS_003, SRS_SFS_004, SRS_SFS_005, SRS_SFS_006, SRS_SFS_007,
/// SRS_SFS_008, SRS_SFS_120]
class SafetyGate final : public StartGate
{
  public:
    SafetyGate(const NetworkSetup& setup, const SafetySlots& room, SdoPool& sdo) noexcept;

    /// @brief From the next verification on this rule says by which objects a slave is recognised; kCia302 at first.
    /// [SRS_SFS_010, SRS_SFS_217, SRS_SFS_218]
    void Use(IdentityRule rule) noexcept;
    /// @brief Reads and compares from the beginning; kBusy until that ends. In doubt, or without a slot,
    /// nothing happens. [SRS_SFS_001]
    void Verify(NodeId node, Instant now) noexcept override;
    /// @brief Writes the whole safety configuration, then as Verify. The slave has to be PRE-OPERATIONAL: it refuses
    /// otherwise. False: no safety slave, in doubt, or no slot. [SRS_SFS_005, SRS_SFS_210, SRS_SFS_211, SRS_SFS_213]
    [[nodiscard]] bool Write(NodeId node, Instant now) noexcept;
    /// @brief Two devices may have this node-ID: the gate is closed and stays so until Trust. [SRS_SFS_151]
    void Doubt(NodeId node) noexcept;
    /// @brief The node was reset: it may be verified again.
    void Trust(NodeId node) noexcept;
    /// @brief A verification or writing that runs begins again, because another device may have answered until now.
    /// [SRS_SFS_002]
    void Renew(NodeId node) noexcept;
    /// @brief The slave has answered that an object of its safety configuration was written. True: by somebody else; a
    /// verification or writing that runs begins again. [SRS_SFS_011, SRS_SFS_221]
    [[nodiscard]] bool OnWritten(NodeId node, const ObjectAddress& object) noexcept;
    /// @brief The slave has answered that this object will be downloaded to it: of the segments and the end of a block
    /// that follow no answer names it. Without a slot nothing is kept. [SRS_SFS_011]
    void NoteDownload(NodeId node, const ObjectAddress& object) noexcept;
    /// @brief The last such object; 0000h: none.
    [[nodiscard]] ObjectAddress LastDownload(NodeId node) const noexcept;
    void OnCycle(Instant now) noexcept override;
    void Close(NodeId node) noexcept override;
    [[nodiscard]] GateState State(NodeId node) const noexcept override;
    [[nodiscard]] GateFinding Finding(NodeId node) const noexcept override;

  private:
    [[nodiscard]] SafetySlot* Find(NodeId node) const noexcept;
    [[nodiscard]] bool Begin(NodeId node, SafetyTask task) noexcept;
    void Cancel(const SafetySlot& slot) noexcept;

    const NetworkSetup& setup_;
    SafetySlots room_;
    SdoPool& sdo_;
    IdentityRule rule_;
};

} // namespace counterpoint::cia302

#endif
