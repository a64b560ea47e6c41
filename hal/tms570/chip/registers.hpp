// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_CHIP_REGISTERS_HPP
#define HAL_TMS570_CHIP_REGISTERS_HPP

#include <cstdint>

/// The one way from the drivers to the hardware. Nothing here says what the hardware is: hal/tms570/silicon defines
/// these functions for a controller, verification/models/tms570 for register models on a host, and the linker chooses.
namespace counterpoint::tms570
{

/// A 32-bit register or memory word of the controller by its address.
struct Register
{
    std::uint32_t address;
};

/// @brief One access of 32 bits, in the order of the program. [SRS_TMS_001]
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

/// @brief Looks until `bits` read as wanted, at most `most` times. kFailed: they never did. [SRS_TMS_003]
[[nodiscard]] Outcome WaitFor(Register place, Bits bits, Looks most) noexcept;

/// @brief Writes and reads again. kFailed: the bits of `mask` read otherwise. [SRS_TMS_004]
[[nodiscard]] Outcome WriteChecked(Register place, std::uint32_t value, std::uint32_t mask) noexcept;

/// @brief Reads a register whose reading does something; the value does not matter.
void Touch(Register place) noexcept;

inline constexpr std::uint32_t kWholeWord = 0xFFFFFFFFU;

/// @brief kDone if both are kDone.
[[nodiscard]] constexpr Outcome Both(const Outcome first, const Outcome second) noexcept
{
    return (first == Outcome::kDone) ? second : Outcome::kFailed;
}

} // namespace counterpoint::tms570

#endif
