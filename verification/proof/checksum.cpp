// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/proof/checksum.hpp"

#include <iomanip>
#include <sstream>

namespace counterpoint::proof
{

std::uint16_t Divided16(const std::uint16_t state, const std::uint8_t byte)
{
    std::uint32_t rest = state;
    for (std::uint32_t bit = 8U; bit > 0U; --bit)
    {
        // The bit that leaves and the bit of the message that comes, the most significant one first.
        const bool takes = (((rest >> 15U) ^ (std::uint32_t{byte} >> (bit - 1U))) & 1U) != 0U;
        rest = ((rest << 1U) & 0xFFFFU) ^ (takes ? 0x1021U : 0U);
    }
    return static_cast<std::uint16_t>(rest);
}

std::uint32_t Divided32(const std::uint32_t state, const std::uint8_t byte)
{
    std::uint32_t rest = state;
    for (std::uint32_t bit = 0U; bit < 8U; ++bit)
    {
        const bool takes = ((rest ^ (std::uint32_t{byte} >> bit)) & 1U) != 0U;
        rest = (rest >> 1U) ^ (takes ? 0xEDB88320U : 0U); // 04C11DB7h, its lowest bit first.
    }
    return rest;
}

std::string WrongStep(const char* const name, const std::uint32_t state, const std::uint32_t byte,
                      const std::uint32_t found, const std::uint32_t right)
{
    std::ostringstream text;
    text << name << ": state " << std::hex << std::uppercase << state << "h, byte " << byte << "h gives " << found
         << "h, by definition " << right << "h";
    return text.str();
}

} // namespace counterpoint::proof
