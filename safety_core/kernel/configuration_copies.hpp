// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_CONFIGURATION_COPIES_HPP
#define SAFETY_CORE_KERNEL_CONFIGURATION_COPIES_HPP

#include "safety_core/contract/channel.hpp"
#include "safety_core/kernel/object_access.hpp"
#include "safety_core/kernel/result.hpp"
#include "safety_core/kernel/safe_state_latch.hpp"

#include <cstdint>

namespace counterpoint
{

/// How an SRDO is checked: all rules, its mapping resolved anew, or signature and resolved mapping again.
enum class CheckDepth : std::uint8_t
{
    kInvalid = 0U,
    kRecheck = 1U,
    kValidate = 2U,
};

/// Device digest as both channels compute it: kSuccessful where it is the expected one, or none is expected.
struct DigestReply
{
    Result result;
    std::uint32_t digest;
};

/// A value that both channels should have alike.
struct CommonValue
{
    std::uint32_t value; ///< As channel A has it.
    bool is_common;
};

/// The configuration as it lives in both channels. What they keep, find or compute otherwise than each other enters the
/// latch at once. [SRS_CFG_046, SRS_CFG_047, SRS_CFG_050, SRS_KRN_150,
/// SRS_KRN_151, SRS_KRN_212]
class ConfigurationCopies
{
  public:
    ConfigurationCopies(Channel& a, Channel& b, SafeStateLatch& latch) noexcept
        : a_{a}, b_{b}, latch_{latch}, config_{&kNoDevice}
    {
    }

    /// @brief The device from now on; it outlives its use. Kernel::Start has checked it.
    void SetDevice(const DeviceConfig& config) noexcept
    {
        config_ = &config;
    }
    /// @brief The device given last; one without SRDOs before.
    [[nodiscard]] const DeviceConfig& Device() const noexcept
    {
        return *config_;
    }
    /// @brief One stored value as channel A has it; the cyclic check vouches for it.
    [[nodiscard]] std::uint32_t Value(SlotIndex slot, ConfigField field, std::uint8_t sub = 0U) const noexcept;
    /// @brief One stored value; a difference is a device fault.
    [[nodiscard]] CommonValue Load(const ConfigAddress& address) noexcept
    {
        const std::uint32_t value_a = a_.Load(address).value;
        const std::uint32_t value_b = b_.Load(address).value;
        if (value_a != value_b)
        {
            latch_.Enter(DeviceFault::kConfiguration, NamedBy(address));
        }
        return CommonValue{value_a, value_a == value_b};
    }
    /// @brief Both channels keep the value; a device fault if one does not give it back. [SRS_CFG_047]
    void Store(const ConfigItem& item) noexcept;
    /// @brief Fields of a static mapping, to both channels. ConfigurationGuard::DefineFields checks what becomes of
    /// them.
    void SetFields(const SlotIndex slot, const StaticFields& fields) noexcept
    {
        a_.SetFields(slot, fields);
        b_.SetFields(slot, fields);
    }
    /// @brief Checks one SRDO in both channels; kInvalid where they differ, a device fault by now.
    [[nodiscard]] CheckResult Check(SlotIndex slot, CheckDepth depth) noexcept;
    /// @brief One more slot in the device digest of both channels: a difference between them shows at the slot where it
    /// is. [SRS_CFG_050]
    [[nodiscard]] DigestReply ContinueDigest(SlotIndex slot, DeviceDigest before) noexcept;
    /// @brief Something in the configuration is not as declared.
    void Report(const SlotIndex slot) noexcept
    {
        latch_.Enter(DeviceFault::kConfiguration, slot);
    }

  private:
    /// @brief The slot that a fault of this value names: none for 1300h and 13FEh, which are of the device.
    [[nodiscard]] static SlotIndex NamedBy(const ConfigAddress& address) noexcept;

    Channel& a_;
    Channel& b_;
    SafeStateLatch& latch_;
    const DeviceConfig* config_; ///< Never null: a device without SRDOs before Restart.
};

} // namespace counterpoint

#endif
