// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_ZYNQMP_OUTPUT_GPIO_REGISTERS_HPP
#define HAL_ZYNQMP_OUTPUT_GPIO_REGISTERS_HPP

#include "hal/zynqmp/chip/registers.hpp"

#include <cstdint>

/// General purpose pins: six banks. Source: register header of the vendor's public driver gpiops; the base address
/// was not checked against a manual. The emulator has none.
namespace counterpoint::zynqmp::gpio
{

inline constexpr RegisterBase kBase{0xFF0A0000U};
inline constexpr std::uint32_t kBanks = 6U; ///< 0 to 2: pins of the controller, 26 each; 3 to 5: into the fabric.

/// Each bank has a register of each kind.
inline constexpr std::uint32_t kMaskedLow = 0x00U;     ///< Bits 15:0 where the bits 31:16 are 0.
inline constexpr std::uint32_t kOutput = 0x40U;        ///< What is driven.
inline constexpr std::uint32_t kInput = 0x60U;         ///< What the pins are.
inline constexpr std::uint32_t kDirection = 0x204U;    ///< 1: output.
inline constexpr std::uint32_t kOutputEnable = 0x208U; ///< 1: the driver is on.

inline constexpr std::uint32_t kMaskedBankBytes = 0x8U;
inline constexpr std::uint32_t kDataBankBytes = 0x4U;
inline constexpr std::uint32_t kBankBytes = 0x40U;

/// What a device uses of a bank: its lower half.
inline constexpr std::uint32_t kPins = 16U;
inline constexpr std::uint32_t kPinMask = 0xFFFFU;

[[nodiscard]] constexpr Register MaskedLow(const std::uint32_t bank) noexcept
{
    return At(kBase, kMaskedLow + (bank * kMaskedBankBytes));
}
[[nodiscard]] constexpr Register Output(const std::uint32_t bank) noexcept
{
    return At(kBase, kOutput + (bank * kDataBankBytes));
}
[[nodiscard]] constexpr Register Input(const std::uint32_t bank) noexcept
{
    return At(kBase, kInput + (bank * kDataBankBytes));
}
[[nodiscard]] constexpr Register Direction(const std::uint32_t bank) noexcept
{
    return At(kBase, kDirection + (bank * kBankBytes));
}
[[nodiscard]] constexpr Register OutputEnable(const std::uint32_t bank) noexcept
{
    return At(kBase, kOutputEnable + (bank * kBankBytes));
}

/// What MaskedLow is written with so that the pins of `pins` become those of `high` and no other changes.
[[nodiscard]] constexpr std::uint32_t Masked(const std::uint32_t pins, const std::uint32_t high) noexcept
{
    return ((~pins & kPinMask) << kPins) | (high & pins);
}

} // namespace counterpoint::zynqmp::gpio

#endif
