// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/third_voice/configuration.hpp"

#include <algorithm>

namespace counterpoint::third_voice
{
namespace
{
constexpr std::uint32_t kValid = 0xA5U;

void Append(std::vector<std::uint8_t>& bytes, const std::uint32_t value, const std::size_t size)
{
    for (std::size_t byte = 0U; byte < size; ++byte)
    {
        bytes.push_back(static_cast<std::uint8_t>(value >> (8U * byte)));
    }
}

} // namespace

std::uint32_t LengthOf(const std::uint32_t entry)
{
    return entry & 0xFFU;
}

Address AddressOf(const std::uint32_t entry)
{
    return {static_cast<std::uint16_t>(entry >> 16U), static_cast<std::uint8_t>(entry >> 8U)};
}

std::uint32_t BitsOf(const SrdoObjects& srdo)
{
    std::uint32_t bits = 0U;
    for (std::size_t entry = 0U; entry < srdo.count; entry += 2U)
    {
        bits += LengthOf(srdo.entries[entry]);
    }
    return bits;
}

std::uint64_t MaskOf(const std::uint32_t bits)
{
    return (bits >= 64U) ? ~std::uint64_t{0U} : ((std::uint64_t{1U} << bits) - 1U);
}
std::uint16_t SignatureOf(const SrdoObjects& srdo)
{
    std::vector<std::uint8_t> bytes;
    Append(bytes, srdo.direction, 1U);
    Append(bytes, srdo.sct_ms, 2U);
    Append(bytes, srdo.srvt_ms, 1U);
    Append(bytes, srdo.cob_id_1, 4U);
    Append(bytes, srdo.cob_id_2, 4U);
    Append(bytes, srdo.count, 1U);
    for (std::uint32_t sub = 1U; sub <= srdo.count; ++sub)
    {
        Append(bytes, sub, 1U);
        Append(bytes, srdo.entries[sub - 1U], 4U);
    }
    std::uint32_t crc = 0U;
    for (const std::uint8_t byte : bytes)
    {
        for (int bit = 7; bit >= 0; --bit)
        {
            const bool is_set =
                (((crc >> 15U) ^ (static_cast<std::uint32_t>(byte) >> static_cast<unsigned>(bit))) & 1U) != 0U;
            crc = (crc << 1U) & 0xFFFFU;
            crc = is_set ? (crc ^ 0x1021U) : crc;
        }
    }
    return static_cast<std::uint16_t>(crc);
}

Configuration::Configuration(const DeviceConfig& config, const Flaw flaw) : config_(config), flaw_(flaw)
{
    SrdoObjects objects;
    objects.entries.assign(config.map_entries, 0U);
    srdos_.assign(config.srdo_count, objects);
}

void Configuration::SetInitial(const std::size_t slot, const SrdoObjects& objects)
{
    srdos_.at(slot) = objects;
}

void Configuration::SetGfcParameter(const std::uint32_t value)
{
    gfc_parameter_ = value;
}

void Configuration::Start()
{
    valid_ = 0U;
}

std::optional<std::size_t> Configuration::SlotOf(const std::uint32_t number) const
{
    for (std::size_t slot = 0U; slot < srdos_.size(); ++slot)
    {
        if (config_.srdos[slot].number == number)
        {
            return slot;
        }
    }
    return std::nullopt;
}

bool Configuration::IsGfcOn() const
{
    return gfc_parameter_ == 1U;
}

bool Configuration::IsValid() const
{
    return valid_ == kValid;
}

bool Configuration::IsAllSound() const
{
    return !FirstFaulty().has_value();
}

std::optional<std::size_t> Configuration::FirstFaulty() const
{
    for (std::size_t slot = 0U; slot < srdos_.size(); ++slot)
    {
        if (!IsSound(srdos_[slot]))
        {
            return slot;
        }
    }
    return std::nullopt;
}

const SrdoObjects& Configuration::Objects(const std::size_t slot) const
{
    return srdos_.at(slot);
}

const MappableObject* Configuration::ObjectOf(const std::uint32_t entry) const
{
    for (std::size_t object = 0U; object < config_.object_count; ++object)
    {
        const MappableObject& candidate = config_.objects[object];
        if (Address{candidate.index, candidate.sub} == AddressOf(entry))
        {
            return &candidate;
        }
    }
    return nullptr;
}

void Configuration::Keep(std::uint32_t& place, const std::uint32_t value)
{
    if (place != value)
    {
        place = value;
        valid_ = 0U;
    }
}

Written Configuration::Write(const Address address, const std::uint32_t value, const std::size_t size,
                             const NmtState nmt)
{
    const auto [index, sub] = address;
    const bool is_operational = nmt == NmtState::kOperational;
    if (index == 0x1300U || index == 0x13FEU)
    {
        return WriteSingle(address, value, size, is_operational);
    }
    if (index == 0x13FFU)
    {
        return {WriteSignature(sub, value, size, is_operational), {}};
    }
    const bool is_parameter = index >= 0x1301U && index <= 0x1340U;
    if (!is_parameter && (index < 0x1381U || index > 0x13C0U))
    {
        return {AbortCode::kObjectUnknown, {}};
    }
    const std::optional<std::size_t> slot = SlotOf(index - (is_parameter ? 0x1300U : 0x1380U));
    if (!slot)
    {
        return {AbortCode::kObjectUnknown, {}};
    }
    const AbortCode refused = is_parameter ? CheckParameter(sub, size) : CheckMapping(sub, size);
    if (refused != AbortCode::kNone || is_operational)
    {
        return {(refused != AbortCode::kNone) ? refused : AbortCode::kDeviceState, {}};
    }
    SrdoObjects& objects = srdos_[*slot];
    return {is_parameter ? WriteParameter(objects, sub, value) : WriteMapping(objects, sub, value), {}};
}

/// 1300h and 13FEh.
Written Configuration::WriteSingle(const Address address, const std::uint32_t value, const std::size_t size,
                                   const bool is_operational)
{
    if (address.second != 0U)
    {
        return {AbortCode::kSubUnknown, {}};
    }
    if (size != 1U)
    {
        return {AbortCode::kLengthMismatch, {}};
    }
    if (address.first == 0x13FEU)
    {
        return is_operational ? Written{AbortCode::kDeviceState, {}} : WriteValid(value);
    }
    if (value > 1U)
    {
        return {AbortCode::kValueRange, {}};
    }
    gfc_parameter_ = value;
    return {};
}

AbortCode Configuration::CheckParameter(const std::uint8_t sub, const std::size_t size)
{
    constexpr std::size_t kSizes[] = {1U, 1U, 2U, 1U, 1U, 4U, 4U};
    if (sub > 6U)
    {
        return AbortCode::kSubUnknown;
    }
    if (sub == 0U)
    {
        return AbortCode::kReadOnly;
    }
    return (size == kSizes[sub]) ? AbortCode::kNone : AbortCode::kLengthMismatch;
}

AbortCode Configuration::CheckMapping(const std::uint8_t sub, const std::size_t size) const
{
    if (sub > config_.map_entries)
    {
        return AbortCode::kSubUnknown;
    }
    return (size == ((sub == 0U) ? 1U : 4U)) ? AbortCode::kNone : AbortCode::kLengthMismatch;
}

AbortCode Configuration::WriteSignature(const std::uint8_t sub, const std::uint32_t value, const std::size_t size,
                                        const bool is_operational)
{
    if (sub == 0U)
    {
        return AbortCode::kReadOnly;
    }
    const std::optional<std::size_t> slot = SlotOf(sub);
    if (!slot)
    {
        return AbortCode::kSubUnknown;
    }
    if (size != 2U)
    {
        return AbortCode::kLengthMismatch;
    }
    if (is_operational)
    {
        return AbortCode::kDeviceState;
    }
    Keep(srdos_[*slot].signature, value);
    return AbortCode::kNone;
}

AbortCode Configuration::CheckIdentifier(const SrdoObjects& objects) const
{
    const bool is_own = objects.cob_id_1 >= 0x101U && objects.cob_id_1 <= 0x17FU && (objects.cob_id_1 % 2U) == 1U &&
                        objects.cob_id_2 == objects.cob_id_1 + 1U;
    if (!is_own)
    {
        return AbortCode::kValueRange;
    }
    for (const SrdoObjects& other : srdos_)
    {
        if (&other != &objects && other.direction != 0U && other.cob_id_1 == objects.cob_id_1)
        {
            return AbortCode::kValueRange;
        }
    }
    return AbortCode::kNone;
}

AbortCode Configuration::WriteParameter(SrdoObjects& objects, const std::uint8_t sub, const std::uint32_t value)
{
    switch (sub)
    {
    case 1U:
        if (value > 2U)
        {
            return AbortCode::kValueRange;
        }
        if (value != 0U && value != objects.direction && CheckIdentifier(objects) != AbortCode::kNone)
        {
            return AbortCode::kValueRange;
        }
        Keep(objects.direction, value);
        return AbortCode::kNone;
    case 2U:
        Keep(objects.sct_ms, value);
        return AbortCode::kNone;
    case 3U:
        Keep(objects.srvt_ms, value);
        return AbortCode::kNone;
    case 4U:
        if (value != 254U)
        {
            return AbortCode::kValueRange;
        }
        Keep(objects.transmission_type, value);
        return AbortCode::kNone;
    default:
        return WriteIdentifier(objects, sub, value);
    }
}

AbortCode Configuration::WriteIdentifier(SrdoObjects& objects, const std::uint8_t sub, const std::uint32_t value)
{
    std::uint32_t& place = (sub == 5U) ? objects.cob_id_1 : objects.cob_id_2;
    if (value == place)
    {
        return AbortCode::kNone;
    }
    const bool is_odd = (value % 2U) == 1U;
    const bool is_in_range = value >= 0x101U && value <= 0x180U && is_odd == (sub == 5U);
    if (!is_in_range || objects.direction != 0U || (sub == 6U && value != objects.cob_id_1 + 1U))
    {
        return AbortCode::kValueRange;
    }
    for (const SrdoObjects& other : srdos_)
    {
        if (&other != &objects && other.direction != 0U && (other.cob_id_1 == value || other.cob_id_2 == value))
        {
            return AbortCode::kValueRange;
        }
    }
    Keep(place, value);
    return AbortCode::kNone;
}

AbortCode Configuration::WriteMapping(SrdoObjects& objects, const std::uint8_t sub, const std::uint32_t value)
{
    std::uint32_t& place = (sub == 0U) ? objects.count : objects.entries[sub - 1U];
    if (value == place)
    {
        return AbortCode::kNone;
    }
    if (objects.direction != 0U || (objects.count != 0U && !(sub == 0U && value == 0U)))
    {
        return AbortCode::kUnsupportedAccess;
    }
    if (sub == 0U)
    {
        if ((value % 2U) != 0U || value > config_.map_entries)
        {
            return AbortCode::kMapTooLong;
        }
        std::uint32_t bits[2] = {0U, 0U};
        for (std::uint32_t entry = 0U; entry < value; ++entry)
        {
            bits[entry % 2U] += LengthOf(objects.entries[entry]);
        }
        if (bits[0] > 64U || bits[1] > 64U)
        {
            return AbortCode::kMapTooLong;
        }
    }
    else
    {
        const MappableObject* const object = ObjectOf(value);
        if (object == nullptr || object->length_bits != LengthOf(value))
        {
            return AbortCode::kNotMappable;
        }
    }
    Keep(place, value);
    return AbortCode::kNone;
}

bool Configuration::IsMappingSound(const SrdoObjects& objects) const
{
    const MapAccess wanted = (objects.direction == kDirectionProducer) ? MapAccess::kProducer : MapAccess::kConsumer;
    for (std::size_t entry = 0U; entry + 1U < objects.count; entry += 2U)
    {
        const MappableObject* const normal = ObjectOf(objects.entries[entry]);
        const MappableObject* const inverse = ObjectOf(objects.entries[entry + 1U]);
        const bool is_pair = normal != nullptr && inverse != nullptr && normal != inverse && normal->access == wanted &&
                             inverse->access == wanted && normal->length_bits == inverse->length_bits &&
                             normal->length_bits == LengthOf(objects.entries[entry]) &&
                             inverse->length_bits == LengthOf(objects.entries[entry + 1U]);
        if (!is_pair || (normal->length_bits % config_.granularity_bits) != 0U)
        {
            return false;
        }
    }
    for (const SrdoObjects& other : srdos_)
    {
        if (other.direction == 0U || &other > &objects) // The later one is named.
        {
            continue;
        }
        for (std::size_t mine = 0U; mine < objects.count; ++mine)
        {
            for (std::size_t theirs = 0U; theirs < other.count; ++theirs)
            {
                const bool is_itself = &other == &objects && mine == theirs;
                const bool are_producers =
                    objects.direction == kDirectionProducer && other.direction == kDirectionProducer;
                const bool may_share = (are_producers || flaw_ == Flaw::kSharedObjects) && &other != &objects;
                if (!is_itself && !may_share && AddressOf(objects.entries[mine]) == AddressOf(other.entries[theirs]))
                {
                    return false;
                }
            }
        }
    }
    return (objects.count % 2U) == 0U && BitsOf(objects) <= 64U;
}

bool Configuration::IsSound(const SrdoObjects& objects) const
{
    if (flaw_ != Flaw::kNoSignature && objects.signature != SignatureOf(objects))
    {
        return false;
    }
    if (objects.direction == 0U)
    {
        return true;
    }
    const bool is_timed = (objects.direction == kDirectionConsumer)
                              ? (objects.srvt_ms >= 1U && objects.srvt_ms < objects.sct_ms)
                              : (objects.sct_ms * 1000U >= config_.cycle_us);
    return is_timed && objects.transmission_type == 254U && CheckIdentifier(objects) == AbortCode::kNone &&
           IsMappingSound(objects);
}

Written Configuration::WriteValid(const std::uint32_t value)
{
    Written written;
    if (value == kValid && valid_ != kValid)
    {
        for (std::size_t slot = 0U; slot < srdos_.size(); ++slot)
        {
            if (!IsSound(srdos_[slot]))
            {
                written.abort = AbortCode::kIncompatible;
                return written;
            }
            if (srdos_[slot].direction == kDirectionConsumer)
            {
                written.safe.push_back(slot);
            }
        }
    }
    valid_ = value;
    return written;
}
} // namespace counterpoint::third_voice
