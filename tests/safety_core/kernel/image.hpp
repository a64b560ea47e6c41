// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_SAFETY_CORE_KERNEL_IMAGE_HPP
#define TESTS_SAFETY_CORE_KERNEL_IMAGE_HPP

#include <cstdint>
#include <vector>

/// An image of a stored configuration, computed apart from the kernel.
namespace counterpoint::image
{

// The CRC as the requirement has it, over words.
inline std::uint32_t CrcOf(const std::vector<std::uint32_t>& words)
{
    std::uint32_t crc = 0xFFFFFFFFU;
    for (const std::uint32_t word : words)
    {
        for (std::uint32_t byte = 0U; byte < 4U; ++byte)
        {
            crc ^= (word >> (8U * byte)) & 0xFFU;
            for (std::uint32_t bit = 0U; bit < 8U; ++bit)
            {
                crc = ((crc & 1U) != 0U) ? ((crc >> 1U) ^ 0xEDB88320U) : (crc >> 1U);
            }
        }
    }
    return ~crc;
}

// What the CRC of the rig's device runs over.
inline std::vector<std::uint32_t> WordsOf(const std::vector<std::uint32_t>& items, const std::uint32_t valid)
{
    std::vector<std::uint32_t> words;
    std::uint32_t item = 0U;
    const auto add = [&words, &item, &items](std::uint32_t index, std::uint32_t sub)
    {
        words.push_back((index << 8U) | sub);
        words.push_back(items[item]);
        ++item;
    };
    for (const std::uint32_t number : {1U, 3U, 4U})
    {
        add(0x13FFU, number);
        for (std::uint32_t sub = 1U; sub <= 6U; ++sub)
        {
            add(0x1300U + number, sub);
        }
        for (std::uint32_t sub = 0U; sub <= 16U; ++sub)
        {
            add(0x1380U + number, sub);
        }
    }
    add(0x1300U, 0U);
    words.push_back(valid);
    return words;
}

} // namespace counterpoint::image

#endif
