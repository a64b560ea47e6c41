// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Numbers as text, for every emulated board.
#include "verification/target/target.hpp"

#include <cstddef>

namespace counterpoint::target
{

void WriteNumber(std::uint32_t value) noexcept
{
    char digits[11] = {};
    std::size_t place = sizeof digits - 1U;
    do
    {
        --place;
        digits[place] = static_cast<char>('0' + static_cast<char>(value % 10U));
        value /= 10U;
    } while (value != 0U);
    Write(&digits[place]);
}

void WriteHex(std::uint32_t value) noexcept
{
    char digits[9] = {};
    for (std::size_t i = 0U; i < 8U; ++i)
    {
        digits[i] = "0123456789abcdef"[(value >> (28U - (4U * i))) & 0xFU];
    }
    Write(digits);
}

} // namespace counterpoint::target
