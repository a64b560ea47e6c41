// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_CONFIGURATION_GUARD_HPP
#define SAFETY_CORE_KERNEL_CONFIGURATION_GUARD_HPP

#include "safety_core/comparator/slot_mask.hpp"
#include "safety_core/kernel/configuration_copies.hpp"
#include "safety_core/kernel/configuration_diagnosis.hpp"
#include "safety_core/kernel/object_access.hpp"
#include "safety_core/kernel/result.hpp"
#include "safety_core/kernel/safe_state_latch.hpp"

#include <cstdint>

namespace counterpoint
{

/// @brief What an application is told of a broken rule of the configuration (codes: docs/reference_table.md).
[[nodiscard]] Result ToResult(ConfigFault rule) noexcept;

/// Owner of 1300h to 13FFh: admits or refuses every access, keeps both channels' copies equal, looks at 13FEh every
/// cycle and has signatures and digests computed anew. The values themselves live in the channels
/// (ConfigurationCopies); the guard keeps only 13FEh, its diagnosis the digest. Faults that it finds enter the latch at
/// once. [SRS_CFG_040, SRS_CFG_041, SRS_CFG_042, SRS_CFG_043, SRS_CFG_044, SRS_CFG_045, SRS_CFG_046, SRS_CFG_047,
/// SRS_CFG_048, SRS_CFG_049, SRS_CFG_050, SRS_CFG_051, SRS_CFG_052, SRS_CFG_053, SRS_CFG_150, SRS_CFG_151, SRS_CFG_218,
/// SRS_CFG_219]
class ConfigurationGuard
{
  public:
    ConfigurationGuard(Channel& a, Channel& b, SafeStateLatch& latch) noexcept;

    /// @brief Power-on: 13FEh is 0; how often a cyclic check is due follows from the diagnostic interval.
    void Restart(const DeviceConfig& config) noexcept;
    /// @brief Every access is refused until the next Restart.
    void Stop() noexcept;
    /// @brief Follows the state that Kernel::SetNmtState is given, which has seen to the SRDOs.
    void SetNmt(NmtState state) noexcept
    {
        nmt_ = state;
    }
    /// @brief kInvalid when stopped: every access is refused then.
    [[nodiscard]] NmtState Nmt() const noexcept
    {
        return nmt_;
    }
    /// @brief Whether 13FEh is A5h.
    [[nodiscard]] bool IsValid() const noexcept
    {
        return valid_ == kConfigurationValidValue;
    }
    /// @brief One stored value as channel A has it; the cyclic check vouches for it.
    [[nodiscard]] std::uint32_t Value(const SlotIndex slot, const ConfigField field,
                                      const std::uint8_t sub = 0U) const noexcept
    {
        return copies_.Value(slot, field, sub);
    }
    /// @brief An object, with the abort code of SDO where there is nothing to read; copies that differ are a device
    /// fault. [SRS_CFG_047]
    [[nodiscard]] ObjectReading Read(ObjectKey key) noexcept;
    /// @brief Writes an object if every rule admits it, else nothing. An accepted write to 1301h-13C0h and 13FFh that
    /// changes a value clears 13FEh.
    [[nodiscard]] AbortCode Write(ObjectKey key, const ObjectData& data) noexcept;
    /// @brief kSuccessful where the configuration may be changed as a whole; kDeviceFault when stopped, kNmtError in
    /// OPERATIONAL.
    [[nodiscard]] Result Changeable() const noexcept;
    /// @brief Looks at 13FEh and does a step of the diagnosis when its turn has come. The token for CycleInput.
    /// [SRS_CFG_031, SRS_CFG_048, SRS_CFG_050]
    [[nodiscard]] std::uint32_t Cycle(std::uint32_t challenge, Instant now) noexcept;
    /// @brief The slot whose signature the last Cycle checked, or none: its objects are to be read again as well.
    /// [SRS_KRN_038]
    [[nodiscard]] SrdoMask Examined() const noexcept
    {
        return (examined_ == kNoSlot) ? SrdoMask{0U} : OnlySlot(examined_).mask;
    }
    /// @brief Checks one SRDO in both channels; kInvalid where they differ: the device fault was entered.
    [[nodiscard]] CheckResult Check(const SlotIndex slot, const CheckDepth depth) noexcept
    {
        return copies_.Check(slot, depth);
    }
    /// @brief Checks all SRDOs in both channels up to the first that is faulty: the rule that it breaks, or kNone.
    /// [SRS_KRN_015, SRS_KRN_210, SRS_KRN_223]
    [[nodiscard]] ConfigFault CheckAll(CheckDepth depth) noexcept;
    /// @brief The faulty SRDO that the last CheckAll found, if it found one.
    [[nodiscard]] SlotIndex Faulty() const noexcept
    {
        return faulty_;
    }
    /// @brief The device digest of now, by both channels; the cyclic one goes on undisturbed. O(slots) [SRS_KRN_150]
    [[nodiscard]] DigestReply Digest() noexcept;
    /// @brief Sets 13FEh to 0 everywhere.
    void Invalidate() noexcept;
    /// @brief Both channels keep the value; a device fault if one does not give it back. [SRS_CFG_047]
    void Store(const ConfigItem& item) noexcept
    {
        copies_.Store(item);
    }
    /// @brief Sets 13FEh to A5h if both channels find every rule kept and the device digest is the expected one.
    [[nodiscard]] Result Declare() noexcept;
    /// @brief The device; one without SRDOs when stopped.
    [[nodiscard]] const DeviceConfig& Config() const noexcept
    {
        return copies_.Device();
    }
    /// @brief Fields of an SRDO with a static mapping. [SRS_KRN_024, SRS_KRN_217, SRS_KRN_218,
    /// SRS_KRN_219]
    [[nodiscard]] Result DefineFields(SlotIndex slot, const StaticFields& fields) noexcept;

    /// @brief 13FEh as it is.
    [[nodiscard]] std::uint8_t Valid() const noexcept
    {
        return valid_;
    }

  private:
    // Used in one source file alone: `inline` leaves it to the compiler whether they are called or put in place.
    [[nodiscard]] inline AbortCode WritePlace(const ObjectPlace& place) noexcept;
    /// @brief A value that the channels keep. The same value again changes nothing; 1300h renews the reference of the
    /// digest and leaves 13FEh as it is.
    [[nodiscard]] inline AbortCode WriteConfiguration(const ConfigItem& item) noexcept;
    /// @brief Whether the mapped objects lie in these fields one behind the other, in whole bytes and not too many.
    [[nodiscard]] inline Result CheckFields(const StaticMap& map, const StaticFields& fields) const noexcept;
    /// @brief The digest of the device as it is becomes the reference of the cyclic one.
    [[nodiscard]] Result TakeDigest() noexcept;

    ConfigurationCopies copies_;
    ConfigurationDiagnosis diagnosis_{};
    NmtState nmt_{NmtState::kInvalid};
    std::uint8_t valid_{0U};
    SlotIndex faulty_{0U};
    SlotIndex examined_{kNoSlot};
};

} // namespace counterpoint

#endif
