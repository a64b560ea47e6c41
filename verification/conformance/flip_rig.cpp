// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/conformance/flip_rig.hpp"

namespace counterpoint::conformance
{

namespace
{
constexpr SlotIndex kConsumerSlot = 0U;
constexpr SlotIndex kProducerSlot = 1U;
constexpr std::uint32_t kWord = 0xFFFFU; ///< Two bytes of data.
constexpr std::uint32_t kSctUs = 50000U;
constexpr std::uint32_t kSrvtUs = 20000U;
constexpr std::uint32_t kGapUs = 100U;
constexpr std::uint32_t kApplicationData = 0x3412U;
constexpr std::uint32_t kDiscrepancyUs = 2000U;

std::uint32_t RotatedLeft(std::uint32_t word, std::uint32_t bits)
{
    return (word << bits) | (word >> (32U - bits));
}

CanFrame FrameWith(std::uint32_t identifier, std::uint32_t data)
{
    CanFrame frame{identifier, FrameKind::kData, CanPortId::kFirst, 2U, {}};
    frame.data[0] = static_cast<std::uint8_t>(data & 0xFFU);
    frame.data[1] = static_cast<std::uint8_t>((data >> 8U) & 0xFFU);
    return frame;
}

std::uint32_t DataOf(const CanFrame& frame)
{
    return static_cast<std::uint32_t>(frame.data[0]) | (static_cast<std::uint32_t>(frame.data[1]) << 8U);
}

void Configure(Channel& channel, SlotIndex slot, const SrdoValues& values)
{
    const auto store = [&channel, slot](ConfigField field, std::uint8_t sub, std::uint32_t value)
    { channel.Store(ConfigItem{ConfigAddress{slot, field, sub}, value}); };
    store(ConfigField::kSct, 0U, values.sct_ms);
    store(ConfigField::kSrvt, 0U, values.srvt_ms);
    store(ConfigField::kCobId1, 0U, values.cob_id_1);
    store(ConfigField::kCobId2, 0U, values.cob_id_2);
    for (std::uint8_t sub = 1U; sub <= values.map_count; ++sub)
    {
        store(ConfigField::kMapEntry, sub, values.entries[sub - 1U]);
    }
    store(ConfigField::kMapCount, 0U, values.map_count);
    store(ConfigField::kDirection, 0U, values.direction);
    store(ConfigField::kSignature, 0U, values.signature);
    static_cast<void>(channel.Validate(slot));
}
} // namespace

FlipRig::FlipRig(ReleasePolicy policy, RigKind device_kind)
    : device_{kRigDevices[static_cast<std::uint8_t>(device_kind)]}, a_{storage_a_.Handle()}, b_{storage_b_.Handle()}
{
    config_ = kMixed.config;
    for (SlotIndex slot = 0U; slot < kRigSlots; ++slot)
    {
        setups_[slot] = kMixed.config.srdos[slot];
        setups_[slot].policy = policy;
    }
    setups_[kConsumerSlot].detection = device_.detection;
    setups_[kConsumerSlot].map = device_.maps[kConsumerSlot];
    setups_[kProducerSlot].map = device_.maps[kProducerSlot];
    config_.srdos = setups_;
    config_.granularity_bits = (device_kind == RigKind::kBits) ? std::uint8_t{1U} : std::uint8_t{8U};
    config_.dummies = (device_kind == RigKind::kBits) ? DummyMapping::kAllowed : DummyMapping::kRefused;
    config_.objects = dictionary_.Objects();
    config_.object_count = Dictionary::kObjectCount;
}

void FlipRig::Store(SlotIndex slot, ConfigField field, std::uint8_t sub, std::uint32_t value)
{
    const ConfigItem item{ConfigAddress{slot, field, sub}, value};
    a_.Store(item);
    b_.Store(item);
}

namespace
{

/// Both work on one memory: each writes its own side.
void ConfigureAll(Channel& channel, const RigDevice& device, const Dictionary& dictionary)
{
    for (SlotIndex slot = 0U; slot < kRigSlots; ++slot)
    {
        if (slot <= kProducerSlot)
        {
            const RigObject& first = (slot == kConsumerSlot) ? device.consumed[0] : device.sent[0];
            channel.SetFields(slot, StaticFields{dictionary.Place(first.normal_index, first.sub),
                                                 dictionary.Place(first.inverse_index, first.sub)});
        }
        Configure(channel, slot, (slot <= kProducerSlot) ? device.values[slot] : kMixed.values[slot]);
    }
}

} // namespace

void FlipRig::Start()
{
    dictionary_.Fill(0U);
    a_.Restart(config_);
    b_.Restart(config_);
    comparator_.Restart(ComparatorSetup{kDiscrepancyUs, config_.acknowledge_window_us, kRigSlots});
    ConfigureAll(a_, device_, dictionary_);
    ConfigureAll(b_, device_, dictionary_);
    Store(0U, ConfigField::kGfcParameter, 0U, 1U);
    Store(0U, ConfigField::kConfigurationValid, 0U, kConfigurationValidValue);
    for (const RigObject& object : device_.sent)
    {
        const std::uint32_t value = (kApplicationData >> object.shift) & object.mask;
        dictionary_.Put(object.normal_index, object.sub, ObjectValue{value, 0U});
        dictionary_.Put(object.inverse_index, object.sub, ObjectValue{value ^ object.mask, 0U});
    }
    nmt_ = NmtState::kPreOperational;
    cycles_ = 0U;
    acknowledge_ = 0U;
    last_.is_valid = false;
    before_.is_valid = false;
    has_sent_normal_ = false;
    is_device_safe_ = false;
    request_ = 0U;
    normal_ = CanFrame{};
    inverse_ = CanFrame{};
    is_granted_ = false;
    Cycle(1000U);
}

void FlipRig::Enter()
{
    nmt_ = NmtState::kOperational;
    Cycle(1000U);
}

void FlipRig::Leave()
{
    nmt_ = NmtState::kPreOperational;
    Cycle(1000U);
}

void FlipRig::Acknowledge(bool level)
{
    acknowledge_ = level ? 7U : 0U;
}

void FlipRig::Cycle(std::uint32_t elapsed_us)
{
    clock_us_ += elapsed_us;
    challenge_ = (challenge_ * 1664525U) + 1013904223U;
    ++cycles_;
    const std::uint32_t token = RotatedLeft(challenge_, 8U) ^ 0xA5A5A5A5U;
    const CycleInput input{Instant{clock_us_}, challenge_, token, acknowledge_,
                           request_,           0U,         nmt_,  QueueState::kIntact};
    request_ = 0U;
    const CycleOutcome outcome_a = a_.OnCycle(input);
    const CycleOutcome outcome_b = b_.OnCycle(input);
    verdict_ = comparator_.Compare(
        Comparison{&outcome_a, &outcome_b, &a_, &b_, Instant{clock_us_}, cycles_, challenge_, HeldPair{}});
    is_device_safe_ = is_device_safe_ || (verdict_.fault != DeviceFault::kNone);
    for (SlotIndex slot = 0U; slot < kRigSlots; ++slot)
    {
        if (((verdict_.demote >> slot) & 1U) != 0U)
        {
            a_.Demote(slot);
            b_.Demote(slot);
        }
    }
    const Agreement agreement = is_device_safe_ ? Agreement{0U, 0U} : verdict_.agreement;
    const SrdoMask examined = SrdoMask{1U} << (cycles_ % kRigSlots);
    const SrdoMask found = a_.Commit(agreement, examined) | b_.Commit(agreement, examined);
    is_device_safe_ = is_device_safe_ || (found != 0U);
    LookAtOutputs(a_.Answer(challenge_), b_.Answer(challenge_));
}

/// Granted is what both permits name, with the objects complements of each other, in a device that is not safe: that
/// must be the data of the last valid pair, and not too old.
void FlipRig::LookAtOutputs(const Permit& a, const Permit& b)
{
    is_granted_ = false;
    if (!IsFenced())
    {
        complaint_ = "a byte beside the storage of a channel was written";
    }
    const bool is_permitted = (a.mask == b.mask) && ((a.mask & 1U) != 0U) && (!is_device_safe_);
    if (!is_permitted)
    {
        return;
    }
    const std::uint32_t normal = ReadSide(false);
    if ((normal ^ ReadSide(true)) != MappedBits(device_))
    {
        return; // The application's check of the pair finds it.
    }
    is_granted_ = true;
    if (!IsLegitimate(normal))
    {
        complaint_ = "granted data " + std::to_string(normal) + ", last valid pair " + std::to_string(last_.data) +
                     ", age " + std::to_string(clock_us_ - last_.normal_us) + " us";
    }
}

bool FlipRig::IsFenced() const
{
    std::uint32_t written = 0U;
    for (const Fence* const fence : {&before_a_, &behind_a_, &behind_b_})
    {
        for (const std::uint8_t byte : fence->bytes)
        {
            written |= byte;
        }
    }
    return written == 0U;
}

/// The consumer's objects of one side where their bits lie in the data; the bits of a dummy are 0.
std::uint32_t FlipRig::ReadSide(bool is_inverse) const
{
    std::uint32_t data = 0U;
    for (const RigObject& object : device_.consumed)
    {
        const std::uint16_t index = is_inverse ? object.inverse_index : object.normal_index;
        data |= dictionary_.Get(index, object.sub).low << object.shift;
    }
    return data;
}

bool FlipRig::IsLegitimate(std::uint32_t granted) const
{
    const std::uint32_t mapped = MappedBits(device_);
    const bool is_last =
        last_.is_valid && (granted == (last_.data & mapped)) && ((clock_us_ - last_.normal_us) <= (kSctUs + kSrvtUs));
    const bool is_before = before_.is_valid && (granted == (before_.data & mapped)) &&
                           ((clock_us_ - before_.normal_us) <= (kSctUs + kSrvtUs));
    return is_last || is_before;
}

void FlipRig::Feed(std::uint32_t identifier, std::uint32_t data)
{
    clock_us_ += kGapUs;
    const CanFrame frame = FrameWith(identifier, data);
    a_.OnFrame(frame, Instant{clock_us_});
    b_.OnFrame(frame, Instant{clock_us_});
}

void FlipRig::Pair(std::uint32_t data, bool is_whole)
{
    Feed(0x111U, data);
    pending_us_ = clock_us_;
    if (is_whole)
    {
        InverseOf(data);
    }
}

void FlipRig::InverseOf(std::uint32_t data)
{
    Feed(0x112U, data ^ kWord);
    before_ = last_;
    last_ = Sent{data, pending_us_, true};
}

void FlipRig::WrongPair(std::uint32_t data)
{
    Feed(0x111U, data);
    Feed(0x112U, data ^ kWord ^ 0x0100U);
    last_.is_valid = false;
    before_.is_valid = false;
}

// ---- producer

void FlipRig::Request()
{
    request_ = SrdoMask{1U} << kProducerSlot;
}

void FlipRig::Prepare()
{
    normal_ = CanFrame{};
    if (((verdict_.start >> kProducerSlot) & 1U) == 0U)
    {
        return;
    }
    const PreparedPair pair_a = a_.Prepare(kProducerSlot);
    const PreparedPair pair_b = b_.Prepare(kProducerSlot);
    const PreparedVerdict verdict = Comparator::ComparePrepared(pair_a, pair_b);
    if (verdict == PreparedVerdict::kEqual)
    {
        normal_ = pair_a.normal;
    }
    else if (verdict == PreparedVerdict::kNotInverse)
    {
        a_.OnTransmitFault(kProducerSlot, TransmitFault{SrdoCause::kNotInverse});
        b_.OnTransmitFault(kProducerSlot, TransmitFault{SrdoCause::kNotInverse});
    }
    else
    {
        is_device_safe_ = true;
    }
}

void FlipRig::Confirm(const CanFrame& frame)
{
    clock_us_ += kGapUs;
    static_cast<void>(a_.OnConfirm(frame, Instant{clock_us_}));
    static_cast<void>(b_.OnConfirm(frame, Instant{clock_us_}));
}

void FlipRig::SendNormal()
{
    const CanFrame frame = normal_;
    normal_ = CanFrame{};
    has_sent_normal_ = (frame.kind == FrameKind::kData) && (frame.identifier == 0x101U) && (!is_device_safe_);
    sent_normal_ = DataOf(frame);
    if (has_sent_normal_)
    {
        Confirm(frame);
    }
}

/// As the kernel does it: a frame in which the channels differ does not leave.
void FlipRig::TakeInverse()
{
    const CanFrame frame_a = a_.InverseFrame(kProducerSlot);
    const CanFrame frame_b = b_.InverseFrame(kProducerSlot);
    const bool is_same = (frame_a.kind == frame_b.kind) && (frame_a.identifier == frame_b.identifier) &&
                         (frame_a.length_bytes == frame_b.length_bytes) && (DataOf(frame_a) == DataOf(frame_b));
    if (is_same && (frame_b.kind == FrameKind::kData))
    {
        inverse_ = frame_b;
    }
}

/// A valid pair on the bus must carry what the application wrote.
void FlipRig::SendInverse()
{
    if (inverse_.kind != FrameKind::kData)
    {
        TakeInverse();
    }
    const CanFrame frame = inverse_;
    inverse_ = CanFrame{};
    if ((frame.kind != FrameKind::kData) || is_device_safe_)
    {
        return;
    }
    const bool is_pair = has_sent_normal_ && (frame.identifier == 0x102U) && (frame.length_bytes == 2U) &&
                         ((sent_normal_ ^ DataOf(frame)) == kWord);
    if (is_pair && (sent_normal_ != kApplicationData))
    {
        complaint_ = "sent a valid pair with data " + std::to_string(sent_normal_) + ", which nobody wrote";
    }
    Confirm(frame);
}

void FlipRig::Recheck()
{
    for (SlotIndex slot = 0U; slot < kRigSlots; ++slot)
    {
        static_cast<void>(a_.Recheck(slot));
        static_cast<void>(b_.Recheck(slot));
    }
    CompareDigests();
}

/// As the guard does it: copies of parameters that differ are no parameters.
void FlipRig::CompareDigests()
{
    DeviceDigest a{0U};
    DeviceDigest b{0U};
    for (SlotIndex slot = 0U; slot < kRigSlots; ++slot)
    {
        a = a_.Digest(slot, a);
        b = b_.Digest(slot, b);
    }
    is_device_safe_ = is_device_safe_ || (a.value != b.value);
}

void FlipRig::SpoilSignature()
{
    Store(kConsumerSlot, ConfigField::kSignature, 0U, 0U);
    Recheck();
}

// ---- what the tests look at

Channel& FlipRig::Of(Party party)
{
    return (party == Party::kA) ? static_cast<Channel&>(a_) : static_cast<Channel&>(b_);
}

SrdoState FlipRig::StateOf(Party party) const
{
    return (party == Party::kA) ? a_.View(kConsumerSlot).state : b_.View(kConsumerSlot).state;
}

std::uint8_t* FlipRig::Bytes(Party party)
{
    // The storage is plain data of ours; a flipped bit is a change of its bytes, whatever their type.
    return (party == Party::kA) ? reinterpret_cast<std::uint8_t*>(&storage_a_)
                                : reinterpret_cast<std::uint8_t*>(&storage_b_);
}

std::size_t FlipRig::ByteCount(Party party)
{
    return (party == Party::kA) ? sizeof(storage_a_) : sizeof(storage_b_);
}

const Complaint& FlipRig::Complaints() const
{
    return complaint_;
}

bool FlipRig::IsGranted() const
{
    return is_granted_;
}

} // namespace counterpoint::conformance
