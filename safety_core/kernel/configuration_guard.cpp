// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/configuration_guard.hpp"

#include "safety_core/kernel/configuration_admission.hpp"
#include "safety_core/kernel/variable.hpp"

namespace counterpoint
{
namespace
{

constexpr std::uint32_t kBitsPerByte = 8U;

constexpr ConfigAddress kValidAddress{0U, ConfigField::kConfigurationValid, 0U};

constexpr std::uint32_t kTokenRotation = 8U;
constexpr std::uint32_t kWordBits = 32U;
constexpr std::uint32_t kEveryByte = 0x01010101U;

constexpr std::uint32_t kRules = 10U;
// Return codes of the reference for the rules of a configuration, by their number. MISRA D-001
constexpr Result kRuleResults[kRules] = {
    Result::kDeviceFault,    Result::kInvalidConfiguration, Result::kInvalidConfiguration, Result::kIdError,
    Result::kIdInUse,        Result::kTimingError,          Result::kMappingError,         Result::kLengthExceeded,
    Result::kSignatureError, Result::kMappingError};
static_assert(static_cast<std::uint32_t>(ConfigFault::kTable) == kRules - 1U, "one result a rule");

bool IsReadOnly(const ObjectKind kind) noexcept
{
    return (kind == ObjectKind::kConstant) || (kind == ObjectKind::kVariable) || (kind == ObjectKind::kFixed);
}

} // namespace

Result ToResult(const ConfigFault rule) noexcept
{
    if (rule == ConfigFault::kNone)
    {
        return Result::kSuccessful;
    }
    const std::uint32_t number = static_cast<std::uint32_t>(rule);
    return (number < kRules) ? kRuleResults[number] : Result::kInvalidConfiguration; // MISRA D-002
}

ConfigurationGuard::ConfigurationGuard(Channel& a, Channel& b, SafeStateLatch& latch) noexcept : copies_{a, b, latch}
{
}

void ConfigurationGuard::Restart(const DeviceConfig& config) noexcept
{
    copies_.SetDevice(config);
    diagnosis_.Restart(config);
    valid_ = 0U;
    nmt_ = NmtState::kInitialising;
}

void ConfigurationGuard::Stop() noexcept
{
    copies_.SetDevice(kNoDevice);
    nmt_ = NmtState::kInvalid;
    valid_ = 0U;
}

Result ConfigurationGuard::Changeable() const noexcept
{
    if (nmt_ == NmtState::kInvalid)
    {
        return Result::kDeviceFault;
    }
    return (nmt_ == NmtState::kOperational) ? Result::kNmtError : Result::kSuccessful;
}

void ConfigurationGuard::Invalidate() noexcept
{
    valid_ = 0U;
    copies_.Store(ConfigItem{kValidAddress, 0U});
}

ObjectReading ConfigurationGuard::Read(const ObjectKey key) noexcept
{
    ObjectReading reading{};
    reading.abort = AbortCode::kDeviceState;
    if (nmt_ == NmtState::kInvalid)
    {
        return reading;
    }
    const ObjectPlace place = Locate(copies_.Device(), key);
    reading.abort = place.refusal;
    if (place.kind == ObjectKind::kInvalid)
    {
        return reading;
    }
    // What is not stored reads 0 in both channels.
    const CommonValue stored = copies_.Load(place.item.address);
    if (!stored.is_common)
    {
        reading.abort = AbortCode::kGeneral;
        return reading;
    }
    VariableValue value{stored.value | place.constant};
    if (place.kind == ObjectKind::kVariable)
    {
        value = ReadVariable(VariablePlace{place.variable->place, place.variable->length_bits});
    }
    reading.abort = AbortCode::kNone;
    reading.data.size_bytes = place.size_bytes;
    WriteVariable(VariablePlace{&reading.data.bytes[0], static_cast<std::uint8_t>(kBitsPerByte * place.size_bytes)},
                  value);
    return reading;
}

AbortCode ConfigurationGuard::Write(const ObjectKey key, const ObjectData& data) noexcept
{
    if (nmt_ == NmtState::kInvalid)
    {
        return AbortCode::kDeviceState;
    }
    ObjectPlace place = Locate(copies_.Device(), key);
    if (place.kind == ObjectKind::kInvalid)
    {
        return place.refusal;
    }
    if (IsReadOnly(place.kind))
    {
        return AbortCode::kReadOnly;
    }
    if (data.size_bytes != place.size_bytes)
    {
        return AbortCode::kLengthMismatch;
    }
    const bool is_gfc = place.item.address.field == ConfigField::kGfcParameter;
    if ((nmt_ == NmtState::kOperational) && (!is_gfc))
    {
        return AbortCode::kDeviceState;
    }
    place.item.value = ToValue(data);
    return WritePlace(place);
}

AbortCode ConfigurationGuard::WritePlace(const ObjectPlace& place) noexcept
{
    const std::uint32_t value = place.item.value;
    if (place.kind == ObjectKind::kGapSignature)
    {
        return (value == 0U) ? AbortCode::kNone : AbortCode::kValueRange;
    }
    if (place.kind == ObjectKind::kConfiguration)
    {
        return WriteConfiguration(place.item);
    }
    if (value == kConfigurationValidValue)
    {
        return (Declare() == Result::kSuccessful) ? AbortCode::kNone : AbortCode::kIncompatible;
    }
    Invalidate();
    return AbortCode::kNone;
}

AbortCode ConfigurationGuard::WriteConfiguration(const ConfigItem& item) noexcept
{
    const ConfigAddress& address = item.address;
    if (copies_.Value(address.slot, address.field, address.sub) == item.value)
    {
        return AbortCode::kNone;
    }
    const AbortCode abort = Admit(copies_, item);
    if (abort != AbortCode::kNone)
    {
        return abort;
    }
    const bool is_gfc = address.field == ConfigField::kGfcParameter;
    if (!is_gfc)
    {
        Invalidate();
    }
    copies_.Store(item);
    if (is_gfc)
    {
        (void)TakeDigest();
    }
    return AbortCode::kNone;
}

ConfigFault ConfigurationGuard::CheckAll(const CheckDepth depth) noexcept
{
    ConfigFault rule = ConfigFault::kNone;
    for (SlotIndex slot = 0U; (slot < copies_.Device().srdo_count) && (rule == ConfigFault::kNone); ++slot)
    {
        rule = copies_.Check(slot, depth).fault;
        faulty_ = slot;
    }
    return rule;
}

DigestReply ConfigurationGuard::Digest() noexcept
{
    DigestReply reply{(nmt_ == NmtState::kInvalid) ? Result::kDeviceFault : Result::kSuccessful, 0U};
    for (SlotIndex slot = 0U; slot < copies_.Device().srdo_count; ++slot)
    {
        const DigestReply further = copies_.ContinueDigest(slot, DeviceDigest{reply.digest});
        reply.digest = further.digest;
        reply.result = (further.result == Result::kSuccessful) ? reply.result : further.result;
    }
    const bool is_expected = (copies_.Device().digest == 0U) || (copies_.Device().digest == reply.digest);
    if ((reply.result == Result::kSuccessful) && (!is_expected))
    {
        reply.result = Result::kInvalidConfiguration;
    }
    return reply;
}

Result ConfigurationGuard::TakeDigest() noexcept
{
    const DigestReply reply = Digest();
    diagnosis_.SetReference(DeviceDigest{reply.digest});
    return reply.result;
}

std::uint32_t ConfigurationGuard::Cycle(const std::uint32_t challenge, const Instant now) noexcept
{
    examined_ = diagnosis_.TakeTurn(now) ? diagnosis_.Examine(copies_, valid_) : kNoSlot;
    const std::uint32_t rotated = (challenge << kTokenRotation) | (challenge >> (kWordBits - kTokenRotation));
    return rotated ^ (static_cast<std::uint32_t>(valid_) * kEveryByte);
}

Result ConfigurationGuard::Declare() noexcept
{
    Result result = ToResult(CheckAll(CheckDepth::kValidate));
    if (result == Result::kSuccessful)
    {
        result = TakeDigest();
    }
    if (result == Result::kSuccessful)
    {
        valid_ = kConfigurationValidValue;
        copies_.Store(ConfigItem{kValidAddress, kConfigurationValidValue});
    }
    return result;
}

Result ConfigurationGuard::DefineFields(const SlotIndex slot, const StaticFields& fields) noexcept
{
    const Result readiness = Changeable();
    if (readiness != Result::kSuccessful)
    {
        return readiness;
    }
    const StaticMap& map = copies_.Device().srdos[slot].map; // MISRA D-002
    if (map.entries == nullptr)
    {
        return Result::kMappingError;
    }
    Invalidate();
    copies_.SetFields(slot, fields);
    Result result = ToResult(copies_.Check(slot, CheckDepth::kValidate).fault);
    // What else is not right yet, such as its signature, is found when the configuration is declared valid.
    const bool is_mapping = (result == Result::kMappingError) || (result == Result::kLengthExceeded);
    if ((!is_mapping) && (result != Result::kDeviceFault))
    {
        result = CheckFields(map, fields);
    }
    if (result != Result::kSuccessful)
    {
        constexpr StaticFields kNone{nullptr, nullptr}; // Fields that were refused are not kept.
        copies_.SetFields(slot, kNone);
    }
    return result;
}

// The channels look at the mapping of an SRDO only once it has a direction; its fields are defined before.
Result ConfigurationGuard::CheckFields(const StaticMap& map, const StaticFields& fields) const noexcept
{
    std::uint32_t bytes[2] = {0U, 0U}; // MISRA D-001
    bool is_too_long = false;
    for (std::uint32_t position = 0U; position < map.count; ++position)
    {
        const std::uint32_t side = position & 1U;
        const std::uint32_t entry = map.entries[position]; // MISRA D-002
        const std::uint8_t* const field = (side == 0U) ? fields.normal : fields.inverse;
        const MappableObject* const object = FindMapped(copies_.Device(), entry);
        if ((object == nullptr) || (object->place != (field + bytes[side]))) // MISRA D-002
        {
            return Result::kMappingError;
        }
        if (((entry & kEntryLengthMask) != object->length_bits) || ((object->length_bits % kBitsPerByte) != 0U))
        {
            return Result::kMappingError;
        }
        bytes[side] += object->length_bits / kBitsPerByte;             // MISRA D-002
        is_too_long = is_too_long || (bytes[side] > kMaxPayloadBytes); // MISRA D-002
    }
    return is_too_long ? Result::kLengthExceeded : Result::kSuccessful;
}

} // namespace counterpoint
