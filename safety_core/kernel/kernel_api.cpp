// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/kernel.hpp"

#include "safety_core/comparator/slot_mask.hpp"

// Calls of the application and of the services around the kernel. [SRS_KRN_010, SRS_KRN_011, SRS_KRN_015,
// SRS_KRN_021, SRS_KRN_022, SRS_KRN_023, SRS_KRN_024, SRS_KRN_025]
namespace counterpoint
{
// What lies outside of 1301h to 1340h leads to a number that no SRDO has.
SlotIndex Kernel::SlotAt(const std::uint32_t index) const noexcept
{
    const std::uint32_t place = index - kFirstCommunication;
    // Most devices have no gaps: nothing to look for.
    if ((config_->gaps != NumberGaps::kSearched) && (place < config_->srdo_count))
    {
        return static_cast<SlotIndex>(place);
    }
    return SlotOf(*config_, SrdoNumber{place + 1U});
}

void Kernel::SetNmtState(const NmtState state) noexcept
{
    if (!run_.started)
    {
        return;
    }
    if (state == guard_.Nmt())
    {
        return;
    }
    if (guard_.Nmt() == NmtState::kOperational)
    {
        run_.left_operational = true;
        run_.requests = 0U;
        Withdraw();
    }
    run_.producers = 0U;
    guard_.SetNmt(state);
    if (state == NmtState::kOperational)
    {
        EnterOperational();
    }
}

void Kernel::EnterOperational() noexcept
{
    if (!guard_.IsValid())
    {
        return; // No fault: SRDOs are off until the configuration is declared valid.
    }
    if (guard_.CheckAll(CheckDepth::kRecheck) != ConfigFault::kNone)
    {
        guard_.Invalidate();
        parts_.application.OnConfigurationInvalid(IndexOf(guard_.Faulty()));
        return;
    }
    // Directions and times stay as they are until OPERATIONAL is left. An SRDO must follow a GFC within the shortest
    // refresh time of the producers; without one it cannot be followed at all.
    std::uint32_t shortest_ms = 0U;
    for (SlotIndex slot = 0U; slot < config_->srdo_count; ++slot)
    {
        if (guard_.Value(slot, ConfigField::kDirection) == kDirectionProducer)
        {
            run_.producers |= OnlySlot(slot).mask;
            const std::uint32_t refresh_ms = guard_.Value(slot, ConfigField::kSct);
            // 0 - 1 is the greatest value: the first producer is always shorter.
            shortest_ms = ((refresh_ms - 1U) < (shortest_ms - 1U)) ? refresh_ms : shortest_ms;
        }
    }
    run_.shortest_refresh_us = shortest_ms * kMicrosecondsPerMillisecond;
}

Result Kernel::SendReadiness() const noexcept
{
    if (!latch_.IsRunning())
    {
        return Result::kDeviceFault;
    }
    if (guard_.Nmt() != NmtState::kOperational)
    {
        return Result::kNmtError;
    }
    return guard_.IsValid() ? Result::kSuccessful : Result::kInvalidConfiguration;
}

Result Kernel::Send(const CommunicationIndex index) noexcept
{
    if (index.value == 0U)
    {
        return Request(kNoSlot, run_.producers);
    }
    const SlotIndex slot = SlotAt(index.value);
    return (slot == kNoSlot) ? Missing() : Request(slot, run_.producers & OnlySlot(slot).mask);
}

Result Kernel::Request(const SlotIndex wanted, const SrdoMask to_send) noexcept
{
    if ((to_send == 0U) || (!latch_.IsRunning()))
    {
        return WhyNotSent(wanted);
    }
    run_.requests |= to_send;
    return Result::kSuccessful;
}

Result Kernel::WhyNotSent(const SlotIndex wanted) const noexcept
{
    const Result readiness = SendReadiness();
    if (readiness != Result::kSuccessful)
    {
        return readiness;
    }
    if (wanted == kNoSlot)
    {
        return Result::kNotExist;
    }
    const bool is_off = guard_.Value(wanted, ConfigField::kDirection) == kDirectionOff;
    return is_off ? Result::kInvalid : Result::kRxTxConflict;
}

CheckReply Kernel::CheckConfiguration() noexcept
{
    CheckReply reply{Result::kDeviceFault, CommunicationIndex{0U}};
    if (run_.started)
    {
        // To resolve a mapping anew is not for OPERATIONAL; elsewhere the first rule that is broken is what is told.
        const bool is_in_use = guard_.Nmt() == NmtState::kOperational;
        const ConfigFault rule = guard_.CheckAll(is_in_use ? CheckDepth::kRecheck : CheckDepth::kValidate);
        reply.result = ToResult(rule);
        if (rule != ConfigFault::kNone)
        {
            reply.index = IndexOf(guard_.Faulty());
        }
        else
        {
            reply.result = guard_.Digest().result;
        }
    }
    return reply;
}

SignReply Kernel::Sign(const CommunicationIndex index) noexcept
{
    const SlotIndex slot = SlotAt(index.value);
    if (slot == kNoSlot)
    {
        return SignReply{Missing(), 0U};
    }
    const CheckResult result = guard_.Check(slot, CheckDepth::kRecheck);
    return (result.fault == ConfigFault::kInvalid) ? SignReply{Result::kDeviceFault, 0U}
                                                   : SignReply{Result::kSuccessful, result.signature};
}

StateReply Kernel::GetState(const CommunicationIndex index) const noexcept
{
    const SlotIndex slot = SlotAt(index.value);
    if (slot == kNoSlot)
    {
        return StateReply{Missing(), SrdoState::kInvalid, SrdoCause::kInvalid, 0U};
    }
    const SrdoView a = parts_.channel_a.View(slot);
    const SrdoView b = parts_.channel_b.View(slot);
    // In the device safe state nothing is released, whatever the channels still hold.
    const bool is_shared = (a.state == b.state) && ((a.state != SrdoState::kReleased) || latch_.IsRunning());
    const SrdoState state = is_shared ? a.state : SrdoState::kFaulted;
    // A demoted channel learned of the fault from the other one, which knows the cause.
    const bool asks_b = (a.first_cause == SrdoCause::kDemoted) || (a.first_cause == SrdoCause::kNone);
    const std::uint16_t error_count = (a.error_count > b.error_count) ? a.error_count : b.error_count;
    return StateReply{Result::kSuccessful, state, asks_b ? b.first_cause : a.first_cause, error_count};
}

StatusReply Kernel::GetStatus(const CommunicationIndex index) const noexcept
{
    const SlotIndex slot = SlotAt(index.value);
    return (slot == kNoSlot) ? StatusReply{Missing(), StatusByte{0U}}
                             : StatusReply{Result::kSuccessful, record_.status.Get(slot)};
}

Result Kernel::SetStatus(const CommunicationIndex index, const StatusByte status) noexcept
{
    const SlotIndex slot = SlotAt(index.value);
    if (slot == kNoSlot)
    {
        return Missing();
    }
    record_.status.Answer(slot, status);
    return Result::kSuccessful;
}

ParametersReply Kernel::GetParameters(const CommunicationIndex index) const noexcept
{
    const SlotIndex slot = SlotAt(index.value);
    if (slot == kNoSlot)
    {
        return ParametersReply{Missing(), 0U, 0U, 0U};
    }
    return ParametersReply{Result::kSuccessful, static_cast<std::uint8_t>(guard_.Value(slot, ConfigField::kDirection)),
                           static_cast<std::uint16_t>(guard_.Value(slot, ConfigField::kSct)),
                           static_cast<std::uint8_t>(guard_.Value(slot, ConfigField::kMapCount))};
}

MappedReply Kernel::GetMapped(const CommunicationIndex index, const MappedEntry entry) const noexcept
{
    MappedReply reply{Missing(), VariablePlace{nullptr, 0U}};
    const SlotIndex slot = SlotAt(index.value);
    // 0 - 1 is the greatest value: there is no entry 0.
    if ((slot != kNoSlot) && ((entry.number - 1U) < guard_.Value(slot, ConfigField::kMapCount)))
    {
        const std::uint32_t mapped = guard_.Value(slot, ConfigField::kMapEntry, entry.number);
        const MappableObject* const object = FindMapped(*config_, mapped);
        reply.result = Result::kSuccessful;
        reply.variable.length_bits = static_cast<std::uint8_t>(mapped & kEntryLengthMask);
        reply.variable.place = (object == nullptr) ? nullptr : object->place;
    }
    return reply;
}

Result Kernel::DefineStaticFields(const CommunicationIndex index, const StaticFields& fields) noexcept
{
    const SlotIndex slot = SlotAt(index.value);
    return (slot == kNoSlot) ? Missing() : guard_.DefineFields(slot, fields);
}

} // namespace counterpoint
