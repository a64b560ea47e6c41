// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "pins.hpp"

#include "registers.hpp"

namespace port_fifo
{

namespace
{

constexpr std::uint32_t kAllPins = 0xFFU;

} // namespace

Pins::Pins(Clocks& clocks, const counterpoint::hal::GateLimit limit) noexcept : clocks_{clocks}, limit_{limit}
{
}

void Pins::Start() noexcept
{
    gate_.Close();
    WriteRegister(kPinOut, 0U);
    WriteRegister(kPinDirection, kAllPins);
    live_ = kLive;
}

std::uint32_t Pins::Challenge() noexcept
{
    return gate_.Challenge();
}

void Pins::Drive(const counterpoint::hal::PermitSet& permits) noexcept
{
    gate_.Drive(permits, clocks_.Now().a);
    Set();
}

void Pins::CutOff() noexcept
{
    WriteRegister(kPinOut, 0U);
    WriteRegister(kPinDirection, 0U);
    live_ = 0U;
}

void Pins::Examine() noexcept
{
    Set();
    if (ReadBack() != ReadRegister(kPinOut))
    {
        CutOff();
    }
}

std::uint32_t Pins::ReadBack() noexcept
{
    return ReadRegister(kPinIn) & kAllPins;
}

void Pins::Set() noexcept
{
    const counterpoint::SrdoMask open = gate_.Open(clocks_.Now().a, limit_);
    const bool is_live = live_ == kLive;
    WriteRegister(kPinOut, is_live ? static_cast<std::uint32_t>(open & kAllPins) : 0U);
}

} // namespace port_fifo
