// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia302/safety_gate/safety_check.hpp"

#include "canopen/cia301/base/little_endian.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint16_t kGfc = 0x1300U;
constexpr std::uint16_t kFirstSettings = 0x1301U;
constexpr std::uint16_t kLastSettings = 0x1340U;
constexpr std::uint16_t kFirstMapping = 0x1381U;
constexpr std::uint16_t kLastMapping = 0x13C0U;
constexpr std::uint16_t kSignatures = 0x13FFU;
constexpr std::uint8_t kDirectionSub = 1U;
constexpr std::uint16_t kReleasePolicy = 0x5F01U;
constexpr std::uint16_t kSafeValue = 0x5F02U;
constexpr std::uint16_t kDigest = 0x5F04U;
constexpr std::uint16_t kDetection = 0x5F05U;
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

/// Of a setting. An SRDO that is off may have none; 0 is refused where it is written, and read back where it is.
/// [SRS_SFS_620]
bool IsNoIdentifier(const ExpectedObject& object) noexcept
{
    constexpr std::uint8_t kFirstIdentifierSub = 5U;
    return (object.address.sub >= kFirstIdentifierSub) && (object.value == 0U);
}

std::uint8_t SizeOfSetting(const std::uint8_t sub) noexcept
{
    constexpr std::uint8_t kSizes[kCommunicationSubs + 1U] = {1U, 1U, 2U, 1U, 1U, 4U, 4U};
    return (sub <= kCommunicationSubs) ? kSizes[sub] : 0U;
}

/// Of what 13FFh does not cover: one object for all of it, or one of each SRDO.
std::uint8_t SizeOfParameter(const ObjectAddress& address) noexcept
{
    const bool is_of_srdo = (address.sub > 0U) && (address.sub <= kMaxSrdoCount);
    std::uint8_t size = 0U;
    if (address.index == kDigest)
    {
        size = (address.sub == 0U) ? 4U : 0U;
    }
    else if (address.index == kSafeValue)
    {
        size = is_of_srdo ? 8U : 0U;
    }
    else if ((address.index == kReleasePolicy) || (address.index == kDetection))
    {
        size = is_of_srdo ? 1U : 0U;
    }
    else
    {
        // No such object.
    }
    return size;
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
    else if (address.index == kGfc)
    {
        size = (address.sub == 0U) ? 1U : 0U;
    }
    else
    {
        size = SizeOfParameter(address);
    }
    return size;
}

void SafetyCheck::Begin(const SafetyOrder& order, const NodeId node) noexcept
{
    const bool is_task = (order.task == SafetyTask::kVerify) || (order.task == SafetyTask::kWrite);
    slave_ = &order.slave;
    node_ = node;
    task_ = order.task;
    rule_ = order.rule;
    phase_ = 0U;
    position_ = 0U;
    has_begun_ = false;
    object_ = ObjectAddress{0U, 0U};
    finding_ = GateFinding{{0U, 0U}, SdoAbort::kNone, 0U, 0U};
    state_ = CheckState::kBusy;
    if (is_task && IsUsable(*order.slave.safety))
    {
        Seek();
    }
    else
    {
        finding_.abort = SdoAbort::kLocalControl;
        End(CheckState::kFailed);
    }
}

void SafetyCheck::OnCycle(SdoPool& sdo, const Instant now) noexcept
{
    const TransferState transfer = has_begun_ ? sdo.State(node_) : TransferState::kIdle;
    if ((state_ == CheckState::kBusy) && ((transfer == TransferState::kDone) || (transfer == TransferState::kFailed)))
    {
        Judge(sdo.Outcome(node_));
    }
    const bool is_waiting = has_begun_ && (sdo.State(node_) == TransferState::kBusy);
    if ((state_ == CheckState::kBusy) && !is_waiting)
    {
        Access(sdo, now);
    }
}

/// First who it is. Then the order is that of figure 9 of CiA 304: parameters, signatures, everything read back, only
/// then valid.
SafetyCheck::Phase SafetyCheck::PhaseNow() const noexcept
{
    constexpr Phase kVerifyPhases[kLongestTask] = {Phase::kIdentity, Phase::kReadValid, Phase::kCompare,
                                                   Phase::kCompareGfc, Phase::kReadValid};
    constexpr Phase kWritePhases[kLongestTask] = {
        Phase::kIdentity,   Phase::kClearValid, Phase::kSwitchOff, Phase::kSettings, Phase::kMapClear,
        Phase::kMapEntries, Phase::kMapCount,   Phase::kSwitchOn,  Phase::kSign,     Phase::kCompare,
        Phase::kSetValid,   Phase::kCompareGfc, Phase::kReadValid};
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
    return (phase == Phase::kIdentity) || (phase == Phase::kReadValid) || (phase == Phase::kCompare) ||
           (phase == Phase::kCompareGfc);
}

/// Behind the last writing everything is read back. Of what is read, no answer to a write is its own: a second one to
/// what was written last cannot be told from somebody else's.
bool SafetyCheck::IsOwn(const ObjectAddress& written) const noexcept
{
    constexpr std::uint8_t kFirstRead = 9U; // kCompare
    const bool is_writing = (task_ == SafetyTask::kWrite) && (phase_ < kFirstRead);
    const bool is_now = (state_ == CheckState::kBusy) && (PhaseNow() == Phase::kSetValid);
    return is_writing || (is_now && (written.index == kValidFlag.index) && (written.sub == kValidFlag.sub));
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
    case Phase::kCompareGfc:
        takes_part = (address.index == kGfc);
        break;
    case Phase::kSwitchOff:
        takes_part = is_direction;
        break;
    case Phase::kSwitchOn: // Off already.
        takes_part = is_direction && (object.value != 0U);
        break;
    case Phase::kSettings:
        takes_part = IsSettings(address) && (address.sub > kDirectionSub) && !IsNoIdentifier(object);
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
    case Phase::kIdentity:
    case Phase::kReadValid:
    case Phase::kClearValid:
    case Phase::kSetValid:
    default:
        break;
    }
    const bool is_read = (phase == Phase::kCompare) || (phase == Phase::kCompareGfc);
    return takes_part && (is_read || !object.is_fixed);
}

std::uint64_t SafetyCheck::ValueIn(const Phase phase, const ExpectedObject& object) noexcept
{
    const bool is_zero = (phase == Phase::kSwitchOff) || (phase == Phase::kMapClear);
    return is_zero ? 0U : object.value;
}

std::uint16_t SafetyCheck::CountIn(const Phase phase) const noexcept
{
    return (phase == Phase::kIdentity) ? std::uint16_t{kIdentityRows} : slave_->safety->count;
}

/// Whether something is to be accessed at this place, and what.
bool SafetyCheck::Take(const Phase phase) noexcept
{
    bool is_meant = false;
    if (phase == Phase::kIdentity)
    {
        const IdentityRow row = IdentityRowOf(*slave_, rule_, static_cast<std::uint8_t>(position_));
        is_meant = (row.mask != 0U);
        object_ = row.object;
        target_ = row.expected;
    }
    else
    {
        const ExpectedObject& object = slave_->safety->objects[position_];
        is_meant = TakesPart(phase, object);
        object_ = object.address;
        target_ = ValueIn(phase, object);
    }
    return is_meant;
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
            object_ = kValidFlag;
            target_ = (phase == Phase::kClearValid) ? 0U : std::uint64_t{kConfigurationValidValue};
        }
        else if (position_ < CountIn(phase))
        {
            is_found = Take(phase);
            position_ = static_cast<std::uint16_t>(is_found ? position_ : (position_ + 1U));
        }
        else
        {
            // This pass is over.
        }
        if (!is_found && (IsValidFlag(phase) || (position_ >= CountIn(phase))))
        {
            ++phase_;
            position_ = 0U;
        }
    }
}

void SafetyCheck::Next() noexcept
{
    ++position_;
    has_begun_ = false;
    Seek();
    if (PhaseNow() == Phase::kEnd)
    {
        End(CheckState::kAlike);
    }
}

std::uint8_t SafetyCheck::SizeNow() const noexcept
{
    return IsValidFlag(PhaseNow()) ? std::uint8_t{1U} : SizeOf(object_);
}

/// Of who the device is only the number counts, as at the start-up; of a safety object the length as well.
bool SafetyCheck::IsAsExpected(const std::uint32_t size_bytes) const noexcept
{
    const bool is_identity = (PhaseNow() == Phase::kIdentity);
    const std::uint64_t mask =
        is_identity ? IdentityRowOf(*slave_, rule_, static_cast<std::uint8_t>(position_)).mask : ~std::uint64_t{0U};
    const bool is_of_size = is_identity || (size_bytes == SizeNow());
    return is_of_size && ((finding_.read & mask) == (finding_.expected & mask));
}

void SafetyCheck::Access(SdoPool& sdo, const Instant now) noexcept
{
    if (Reads())
    {
        constexpr std::uint32_t kUsualRoom = 4U;
        const std::uint32_t room = (SizeNow() > kUsualRoom) ? sizeof(buffer_) : kUsualRoom;
        has_begun_ = sdo.Upload(node_, object_, Room{buffer_, room}, SdoMode::kNormal, now);
    }
    else
    {
        cia301::ToLittleEndian(target_, buffer_, SizeNow());
        has_begun_ = sdo.Download(node_, object_, Bytes{buffer_, SizeNow()}, SdoMode::kNormal, now);
    }
}

void SafetyCheck::Judge(const cia301::SdoOutcome& outcome) noexcept
{
    finding_.object = object_;
    finding_.abort = outcome.abort;
    finding_.expected = target_;
    if (outcome.abort != SdoAbort::kNone)
    {
        End(CheckState::kFailed);
    }
    else if (!Reads())
    {
        Next();
    }
    else
    {
        const std::uint32_t length = (outcome.size_bytes > sizeof(buffer_)) ? sizeof(buffer_) : outcome.size_bytes;
        finding_.read = cia301::FromLittleEndian(buffer_, length);
        if (IsAsExpected(outcome.size_bytes))
        {
            Next();
        }
        else
        {
            // The same number in another length: the numbers alone would not say what is wrong.
            finding_.abort = (finding_.read == finding_.expected) ? SdoAbort::kLengthMismatch : SdoAbort::kNone;
            End(CheckState::kDiffers);
        }
    }
}

void SafetyCheck::End(const CheckState state) noexcept
{
    state_ = state;
    has_begun_ = false;
}

} // namespace counterpoint::cia302
