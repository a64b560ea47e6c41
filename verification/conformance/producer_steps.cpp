// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/conformance/producer_steps.hpp"

namespace counterpoint::conformance
{

void ProducerSteps::CheckFrame(const Step& step, const CanFrame& frame) noexcept
{
    judge_.Expect("kind of the frame", static_cast<std::uint64_t>(FrameKind::kData),
                  static_cast<std::uint64_t>(frame.kind));
    judge_.Expect("identifier of the frame", step.z, frame.identifier);
    judge_.Expect("controller of the frame", step.field, static_cast<std::uint64_t>(frame.port));
    judge_.Expect("length of the frame", step.sub, frame.length_bytes);
    for (std::uint32_t i = 0U; i < kMaxPayloadBytes; ++i)
    {
        const std::uint32_t half = (i < 4U) ? step.x : step.y;
        judge_.Expect("data of the frame", (half >> (8U * (i % 4U))) & 0xFFU, frame.data[i]);
    }
}

void ProducerSteps::CheckEmpty(const CanFrame& frame) noexcept
{
    judge_.Expect("kind of the empty frame", 0U, static_cast<std::uint64_t>(frame.kind));
    judge_.Expect("identifier of the empty frame", 0U, frame.identifier);
    judge_.Expect("controller of the empty frame", 0U, static_cast<std::uint64_t>(frame.port));
    judge_.Expect("length of the empty frame", 0U, frame.length_bytes);
    for (const std::uint8_t byte : frame.data)
    {
        judge_.Expect("data of the empty frame", 0U, byte);
    }
}

/// Data of the channel under test in x, y.
Step ProducerSteps::OwnData(const Step& step) const noexcept
{
    const bool is_a = party_ == Party::kA;
    return With(step, is_a ? step.x : step.v, is_a ? step.y : step.w, step.z);
}

void ProducerSteps::CheckPrepare(const Step& step) noexcept
{
    const PreparedPair pair = channel_.Prepare(step.slot);
    hash_.Add(static_cast<std::uint32_t>(pair.status));
    hash_.AddFrame(pair.normal);
    prepared_ = pair.normal;
    if (step.op == Op::kReady)
    {
        judge_.Expect("status of Prepare", static_cast<std::uint64_t>(PrepareStatus::kReady),
                      static_cast<std::uint64_t>(pair.status));
        CheckFrame(OwnData(step), pair.normal);
    }
    else
    {
        judge_.Expect("status of Prepare", step.field, static_cast<std::uint64_t>(pair.status));
        CheckEmpty(pair.normal);
    }
}

/// Asked twice, of a channel that may not change: both answers are the same.
void ProducerSteps::CheckInverseFrame(const Step& step) noexcept
{
    const Channel& asked = channel_;
    const CanFrame frames[] = {asked.InverseFrame(step.slot), asked.InverseFrame(step.slot)};
    for (const CanFrame& frame : frames)
    {
        hash_.AddFrame(frame);
        if (step.op == Op::kTakeInverse)
        {
            CheckFrame(OwnData(step), frame);
        }
        else
        {
            CheckEmpty(frame);
        }
    }
}

void ProducerSteps::CheckConfirmation(const Step& step, const CanFrame& frame, std::uint32_t origin) noexcept
{
    const Confirmation confirmation = channel_.OnConfirm(frame, Instant{step.time + origin});
    hash_.Add(confirmation.slot);
    hash_.Add(static_cast<std::uint32_t>(confirmation.step));
    judge_.Expect("slot of the confirmation", step.v, confirmation.slot);
    judge_.Expect("step of the confirmation", step.w, static_cast<std::uint64_t>(confirmation.step));
}

bool ProducerSteps::Run(const Step& step, std::uint32_t origin) noexcept
{
    if ((step.op == Op::kReady) || (step.op == Op::kNotReady))
    {
        CheckPrepare(step);
    }
    else if ((step.op == Op::kTakeInverse) || (step.op == Op::kTakeNone))
    {
        CheckInverseFrame(step);
    }
    else if (step.op == Op::kConfirm)
    {
        CheckConfirmation(step, FrameOf(step), origin);
    }
    else if (step.op == Op::kConfirmOwn)
    {
        CheckConfirmation(With(step, 0U, 0U, 0U, step.slot, static_cast<std::uint32_t>(ConfirmStep::kNormal)),
                          prepared_, origin);
    }
    else if (step.op == Op::kTransmitFault)
    {
        channel_.OnTransmitFault(step.slot, counterpoint::TransmitFault{static_cast<SrdoCause>(step.x)});
    }
    else
    {
        return false;
    }
    return true;
}

} // namespace counterpoint::conformance
