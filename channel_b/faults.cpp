// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/faults.hpp"

#include "channel_b/slots.hpp"

#include <cstdint>

namespace counterpoint::channel_b
{

namespace
{

constexpr std::uint16_t kMostErrors = 0xFFFFU;

[[nodiscard]] constexpr std::uint8_t CodeOf(SrdoCause cause) noexcept
{
    return static_cast<std::uint8_t>(cause);
}

[[nodiscard]] constexpr std::uint32_t SignalOf(SrdoCause cause) noexcept
{
    return std::uint32_t{1U} << (CodeOf(cause) % 32U);
}

} // namespace

void Faults::Restart(std::uint8_t count) noexcept
{
    x_unreported = 0U;
    x_signalled = 0U;
    for (SlotIndex slot = 0U; slot < count; ++slot)
    {
        x_columns.causes[slot] = 0U;
        x_columns.error_count[slot] = 0U;
        x_columns.first_cause[slot] = CodeOf(SrdoCause::kNone);
    }
}

/// [SRS_CONS_020]
void Faults::Count(SlotIndex slot, SrdoCause cause) noexcept
{
    if (x_columns.error_count[slot] != kMostErrors)
    {
        x_columns.error_count[slot] = static_cast<std::uint16_t>(x_columns.error_count[slot] + 1U);
    }
    if (FirstCause(slot) == SrdoCause::kNone)
    {
        x_columns.first_cause[slot] = CodeOf(cause);
    }
}

void Faults::Record(SlotIndex slot, SrdoCause cause) noexcept
{
    Complain(slot, cause);
    Count(slot, cause);
}

void Faults::Complain(SlotIndex slot, SrdoCause cause) noexcept
{
    x_columns.causes[slot] |= SignalOf(cause);
    x_unreported |= BitOf(slot);
}

} // namespace counterpoint::channel_b
