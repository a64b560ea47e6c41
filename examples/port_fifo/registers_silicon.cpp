// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "registers.hpp"

namespace port_fifo
{

namespace
{

/// Where the made-up controller has its peripherals.
constexpr std::uintptr_t kPeripherals = 0x40000000U;

[[nodiscard]] volatile std::uint32_t& At(const std::uint32_t offset) noexcept
{
    return *reinterpret_cast<volatile std::uint32_t*>(kPeripherals + offset);
}

} // namespace

std::uint32_t ReadRegister(const std::uint32_t offset) noexcept
{
    return At(offset);
}

void WriteRegister(const std::uint32_t offset, const std::uint32_t value) noexcept
{
    At(offset) = value;
}

} // namespace port_fifo
