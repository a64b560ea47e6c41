// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia302/safety_check.hpp"

#include "canopen/cia301/little_endian.hpp"

namespace counterpoint::cia302
{
namespace
{

using cia301::SdoAbort;
using cia301::SdoClientState;

constexpr std::uint16_t kGfc = 0x1300U;
constexpr std::uint16_t kFirstSettings = 0x1301U;
constexpr std::uint16_t kLastSettings = 0x1340U;
constexpr std::uint16_t kFirstMapping = 0x1381U;
constexpr std::uint16_t kLastMapping = 0x13C0U;
constexpr std::uint16_t kSignatures = 0x13FFU;
constexpr std::uint8_t kDirectionSub = 1U;
constexpr ObjectAddress kValidFlag{0x13FEU, 0U};

bool IsSettings(const ObjectAddress& address) noexcept
{
    return (address.index >= kFirstSettings) && (address.index <= kLastSettings);
}

bool IsMapping(const ObjectAddress& address) noexcept
{
    return (address.index >= kFirstMapping) && (address.index <= kLastMapping);
}

bool IsSignature(const ObjectAddress& address) noexcept
{
    return (address.index == kSignatures) && (address.sub > 0U);
}

std::uint8_t SizeOfSetting(const std::uint8_t sub) noexcept
{
    constexpr std::uint8_t kSizes[kCommunicationSubs + 1U] = {0U, 1U, 2U, 1U, 1U, 4U, 4U};
    return (sub <= kCommunicationSubs) ? kSizes[sub] : 0U;
}

} // namespace

std::uint8_t SizeOf(const ObjectAddress& address) noexcept
{
    std::uint8_t size = 0U;
    if (IsSettings(address))
    {
        size = SizeOfSetting(address.sub);
    }
    else if (IsMapping(address))
    {
        size = (address.sub == 0U) ? 1U : 4U;
        size = (address.sub > kMaxMapEntries) ? 0U : size;
    }
    else if (address.index == kSignatures)
    {
        size = (address.sub == 0U) ? 1U : 2U;
        size = (address.sub > kMaxSrdoCount) ? 0U : size;
    }
    else
    {
        size = ((address.index == kGfc) && (address.sub == 0U)) ? 1U : 0U;
    }
    return size;
}

bool SafetyCheck::Begin(const SafetyExpectation& expectation, const SafetyTask task, cia301::SdoClient& client,
                        const Instant now) noexcept
{
    const bool is_task = (task == SafetyTask::kVerify) || (task == SafetyTask::kWrite);
    const bool is_free = !IsBusy() && (client.State() != SdoClientState::kBusy) && is_task;
    if (is_free)
    {
        expectation_ = &expectation;
        client_ = &client;
        task_ = task;
        phase_ = 0U;
        position_ = 0U;
        attempt_ = 0U;
        has_begun_ = false;
        result_ = SafetyResult{SafetyVerdict::kOpen, {0U, 0U}, 0U, 0U, SdoAbort::kNone, 0U};
        if (IsUsable(expectation))
        {
            Seek();
            Access(now);
        }
        else
        {
            End(SafetyVerdict::kUnusable);
        }
    }
    return is_free;
}

void SafetyCheck::OnCycle(const Instant now) noexcept
{
    if (IsBusy() && !has_begun_)
    {
        Access(now);
    }
    else if (IsBusy() && (client_->State() == SdoClientState::kDone))
    {
        Judge(now);
    }
    else if (IsBusy() && (client_->State() != SdoClientState::kBusy))
    {
        JudgeFailure(now);
    }
    else
    {
        // Waits for the slave, or nothing is under way.
    }
}

void SafetyCheck::Withdraw() noexcept
{
    if (IsBusy() && has_begun_)
    {
        client_->Cancel(SdoAbort::kGeneral);
    }
    client_ = nullptr;
    result_ = SafetyResult{SafetyVerdict::kOpen, {0U, 0U}, 0U, 0U, SdoAbort::kNone, 0U};
}

/// The order is that of figure 9 of CiA 304: parameters, signatures, everything read back, only then valid.
SafetyCheck::Phase SafetyCheck::PhaseNow() const noexcept
{
    constexpr Phase kVerifyPhases[kLongestTask] = {Phase::kReadValid, Phase::kCompare, Phase::kReadValid};
    constexpr Phase kWritePhases[kLongestTask] = {
        Phase::kClearValid, Phase::kSwitchOff, Phase::kSettings, Phase::kMapClear, Phase::kMapEntries, Phase::kMapCount,
        Phase::kSwitchOn,   Phase::kSign,      Phase::kCompare,  Phase::kSetValid, Phase::kReadValid};
    Phase phase = Phase::kEnd;
    if (phase_ < kLongestTask)
    {
        phase = (task_ == SafetyTask::kWrite) ? kWritePhases[phase_] : kVerifyPhases[phase_];
    }
    return phase;
}

bool SafetyCheck::IsValidFlag(const Phase phase) noexcept
{
    return (phase == Phase::kReadValid) || (phase == Phase::kClearValid) || (phase == Phase::kSetValid);
}

bool SafetyCheck::Reads() const noexcept
{
    const Phase phase = PhaseNow();
    return (phase == Phase::kReadValid) || (phase == Phase::kCompare);
}

bool SafetyCheck::TakesPart(const Phase phase, const ExpectedObject& object) noexcept
{
    const ObjectAddress& address = object.address;
    const bool is_direction = IsSettings(address) && (address.sub == kDirectionSub);
    bool takes_part = false;
    switch (phase)
    {
    case Phase::kCompare:
        takes_part = true;
        break;
    case Phase::kSwitchOff:
        takes_part = is_direction;
        break;
    case Phase::kSwitchOn: // Off already.
        takes_part = is_direction && (object.value != 0U);
        break;
    case Phase::kSettings:
        takes_part = IsSettings(address) && !is_direction;
        break;
    case Phase::kMapClear:
        takes_part = IsMapping(address) && (address.sub == 0U);
        break;
    case Phase::kMapCount: // 0 already.
        takes_part = IsMapping(address) && (address.sub == 0U) && (object.value != 0U);
        break;
    case Phase::kMapEntries:
        takes_part = IsMapping(address) && (address.sub != 0U);
        break;
    case Phase::kSign:
        takes_part = IsSignature(address) || (address.index == kGfc);
        break;
    case Phase::kEnd:
    case Phase::kReadValid:
    case Phase::kClearValid:
    case Phase::kSetValid:
    default:
        break;
    }
    return takes_part && ((phase == Phase::kCompare) || !object.is_fixed);
}

std::uint32_t SafetyCheck::ValueIn(const Phase phase, const ExpectedObject& object) noexcept
{
    const bool is_zero = (phase == Phase::kSwitchOff) || (phase == Phase::kMapClear);
    return is_zero ? 0U : object.value;
}

/// From the present place, itself included, to the next access; or to the end.
void SafetyCheck::Seek() noexcept
{
    bool is_found = false;
    while (!is_found && (PhaseNow() != Phase::kEnd))
    {
        const Phase phase = PhaseNow();
        if (IsValidFlag(phase))
        {
            is_found = (position_ == 0U);
            result_.object = kValidFlag;
            target_ = (phase == Phase::kClearValid) ? 0U : std::uint32_t{kConfigurationValidValue};
        }
        else if (position_ < expectation_->count)
        {
            const ExpectedObject& object = expectation_->objects[position_];
            is_found = TakesPart(phase, object);
            result_.object = object.address;
            target_ = ValueIn(phase, object);
            position_ = static_cast<std::uint16_t>(is_found ? position_ : (position_ + 1U));
        }
        else
        {
            // This pass is over.
        }
        if (!is_found && (IsValidFlag(phase) || (position_ >= expectation_->count)))
        {
            ++phase_;
            position_ = 0U;
        }
    }
}

void SafetyCheck::Next() noexcept
{
    ++position_;
    attempt_ = 0U;
    has_begun_ = false;
    Seek();
    if (PhaseNow() == Phase::kEnd)
    {
        End(SafetyVerdict::kAlike);
    }
}

void SafetyCheck::Access(const Instant now) noexcept
{
    if (Reads())
    {
        has_begun_ =
            client_->StartUpload(result_.object, cia301::Room{buffer_, sizeof(buffer_)}, cia301::SdoMode::kNormal, now);
    }
    else
    {
        const std::uint8_t size =
            (result_.object.index == kValidFlag.index) ? std::uint8_t{1U} : SizeOf(result_.object);
        cia301::ToLittleEndian(target_, buffer_, size);
        has_begun_ =
            client_->StartDownload(result_.object, cia301::Bytes{buffer_, size}, cia301::SdoMode::kNormal, now);
    }
}

void SafetyCheck::Judge(const Instant now) noexcept
{
    const std::uint8_t size = (result_.object.index == kValidFlag.index) ? std::uint8_t{1U} : SizeOf(result_.object);
    const std::uint32_t length = client_->Outcome().size_bytes;
    bool is_alike = true;
    if (Reads())
    {
        result_.read = static_cast<std::uint32_t>(
            cia301::FromLittleEndian(buffer_, (length > sizeof(buffer_)) ? sizeof(buffer_) : length));
        is_alike = (length == size) && (result_.read == target_);
    }
    if (is_alike)
    {
        Next();
        if (IsBusy())
        {
            Access(now);
        }
    }
    else
    {
        result_.expected = target_;
        result_.size_bytes = length;
        End(SafetyVerdict::kDiffers);
    }
}

/// Silence is asked again: one lost frame says nothing about the slave. [SRS-SFS-004]
void SafetyCheck::JudgeFailure(const Instant now) noexcept
{
    const cia301::SdoOutcome outcome = client_->Outcome();
    const bool is_silence = (outcome.abort == SdoAbort::kTimeOut) && !outcome.by_server;
    ++attempt_;
    if (is_silence && (attempt_ < kAttempts))
    {
        Access(now);
    }
    else
    {
        result_.expected = target_;
        result_.abort = outcome.abort;
        End(is_silence ? SafetyVerdict::kSilent : SafetyVerdict::kAborted);
    }
}

void SafetyCheck::End(const SafetyVerdict verdict) noexcept
{
    result_.verdict = verdict;
    client_ = nullptr;
}

} // namespace counterpoint::cia302
