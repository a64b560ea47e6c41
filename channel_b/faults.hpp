// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_B_FAULTS_HPP
#define CHANNEL_B_FAULTS_HPP

#include "channel_b/settings.hpp"
#include "channel_b/storage.hpp"

#include <cstdint>

namespace counterpoint::channel_b
{

/// What went wrong in each slot, and what of it is signalled.
class Faults
{
  public:
    Faults(const FaultColumns& columns, const Settings& settings) noexcept : x_columns(columns), x_settings(settings)
    {
    }

    void Restart() noexcept;

    /// @brief Counts a fault; the first one is kept.
    void Count(SlotIndex slot, SrdoCause cause) noexcept;
    /// @brief A fault that the next OnCycle, or this one, reports.
    void Record(SlotIndex slot, SrdoCause cause) noexcept;
    /// @brief To be signalled like a fault, without being one.
    void Complain(SlotIndex slot, SrdoCause cause) noexcept;
    /// @brief The first cause was read.
    void Forget(SlotIndex slot) noexcept;

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

    [[nodiscard]] std::uint32_t Signals(SlotIndex slot) const noexcept;

    /// @brief The windows grow older; the signals of the last call are gone.
    void Age(std::uint32_t elapsed_us) noexcept;
    /// @brief Reports what was recorded; the slots with a signal.
    [[nodiscard]] SrdoMask Report() noexcept;

  private:
    FaultColumns x_columns;
    const Settings& x_settings;
    SrdoMask x_unreported{0U};
    SrdoMask x_windows{0U};   ///< Slots with an open window.
    SrdoMask x_signalled{0U}; ///< By the last OnCycle.
};

} // namespace counterpoint::channel_b

#endif
