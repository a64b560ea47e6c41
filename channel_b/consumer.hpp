// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_B_CONSUMER_HPP
#define CHANNEL_B_CONSUMER_HPP

#include "channel_b/parts.hpp"
#include "channel_b/slots.hpp"
#include "channel_b/storage.hpp"
#include "channel_b/tick.hpp"
#include "channel_b/words.hpp"
#include "safety_core/contract/channel.hpp"

#include <cstdint>

namespace counterpoint::channel_b
{

/// All active consumers. Nothing here is a state: marks say what is held and granted, budgets what time is left, masks
/// what has happened. What a consumer is follows from them, anew whenever it matters.
///
/// Invariants between two calls:
/// - `granted` implies `held`; a held pair implies an ordinal above 0 (until the ordinal wraps);
/// - the budget of SCT belongs to the held pair, the budget of SRVT to the pending normal frame;
/// - x_committed are the slots whose inverse objects hold released data;
/// - a permit wants a slot in x_committed and in x_permitted, so that no single flipped bit is one.
class Consumers
{
  public:
    Consumers(const PairColumns& columns, const Parts& parts) noexcept
        : x_pairs{columns}, x_settings{parts.settings}, x_mappings{parts.mappings}, x_faults{parts.faults}
    {
    }

    void Restart() noexcept;
    /// @brief OPERATIONAL begins without consumers; those that are admitted follow.
    void Enter() noexcept;
    void Admit(SlotIndex slot) noexcept;
    /// @brief OPERATIONAL ends; the slots that were active.
    [[nodiscard]] SrdoMask Leave() noexcept;

    /// @brief A data frame that the look-up leads here, so long after the last OnCycle (modular); only an active
    /// consumer takes it. [SRS_CONS_001]
    void OnFrame(SlotIndex slot, const CanFrame& frame, std::uint32_t since_call_us) noexcept
    {
        if (!IsActive(slot))
        {
            return;
        }
        const std::uint64_t data = FrameWord(frame);
        if ((frame.identifier % 2U) != 0U)
        {
            TakeNormal(slot, frame, data, since_call_us);
        }
        else
        {
            TakeInverse(slot, frame, data, since_call_us);
        }
    }

    void Serve(const Tick& tick, CycleOutcome& outcome) noexcept;
    void Demote(SlotIndex slot) noexcept;
    /// @brief Writes, then reads back; the slots whose objects hold something else than was written.
    [[nodiscard]] SrdoMask Commit(const Agreement& agreement, SrdoMask examine) noexcept;
    /// @brief What was released of this slot is over. The objects of a consumer take the safe value, which is read
    /// back; the next Commit tells if it is not there.
    void SetUp(SlotIndex slot) noexcept;

    [[nodiscard]] bool IsActive(SlotIndex slot) const noexcept
    {
        return HasAny(x_active, BitOf(slot));
    }

    [[nodiscard]] SrdoState StateOf(SlotIndex slot) const noexcept;
    /// @brief Of a valid pair the inverse data tell the normal data. [SRS_CONS_025]
    [[nodiscard]] HeldPair Held(SlotIndex slot) const noexcept
    {
        HeldPair pair{{0U, 0U}, 0U, 0U};
        if (IsActive(slot))
        {
            pair.ordinal = x_pairs.ordinal[slot];
            if (IsHeld(slot))
            {
                pair.data = PayloadOf(~x_pairs.data[slot] & x_mappings.MappedBits(slot));
                pair.holds_pair = 1U;
            }
        }
        return pair;
    }

    /// @brief What the last Commit, since the last OnCycle, left committed and did not return. [SRS_REL_010]
    [[nodiscard]] SrdoMask Permitted() const noexcept
    {
        return x_committed & x_permitted;
    }

  private:
    [[nodiscard]] bool IsHeld(SlotIndex slot) const noexcept
    {
        return x_pairs.held[slot] == Mark::kHeld;
    }

    [[nodiscard]] bool IsReleased(SlotIndex slot) const noexcept
    {
        return IsHeld(slot) && (x_pairs.granted[slot] == Mark::kGranted) && x_faults.IsCauseDefined(slot);
    }
    [[nodiscard]] bool IsSound(SlotIndex slot) const noexcept;

    [[nodiscard]] SrdoCause ExpiredAt(SlotIndex slot, std::uint32_t since_call_us) const noexcept;
    [[nodiscard]] SrdoCause ExpiredAtInverse(SlotIndex slot, std::uint32_t since_call_us) const noexcept;
    [[nodiscard]] SrdoMask Settle(SrdoMask quiet, std::uint32_t elapsed_us, CycleOutcome& outcome) noexcept;
    void SpendOthers(SlotIndex slot, std::uint32_t elapsed_us) noexcept;
    void Examine(SlotIndex slot, const Tick& tick) noexcept;
    [[nodiscard]] bool Grant(SlotIndex slot) noexcept;
    [[nodiscard]] bool ServeBusy(SlotIndex slot, const Tick& tick, CycleOutcome& outcome) noexcept;
    void Discard(SlotIndex slot) noexcept;
    [[gnu::cold]] void Fault(SlotIndex slot, SrdoCause cause) noexcept;

    [[nodiscard]] SrdoCause FlawOfNormal(SlotIndex slot, const CanFrame& frame) const noexcept;
    [[nodiscard]] SrdoCause FlawOfInverse(SlotIndex slot, const CanFrame& frame) const noexcept;
    void TakeNormal(SlotIndex slot, const CanFrame& frame, std::uint64_t data, std::uint32_t since_call_us) noexcept;
    void TakeInverse(SlotIndex slot, const CanFrame& frame, std::uint64_t data, std::uint32_t since_call_us) noexcept;

    PairColumns x_pairs;
    const Settings& x_settings;
    const Mappings& x_mappings;
    Faults& x_faults;
    SrdoMask x_active{0U};
    SrdoMask x_pending{0U};   ///< A normal frame waits for its inverse frame.
    SrdoMask x_fresh{0U};     ///< A pair was completed since the last OnCycle.
    SrdoMask x_unheard{0U};   ///< No pair, fault or complaint since OPERATIONAL was entered.
    SrdoMask x_troubled{0U};  ///< A fault since OPERATIONAL was entered.
    SrdoMask x_released{0U};  ///< As the last OnCycle decided, less those with a fault since.
    SrdoMask x_unwritten{0U}; ///< The held pair has not been written into the objects.
    SrdoMask x_committed{0U};
    SrdoMask x_missed{0U};         ///< Set up, and the objects did not hold the safe value; not told yet.
    SrdoMask x_permitted{0U};      ///< Committed and found as written by the last Commit; none since an OnCycle.
    std::uint32_t x_active_us{0U}; ///< Since entering OPERATIONAL.
};

} // namespace counterpoint::channel_b

#endif
