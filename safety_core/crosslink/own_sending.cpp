// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/crosslink/own_sending.hpp"

#include "safety_core/comparator/slot_mask.hpp"

namespace counterpoint
{

OwnSending::OwnSending(Channel& channel, const PeerRole role) noexcept : channel_{channel}, role_{role}
{
}

void OwnSending::Restart() noexcept
{
    armed_.Restart();
    due_ = 0U;
    peer_due_ = 0U;
    contact_ = 0U;
    standing_ = 0U;
    now_ = Instant{0U};
    status_ = PrepareStatus::kInvalid;
}

SrdoMask OwnSending::Show(const SrdoMask due, const Instant now) noexcept
{
    due_ = due;
    now_ = now;
    if (!IsFollower())
    {
        return due & contact_;
    }
    standing_ = due & ~peer_due_;
    return armed_.Fitting(due & Wanted());
}

PreparedPair OwnSending::PrepareAhead(const SlotIndex slot) noexcept
{
    const PreparedPair prepared = channel_.Prepare(slot);
    status_ = prepared.status;
    if (status_ == PrepareStatus::kReady)
    {
        const std::uint32_t srvt_ms = channel_.Load(ConfigAddress{slot, ConfigField::kSrvt, 0U}).value;
        armed_.Arm(Arming{slot, prepared.normal, now_, srvt_ms * kMicrosecondsPerMillisecond});
    }
    return PreparedPair{CanFrame{}, status_};
}

PreparedPair OwnSending::Prepare(const SlotIndex slot) noexcept
{
    if (IsFollower())
    {
        return PreparedPair{CanFrame{}, status_};
    }
    const PreparedPair prepared = channel_.Prepare(slot);
    status_ = prepared.status;
    due_ &= ~OnlySlot(slot).mask;
    return prepared;
}

void OwnSending::TakeDue(const SrdoMask due, const Window& composed) noexcept
{
    peer_due_ = IsFollower() ? due : SrdoMask{0U};
    contact_ = ~SrdoMask{0U};
    armed_.Clear(composed);
}

void OwnSending::TakeRefusal(const Refusal& refusal, const Instant at) noexcept
{
    const SlotIndex slot = armed_.Refuse(refusal, at);
    if (slot != kNoSlot)
    {
        channel_.OnTransmitFault(slot, TransmitFault{refusal.cause});
    }
}

} // namespace counterpoint
