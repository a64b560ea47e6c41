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

void Faults::Restart() noexcept
{
    x_unreported = 0U;
    x_windows = 0U;
    x_signalled = 0U;
    for (SlotIndex slot = 0U; slot < x_settings.Count(); ++slot)
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

void Faults::Forget(SlotIndex slot) noexcept
{
    x_columns.first_cause[slot] = CodeOf(SrdoCause::kNone);
}

std::uint32_t Faults::Signals(SlotIndex slot) const noexcept
{
    return HasAny(x_signalled, BitOf(slot)) ? x_columns.signals[slot] : 0U;
}

/// [SRS_CONS_021]
void Faults::Age(std::uint32_t elapsed_us) noexcept
{
    x_signalled = 0U;
    SlotWalk walk{x_windows};
    while (walk.Next())
    {
        const SlotIndex slot = walk.Slot();
        x_columns.window_us[slot] += elapsed_us;
        if (x_columns.window_us[slot] > x_settings.SctUs(slot))
        {
            x_windows &= ~BitOf(walk.Slot());
        }
    }
}

/// [SRS_CONS_021]
SrdoMask Faults::Report() noexcept
{
    SlotWalk walk{x_unreported};
    while (walk.Next())
    {
        const SlotIndex slot = walk.Slot();
        const SrdoMask bit = BitOf(walk.Slot());
        const std::uint32_t causes = x_columns.causes[slot];
        if (!HasAny(x_windows, bit))
        {
            x_windows |= bit;
            x_columns.window_us[slot] = 0U;
            x_columns.told[slot] = 0U;
        }
        x_columns.signals[slot] = causes & ~x_columns.told[slot];
        x_columns.told[slot] |= causes;
        x_columns.causes[slot] = 0U;
        if (x_columns.signals[slot] != 0U)
        {
            x_signalled |= bit;
        }
    }
    x_unreported = 0U;
    return x_signalled;
}

} // namespace counterpoint::channel_b
