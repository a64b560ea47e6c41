// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/configuration_guard.hpp"

#include "safety_core/kernel/variable.hpp"

namespace counterpoint
{
namespace
{

constexpr std::uint32_t kBitsPerByte = 8U;

constexpr ConfigAddress kValidAddress{0U, ConfigField::kConfigurationValid, 0U};

bool IsReadOnly(const ObjectKind kind) noexcept
{
    return (kind == ObjectKind::kConstant) || (kind == ObjectKind::kVariable) || (kind == ObjectKind::kFixed);
}

} // namespace

ConfigurationGuard::ConfigurationGuard(Channel& a, Channel& b, SafeStateLatch& latch) noexcept
    : a_{a}, b_{b}, latch_{latch}, config_{&kNoDevice}
{
}

void ConfigurationGuard::Restart(const DeviceConfig& config) noexcept
{
    config_ = &config;
    // Kernel::Start made sure that the interval holds at least two cycles for each SRDO.
    cycles_per_check_ = config.diagnostic_interval_us / (2U * config.cycle_us * config.srdo_count);
    cycles_to_check_ = cycles_per_check_;
    step_ = 0U;
    valid_ = 0U;
    nmt_ = NmtState::kInitialising;
}

void ConfigurationGuard::Stop() noexcept
{
    config_ = &kNoDevice;
    nmt_ = NmtState::kInvalid;
    valid_ = 0U;
}

std::uint32_t ConfigurationGuard::Value(const SlotIndex slot, const ConfigField field,
                                        const std::uint8_t sub) const noexcept
{
    return a_.Load(ConfigAddress{slot, field, sub}).value;
}

Result ConfigurationGuard::Changeable() const noexcept
{
    if (nmt_ == NmtState::kInvalid)
    {
        return Result::kDeviceFault;
    }
    return (nmt_ == NmtState::kOperational) ? Result::kNmtError : Result::kSuccessful;
}

// Both channels keep the value; what they give back then must be what was stored. The stand-in of a channel on another
// CPU gives back what the channel here keeps: so both keep it first. [SRS_CFG_047]
void ConfigurationGuard::StoreBoth(const ConfigItem& item) noexcept
{
    a_.Store(item);
    b_.Store(item);
    const std::uint32_t differences =
        (a_.Load(item.address).value ^ item.value) | (b_.Load(item.address).value ^ item.value);
    if (differences != 0U)
    {
        latch_.Enter(DeviceFault::kConfiguration, item.address.slot);
    }
}

void ConfigurationGuard::Invalidate() noexcept
{
    valid_ = 0U;
    StoreBoth(ConfigItem{kValidAddress, 0U});
}

ObjectReading ConfigurationGuard::Read(const ObjectKey key) noexcept
{
    ObjectReading reading{};
    reading.abort = AbortCode::kDeviceState;
    if (nmt_ == NmtState::kInvalid)
    {
        return reading;
    }
    const ObjectPlace place = Locate(*config_, key);
    reading.abort = place.refusal;
    if (place.kind == ObjectKind::kInvalid)
    {
        return reading;
    }
    // What is not stored reads 0 in both channels.
    const std::uint32_t value_a = a_.Load(place.item.address).value;
    const std::uint32_t value_b = b_.Load(place.item.address).value;
    if (value_a != value_b)
    {
        latch_.Enter(DeviceFault::kConfiguration, place.item.address.slot);
        reading.abort = AbortCode::kGeneral;
        return reading;
    }
    VariableValue value{value_a | place.constant};
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
    ObjectPlace place = Locate(*config_, key);
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
    if (Value(address.slot, address.field, address.sub) == item.value)
    {
        return AbortCode::kNone;
    }
    const AbortCode abort = AdmitItem(item);
    if (abort != AbortCode::kNone)
    {
        return abort;
    }
    const bool is_gfc = address.field == ConfigField::kGfcParameter;
    if (!is_gfc)
    {
        Invalidate();
    }
    StoreBoth(item);
    if (is_gfc)
    {
        (void)TakeDigest();
    }
    return AbortCode::kNone;
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
        StoreBoth(ConfigItem{kValidAddress, kConfigurationValidValue});
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
    const StaticMap& map = config_->srdos[slot].map; // MISRA D-002
    if (map.entries == nullptr)
    {
        return Result::kMappingError;
    }
    Invalidate();
    a_.SetFields(slot, fields);
    b_.SetFields(slot, fields);
    Result result = ToResult(Check(slot, CheckDepth::kValidate).fault);
    // What else is not right yet, such as its signature, is found when the configuration is declared valid.
    const bool is_mapping = (result == Result::kMappingError) || (result == Result::kLengthExceeded);
    if ((!is_mapping) && (result != Result::kDeviceFault))
    {
        result = CheckFields(map, fields);
    }
    if (result != Result::kSuccessful)
    {
        constexpr StaticFields kNone{nullptr, nullptr}; // Fields that were refused are not kept.
        a_.SetFields(slot, kNone);
        b_.SetFields(slot, kNone);
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
        const MappableObject* const object = FindMapped(*config_, entry);
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
