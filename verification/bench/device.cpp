// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/bench/device.hpp"

#include "verification/bench/meter.hpp"

namespace counterpoint::bench
{
namespace
{

constexpr std::uint16_t kCommunicationIndex = 0x1301U;
constexpr std::uint32_t kFrameGapUs = 1U;

} // namespace

Device::Device() noexcept
    : kernel_{KernelParts{channel_a_, channel_b_, ports_, output_, watchdog_, application_, nullptr, &windows_[0]}}
{
}

bool Device::Start(const DevicePlan& plan) noexcept
{
    const DeviceConfig& config = setup_.Describe(plan);
    if (kernel_.Start(config, FlowCallback::kOff) != StartResult::kStarted)
    {
        return false;
    }
    kernel_.SetNmtState(NmtState::kPreOperational);
    const bool good = setup_.Configure(kernel_);
    UnmeasuredCycle();
    kernel_.SetNmtState(NmtState::kOperational);
    // Past the wait before the first transmission.
    for (std::uint32_t i = 0U; i < 60U; ++i)
    {
        UnmeasuredCycle();
    }
    setup_.FillVariables();
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
    frame.frame.length_bytes = setup_.FrameBytes();
    for (std::uint32_t i = 0U; i < setup_.FrameBytes(); ++i)
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
    for (std::uint8_t slot = 0U; slot < setup_.SrdoCount(); ++slot)
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
