// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/injection/thumb.hpp"

namespace counterpoint::injection
{

bool IsIt(const std::uint32_t half_word)
{
    return ((half_word & 0xFF00U) == 0xBF00U) && ((half_word & 0xFU) != 0U);
}

std::uint32_t BlockLength(const std::uint32_t half_word)
{
    std::uint32_t length = 4U;
    while (((half_word >> (4U - length)) & 1U) == 0U)
    {
        --length;
    }
    return length;
}

std::uint32_t BlockEnd(const Program& program, const std::uint32_t it, const std::uint32_t half_word)
{
    std::uint32_t end = it + 2U;
    for (std::uint32_t left = BlockLength(half_word); left != 0U; --left)
    {
        end += program.Length(end);
    }
    return end;
}

std::uint32_t Target(const Program& program, const std::uint32_t address)
{
    const std::uint32_t first = program.HalfWord(address);
    if ((first & 0xF500U) == 0xB100U) // CBZ, CBNZ
    {
        return address + 4U + (((first >> 3U) & 0x1FU) << 1U) + (((first >> 9U) & 1U) << 6U);
    }
    if (program.Length(address) == 2U)
    {
        const auto offset = static_cast<std::int8_t>(first & 0xFFU);
        return address + 4U + static_cast<std::uint32_t>(2 * offset);
    }
    const std::uint32_t second = program.HalfWord(address + 2U);
    const std::uint32_t sign = (first >> 10U) & 1U;
    std::uint32_t offset = ((second & 0x7FFU) << 1U) | ((first & 0x3FU) << 12U) | (((second >> 13U) & 1U) << 18U) |
                           (((second >> 11U) & 1U) << 19U);
    offset |= (sign != 0U) ? 0xFFF00000U : 0U;
    return address + 4U + offset;
}

std::uint32_t FindBlock(const Program& program, const std::vector<std::uint32_t>& trace, const std::uint32_t count)
{
    for (std::uint32_t back = 1U; (back <= 4U) && (back <= count); ++back)
    {
        const std::uint32_t it = trace[count - back];
        if (IsIt(program.HalfWord(it)) && (trace[count] > it) &&
            (trace[count] < BlockEnd(program, it, program.HalfWord(it))))
        {
            return count - back;
        }
    }
    return count;
}

bool IsDecision(const Program& program, const std::uint32_t address)
{
    const std::uint32_t first = program.HalfWord(address);
    const bool is_short = ((first & 0xF000U) == 0xD000U) && (((first >> 8U) & 0xFU) < 14U);
    const bool is_zero = (first & 0xF500U) == 0xB100U;
    bool is_long = false;
    if ((first & 0xF800U) == 0xF000U)
    {
        const std::uint32_t second = program.HalfWord(address + 2U);
        is_long = ((second & 0xD000U) == 0x8000U) && (((first >> 6U) & 0xFU) < 14U);
    }
    return is_short || is_zero || is_long || IsIt(first);
}

} // namespace counterpoint::injection
