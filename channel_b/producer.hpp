// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_B_PRODUCER_HPP
#define CHANNEL_B_PRODUCER_HPP

#include "channel_b/parts.hpp"
#include "channel_b/slots.hpp"
#include "channel_b/storage.hpp"
#include "channel_b/tick.hpp"
#include "channel_b/words.hpp"
#include "safety_core/contract/channel.hpp"

#include <cstdint>

namespace counterpoint::channel_b
{

/// All active producers. A pair is in flight at every stage but kIdle; then its normal data are kept and the budget of
/// its confirmation runs. There is an inverse frame at the stage kInverse alone.
class Producers
{
  public:
    Producers(const PairColumns& columns, const Parts& parts) noexcept
        : x_pairs{columns}, x_settings{parts.settings}, x_mappings{parts.mappings}, x_faults{parts.faults}
    {
    }

    /// @brief OPERATIONAL begins or ends without producers; those that are admitted follow.
    void Clear() noexcept;
    void Admit(SlotIndex slot) noexcept;

    void Serve(const Tick& tick, CycleOutcome& outcome) noexcept;
    [[nodiscard]] PreparedPair Prepare(SlotIndex slot) noexcept;
    [[nodiscard]] CanFrame InverseFrame(SlotIndex slot) const noexcept;
    /// @brief A frame of the device to which the look-up leads, so long after the last OnCycle (modular).
    [[nodiscard]] Confirmation OnConfirm(SlotIndex slot, const CanFrame& frame, std::uint32_t since_call_us) noexcept;
    void OnTransmitFault(SlotIndex slot, SrdoCause cause) noexcept;

    [[nodiscard]] bool IsActive(SlotIndex slot) const noexcept
    {
        return HasAny(x_active, BitOf(slot));
    }

    /// @brief Pairs sent.
    [[nodiscard]] std::uint32_t Ordinal(SlotIndex slot) const noexcept
    {
        return x_pairs.ordinal[slot];
    }

    /// @brief Normal data of the pair in flight; 0 if there is none. [SRS_CONS_025]
    [[nodiscard]] Payload InFlight(SlotIndex slot) const noexcept
    {
        return PayloadOf(IsInFlight(slot) ? x_pairs.data[slot] : 0U);
    }

  private:
    /// A corrupted stage is in flight until its budget is over; nothing confirms it.
    [[nodiscard]] bool IsInFlight(SlotIndex slot) const noexcept
    {
        return IsActive(slot) && (x_pairs.stage[slot] != Stage::kIdle);
    }

    /// For so long the application may send nothing: the refresh time and a cycle that is just in time.
    [[nodiscard]] std::uint32_t SilenceUs(SlotIndex slot) const noexcept
    {
        return x_settings.SctUs(slot) + x_settings.LongestCallUs();
    }

    [[nodiscard]] std::uint64_t InverseData(SlotIndex slot) const noexcept
    {
        return ~x_pairs.data[slot] & LowBytes(x_mappings.LengthBytes(slot));
    }

    [[nodiscard]] SrdoCause FlawOf(SlotIndex slot, const CanFrame& frame, std::uint64_t data,
                                   std::uint32_t since_call_us) const noexcept;
    [[nodiscard]] Confirmation ConfirmNormal(SlotIndex slot, const CanFrame& frame,
                                             std::uint32_t since_call_us) noexcept;
    [[nodiscard]] Confirmation ConfirmInverse(SlotIndex slot, const CanFrame& frame,
                                              std::uint32_t since_call_us) noexcept;
    [[nodiscard]] bool IsProvider(SlotIndex slot) const noexcept
    {
        return x_settings.Form(slot) == ProducerForm::kProviderCalled;
    }

    /// A fault that gives up the pair in flight. [SRS_PROD_009]
    void Fail(SlotIndex slot, SrdoCause cause) noexcept
    {
        x_pairs.stage[slot] = Stage::kIdle;
        x_faults.Record(slot, cause);
    }

    void SpendConfirmation(SlotIndex slot, std::uint32_t elapsed_us) noexcept;
    void SpendPhase(SlotIndex slot, std::uint32_t elapsed_us) noexcept;
    void AdvanceProvider(SlotIndex slot) noexcept;
    void AdvanceApplication(SlotIndex slot) noexcept;

    PairColumns x_pairs;
    const Settings& x_settings;
    const Mappings& x_mappings;
    Faults& x_faults;
    SrdoMask x_active{0U};
    SrdoMask x_started{0U};     ///< The first transmission is possible.
    SrdoMask x_requested{0U};   ///< The application wants to send.
    SrdoMask x_refresh_due{0U}; ///< A refresh fell due and was not prepared yet.
    SrdoMask x_silent{0U};      ///< The phase is that of the application's silence.
};

} // namespace counterpoint::channel_b

#endif
