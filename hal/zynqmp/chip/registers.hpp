// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_ZYNQMP_CHIP_REGISTERS_HPP
#define HAL_ZYNQMP_CHIP_REGISTERS_HPP

#include <cstdint>

/// The one way from the drivers to the hardware: hal/zynqmp/silicon defines Read and Write. [SRS_ZYN_040]
namespace counterpoint::zynqmp
{

/// A 32-bit register of the controller by its address.
struct Register
{
    std::uint32_t address;
};

/// @brief One access of 32 bits, in the order of the program.
[[nodiscard]] std::uint32_t Read(Register place) noexcept;
/// @brief One access of 32 bits, in the order of the program.
void Write(Register place, std::uint32_t value) noexcept;

/// First register of a peripheral.
struct RegisterBase
{
    std::uint32_t address;
};

/// @brief A register of a peripheral by its offset.
[[nodiscard]] constexpr Register At(const RegisterBase base, const std::uint32_t offset_bytes) noexcept
{
    return Register{base.address + offset_bytes};
}

/// Some bits of a register and what they should read.
struct Bits
{
    std::uint32_t mask;
    std::uint32_t value;
};

/// How often a wait looks before it gives up; each wait names its own bound.
struct Looks
{
    std::uint32_t count;
};

/// Whether something succeeded. Zero-filled memory reads as kInvalid, which every reader treats as a failure.
enum class Outcome : std::uint8_t
{
    kInvalid = 0U,
    kDone = 0x69U,
    kFailed = 1U,
};

/// @brief Looks until `bits` read as wanted, at most `most` times. kFailed: they never did. [SRS_ZYN_041]
[[nodiscard]] Outcome WaitFor(Register place, Bits bits, Looks most) noexcept;

/// @brief Writes and reads again. kFailed: the bits of `mask` read otherwise. [SRS_ZYN_041]
[[nodiscard]] Outcome WriteChecked(Register place, std::uint32_t value, std::uint32_t mask) noexcept;

inline constexpr std::uint32_t kWholeWord = 0xFFFFFFFFU;

/// @brief kDone if both are kDone.
[[nodiscard]] constexpr Outcome Both(const Outcome first, const Outcome second) noexcept
{
    return (first == Outcome::kDone) ? second : Outcome::kFailed;
}

} // namespace counterpoint::zynqmp

#endif
