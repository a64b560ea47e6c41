// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CONFORMANCE_TWISTING_HPP
#define VERIFICATION_CONFORMANCE_TWISTING_HPP

#include "verification/conformance/forwarding.hpp"

#include <cstdint>

namespace counterpoint::conformance
{

/// Of all numbers that a channel returns, the one of that place is another one.
class Twisting final : public Forwarding
{
  public:
    Twisting(Channel& inner, std::uint32_t place) noexcept : Forwarding(inner), place_(place)
    {
    }

    [[nodiscard]] ConfigItem Load(const ConfigAddress& address) const noexcept override
    {
        ConfigItem item = Forwarding::Load(address);
        Twist(0U, item.value);
        return item;
    }
    [[nodiscard]] DeviceDigest Digest(SlotIndex slot, DeviceDigest before) const noexcept override
    {
        DeviceDigest digest = Forwarding::Digest(slot, before);
        Twist(1U, digest.value);
        return digest;
    }
    [[nodiscard]] CheckResult Validate(SlotIndex slot) noexcept override
    {
        return Twisted(2U, Forwarding::Validate(slot));
    }
    [[nodiscard]] CheckResult Recheck(SlotIndex slot) noexcept override
    {
        return Twisted(4U, Forwarding::Recheck(slot));
    }
    [[nodiscard]] SrdoMask Commit(const Agreement& agreement, SrdoMask examine) noexcept override
    {
        SrdoMask found = Forwarding::Commit(agreement, examine);
        Twist(6U, found);
        return found;
    }
    [[nodiscard]] Permit Answer(std::uint32_t challenge) const noexcept override
    {
        Permit permit = Forwarding::Answer(challenge);
        Twist(7U, permit.mask);
        Twist(8U, permit.response);
        return permit;
    }
    [[nodiscard]] PreparedPair Prepare(SlotIndex slot) noexcept override
    {
        PreparedPair pair = Forwarding::Prepare(slot);
        Twist(9U, pair.status);
        pair.normal = Twisted(10U, pair.normal);
        return pair;
    }
    [[nodiscard]] CanFrame InverseFrame(SlotIndex slot) const noexcept override
    {
        return Twisted(22U, Forwarding::InverseFrame(slot));
    }
    [[nodiscard]] Confirmation OnConfirm(const CanFrame& frame, Instant stamp) noexcept override
    {
        Confirmation confirmation = Forwarding::OnConfirm(frame, stamp);
        Twist(34U, confirmation.slot);
        Twist(35U, confirmation.step);
        return confirmation;
    }
    [[nodiscard]] HeldPair Held(SlotIndex slot) const noexcept override
    {
        HeldPair held = Forwarding::Held(slot);
        Twist(36U, held.data.low);
        Twist(37U, held.data.high);
        Twist(38U, held.ordinal);
        Twist(39U, held.holds_pair);
        return held;
    }
    [[nodiscard]] SrdoView View(SlotIndex slot) const noexcept override
    {
        SrdoView view = Forwarding::View(slot);
        Twist(40U, view.data.low);
        Twist(41U, view.data.high);
        Twist(42U, view.ordinal);
        Twist(43U, view.signals);
        Twist(44U, view.error_count);
        Twist(45U, view.state);
        Twist(46U, view.first_cause);
        Twist(47U, view.holds_pair);
        return view;
    }
    [[nodiscard]] CycleOutcome OnCycle(const CycleInput& input) noexcept override
    {
        CycleOutcome outcome = Forwarding::OnCycle(input);
        SrdoMask* const masks[] = {&outcome.released, &outcome.faulted, &outcome.waiting, &outcome.new_fault,
                                   &outcome.fresh,    &outcome.due,     &outcome.refresh, &outcome.signalled};
        for (std::uint32_t i = 0U; i < 8U; ++i)
        {
            Twist(48U + i, *masks[i]);
        }
        Twist(56U, outcome.cycle);
        Twist(57U, outcome.ordinal_sum);
        Twist(58U, outcome.guard);
        Twist(59U, outcome.sct_checked);
        Twist(60U, outcome.is_tx);
        Twist(61U, outcome.is_invalid);
        Twist(62U, outcome.not_operational);
        return outcome;
    }

    static constexpr std::uint32_t kPlaces = 63U;

  private:
    template <typename Number> void Twist(std::uint32_t place, Number& number) const noexcept
    {
        number = (place == place_) ? static_cast<Number>(static_cast<std::uint64_t>(number) ^ 1U) : number;
    }
    [[nodiscard]] CheckResult Twisted(std::uint32_t place, CheckResult result) const noexcept
    {
        Twist(place, result.fault);
        Twist(place + 1U, result.signature);
        return result;
    }
    [[nodiscard]] CanFrame Twisted(std::uint32_t place, CanFrame frame) const noexcept
    {
        Twist(place, frame.identifier);
        Twist(place + 1U, frame.kind);
        Twist(place + 2U, frame.port);
        Twist(place + 3U, frame.length_bytes);
        for (std::uint32_t i = 0U; i < kMaxPayloadBytes; ++i)
        {
            Twist(place + 4U + i, frame.data[i]);
        }
        return frame;
    }

    std::uint32_t place_;
};

} // namespace counterpoint::conformance

#endif
