// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_B_FAULTS_HPP
#define CHANNEL_B_FAULTS_HPP

#include "channel_b/slots.hpp"
#include "channel_b/storage.hpp"

#include <cstdint>

namespace counterpoint::channel_b
{

/// What went wrong in each slot. Every cause is signalled by the OnCycle that reports it.
class Faults
{
  public:
    explicit Faults(const FaultColumns& columns) noexcept : x_columns(columns)
    {
    }

    void Restart(std::uint8_t count) noexcept;

    /// @brief Counts a fault; the first one is kept.
    void Count(SlotIndex slot, SrdoCause cause) noexcept;
    /// @brief A fault that the next OnCycle, or this one, reports.
    void Record(SlotIndex slot, SrdoCause cause) noexcept;
    /// @brief To be signalled like a fault, without being one.
    void Complain(SlotIndex slot, SrdoCause cause) noexcept;
    /// @brief The first cause was read.
    void Forget(SlotIndex slot) noexcept
    {
        x_columns.first_cause[slot] = static_cast<std::uint8_t>(SrdoCause::kNone);
    }

    /// @brief Slots with something that is not reported yet.
    [[nodiscard]] SrdoMask Unreported() const noexcept
    {
        return x_unreported;
    }

    /// @brief Any other first cause is corrupted, or was put there because something else was. [SRS_CONS_024]
    [[nodiscard]] bool IsCauseDefined(SlotIndex slot) const noexcept
    {
        const SrdoCause cause = FirstCause(slot);
        return (cause == SrdoCause::kNone) || ((cause >= SrdoCause::kLength) && (cause <= SrdoCause::kWrongEcho));
    }
    [[nodiscard]] SrdoCause FirstCause(SlotIndex slot) const noexcept
    {
        return static_cast<SrdoCause>(x_columns.first_cause[slot]);
    }

    [[nodiscard]] std::uint16_t ErrorCount(SlotIndex slot) const noexcept
    {
        return x_columns.error_count[slot];
    }

    [[nodiscard]] std::uint32_t Signals(SlotIndex slot) const noexcept
    {
        return HasAny(x_signalled, BitOf(slot)) ? x_columns.signals[slot] : 0U;
    }

    /// @brief Signals what was recorded, and nothing else any longer; the slots with a signal. [SRS_CONS_021]
    [[nodiscard]] SrdoMask Report() noexcept
    {
        SlotWalk walk{x_unreported};
        while (walk.Next())
        {
            const SlotIndex slot = walk.Slot();
            x_columns.signals[slot] = x_columns.causes[slot];
            x_columns.causes[slot] = 0U;
        }
        x_signalled = x_unreported;
        x_unreported = 0U;
        return x_signalled;
    }

  private:
    FaultColumns x_columns;
    SrdoMask x_unreported{0U};
    SrdoMask x_signalled{0U}; ///< By the last OnCycle.
};

} // namespace counterpoint::channel_b

#endif
