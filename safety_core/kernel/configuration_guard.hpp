// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_CONFIGURATION_GUARD_HPP
#define SAFETY_CORE_KERNEL_CONFIGURATION_GUARD_HPP

#include "safety_core/contract/channel.hpp"
#include "safety_core/contract/device_fault.hpp"
#include "safety_core/kernel/application.hpp"
#include "safety_core/kernel/object_access.hpp"

#include <cstdint>

namespace counterpoint
{

/// A finding about the whole configuration.
struct ConfigurationFinding
{
    DeviceFault fault;        ///< kDisagreement: the channels differ; else kNone.
    ConfigFault rule;         ///< First broken rule; kNone: all hold.
    CommunicationIndex index; ///< First faulty SRDO; 0: none.
    SlotIndex slot;
};

/// Owner of 1300h to 13FFh: admits or refuses every access, keeps both channels' copies equal, looks at 13FEh every
/// cycle and has the signatures rechecked. The values themselves live in the channels; the guard keeps only 13FEh.
/// [SRS-CFG-040..049]
class ConfigurationGuard
{
  public:
    ConfigurationGuard(Channel& a, Channel& b) noexcept;

    /// @brief Power-on: 13FEh 0; distance of the cyclic checks from the diagnostic interval.
    void Restart(const DeviceConfig& config) noexcept;
    void SetNmt(NmtState state) noexcept;
    /// @brief SRDOs that are not off, and the producers among them, as of the last declaration of a valid
    /// configuration.
    [[nodiscard]] SrdoMask Active() const noexcept;
    [[nodiscard]] SrdoMask Producers() const noexcept;
    /// @brief One stored value as channel A has it; the cyclic check vouches for it.
    [[nodiscard]] std::uint32_t Value(SlotIndex slot, ConfigField field, std::uint8_t sub) const noexcept;
    [[nodiscard]] ObjectReading Read(const ObjectAddress& address) noexcept;
    [[nodiscard]] AbortCode Write(const ObjectAddress& address, const ObjectData& data) noexcept;
    /// @brief Looks at 13FEh and rechecks an SRDO when its turn has come. The token for CycleInput. [SRS-CFG-031,
    /// SRS-CFG-048]
    [[nodiscard]] std::uint32_t Cycle(std::uint32_t challenge) noexcept;
    /// @brief Rechecks all SRDOs in both channels. [SRS-KRN-010, SRS-KRN-015]
    [[nodiscard]] ConfigurationFinding CheckAll() noexcept;
    /// @brief Sets 13FEh to 0 everywhere.
    void Invalidate() noexcept;
    [[nodiscard]] bool IsValid() const noexcept;
    /// @brief First device fault found since the last call; kNone if none.
    [[nodiscard]] DeviceFaultReport TakeFinding() noexcept;

  private:
    [[nodiscard]] AbortCode WriteConfiguration(const ConfigItem& item) noexcept;
    [[nodiscard]] AbortCode WriteValid(std::uint8_t value) noexcept;
    [[nodiscard]] AbortCode AdmitItem(const ConfigItem& item) const noexcept;
    [[nodiscard]] AbortCode AdmitDirection(const ConfigItem& item) const noexcept;
    [[nodiscard]] AbortCode AdmitCobId(const ConfigItem& item) const noexcept;
    [[nodiscard]] AbortCode AdmitMapCount(const ConfigItem& item) const noexcept;
    [[nodiscard]] AbortCode AdmitMapEntry(const ConfigItem& item) const noexcept;
    [[nodiscard]] bool IsIdentifierFree(const ConfigItem& item) const noexcept;
    [[nodiscard]] AbortCode AdmitConnection(SlotIndex slot) const noexcept;
    [[nodiscard]] std::uint32_t MappedBits(SlotIndex slot, std::uint8_t first, std::uint32_t count) const noexcept;
    void StoreBoth(const ConfigItem& item) noexcept;
    [[nodiscard]] ConfigurationFinding Compare(SlotIndex slot, const CheckResult& a,
                                               const CheckResult& b) const noexcept;
    void TakeDirections() noexcept;
    void Find(DeviceFault fault, SlotIndex slot) noexcept;
    void RecheckNext() noexcept;

    Channel& a_;
    Channel& b_;
    const DeviceConfig* config_; ///< Never null: a device without SRDOs before Restart.
    SrdoMask active_{0U};
    SrdoMask producers_{0U};
    std::uint32_t cycles_per_check_{1U};
    std::uint32_t cycles_to_check_{1U};
    DeviceFaultReport finding_{DeviceFault::kNone, kNoSlot, 0U};
    SlotIndex next_slot_{0U};
    NmtState nmt_{NmtState::kInvalid};
    std::uint8_t valid_{0U};
};

/// Default identifiers of SRDO 1 for a node-ID. [SRS-CFG-049]
struct Connection
{
    std::uint16_t cob_id_1;
    std::uint16_t cob_id_2;
    std::uint8_t direction;
};
struct NodeId
{
    std::uint8_t value;
};
[[nodiscard]] Connection DefaultConnection(NodeId node_id) noexcept;

} // namespace counterpoint

#endif
