// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/production.hpp"

#include "safety_core/comparator/comparator.hpp"
#include "safety_core/comparator/slot_mask.hpp"

namespace counterpoint
{
namespace
{

constexpr std::uint32_t kSignBit = 31U;
constexpr std::uint32_t kMissedBit = std::uint32_t{1U} << static_cast<std::uint32_t>(SrdoCause::kRefreshMissed);

// The GFC as it has to be on the bus, in the memory of constants: what SendGfc composes is compared with it.
constexpr PreparedPair kGfcByFirst{{kGfcIdentifier, FrameKind::kData, CanPortId::kFirst, 0U, {}},
                                   PrepareStatus::kReady};
constexpr PreparedPair kGfcBySecond{{kGfcIdentifier, FrameKind::kData, CanPortId::kSecond, 0U, {}},
                                    PrepareStatus::kReady};

} // namespace

void Production::Begin(const KernelContext& context) noexcept
{
    // An SRDO must follow a GFC within the shortest refresh time of the producers; without one it cannot be followed at
    // all.
    std::uint32_t shortest_ms = 0U;
    for (SlotIndex slot = 0U; slot < context.config->srdo_count; ++slot)
    {
        if (context.guard.Value(slot, ConfigField::kDirection) == kDirectionProducer)
        {
            producers_ |= OnlySlot(slot).mask;
            const std::uint32_t refresh_ms = context.guard.Value(slot, ConfigField::kSct);
            // 0 - 1 is the greatest value: the first producer is always shorter.
            shortest_ms = ((refresh_ms - 1U) < (shortest_ms - 1U)) ? refresh_ms : shortest_ms;
        }
    }
    shortest_refresh_us_ = shortest_ms * kMicrosecondsPerMillisecond;
}

Result Production::Readiness(KernelContext& context) noexcept
{
    if (!context.latch.IsRunning())
    {
        return Result::kDeviceFault;
    }
    if (context.guard.Nmt() != NmtState::kOperational)
    {
        return Result::kNmtError;
    }
    return context.guard.IsValid() ? Result::kSuccessful : Result::kInvalidConfiguration;
}

Result Production::WhyNotSent(KernelContext& context, const SlotIndex wanted) noexcept
{
    const Result readiness = Readiness(context);
    if (readiness != Result::kSuccessful)
    {
        return readiness;
    }
    if (wanted == kNoSlot)
    {
        return Result::kNotExist;
    }
    const bool is_off = context.guard.Value(wanted, ConfigField::kDirection) == kDirectionOff;
    return is_off ? Result::kInvalid : Result::kRxTxConflict;
}

SrdoMask Production::MissedOf(const Channel& channel, SlotSet told) noexcept
{
    SrdoMask missed = told.mask;
    while (told.mask != 0U)
    {
        const SlotIndex slot = TakeLowest(told);
        if ((channel.View(slot).signals & kMissedBit) == 0U)
        {
            missed &= ~OnlySlot(slot).mask;
        }
    }
    return missed;
}

// t        k            k+1
// ahead    next missed  stands    by its counter a whole refresh has passed while one waited, and is skipped
// behind   not due      missed
// A pair at k would be the refresh that waited in both, and the one at k+1 would then wait in the second alone.
void Production::Await(const KernelContext& context, CycleOutcome& a, CycleOutcome& b) noexcept
{
    if ((a.refresh | b.refresh | stand_a_ | stand_b_ | missed_) == 0U)
    {
        return; // No refresh waits, and nobody stands.
    }
    const SrdoMask both = a.refresh & b.refresh;
    const SrdoMask missed_a = MissedOf(context.parts.channel_a, SlotSet{both & a.signalled});
    const SrdoMask missed_b = MissedOf(context.parts.channel_b, SlotSet{both & b.signalled});
    const SrdoMask only_a = missed_a & ~missed_b;
    const SrdoMask only_b = missed_b & ~missed_a;
    // Whoever stood for a missed refresh goes on to, until the other one has missed it, too: then they are even.
    const SrdoMask begun_a = only_a & ~(missed_ & stand_b_);
    const SrdoMask begun_b = only_b & ~(missed_ & stand_a_);
    const SrdoMask ahead_a = ((missed_ & stand_a_ & ~only_b) | begun_a) & both;
    const SrdoMask ahead_b = ((missed_ & stand_b_ & ~only_a) | begun_b) & both;
    missed_ = ahead_a | ahead_b;
    stand_a_ = (a.refresh & ~b.refresh) | ahead_a;
    stand_b_ = (b.refresh & ~a.refresh) | ahead_b;
    a.due &= ~stand_b_;
    b.due &= ~stand_a_;
}

void Production::Produce(KernelContext& context, const SrdoMask start) noexcept
{
    transmitted_told_ = transmitted_;
    transmitted_ = 0U;
    SlotSet to_start{start & context.latch.Gate()};
    while (to_start.mask != 0U)
    {
        const SlotIndex slot = TakeLowest(to_start);
        // Looked at again: what a producer before it brought to light holds for it too. [SRS_KRN_004]
        if (context.latch.IsRunning())
        {
            ProduceSlot(context, slot);
        }
    }
    FollowGfc(context);
}

void Production::ProduceSlot(KernelContext& context, const SlotIndex slot) noexcept
{
    const bool asks_provider = context.config->srdos[slot].form == ProducerForm::kProviderCalled; // MISRA D-002
    if (asks_provider && (context.parts.application.OnRefresh(IndexOf(*context.config, slot)) != RefreshAnswer::kReady))
    {
        return;
    }
    if (!context.latch.IsRunning()) // The provider may demand the device safe state. [SRS_KRN_031]
    {
        return;
    }
    const PreparedPair pair_a = context.parts.channel_a.Prepare(slot);
    const PreparedPair pair_b = context.parts.channel_b.Prepare(slot);
    const PreparedVerdict verdict = Comparator::ComparePrepared(pair_a, pair_b);
    if (verdict == PreparedVerdict::kEqual)
    {
        // Only a pair that begins now follows a GFC, not the second half of one that was there before.
        if (HandOver(context, slot, pair_a.normal) == hal::TransmitStatus::kAccepted)
        {
            gfc_open_ = false;
        }
    }
    else if (verdict == PreparedVerdict::kNotInverse)
    {
        GiveUp(context, slot, SrdoCause::kNotInverse);
    }
    else
    {
        context.latch.Enter(DeviceFault::kDisagreement, slot);
    }
}

void Production::SendInverse(KernelContext& context, const SlotIndex slot) noexcept
{
    if (Readiness(context) != Result::kSuccessful)
    {
        return;
    }
    const PreparedPair inverse_a{context.parts.channel_a.InverseFrame(slot), PrepareStatus::kReady};
    const PreparedPair inverse_b{context.parts.channel_b.InverseFrame(slot), PrepareStatus::kReady};
    if (Comparator::ComparePrepared(inverse_a, inverse_b) == PreparedVerdict::kEqual)
    {
        (void)HandOver(context, slot, inverse_b.normal);
    }
    else
    {
        context.latch.Enter(DeviceFault::kDisagreement, slot);
    }
}

void Production::GiveUp(const KernelContext& context, const SlotIndex slot, const SrdoCause cause) noexcept
{
    const TransmitFault fault{cause};
    context.parts.channel_a.OnTransmitFault(slot, fault);
    context.parts.channel_b.OnTransmitFault(slot, fault);
}

Result Production::SendGfc(KernelContext& context) noexcept
{
    const Result readiness = Readiness(context);
    if (readiness != Result::kSuccessful)
    {
        return readiness;
    }
    if (context.guard.Value(0U, ConfigField::kGfcParameter) != 1U)
    {
        return Result::kGfcUnsupported;
    }
    PreparedPair gfc{};
    gfc.normal.identifier = kGfcIdentifier;
    gfc.normal.kind = FrameKind::kData;
    gfc.normal.port = context.config->normal_port;
    gfc.status = PrepareStatus::kReady;
    const PreparedPair& wanted = (gfc.normal.port == CanPortId::kFirst) ? kGfcByFirst : kGfcBySecond;
    if (Comparator::ComparePrepared(gfc, wanted) != PreparedVerdict::kEqual)
    {
        context.latch.Enter(DeviceFault::kDisagreement, kNoSlot);
        return Result::kDeviceFault;
    }
    if (context.parts.can.Transmit(gfc.normal) != hal::TransmitStatus::kAccepted)
    {
        return Result::kTransmitFailed;
    }
    if (!gfc_open_)
    {
        gfc_open_ = true;
        gfc_until_.us = now_.us + shortest_refresh_us_;
    }
    return Result::kSuccessful;
}

void Production::FollowGfc(const KernelContext& context) noexcept
{
    // Instants are modular: bit 31 of what is left stands for an instant that has passed.
    if (gfc_open_ && (((gfc_until_.us - now_.us) >> kSignBit) != 0U))
    {
        gfc_open_ = false;
        context.parts.application.OnGfcNotFollowed();
    }
}

} // namespace counterpoint
