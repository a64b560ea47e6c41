// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/kernel.hpp"

#include "safety_core/comparator/slot_mask.hpp"

// Calls of the application and of the services around the kernel. [SRS-KRN-010, SRS-KRN-011, SRS-KRN-015,
// SRS-KRN-021..025]
namespace counterpoint
{
SlotIndex Kernel::SlotAt(const CommunicationIndex index) const noexcept
{
    const std::uint32_t distance = static_cast<std::uint32_t>(index.value) - kFirstCommunication;
    if (distance >= kMaxSrdoCount)
    {
        return kNoSlot;
    }
    return SlotOf(*config_, SrdoNumber{static_cast<std::uint8_t>(distance + 1U)});
}

void Kernel::SetNmtState(const NmtState state) noexcept
{
    if (!run_.started)
    {
        return;
    }
    const bool was_operational = guard_.Nmt() == NmtState::kOperational;
    const bool is_operational = state == NmtState::kOperational;
    guard_.SetNmt(state);
    if (is_operational && (!was_operational))
    {
        EnterOperational();
    }
    if (was_operational && (!is_operational))
    {
        run_.left_operational = true;
    }
}

void Kernel::EnterOperational() noexcept
{
    if (!guard_.IsValid())
    {
        return; // No fault: SRDOs are off until the configuration is declared valid.
    }
    const ConfigurationFinding finding = guard_.CheckAll(CheckDepth::kRecheck);
    if (finding.rule != ConfigFault::kNone)
    {
        guard_.Invalidate();
        parts_.application.OnConfigurationInvalid(IndexOf(finding.slot));
    }
    // Directions stay as they are until OPERATIONAL is left.
    run_.producers = 0U;
    for (SlotIndex slot = 0U; slot < config_->srdo_count; ++slot)
    {
        const bool is_producer = guard_.Value(slot, ConfigField::kDirection) == kDirectionProducer;
        run_.producers |= is_producer ? OnlySlot(slot).mask : SrdoMask{0U};
    }
}

ObjectReading Kernel::ReadObject(const ObjectAddress& address) noexcept
{
    return guard_.Read(address);
}

AbortCode Kernel::WriteObject(const ObjectAddress& address, const ObjectData& data) noexcept
{
    return guard_.Write(address, data);
}

HeaderReply Kernel::ConfigurationHeader() noexcept
{
    return guard_.Header(guard_.Valid());
}

ItemReply Kernel::ReadItem(const std::uint32_t number) noexcept
{
    return guard_.ReadItem(number);
}

Result Kernel::LoadItem(const std::uint32_t number, const std::uint32_t value) noexcept
{
    return guard_.LoadItem(number, value);
}

Result Kernel::LoadConfiguration(const ImageHeader& header) noexcept
{
    return guard_.Load(header);
}

Result Kernel::RestoreDefaults() noexcept
{
    return guard_.RestoreDefaults();
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
    const SlotIndex wanted = SlotAt(index);
    if ((wanted == kNoSlot) && (index.value != 0U))
    {
        return Result::kNotExist;
    }
    const Result readiness = SendReadiness();
    if (readiness != Result::kSuccessful)
    {
        return readiness;
    }
    const SrdoMask meant = (wanted == kNoSlot) ? ~SrdoMask{0U} : OnlySlot(wanted).mask;
    const SrdoMask to_send = meant & run_.producers;
    run_.requests |= to_send;
    Result result = (to_send != 0U) ? Result::kSuccessful : Result::kNotExist;
    if ((wanted != kNoSlot) && (to_send == 0U))
    {
        const bool is_off = guard_.Value(wanted, ConfigField::kDirection) == kDirectionOff;
        result = is_off ? Result::kInvalid : Result::kRxTxConflict;
    }
    return result;
}

CheckReply Kernel::CheckConfiguration() noexcept
{
    CheckReply reply{Result::kDeviceFault, CommunicationIndex{0U}};
    if (run_.started)
    {
        const ConfigurationFinding finding = guard_.CheckAll(CheckDepth::kRecheck);
        reply.result = ToResult(finding.rule);
        if (finding.slot != kNoSlot)
        {
            reply.index = IndexOf(finding.slot);
        }
    }
    return reply;
}

SignReply Kernel::Sign(const CommunicationIndex index) noexcept
{
    const SlotIndex slot = SlotAt(index);
    if (slot == kNoSlot)
    {
        return SignReply{Result::kNotExist, 0U};
    }
    const ConfigurationFinding finding = guard_.Check(slot, CheckDepth::kRecheck);
    return (finding.rule == ConfigFault::kInvalid) ? SignReply{Result::kDeviceFault, 0U}
                                                   : SignReply{Result::kSuccessful, finding.signature};
}

StateReply Kernel::GetState(const CommunicationIndex index) const noexcept
{
    const SlotIndex slot = SlotAt(index);
    if (slot == kNoSlot)
    {
        return StateReply{Result::kNotExist, SrdoState::kInvalid, SrdoCause::kInvalid, 0U};
    }
    const SrdoView a = parts_.channel_a.View(slot);
    const SrdoView b = parts_.channel_b.View(slot);
    const SrdoState state = (a.state == b.state) ? a.state : SrdoState::kFaulted;
    // A demoted channel learned of the fault from the other one, which knows the cause.
    const bool asks_b = a.first_cause == SrdoCause::kDemoted;
    return StateReply{Result::kSuccessful, state, asks_b ? b.first_cause : a.first_cause, a.error_count};
}

StatusReply Kernel::GetStatus(const CommunicationIndex index) const noexcept
{
    const SlotIndex slot = SlotAt(index);
    return (slot == kNoSlot) ? StatusReply{Result::kNotExist, StatusByte{0U}}
                             : StatusReply{Result::kSuccessful, run_.status.Get(slot)};
}

Result Kernel::SetStatus(const CommunicationIndex index, const StatusByte status) noexcept
{
    const SlotIndex slot = SlotAt(index);
    if (slot == kNoSlot)
    {
        return Result::kNotExist;
    }
    run_.status.Set(slot, status);
    return Result::kSuccessful;
}

ParametersReply Kernel::GetParameters(const CommunicationIndex index) const noexcept
{
    const SlotIndex slot = SlotAt(index);
    if (slot == kNoSlot)
    {
        return ParametersReply{Result::kNotExist, 0U, 0U, 0U};
    }
    return ParametersReply{Result::kSuccessful, static_cast<std::uint8_t>(guard_.Value(slot, ConfigField::kDirection)),
                           static_cast<std::uint16_t>(guard_.Value(slot, ConfigField::kSct)),
                           static_cast<std::uint8_t>(guard_.Value(slot, ConfigField::kMapCount))};
}

MappedReply Kernel::GetMapped(const CommunicationIndex index, const MappedEntry entry) const noexcept
{
    MappedReply reply{Result::kNotExist, VariablePlace{nullptr, 0U}};
    const SlotIndex slot = SlotAt(index);
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
    const SlotIndex slot = SlotAt(index);
    return (slot == kNoSlot) ? Result::kNotExist : guard_.DefineFields(slot, fields);
}

void Kernel::DemandSafeState() noexcept
{
    latch_.Enter(DeviceFault::kApplication, kNoSlot);
}

void Kernel::OnCrossLinkFault() noexcept
{
    latch_.Enter(DeviceFault::kCrossLink, kNoSlot);
}

DeviceFaultReport Kernel::DeviceState() const noexcept
{
    return latch_.Report();
}

std::uint16_t Kernel::DemotionCount() const noexcept
{
    return run_.demotions;
}

const Verdict& Kernel::LastVerdict() const noexcept
{
    return run_.verdict;
}

} // namespace counterpoint
