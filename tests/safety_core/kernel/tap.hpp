// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_SAFETY_CORE_KERNEL_TAP_HPP
#define TESTS_SAFETY_CORE_KERNEL_TAP_HPP

#include "safety_core/contract/channel.hpp"

#include <functional>
#include <utility>
#include <vector>

namespace counterpoint
{

/// Hands every call on to a real channel; a test may alter what comes back, or keep a call from being made.
class Tap final : public Channel
{
  public:
    explicit Tap(Channel& real) noexcept : real_{real}
    {
    }

    void Restart(const DeviceConfig& config) noexcept override
    {
        real_.Restart(config);
    }
    void Store(const ConfigItem& item) noexcept override
    {
        last_stored = item;
        if (!drop_store)
        {
            real_.Store(item);
        }
    }
    ConfigItem Load(const ConfigAddress& address) const noexcept override
    {
        ConfigItem item = real_.Load(address);
        item.value ^= ((load_slot == kNoSlot) || (address.slot == load_slot)) ? load_flip : 0U;
        return item;
    }
    ChannelRoom Room() const noexcept override
    {
        const ChannelRoom real = real_.Room();
        return ChannelRoom{(room_slots == 0U) ? real.slots : room_slots,
                           (room_entries == 0U) ? real.map_entries : room_entries};
    }
    void SetFields(SlotIndex slot, const StaticFields& fields) noexcept override
    {
        ++fields_set;
        last_fields = fields;
        fields_slot = slot;
        real_.SetFields(slot, fields);
    }
    DeviceDigest Digest(SlotIndex slot, DeviceDigest before) const noexcept override
    {
        ++digests;
        DeviceDigest digest = real_.Digest(slot, before);
        digest.value ^= (slot == digest_slot) ? digest_flip : 0U;
        return digest;
    }
    CheckResult Validate(SlotIndex slot) noexcept override
    {
        validated = slot;
        return Alter(slot, real_.Validate(slot));
    }
    CheckResult Recheck(SlotIndex slot) noexcept override
    {
        rechecked = slot;
        return Alter(slot, real_.Recheck(slot));
    }
    void OnFrame(const CanFrame& frame, Instant stamp) noexcept override
    {
        if (keep_frames)
        {
            heard.emplace_back(frame, stamp);
        }
        if (on_frame)
        {
            on_frame();
        }
        if (!drop_frames)
        {
            real_.OnFrame(frame, stamp);
        }
    }
    CycleOutcome OnCycle(const CycleInput& input) noexcept override
    {
        last_input = input;
        requests |= input.request;
        stands += (input.stand == 0U) ? 0 : 1;
        CycleOutcome outcome = skip_cycle ? CycleOutcome{} : real_.OnCycle(input);
        if (on_outcome)
        {
            on_outcome(outcome);
        }
        return outcome;
    }
    HeldPair Held(SlotIndex slot) const noexcept override
    {
        last_held = slot;
        HeldPair held = real_.Held(slot);
        held.data.low ^= data_flip;
        return held;
    }
    SrdoView View(SlotIndex slot) const noexcept override
    {
        last_viewed = slot;
        SrdoView view = real_.View(slot);
        view.signals |= ((signals_slot == kNoSlot) || (slot == signals_slot)) ? more_signals : 0U;
        view.first_cause = (first_cause == SrdoCause::kNone) ? view.first_cause : first_cause;
        return view;
    }
    void Demote(SlotIndex slot) noexcept override
    {
        ++demotions;
        demoted = slot;
        real_.Demote(slot);
    }
    [[nodiscard]] SrdoMask Commit(const Agreement& agreement, SrdoMask examine) noexcept override
    {
        if (keep_examined)
        {
            examined.push_back(examine);
        }
        if (skip_commit)
        {
            return 0U;
        }
        const SrdoMask found = real_.Commit(agreement, examine);
        if (on_committed)
        {
            on_committed();
        }
        return found | more_found;
    }
    Permit Answer(std::uint32_t challenge) const noexcept override
    {
        Permit permit = real_.Answer(challenge);
        permit.response ^= permit_flip;
        permit.mask ^= permit_slots;
        return permit;
    }
    PreparedPair Prepare(SlotIndex slot) noexcept override
    {
        PreparedPair pair = real_.Prepare(slot);
        if (on_prepared)
        {
            on_prepared(pair);
        }
        return pair;
    }
    Confirmation OnConfirm(const CanFrame& frame, Instant stamp) noexcept override
    {
        Confirmation confirmation{kNoSlot, ConfirmStep::kNone};
        if (!drop_confirms)
        {
            confirmation = real_.OnConfirm(frame, stamp);
        }
        if (on_confirmed)
        {
            on_confirmed(confirmation);
        }
        return confirmation;
    }
    CanFrame InverseFrame(SlotIndex slot) const noexcept override
    {
        ++inverse_frames;
        CanFrame frame = real_.InverseFrame(slot);
        if (on_inverse)
        {
            on_inverse(frame);
        }
        return frame;
    }
    void OnTransmitFault(SlotIndex slot, const TransmitFault& fault) noexcept override
    {
        transmit_faults.push_back(fault.cause);
        given_up = slot;
        real_.OnTransmitFault(slot, fault);
    }

    std::function<void()> on_frame{};
    std::function<void(CycleOutcome&)> on_outcome{};
    std::function<void(PreparedPair&)> on_prepared{};
    std::function<void(Confirmation&)> on_confirmed{};
    std::function<void(CanFrame&)> on_inverse{};
    std::function<void()> on_committed{};
    std::vector<SrdoCause> transmit_faults{};
    std::vector<SrdoMask> examined{};                  ///< By each Commit, if they are kept.
    std::vector<std::pair<CanFrame, Instant>> heard{}; ///< By each OnFrame, if they are kept.
    SrdoMask more_found{0U};                           ///< Slots that Commit finds otherwise than written.
    SrdoMask requests{0U};                             ///< All that were asked for.
    std::uint32_t load_flip{0U};
    std::uint32_t data_flip{0U};
    std::uint32_t permit_flip{0U};
    SrdoMask permit_slots{0U};
    std::uint32_t digest_flip{0U};
    std::uint32_t more_signals{0U};
    SrdoCause first_cause{SrdoCause::kNone}; ///< In each view; kNone: what the channel has.
    StaticFields last_fields{};
    ConfigItem last_stored{};
    CycleInput last_input{};
    SlotIndex digest_slot{0U};            ///< Where it is flipped.
    SlotIndex load_slot{kNoSlot};         ///< Likewise; kNoSlot: everywhere.
    SlotIndex signals_slot{kNoSlot};      ///< Likewise.
    SlotIndex check_slot{kNoSlot};        ///< Of `check_fault` and `signature_flip`.
    SlotIndex fields_slot{kNoSlot};       ///< By the last SetFields.
    SlotIndex validated{kNoSlot};         ///< By the last Validate.
    SlotIndex rechecked{kNoSlot};         ///< By the last Recheck.
    SlotIndex demoted{kNoSlot};           ///< By the last Demote.
    mutable SlotIndex last_held{kNoSlot}; ///< Of which the last pair was asked for.
    mutable SlotIndex last_viewed{kNoSlot};
    SlotIndex given_up{kNoSlot}; ///< By the last OnTransmitFault.
    std::uint16_t signature_flip{0U};
    std::uint8_t room_slots{0U};   ///< Instead of the real one's; 0: the real one's.
    std::uint8_t room_entries{0U}; ///< Likewise.
    ConfigFault check_fault{ConfigFault::kNone};
    int demotions{0};
    int fields_set{0};
    int stands{0};                 ///< Calls with a producer that stands.
    mutable int inverse_frames{0}; ///< Times that it was asked for one.
    mutable int digests{0};        ///< Likewise.
    bool drop_store{false};
    bool drop_frames{false};
    bool drop_confirms{false};
    bool skip_cycle{false};
    bool skip_commit{false};
    bool keep_examined{false};
    bool keep_frames{false};

  private:
    CheckResult Alter(const SlotIndex slot, CheckResult result) const noexcept
    {
        const bool is_found = (check_slot == kNoSlot) || (slot == check_slot);
        result.signature = static_cast<std::uint16_t>(result.signature ^ (is_found ? signature_flip : 0U));
        result.fault = (is_found && (check_fault != ConfigFault::kNone)) ? check_fault : result.fault;
        return result;
    }

    Channel& real_;
};

} // namespace counterpoint

#endif
