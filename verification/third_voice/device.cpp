// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/third_voice/device.hpp"

#include <algorithm>

namespace counterpoint::third_voice
{
namespace
{
constexpr std::uint32_t kValid = 0xA5U;
constexpr Time kUsPerMs = 1000;
constexpr std::uint32_t kGfcIdentifier = 1U;

std::uint64_t MaskOf(const std::uint32_t bits)
{
    return (bits >= 64U) ? ~std::uint64_t{0U} : ((std::uint64_t{1U} << bits) - 1U);
}

std::uint32_t LengthOf(const std::uint32_t entry)
{
    return entry & 0xFFU;
}

Device::Address AddressOf(const std::uint32_t entry)
{
    return {static_cast<std::uint16_t>(entry >> 16U), static_cast<std::uint8_t>(entry >> 8U)};
}

void Append(Bytes& bytes, const std::uint32_t value, const std::size_t size)
{
    for (std::size_t byte = 0U; byte < size; ++byte)
    {
        bytes.push_back(static_cast<std::uint8_t>(value >> (8U * byte)));
    }
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
} // namespace

std::uint16_t SignatureOf(const SrdoObjects& srdo)
{
    Bytes bytes;
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

Device::Device(const DeviceConfig& config, const Flaw flaw) : config_(config), flaw_(flaw)
{
    for (std::size_t slot = 0U; slot < config.srdo_count; ++slot)
    {
        Srdo srdo;
        srdo.setup = &config.srdos[slot];
        srdo.objects.entries.assign(config.map_entries, 0U);
        srdos_.push_back(std::move(srdo));
    }
    for (std::size_t object = 0U; object < config.object_count; ++object)
    {
        variables_[{config.objects[object].index, config.objects[object].sub}] = 0U;
    }
}

void Device::SetInitial(const std::uint8_t number, const SrdoObjects& objects)
{
    Existing(number).objects = objects;
}

void Device::SetGfcParameter(const std::uint32_t value)
{
    gfc_parameter_ = value;
}

void Device::Start()
{
    valid_ = 0U;
    nmt_ = NmtState::kInitialising;
    is_running_ = false;
}

Device::Srdo* Device::Find(const std::uint8_t number)
{
    for (Srdo& srdo : srdos_)
    {
        if (srdo.setup->number == number)
        {
            return &srdo;
        }
    }
    return nullptr;
}

const MappableObject* Device::ObjectOf(const std::uint32_t entry) const
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

const Device::Srdo& Device::Existing(const std::uint8_t number) const
{
    const auto found =
        std::find_if(srdos_.begin(), srdos_.end(), [number](const Srdo& srdo) { return srdo.setup->number == number; });
    return srdos_.at(static_cast<std::size_t>(found - srdos_.begin()));
}

Device::Srdo& Device::Existing(const std::uint8_t number)
{
    const auto found =
        std::find_if(srdos_.begin(), srdos_.end(), [number](const Srdo& srdo) { return srdo.setup->number == number; });
    return srdos_.at(static_cast<std::size_t>(found - srdos_.begin()));
}

SrdoMask Device::BitOf(const Srdo& srdo) const
{
    return SrdoMask{1U} << static_cast<unsigned>(&srdo - srdos_.data());
}

void Device::Keep(std::uint32_t& place, const std::uint32_t value)
{
    if (place != value)
    {
        place = value;
        valid_ = 0U;
    }
}

AbortCode Device::Write(const Address address, const std::uint64_t value, const std::size_t size)
{
    const auto [index, sub] = address;
    const auto number = static_cast<std::uint32_t>(value);
    const bool is_operational = (nmt_ == NmtState::kOperational);
    if (index == 0x1300U)
    {
        if (sub != 0U)
        {
            return AbortCode::kSubUnknown;
        }
        if (size != 1U)
        {
            return AbortCode::kLengthMismatch;
        }
        if (number > 1U)
        {
            return AbortCode::kValueRange;
        }
        gfc_parameter_ = number;
        return AbortCode::kNone;
    }
    if (index == 0x13FEU)
    {
        if (sub != 0U)
        {
            return AbortCode::kSubUnknown;
        }
        if (size != 1U)
        {
            return AbortCode::kLengthMismatch;
        }
        return is_operational ? AbortCode::kDeviceState : WriteValid(number);
    }
    Srdo* srdo = nullptr;
    if (index >= 0x1301U && index <= 0x1340U)
    {
        srdo = Find(static_cast<std::uint8_t>(index - 0x1300U));
        constexpr std::size_t kSizes[] = {1U, 1U, 2U, 1U, 1U, 4U, 4U};
        if (srdo == nullptr)
        {
            return AbortCode::kObjectUnknown;
        }
        if (sub > 6U)
        {
            return AbortCode::kSubUnknown;
        }
        if (sub == 0U)
        {
            return AbortCode::kReadOnly;
        }
        if (size != kSizes[sub])
        {
            return AbortCode::kLengthMismatch;
        }
        return is_operational ? AbortCode::kDeviceState : WriteParameter(*srdo, sub, number);
    }
    if (index >= 0x1381U && index <= 0x13C0U)
    {
        srdo = Find(static_cast<std::uint8_t>(index - 0x1380U));
        if (srdo == nullptr)
        {
            return AbortCode::kObjectUnknown;
        }
        if (sub > config_.map_entries)
        {
            return AbortCode::kSubUnknown;
        }
        if (size != ((sub == 0U) ? 1U : 4U))
        {
            return AbortCode::kLengthMismatch;
        }
        return is_operational ? AbortCode::kDeviceState : WriteMapping(*srdo, sub, number);
    }
    if (index == 0x13FFU)
    {
        srdo = (sub == 0U) ? nullptr : Find(sub);
        if (sub == 0U)
        {
            return AbortCode::kReadOnly;
        }
        if (srdo == nullptr)
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
        Keep(srdo->objects.signature, number);
        return AbortCode::kNone;
    }
    return (variables_.count(address) != 0U) ? AbortCode::kReadOnly : AbortCode::kObjectUnknown;
}

AbortCode Device::CheckIdentifier(const Srdo& srdo, const std::uint32_t cob_id_1, const std::uint32_t cob_id_2) const
{
    const bool is_own = cob_id_1 >= 0x101U && cob_id_1 <= 0x17FU && (cob_id_1 % 2U) == 1U && cob_id_2 == cob_id_1 + 1U;
    if (!is_own)
    {
        return AbortCode::kValueRange;
    }
    for (const Srdo& other : srdos_)
    {
        if (&other != &srdo && other.objects.direction != 0U && other.objects.cob_id_1 == cob_id_1)
        {
            return AbortCode::kValueRange;
        }
    }
    return AbortCode::kNone;
}

AbortCode Device::WriteParameter(Srdo& srdo, const std::uint8_t sub, const std::uint32_t value)
{
    SrdoObjects& objects = srdo.objects;
    switch (sub)
    {
    case 1U:
        if (value > 2U)
        {
            return AbortCode::kValueRange;
        }
        if (value != 0U && value != objects.direction &&
            CheckIdentifier(srdo, objects.cob_id_1, objects.cob_id_2) != AbortCode::kNone)
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
        break;
    }
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
    for (const Srdo& other : srdos_)
    {
        if (&other != &srdo && other.objects.direction != 0U &&
            (other.objects.cob_id_1 == value || other.objects.cob_id_2 == value))
        {
            return AbortCode::kValueRange;
        }
    }
    Keep(place, value);
    return AbortCode::kNone;
}

AbortCode Device::WriteMapping(Srdo& srdo, const std::uint8_t sub, const std::uint32_t value)
{
    SrdoObjects& objects = srdo.objects;
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

bool Device::IsMappingSound(const Srdo& srdo) const
{
    const SrdoObjects& objects = srdo.objects;
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
    for (const Srdo& other : srdos_)
    {
        if (other.objects.direction == 0U)
        {
            continue;
        }
        for (std::size_t mine = 0U; mine < objects.count; ++mine)
        {
            for (std::size_t theirs = 0U; theirs < other.objects.count; ++theirs)
            {
                const bool is_itself = &other == &srdo && mine == theirs;
                const bool may_share = objects.direction == kDirectionProducer &&
                                       other.objects.direction == kDirectionProducer && &other != &srdo;
                if (!is_itself && !may_share &&
                    AddressOf(objects.entries[mine]) == AddressOf(other.objects.entries[theirs]))
                {
                    return false;
                }
            }
        }
    }
    return (objects.count % 2U) == 0U && BitsOf(objects) <= 64U;
}

bool Device::IsSound(const Srdo& srdo) const
{
    const SrdoObjects& objects = srdo.objects;
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
    return is_timed && objects.transmission_type == 254U &&
           CheckIdentifier(srdo, objects.cob_id_1, objects.cob_id_2) == AbortCode::kNone && IsMappingSound(srdo);
}

AbortCode Device::WriteValid(const std::uint32_t value)
{
    if (value == kValid && valid_ != kValid)
    {
        for (const Srdo& srdo : srdos_)
        {
            if (!IsSound(srdo))
            {
                return AbortCode::kIncompatible;
            }
            if (srdo.objects.direction == kDirectionConsumer)
            {
                WriteSafe(srdo); // A sound one, also where a later one makes the whole refused.
            }
        }
    }
    valid_ = value;
    return AbortCode::kNone;
}

ConsumerRules Device::RulesOf(const Srdo& srdo) const
{
    const std::uint32_t bits = BitsOf(srdo.objects);
    ConsumerRules rules;
    rules.sct_us = kUsPerMs * srdo.objects.sct_ms;
    rules.srvt_us = kUsPerMs * srdo.objects.srvt_ms;
    rules.sct_us += (flaw_ == Flaw::kSctLonger) ? 1 : 0;
    rules.srvt_us += (flaw_ == Flaw::kSrvtLonger) ? 1 : 0;
    rules.length_bytes = (bits + 7U) / 8U;
    rules.is_inversion_checked = flaw_ != Flaw::kNoInversion;
    rules.mask = MaskOf(bits);
    rules.is_late = srdo.setup->detection == SrvtDetection::kLate;
    rules.is_automatic = srdo.setup->policy == ReleasePolicy::kAutomatic;
    rules.acknowledge_window_us = config_.acknowledge_window_us;
    return rules;
}

void Device::SetNmt(const NmtState state)
{
    const bool leaves = nmt_ == NmtState::kOperational && state != NmtState::kOperational;
    nmt_ = state;
    if (leaves)
    {
        has_left_ = true;
        Leave();
    }
}

void Device::Leave()
{
    for (Srdo& srdo : srdos_)
    {
        if (is_running_ && srdo.objects.direction == kDirectionConsumer)
        {
            // In this very call, whatever follows. [semantics 4]
            left_.push_back(srdo.setup->number);
            if (flaw_ != Flaw::kKeepsReleased)
            {
                WriteSafe(srdo);
            }
        }
        srdo.is_released = false;
        srdo.observers[0].LeaveOperational();
        srdo.observers[1].LeaveOperational();
    }
    is_running_ = false;
    has_entered_ = false;
}

/// With the first cycle behind the command.
void Device::Enter(const Time now)
{
    has_entered_ = true;
    bool is_sound = valid_ == kValid;
    for (const Srdo& srdo : srdos_)
    {
        is_sound = is_sound && IsSound(srdo);
    }
    seen_.is_configuration_invalid = valid_ == kValid && !is_sound;
    is_running_ = is_sound;
    for (Srdo& srdo : srdos_)
    {
        if (is_sound && srdo.objects.direction == kDirectionConsumer)
        {
            srdo.observers[0].EnterOperational(RulesOf(srdo), now);
            srdo.observers[1].EnterOperational(RulesOf(srdo), now);
        }
    }
}

void Device::OnFrame(const CanFrame& frame, const Time stamp)
{
    if (!is_running_ || frame.kind != FrameKind::kData)
    {
        return;
    }
    if (frame.identifier == kGfcIdentifier && frame.length_bytes == 0U && gfc_parameter_ == 1U)
    {
        has_gfc_ = true; // Takes effect with the cycle.
        return;
    }
    const Bytes data(frame.data, frame.data + std::min<std::size_t>(frame.length_bytes, 8U));
    for (Srdo& srdo : srdos_)
    {
        for (Consumer& observer : srdo.observers)
        {
            if (frame.identifier == srdo.objects.cob_id_1)
            {
                observer.OnNormal(data, stamp);
            }
            else if (frame.identifier == srdo.objects.cob_id_2)
            {
                observer.OnInverse(data, stamp);
            }
        }
    }
}

void Device::WriteData(const Srdo& srdo, const std::uint64_t normal)
{
    std::uint32_t shift = 0U;
    for (std::size_t entry = 0U; entry + 1U < srdo.objects.count; entry += 2U)
    {
        const std::uint32_t bits = LengthOf(srdo.objects.entries[entry]);
        const std::uint64_t value = (normal >> shift) & MaskOf(bits);
        variables_[AddressOf(srdo.objects.entries[entry])] = value;
        variables_[AddressOf(srdo.objects.entries[entry + 1U])] = ~value & MaskOf(bits);
        shift += bits;
    }
}

void Device::WriteSafe(const Srdo& srdo)
{
    const Payload& safe = srdo.setup->safe_value;
    WriteData(srdo, (std::uint64_t{safe.high} << 32U) | safe.low);
}

void Device::Decide(Srdo& srdo, const Time now)
{
    Consumer& a = srdo.observers[0];
    Consumer& b = srdo.observers[1];
    // Whoever reports a fault makes both safe in this cycle. [semantics 3]
    if (a.HasNewFault() != b.HasNewFault())
    {
        (a.HasNewFault() ? b : a).Fail(SrdoCause::kDemoted, now);
    }
    const bool is_agreed = a.MayRelease(now) && b.MayRelease(now) && a.Ordinal() == b.Ordinal() && a.Data() == b.Data();
    if (is_agreed)
    {
        if (!srdo.is_released || srdo.written_ordinal != a.Ordinal())
        {
            seen_.events.push_back(srdo.setup->number);
        }
        a.Release();
        b.Release();
        srdo.is_released = true;
        srdo.written_ordinal = a.Ordinal();
        WriteData(srdo, a.Data());
    }
    else
    {
        srdo.is_released = false;
        WriteSafe(srdo);
    }
    a.EndCycle();
    b.EndCycle();
}

void Device::Cycle(const Time now, const SrdoMask acknowledge_a, const SrdoMask acknowledge_b)
{
    for (const std::uint8_t number : left_)
    {
        seen_.signals.emplace_back(number, SrdoCause::kNotOperational);
    }
    left_.clear();
    const bool is_shown_as_left = has_left_;
    has_left_ = false;
    if (nmt_ == NmtState::kOperational && !has_entered_ && !is_shown_as_left)
    {
        Enter(now);
    }
    const bool is_gfc = has_gfc_ && is_running_;
    has_gfc_ = false;
    seen_.gfcs += is_gfc ? 1 : 0;
    for (Srdo& srdo : srdos_)
    {
        const SrdoMask bit = BitOf(srdo);
        srdo.observers[0].LookAtAcknowledge((acknowledge_a & bit) != 0U, now);
        srdo.observers[1].LookAtAcknowledge((acknowledge_b & bit) != 0U, now);
        if (!is_running_)
        {
            continue;
        }
        if (srdo.objects.direction == kDirectionConsumer)
        {
            srdo.observers[0].LookAtLimits(now);
            srdo.observers[1].LookAtLimits(now);
            if (is_gfc)
            {
                srdo.observers[0].Fail(SrdoCause::kGfc, now);
                srdo.observers[1].Fail(SrdoCause::kGfc, now);
            }
            Decide(srdo, now);
            for (const SrdoCause cause : srdo.observers[0].TakeSignals())
            {
                seen_.signals.emplace_back(srdo.setup->number, cause);
            }
            static_cast<void>(srdo.observers[1].TakeSignals());
        }
    }
}

std::uint64_t Device::Variable(const Address address) const
{
    return variables_.at(address);
}

bool Device::IsValid() const
{
    return valid_ == kValid;
}

const SrdoObjects& Device::Objects(const std::uint8_t number) const
{
    return Existing(number).objects;
}

SrdoState Device::StateOf(const std::uint8_t number) const
{
    const Srdo& srdo = Existing(number);
    if (!is_running_ || srdo.objects.direction == 0U)
    {
        return SrdoState::kOff;
    }
    return (srdo.objects.direction == kDirectionProducer) ? SrdoState::kProducer : srdo.observers[0].State();
}

SrdoMask Device::Open() const
{
    SrdoMask open = 0U;
    for (const Srdo& srdo : srdos_)
    {
        open |= srdo.is_released ? BitOf(srdo) : 0U;
    }
    return open;
}

Seen Device::TakeSeen()
{
    Seen taken;
    std::swap(taken, seen_);
    return taken;
}
} // namespace counterpoint::third_voice
