// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/kernel.hpp"

#include "safety_core/comparator/slot_mask.hpp"

// Calls of the application and of the services around the kernel. [SRS-KRN-010, SRS-KRN-011, SRS-KRN-015]
namespace counterpoint
{
namespace
{

struct RuleResult
{
    ConfigFault rule;
    Result result;
};

// Return codes of the reference for the rules of a configuration; a rule not listed is kInvalidConfiguration.
constexpr RuleResult kRuleResults[] = {
    // MISRA D-001
    {ConfigFault::kNone, Result::kSuccessful},          {ConfigFault::kIdentifier, Result::kIdError},
    {ConfigFault::kIdentifierInUse, Result::kIdInUse},  {ConfigFault::kTiming, Result::kTimingError},
    {ConfigFault::kMapping, Result::kMappingError},     {ConfigFault::kLengthExceeded, Result::kLengthExceeded},
    {ConfigFault::kSignature, Result::kSignatureError}, {ConfigFault::kTable, Result::kMappingError},
    {ConfigFault::kInvalid, Result::kDeviceFault},
};

Result ToResult(const ConfigFault rule) noexcept
{
    Result result = Result::kInvalidConfiguration;
    for (const RuleResult& entry : kRuleResults)
    {
        if (entry.rule == rule)
        {
            result = entry.result;
        }
    }
    return result;
}

} // namespace

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
    if (!started_)
    {
        return;
    }
    guard_.SetNmt(state);
    if ((state == NmtState::kOperational) && (nmt_ != NmtState::kOperational))
    {
        EnterOperational();
    }
    if ((state != NmtState::kOperational) && (nmt_ == NmtState::kOperational))
    {
        left_operational_ = true;
    }
    nmt_ = state;
}

void Kernel::EnterOperational() noexcept
{
    if (!guard_.IsValid())
    {
        return; // No fault: SRDOs are off until the configuration is declared valid.
    }
    const ConfigurationFinding finding = guard_.CheckAll();
    latch_.Enter(finding.fault, finding.slot);
    if (finding.rule != ConfigFault::kNone)
    {
        guard_.Invalidate();
        parts_.application.OnConfigurationInvalid(finding.index);
    }
}

ObjectReading Kernel::ReadObject(const ObjectAddress& address) noexcept
{
    ObjectReading reading{};
    reading.abort = AbortCode::kDeviceState;
    if (started_)
    {
        reading = guard_.Read(address);
        Adopt(guard_.TakeFinding());
    }
    return reading;
}

AbortCode Kernel::WriteObject(const ObjectAddress& address, const ObjectData& data) noexcept
{
    AbortCode abort = AbortCode::kDeviceState;
    if (started_)
    {
        abort = guard_.Write(address, data);
        Adopt(guard_.TakeFinding());
    }
    return abort;
}

Result Kernel::SendReadiness() const noexcept
{
    if (!latch_.IsRunning())
    {
        return Result::kDeviceFault;
    }
    if (nmt_ != NmtState::kOperational)
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
    const SrdoMask bits = (wanted == kNoSlot) ? ~SrdoMask{0U} : OnlySlot(wanted).mask;
    const SrdoMask to_send = bits & guard_.Producers();
    requests_ |= to_send;
    if (to_send != 0U)
    {
        return Result::kSuccessful;
    }
    if (wanted == kNoSlot)
    {
        return Result::kNotExist;
    }
    return ((guard_.Active() & bits) == 0U) ? Result::kInvalid : Result::kRxTxConflict;
}

CheckReply Kernel::CheckConfiguration() noexcept
{
    if (!started_)
    {
        return CheckReply{Result::kDeviceFault, CommunicationIndex{0U}};
    }
    const ConfigurationFinding finding = guard_.CheckAll();
    latch_.Enter(finding.fault, finding.slot);
    return CheckReply{ToResult(finding.rule), finding.index};
}

SignReply Kernel::Sign(const CommunicationIndex index) noexcept
{
    const SlotIndex slot = SlotAt(index);
    if (slot == kNoSlot)
    {
        return SignReply{Result::kNotExist, 0U};
    }
    const CheckResult a = parts_.channel_a.Recheck(slot);
    const CheckResult b = parts_.channel_b.Recheck(slot);
    if (a.signature != b.signature)
    {
        latch_.Enter(DeviceFault::kDisagreement, slot);
        return SignReply{Result::kDeviceFault, 0U};
    }
    return SignReply{Result::kSuccessful, a.signature};
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

void Kernel::DemandSafeState() noexcept
{
    latch_.Enter(DeviceFault::kApplication, kNoSlot);
}

DeviceFaultReport Kernel::DeviceState() const noexcept
{
    return latch_.Report();
}

std::uint16_t Kernel::DemotionCount() const noexcept
{
    return demotions_;
}

const Verdict& Kernel::LastVerdict() const noexcept
{
    return verdict_;
}

} // namespace counterpoint
