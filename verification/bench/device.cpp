// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/bench/device.hpp"

#include "verification/bench/meter.hpp"

namespace counterpoint::bench
{
namespace
{

// Above 64 a node has no default identifiers: all SRDOs are off until they are configured.
constexpr std::uint8_t kNodeId = 100U;
constexpr std::uint16_t kNormalIndex = 0x6000U;
constexpr std::uint16_t kInverseIndex = 0x6100U;
constexpr std::uint16_t kCommunicationIndex = 0x1301U;
constexpr std::uint16_t kMappingIndex = 0x1381U;
constexpr std::uint16_t kValidIndex = 0x13FEU;
constexpr std::uint16_t kSignatureIndex = 0x13FFU;
// Longer than any item runs: no time-out and no refresh of its own comes in between.
constexpr std::uint32_t kSctMs = 60000U;
constexpr std::uint32_t kSrvtMs = 50U;
constexpr std::uint32_t kFrameGapUs = 1U;

} // namespace

hal::CanGuarantees BenchPorts::Guarantees() const noexcept
{
    return {hal::Guarantee::kGiven, hal::Guarantee::kGiven, hal::Guarantee::kGiven};
}

hal::TransmitStatus BenchPorts::DoTransmit(const CanFrame& frame) noexcept
{
    frames_[written_ % kPlaces] = frame;
    ++written_;
    return hal::TransmitStatus::kAccepted;
}

CanFrame BenchPorts::Take() noexcept
{
    CanFrame frame{};
    if (read_ != written_)
    {
        frame = frames_[read_ % kPlaces];
        ++read_;
    }
    return frame;
}

std::uint32_t BenchOutput::Challenge() noexcept
{
    return gate_.Challenge();
}

void BenchOutput::Drive(const hal::PermitSet& permits) noexcept
{
    gate_.Drive(permits, now_);
}

void BenchOutput::Advance(const Instant now) noexcept
{
    now_ = now;
}

SrdoMask BenchOutput::Open() noexcept
{
    return gate_.Open(now_, hal::GateLimit{2U * kCycleUs});
}

hal::WatchdogQuestion BenchWatchdog::Question() noexcept
{
    return {question_};
}

void BenchWatchdog::Answer(const hal::WatchdogAnswer& answer) noexcept
{
    const std::uint32_t right = (hal::kFlowReference + question_) * hal::kWatchdogConstant;
    wrong_ += (answer.value == right) ? 0U : 1U;
    ++question_;
}

std::uint32_t BenchWatchdog::WrongAnswers() const noexcept
{
    return wrong_;
}

RefreshAnswer BenchApplication::OnRefresh(CommunicationIndex /*index*/) noexcept
{
    return RefreshAnswer::kReady;
}

void BenchApplication::OnSrdoEvent(CommunicationIndex /*index*/) noexcept
{
    ++events_;
}

void BenchApplication::OnSrdoError(CommunicationIndex /*index*/, SrdoCause /*cause*/) noexcept
{
    ++errors_;
}

void BenchApplication::OnGfc() noexcept
{
    ++errors_;
}

void BenchApplication::OnGfcNotFollowed() noexcept
{
    ++errors_;
}

void BenchApplication::OnConfigurationInvalid(CommunicationIndex /*index*/) noexcept
{
    ++errors_;
}

void BenchApplication::OnDeviceFault(const DeviceFaultReport& /*report*/) noexcept
{
    ++errors_;
}

void BenchApplication::OnFlow(const FlowCount& /*count*/) noexcept
{
}

std::uint32_t BenchApplication::Events() const noexcept
{
    return events_;
}

std::uint32_t BenchApplication::Errors() const noexcept
{
    return errors_;
}

Device::Device() noexcept : kernel_{KernelParts{channel_a_, channel_b_, ports_, output_, watchdog_, application_}}
{
}

void Device::Describe(const DevicePlan& plan) noexcept
{
    const MapAccess access = (plan.role == DeviceRole::kConsumers) ? MapAccess::kConsumer : MapAccess::kProducer;
    for (std::uint8_t slot = 0U; slot < plan.srdo_count; ++slot)
    {
        setups_[slot] = SrdoSetup{static_cast<std::uint8_t>(slot + 1U),
                                  ReleasePolicy::kAutomatic,
                                  ProducerForm::kApplicationSends,
                                  Payload{0U, 0U},
                                  SrvtDetection::kEarly,
                                  StaticMap{nullptr, 0U}};
        for (std::uint8_t part = 0U; part < 2U; ++part)
        {
            const std::uint32_t normal = (2U * slot) + part;
            const std::uint32_t inverse = (2U * plan.srdo_count) + normal;
            const auto sub = static_cast<std::uint8_t>(part + 1U);
            objects_[normal] =
                MappableObject{static_cast<std::uint16_t>(kNormalIndex + slot), sub, 32U, access, places_[normal]};
            objects_[inverse] =
                MappableObject{static_cast<std::uint16_t>(kInverseIndex + slot), sub, 32U, access, places_[inverse]};
        }
    }
    config_.srdos = setups_;
    config_.objects = objects_;
    config_.object_count = static_cast<std::uint16_t>(kObjectsEach * plan.srdo_count);
    config_.srdo_count = plan.srdo_count;
    config_.node_id = kNodeId;
    config_.granularity_bits = 32U;
    config_.map_entries = kUsualMapEntries;
    config_.gfc = GfcUse::kPresent;
    config_.normal_port = CanPortId::kFirst;
    config_.inverse_port = CanPortId::kFirst;
    config_.cycle_us = kCycleUs;
    config_.cycle_tolerance_us = 100U;
    config_.discrepancy_us = 2U * kCycleUs;
    config_.acknowledge_window_us = 500000U;
    config_.diagnostic_interval_us = plan.interval_us;
    config_.test_interval_us = plan.interval_us;
    config_.clock_tolerance_us = 1000U;
    config_.clock_interval_us = 100000U;
    config_.output_time_us = 100U;
}

bool Device::Write(const ObjectAddress& address, const ObjectNumber& number) noexcept
{
    ObjectData data{};
    data.size_bytes = number.size_bytes;
    for (std::uint32_t i = 0U; i < number.size_bytes; ++i)
    {
        data.bytes[i] = static_cast<std::uint8_t>(number.value >> (8U * i));
    }
    return kernel_.WriteObject(address, data) == AbortCode::kNone;
}

bool Device::ConfigureSlot(const std::uint8_t slot, const DevicePlan& plan) noexcept
{
    const auto communication = static_cast<std::uint16_t>(kCommunicationIndex + slot);
    const auto mapping = static_cast<std::uint16_t>(kMappingIndex + slot);
    const std::uint32_t direction = (plan.role == DeviceRole::kConsumers) ? kDirectionConsumer : kDirectionProducer;
    const std::uint32_t cob_id = kFirstSrdoIdentifier + (2U * slot);
    bool good = Write({communication, 1U}, {kDirectionOff, 1U});
    good = Write({mapping, 0U}, {0U, 1U}) && good;
    for (std::uint8_t part = 0U; part < 2U; ++part)
    {
        const std::uint32_t tail = ((part + 1U) << 8U) | 32U;
        const auto sub = static_cast<std::uint8_t>((2U * part) + 1U);
        good = Write({mapping, sub}, {((kNormalIndex + static_cast<std::uint32_t>(slot)) << 16U) | tail, 4U}) && good;
        good = Write({mapping, static_cast<std::uint8_t>(sub + 1U)},
                     {((kInverseIndex + static_cast<std::uint32_t>(slot)) << 16U) | tail, 4U}) &&
               good;
    }
    good = Write({mapping, 0U}, {kObjectsEach, 1U}) && good;
    good = Write({communication, 2U}, {kSctMs, 2U}) && good;
    good = Write({communication, 3U}, {kSrvtMs, 1U}) && good;
    good = Write({communication, 4U}, {kTransmissionTypeAsynchronous, 1U}) && good;
    good = Write({communication, 5U}, {cob_id, 4U}) && good;
    good = Write({communication, 6U}, {cob_id + 1U, 4U}) && good;
    good = Write({communication, 1U}, {direction, 1U}) && good;
    const SignReply signature = kernel_.Sign(CommunicationIndex{communication});
    return Write({kSignatureIndex, static_cast<std::uint8_t>(slot + 1U)}, {signature.signature, 2U}) && good;
}

bool Device::Start(const DevicePlan& plan) noexcept
{
    Describe(plan);
    if (kernel_.Start(config_, FlowCallback::kOff) != StartResult::kStarted)
    {
        return false;
    }
    kernel_.SetNmtState(NmtState::kPreOperational);
    bool good = true;
    for (std::uint8_t slot = 0U; slot < plan.srdo_count; ++slot)
    {
        good = ConfigureSlot(slot, plan) && good;
    }
    good = Write({kValidIndex, 0U}, {kConfigurationValidValue, 1U}) && good;
    UnmeasuredCycle();
    kernel_.SetNmtState(NmtState::kOperational);
    // Past the wait before the first transmission.
    for (std::uint32_t i = 0U; i < 60U; ++i)
    {
        UnmeasuredCycle();
    }
    for (std::uint32_t i = 0U; i < config_.object_count; ++i)
    {
        const bool inverse = i >= (2U * static_cast<std::uint32_t>(plan.srdo_count));
        for (std::uint8_t& byte : places_[i])
        {
            byte = inverse ? 0xA5U : 0x5AU;
        }
    }
    return good && IsWell();
}

CycleCall Device::NextCall() noexcept
{
    now_us_ += kCycleUs;
    offset_us_ = 0U;
    output_.Advance(Instant{now_us_});
    return {{Instant{now_us_}, Instant{now_us_ + 7U}}, 0U, 0U};
}

void Device::MeasuredCycle() noexcept
{
    const CycleCall call = NextCall();
    MeterBegin();
    kernel_.Cycle(call);
    MeterEnd();
}

void Device::UnmeasuredCycle() noexcept
{
    kernel_.Cycle(NextCall());
}

StampedFrame Device::NextFrame(const SlotIndex slot, const FrameSide side) noexcept
{
    StampedFrame frame{};
    const std::uint32_t mask = (side == FrameSide::kInverse) ? 0xFFU : 0U;
    frame.frame.identifier = kFirstSrdoIdentifier + (2U * slot) + ((side == FrameSide::kInverse) ? 1U : 0U);
    frame.frame.kind = FrameKind::kData;
    frame.frame.port = CanPortId::kFirst;
    frame.frame.length_bytes = kMaxPayloadBytes;
    for (std::uint32_t i = 0U; i < kMaxPayloadBytes; ++i)
    {
        frame.frame.data[i] = static_cast<std::uint8_t>((data_ >> (3U * i)) ^ mask);
    }
    offset_us_ += kFrameGapUs;
    frame.stamp = {Instant{now_us_ + offset_us_}, Instant{now_us_ + 7U + offset_us_}};
    return frame;
}

void Device::MeasuredPair(const SlotIndex slot) noexcept
{
    ++data_;
    const StampedFrame normal = NextFrame(slot, FrameSide::kNormal);
    MeterBegin();
    kernel_.OnFrame(normal);
    MeterEnd();
    const StampedFrame inverse = NextFrame(slot, FrameSide::kInverse);
    MeterBegin();
    kernel_.OnFrame(inverse);
    MeterEnd();
}

void Device::ConfirmNext() noexcept
{
    StampedFrame frame{};
    frame.frame = ports_.Take();
    well_ = well_ && (frame.frame.kind == FrameKind::kData);
    offset_us_ += kFrameGapUs;
    frame.stamp = {Instant{now_us_ + offset_us_}, Instant{now_us_ + 7U + offset_us_}};
    MeterBegin();
    kernel_.OnConfirm(frame);
    MeterEnd();
}

void Device::MeasuredSend(const SlotIndex slot) noexcept
{
    const CommunicationIndex index{static_cast<std::uint16_t>(kCommunicationIndex + slot)};
    MeterBegin();
    const Result result = kernel_.Send(index);
    MeterEnd();
    well_ = well_ && (result == Result::kSuccessful);
    MeasuredCycle();
    ConfirmNext();
    ConfirmNext();
    MeasuredCycle();
}

void Device::MeasuredCheck(const SlotIndex slot) noexcept
{
    Channel& a = channel_a_;
    Channel& b = channel_b_;
    MeterBegin();
    const CheckResult result_a = a.Recheck(slot);
    const CheckResult result_b = b.Recheck(slot);
    MeterEnd();
    well_ = well_ && (result_a.fault == ConfigFault::kNone) && (result_b.fault == ConfigFault::kNone) &&
            (result_a.signature == result_b.signature);
}

void Device::ReleaseAll() noexcept
{
    for (std::uint8_t slot = 0U; slot < config_.srdo_count; ++slot)
    {
        ++data_;
        kernel_.OnFrame(NextFrame(slot, FrameSide::kNormal));
        kernel_.OnFrame(NextFrame(slot, FrameSide::kInverse));
    }
    UnmeasuredCycle();
}

std::uint32_t Device::Events() const noexcept
{
    return application_.Events();
}

bool Device::IsWell() const noexcept
{
    return well_ && (kernel_.DeviceState().fault == DeviceFault::kNone) && (application_.Errors() == 0U) &&
           (watchdog_.WrongAnswers() == 0U);
}

SrdoMask Device::Open() noexcept
{
    return output_.Open();
}

} // namespace counterpoint::bench
