// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Numbers and the bytes that they are kept in, worked out by the compiler for a processor that number_bytes_test.py
// names: what is not as it has to be leaves a call of Wrong. Each value and its bytes are written by hand.
#include "canopen/cia301/dictionary/entry_value.cpp"
#include "canopen/generated/numbers.cpp"
#include "safety_core/kernel/variable.cpp"

#include <cstdint>

#ifndef OTHER_BYTE
#define OTHER_BYTE 0U
#endif

extern "C" void Wrong();

namespace
{

using namespace counterpoint;

struct Image
{
    std::uint8_t bytes[8];
};

void Is(const bool is_right)
{
    if (!is_right)
    {
        Wrong();
    }
}

void IsImage(const Image& image, const Image& expected)
{
    for (std::uint32_t byte = 0U; byte < 8U; ++byte)
    {
        Is(image.bytes[byte] == expected.bytes[byte]);
    }
}

} // namespace

extern "C" void Check()
{
    // Variables of generated dictionaries: a real number of 64 and of 32 bits, a number with sign of 24 bits
    Image real{};
    generated::WriteReal64({real.bytes, 64U}, -1.5);
    IsImage(real, Image{{0U, 0U, 0U, 0U, 0U, 0U, 0xF8U, 0xBFU + OTHER_BYTE}});
    Is(generated::ReadReal64({real.bytes, 64U}) == -1.5);
    Image small{};
    generated::WriteReal32({small.bytes, 32U}, 1.0F);
    IsImage(small, Image{{0U, 0U, 0x80U, 0x3FU, 0U, 0U, 0U, 0U}});
    Is(generated::ReadReal32({small.bytes, 32U}) == 1.0F);
    Image whole{};
    generated::WriteSigned({whole.bytes, 24U}, -8388607);
    IsImage(whole, Image{{0x01U, 0x00U, 0x80U, 0U, 0U, 0U, 0U, 0U}});
    Is(generated::ReadSigned({whole.bytes, 24U}) == -8388607);
    // Entries of the dictionary
    const std::uint8_t word[4] = {0x78U, 0x56U, 0x34U, 0x12U};
    Is(cia301::NumberOf(cia301::DataType::kUnsigned32, {word, 4U}) == 0x12345678U);
    const std::uint8_t negative[2] = {0xFEU, 0xFFU};
    Is(cia301::NumberOf(cia301::DataType::kInteger16, {negative, 2U}) == 0xFFFFFFFFFFFFFFFEU);
    Image entry{};
    cia301::ToLittleEndian(0x123456789ABCDEF0U, entry.bytes, 8U);
    IsImage(entry, Image{{0xF0U, 0xDEU, 0xBCU, 0x9AU, 0x78U, 0x56U, 0x34U, 0x12U}});
}
