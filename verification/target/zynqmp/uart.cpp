// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/target/zynqmp/uart.hpp"

#include <cstdint>

extern "C"
{
    extern const std::uint8_t image_core[]; // Its address is the number of the processor, plus 1.
}

namespace
{

constexpr std::uint32_t kFirstUart = 0xFF000000U;
constexpr std::uint32_t kUartBytes = 0x00010000U;
constexpr std::uint32_t kControl = 0x00U;
constexpr std::uint32_t kStatus = 0x2CU;
constexpr std::uint32_t kFifo = 0x30U;
constexpr std::uint32_t kTransmit = 0x10U;
constexpr std::uint32_t kFull = 0x10U;
constexpr std::uint32_t kMostLooks = 1000000U;

volatile std::uint32_t& At(const std::uint32_t offset) noexcept
{
    const auto core = static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(image_core)) - 1U;
    return *reinterpret_cast<volatile std::uint32_t*>(kFirstUart + (core * kUartBytes) + offset);
}

} // namespace

namespace counterpoint::target
{

void WriteUart(const char* const text) noexcept
{
    At(kControl) = kTransmit;
    for (const char* letter = text; *letter != '\0'; ++letter)
    {
        for (std::uint32_t look = 0U; (look < kMostLooks) && ((At(kStatus) & kFull) != 0U); ++look)
        {
        }
        At(kFifo) = static_cast<std::uint8_t>(*letter);
    }
}

} // namespace counterpoint::target
