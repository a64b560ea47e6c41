// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/configuration_guard.hpp"

#include "safety_core/comparator/slot_mask.hpp"

namespace counterpoint
{
namespace
{

constexpr DeviceConfig kNoDevice{};

constexpr std::uint8_t kLastProducerNode = 32U;
constexpr std::uint8_t kLastDefaultNode = 64U;
constexpr std::uint16_t kDefaultCobId1Base = 0xFFU;
constexpr std::uint16_t kDefaultCobId2Base = 0x100U;
constexpr std::uint32_t kTokenRotation = 8U;
constexpr std::uint32_t kWordBits = 32U;
constexpr std::uint32_t kEveryByte = 0x01010101U;
constexpr std::uint16_t kCommunicationBase = 0x1301U;

constexpr DeviceFaultReport kNothingFound{DeviceFault::kNone, kNoSlot, 0U};
constexpr ConfigAddress kValidAddress{0U, ConfigField::kConfigurationValid, 0U};

std::uint32_t ToValue(const ObjectData& data) noexcept
{
    std::uint32_t value = 0U;
    for (std::uint32_t byte = 0U; byte < data.size_bytes; ++byte)
    {
        value |= static_cast<std::uint32_t>(data.bytes[byte]) << (8U * byte); // MISRA D-002
    }
    return value;
}

ObjectReading ToReading(const std::uint32_t value, const std::uint8_t size_bytes) noexcept
{
    ObjectReading reading{};
    reading.abort = AbortCode::kNone;
    reading.data.size_bytes = size_bytes;
    for (std::uint32_t byte = 0U; byte < size_bytes; ++byte)
    {
        reading.data.bytes[byte] = static_cast<std::uint8_t>(value >> (8U * byte)); // MISRA D-002
    }
    return reading;
}

ObjectReading ToReading(const MappableObject& object, const std::uint8_t size_bytes) noexcept
{
    ObjectReading reading{};
    reading.abort = AbortCode::kNone;
    reading.data.size_bytes = size_bytes;
    for (std::uint32_t byte = 0U; byte < size_bytes; ++byte)
    {
        reading.data.bytes[byte] = object.place[byte]; // MISRA D-002
    }
    return reading;
}

ObjectReading Refused(const AbortCode abort) noexcept
{
    ObjectReading reading{};
    reading.abort = abort;
    return reading;
}

} // namespace

Connection DefaultConnection(const NodeId node_id) noexcept
{
    if ((node_id.value == 0U) || (node_id.value > kLastDefaultNode))
    {
        return Connection{0U, 0U, kDirectionOff};
    }
    const std::uint32_t offset = 2U * static_cast<std::uint32_t>(node_id.value);
    const std::uint8_t direction = (node_id.value <= kLastProducerNode) ? kDirectionProducer : kDirectionConsumer;
    return Connection{static_cast<std::uint16_t>(kDefaultCobId1Base + offset),
                      static_cast<std::uint16_t>(kDefaultCobId2Base + offset), direction};
}

ConfigurationGuard::ConfigurationGuard(Channel& a, Channel& b) noexcept : a_{a}, b_{b}, config_{&kNoDevice}
{
}

void ConfigurationGuard::Restart(const DeviceConfig& config) noexcept
{
    config_ = &config;
    // Kernel::Start made sure that the interval holds at least one cycle for each SRDO.
    cycles_per_check_ = config.diagnostic_interval_us / (config.cycle_us * config.srdo_count);
    cycles_to_check_ = cycles_per_check_;
    finding_ = kNothingFound;
    next_slot_ = 0U;
    nmt_ = NmtState::kInitialising;
    valid_ = 0U;
}

void ConfigurationGuard::SetNmt(const NmtState state) noexcept
{
    nmt_ = state;
}

SrdoMask ConfigurationGuard::Active() const noexcept
{
    return active_;
}

SrdoMask ConfigurationGuard::Producers() const noexcept
{
    return producers_;
}

bool ConfigurationGuard::IsValid() const noexcept
{
    return valid_ == kConfigurationValidValue;
}

std::uint32_t ConfigurationGuard::Value(const SlotIndex slot, const ConfigField field,
                                        const std::uint8_t sub) const noexcept
{
    return a_.Load(ConfigAddress{slot, field, sub}).value;
}

void ConfigurationGuard::Find(const DeviceFault fault, const SlotIndex slot) noexcept
{
    if (finding_.fault == DeviceFault::kNone)
    {
        finding_ = DeviceFaultReport{fault, slot, 1U};
    }
}

DeviceFaultReport ConfigurationGuard::TakeFinding() noexcept
{
    const DeviceFaultReport taken = finding_;
    finding_ = kNothingFound;
    return taken;
}

// Both channels keep the value; what they give back must be what was stored. [SRS-CFG-047]
void ConfigurationGuard::StoreBoth(const ConfigItem& item) noexcept
{
    a_.Store(item);
    b_.Store(item);
    const std::uint32_t differences =
        (a_.Load(item.address).value ^ item.value) | (b_.Load(item.address).value ^ item.value);
    if (differences != 0U)
    {
        Find(DeviceFault::kConfiguration, item.address.slot);
    }
}

void ConfigurationGuard::Invalidate() noexcept
{
    valid_ = 0U;
    StoreBoth(ConfigItem{kValidAddress, 0U});
}

ObjectReading ConfigurationGuard::Read(const ObjectAddress& address) noexcept
{
    const ObjectPlace place = Locate(*config_, address);
    if (place.kind == ObjectKind::kInvalid)
    {
        return Refused(AbortCode::kObjectUnknown);
    }
    if (place.kind == ObjectKind::kSubUnknown)
    {
        return Refused(AbortCode::kSubUnknown);
    }
    if (place.kind == ObjectKind::kVariable)
    {
        return ToReading(*place.variable, place.size_bytes);
    }
    if ((place.kind == ObjectKind::kConstant) || (place.kind == ObjectKind::kGapSignature))
    {
        return ToReading(place.constant, place.size_bytes);
    }
    const ConfigItem item_a = a_.Load(place.config);
    const ConfigItem item_b = b_.Load(place.config);
    if (item_a.value != item_b.value)
    {
        Find(DeviceFault::kConfiguration, place.config.slot);
        return Refused(AbortCode::kGeneral);
    }
    return ToReading(item_a.value, place.size_bytes);
}

AbortCode ConfigurationGuard::Write(const ObjectAddress& address, const ObjectData& data) noexcept
{
    const ObjectPlace place = Locate(*config_, address);
    if (place.kind == ObjectKind::kInvalid)
    {
        return AbortCode::kObjectUnknown;
    }
    if (place.kind == ObjectKind::kSubUnknown)
    {
        return AbortCode::kSubUnknown;
    }
    if ((place.kind == ObjectKind::kConstant) || (place.kind == ObjectKind::kVariable))
    {
        return AbortCode::kReadOnly;
    }
    if (data.size_bytes != place.size_bytes)
    {
        return AbortCode::kLengthMismatch;
    }
    const bool is_gfc = place.config.field == ConfigField::kGfcParameter;
    if ((nmt_ == NmtState::kOperational) && (!is_gfc))
    {
        return AbortCode::kDeviceState;
    }
    const std::uint32_t value = ToValue(data);
    if (place.kind == ObjectKind::kGapSignature)
    {
        return (value == 0U) ? AbortCode::kNone : AbortCode::kValueRange;
    }
    if (place.kind == ObjectKind::kConfigurationValid)
    {
        return WriteValid(static_cast<std::uint8_t>(value));
    }
    return WriteConfiguration(ConfigItem{place.config, value});
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
    if (address.field != ConfigField::kGfcParameter)
    {
        Invalidate();
    }
    StoreBoth(item);
    return AbortCode::kNone;
}

AbortCode ConfigurationGuard::WriteValid(const std::uint8_t value) noexcept
{
    if (value != kConfigurationValidValue)
    {
        Invalidate();
        return AbortCode::kNone;
    }
    for (SlotIndex slot = 0U; slot < config_->srdo_count; ++slot)
    {
        const CheckResult a = a_.Validate(slot);
        const CheckResult b = b_.Validate(slot);
        const ConfigurationFinding finding = Compare(slot, a, b);
        if (finding.rule != ConfigFault::kNone)
        {
            if (finding.fault != DeviceFault::kNone)
            {
                Find(finding.fault, slot);
            }
            return AbortCode::kIncompatible;
        }
    }
    TakeDirections();
    valid_ = value;
    StoreBoth(ConfigItem{kValidAddress, value});
    return AbortCode::kNone;
}

void ConfigurationGuard::TakeDirections() noexcept
{
    active_ = 0U;
    producers_ = 0U;
    for (SlotIndex slot = 0U; slot < config_->srdo_count; ++slot)
    {
        const std::uint32_t direction = Value(slot, ConfigField::kDirection, 0U);
        active_ |= (direction != kDirectionOff) ? OnlySlot(slot).mask : 0U;
        producers_ |= (direction == kDirectionProducer) ? OnlySlot(slot).mask : 0U;
    }
}

ConfigurationFinding ConfigurationGuard::Compare(const SlotIndex slot, const CheckResult& a,
                                                 const CheckResult& b) const noexcept
{
    const std::uint32_t rules = static_cast<std::uint32_t>(a.fault) ^ static_cast<std::uint32_t>(b.fault);
    const std::uint32_t signatures = static_cast<std::uint32_t>(a.signature) ^ static_cast<std::uint32_t>(b.signature);
    const CommunicationIndex index{
        static_cast<std::uint16_t>((kCommunicationBase - 1U) + config_->srdos[slot].number)}; // MISRA D-002
    if ((rules | signatures) != 0U)
    {
        return ConfigurationFinding{DeviceFault::kDisagreement, ConfigFault::kInvalid, index, slot};
    }
    return ConfigurationFinding{DeviceFault::kNone, a.fault, index, slot};
}

ConfigurationFinding ConfigurationGuard::CheckAll() noexcept
{
    for (SlotIndex slot = 0U; slot < config_->srdo_count; ++slot)
    {
        const CheckResult a = a_.Recheck(slot);
        const CheckResult b = b_.Recheck(slot);
        const ConfigurationFinding finding = Compare(slot, a, b);
        if (finding.rule != ConfigFault::kNone)
        {
            return finding;
        }
    }
    return ConfigurationFinding{DeviceFault::kNone, ConfigFault::kNone, CommunicationIndex{0U}, kNoSlot};
}

std::uint32_t ConfigurationGuard::Cycle(const std::uint32_t challenge) noexcept
{
    --cycles_to_check_;
    if (cycles_to_check_ == 0U)
    {
        cycles_to_check_ = cycles_per_check_;
        RecheckNext();
    }
    const std::uint32_t rotated = (challenge << kTokenRotation) | (challenge >> (kWordBits - kTokenRotation));
    return rotated ^ (static_cast<std::uint32_t>(valid_) * kEveryByte);
}

void ConfigurationGuard::RecheckNext() noexcept
{
    const SlotIndex slot = next_slot_;
    const std::uint32_t following = static_cast<std::uint32_t>(slot) + 1U;
    next_slot_ = (following == config_->srdo_count) ? SlotIndex{0U} : static_cast<SlotIndex>(following);
    if (!IsValid())
    {
        return;
    }
    const CheckResult a = a_.Recheck(slot);
    const CheckResult b = b_.Recheck(slot);
    const ConfigurationFinding finding = Compare(slot, a, b);
    if (finding.fault != DeviceFault::kNone)
    {
        Find(finding.fault, slot);
    }
    else if (finding.rule != ConfigFault::kNone)
    {
        Find(DeviceFault::kConfiguration, slot);
    }
    else
    {
        // This SRDO is as it was declared.
    }
}

} // namespace counterpoint
