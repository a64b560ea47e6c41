// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/injection/registers.hpp"

#include <unicorn/unicorn.h>

namespace counterpoint::injection
{
namespace
{

// Of CPSR; the others tell mode and order of bytes.
constexpr std::uint32_t kFlags = 0xF80F0000U;
constexpr std::uint32_t kModes = 0x0000021FU;

constexpr int kKept[] = {UC_ARM_REG_R4, UC_ARM_REG_R5,  UC_ARM_REG_R6,  UC_ARM_REG_R7, UC_ARM_REG_R8,
                         UC_ARM_REG_R9, UC_ARM_REG_R10, UC_ARM_REG_R11, UC_ARM_REG_SP, UC_ARM_REG_LR};
constexpr int kKeptDoubles[] = {UC_ARM_REG_D8,  UC_ARM_REG_D9,  UC_ARM_REG_D10, UC_ARM_REG_D11,
                                UC_ARM_REG_D12, UC_ARM_REG_D13, UC_ARM_REG_D14, UC_ARM_REG_D15};
constexpr int kNumbered[] = {UC_ARM_REG_R0,  UC_ARM_REG_R1,  UC_ARM_REG_R2,  UC_ARM_REG_R3, UC_ARM_REG_R4,
                             UC_ARM_REG_R5,  UC_ARM_REG_R6,  UC_ARM_REG_R7,  UC_ARM_REG_R8, UC_ARM_REG_R9,
                             UC_ARM_REG_R10, UC_ARM_REG_R11, UC_ARM_REG_R12, UC_ARM_REG_SP, UC_ARM_REG_LR};

template <typename Value> void Copy(uc_struct* const from, uc_struct* const to, const int which)
{
    Value value = 0U;
    uc_reg_read(from, which, &value);
    uc_reg_write(to, which, &value);
}

} // namespace

Registers ReadKept(uc_struct* const engine)
{
    Registers result{};
    for (std::size_t i = 0U; i < result.words.size(); ++i)
    {
        uc_reg_read(engine, kKept[i], &result.words[i]);
    }
    for (std::size_t i = 0U; i < result.doubles.size(); ++i)
    {
        uc_reg_read(engine, kKeptDoubles[i], &result.doubles[i]);
    }
    return result;
}

void CopyRegisters(uc_struct* const from, uc_struct* const to)
{
    std::uint32_t flags = 0U;
    std::uint32_t status = 0U;
    uc_reg_read(from, UC_ARM_REG_CPSR, &flags);
    uc_reg_read(to, UC_ARM_REG_CPSR, &status);
    status = (status & ~kFlags) | (flags & kFlags);
    uc_reg_write(to, UC_ARM_REG_CPSR, &status);
    for (const int which : kNumbered)
    {
        Copy<std::uint32_t>(from, to, which);
    }
    Copy<std::uint32_t>(from, to, UC_ARM_REG_FPSCR);
    for (int which = UC_ARM_REG_D0; which <= UC_ARM_REG_D15; ++which)
    {
        Copy<std::uint64_t>(from, to, which);
    }
}

void FlipRegister(uc_struct* const engine, const std::uint32_t number)
{
    const int which = kNumbered[number / 32U];
    std::uint32_t value = 0U;
    uc_reg_read(engine, which, &value);
    value ^= 1U << (number % 32U);
    uc_reg_write(engine, which, &value);
}

std::uint32_t ModeOf(uc_struct* const engine)
{
    std::uint32_t status = 0U;
    uc_reg_read(engine, UC_ARM_REG_CPSR, &status);
    return status & kModes;
}

} // namespace counterpoint::injection
