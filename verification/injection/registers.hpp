// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_INJECTION_REGISTERS_HPP
#define VERIFICATION_INJECTION_REGISTERS_HPP

#include <array>
#include <cstdint>

struct uc_struct;

namespace counterpoint::injection
{

/// Registers that a call keeps, stack pointer and the place to go on.
struct Registers
{
    std::array<std::uint32_t, 10> words{}; ///< r4 to r11, sp, lr
    std::array<std::uint64_t, 8> doubles{};

    bool operator==(const Registers& other) const
    {
        return (words == other.words) && (doubles == other.doubles);
    }
};

[[nodiscard]] Registers ReadKept(uc_struct* engine);
/// @brief All that a program of this image sees; mode and order of bytes stay.
void CopyRegisters(uc_struct* from, uc_struct* to);
/// @brief Inverts a bit; `number` is 32 * register + bit.
void FlipRegister(uc_struct* engine, std::uint32_t number);
/// @brief Mode of the processor and order of bytes.
[[nodiscard]] std::uint32_t ModeOf(uc_struct* engine);

} // namespace counterpoint::injection

#endif
