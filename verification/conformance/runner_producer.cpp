// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/conformance/cases.hpp"
#include "verification/conformance/runner.hpp"

namespace counterpoint::conformance
{

CanFrame FrameOf(const Step& step) noexcept
{
    CanFrame frame{step.z, static_cast<FrameKind>(step.slot), static_cast<CanPortId>(step.field), step.sub, {}};
    for (std::uint32_t i = 0U; i < kMaxPayloadBytes; ++i)
    {
        const std::uint32_t half = (i < 4U) ? step.x : step.y;
        frame.data[i] = static_cast<std::uint8_t>((half >> (8U * (i % 4U))) & 0xFFU);
    }
    return frame;
}

void Runner::LookAtSlots() noexcept
{
    for (SlotIndex slot = 0U; slot < config_.srdo_count; ++slot)
    {
        const SrdoView view = channel_.View(slot);
        hash_.AddView(view);
        CheckHeld(slot, view);
    }
}

/// Held tells what View tells of an active consumer, and nothing of the others.
void Runner::CheckHeld(SlotIndex slot, const SrdoView& view) noexcept
{
    const bool is_consumer = (view.state == SrdoState::kWaiting) || (view.state == SrdoState::kFaulted) ||
                             (view.state == SrdoState::kReleased);
    const HeldPair held = channel_.Held(slot);
    hash_.AddHeld(held);
    Expect("held data, bytes 0 to 3", is_consumer ? view.data.low : 0U, held.data.low);
    Expect("held data, bytes 4 to 7", is_consumer ? view.data.high : 0U, held.data.high);
    Expect("held ordinal", is_consumer ? view.ordinal : 0U, held.ordinal);
    Expect("holds_pair of Held", is_consumer ? view.holds_pair : 0U, held.holds_pair);
}

bool Runner::RunReleaseStep(const Step& step) noexcept
{
    if (step.op == Op::kDemote)
    {
        channel_.Demote(step.slot);
    }
    else if (step.op == Op::kCommit)
    {
        channel_.Commit(Agreement{(SrdoMask{step.y} << 32U) | step.x, (SrdoMask{step.v} << 32U) | step.z});
        hash_.Add(dictionary_.Digest());
    }
    else if (step.op == Op::kAnswer)
    {
        const Permit permit = channel_.Answer(step.z);
        hash_.AddMask(permit.mask);
        hash_.Add(permit.response);
        Expect("mask of the permit", (SrdoMask{step.y} << 32U) | step.x, permit.mask);
        Expect("response of the permit", (party_ == Party::kA) ? step.v : step.w, permit.response);
    }
    else
    {
        return false;
    }
    return true;
}

void Runner::CheckFrame(const Step& step, const CanFrame& frame) noexcept
{
    Expect("kind of the frame", static_cast<std::uint64_t>(FrameKind::kData), static_cast<std::uint64_t>(frame.kind));
    Expect("identifier of the frame", step.z, frame.identifier);
    Expect("controller of the frame", step.field, static_cast<std::uint64_t>(frame.port));
    Expect("length of the frame", step.sub, frame.length_bytes);
    for (std::uint32_t i = 0U; i < kMaxPayloadBytes; ++i)
    {
        const std::uint32_t half = (i < 4U) ? step.x : step.y;
        Expect("data of the frame", (half >> (8U * (i % 4U))) & 0xFFU, frame.data[i]);
    }
}

void Runner::CheckEmpty(const CanFrame& frame) noexcept
{
    Expect("kind of the empty frame", 0U, static_cast<std::uint64_t>(frame.kind));
    Expect("identifier of the empty frame", 0U, frame.identifier);
    Expect("controller of the empty frame", 0U, static_cast<std::uint64_t>(frame.port));
    Expect("length of the empty frame", 0U, frame.length_bytes);
    for (const std::uint8_t byte : frame.data)
    {
        Expect("data of the empty frame", 0U, byte);
    }
}

void Runner::CheckPrepare(const Step& step) noexcept
{
    const PreparedPair pair = channel_.Prepare(step.slot);
    hash_.Add(static_cast<std::uint32_t>(pair.status));
    hash_.AddFrame(pair.normal);
    if (step.op == Op::kReady)
    {
        Expect("status of Prepare", static_cast<std::uint64_t>(PrepareStatus::kReady),
               static_cast<std::uint64_t>(pair.status));
        const bool is_a = party_ == Party::kA;
        CheckFrame(With(step, is_a ? step.x : step.v, is_a ? step.y : step.w, step.z), pair.normal);
    }
    else
    {
        Expect("status of Prepare", step.field, static_cast<std::uint64_t>(pair.status));
        CheckEmpty(pair.normal);
    }
}

/// Only B has inverse frames.
void Runner::CheckInverseFrame(const Step& step) noexcept
{
    const CanFrame frame = channel_.InverseFrame(step.slot);
    hash_.AddFrame(frame);
    if ((step.op == Op::kTakeInverse) && (party_ == Party::kB))
    {
        CheckFrame(step, frame);
    }
    else
    {
        CheckEmpty(frame);
    }
}

void Runner::CheckConfirmation(const Step& step) noexcept
{
    const Confirmation confirmation = channel_.OnConfirm(FrameOf(step), Instant{step.time + origin_});
    hash_.Add(confirmation.slot);
    hash_.Add(static_cast<std::uint32_t>(confirmation.step));
    Expect("slot of the confirmation", step.v, confirmation.slot);
    Expect("step of the confirmation", step.w, static_cast<std::uint64_t>(confirmation.step));
}

void Runner::RunProducerStep(const Step& step) noexcept
{
    if (step.op == Op::kRequest)
    {
        request_ |= SrdoMask{1U} << step.slot;
    }
    else if (step.op == Op::kStand)
    {
        stand_ |= SrdoMask{1U} << step.slot;
    }
    else if ((step.op == Op::kReady) || (step.op == Op::kNotReady))
    {
        CheckPrepare(step);
    }
    else if ((step.op == Op::kTakeInverse) || (step.op == Op::kTakeNone))
    {
        CheckInverseFrame(step);
    }
    else if (step.op == Op::kConfirm)
    {
        CheckConfirmation(step);
    }
    else if (step.op == Op::kTransmitFault)
    {
        channel_.OnTransmitFault(step.slot, counterpoint::TransmitFault{static_cast<SrdoCause>(step.x)});
    }
    else
    {
        Expect("kind of step", 0U, static_cast<std::uint64_t>(step.op));
    }
}

RunResult RunConformance(Runner& runner) noexcept
{
    RunResult result{0U, 0U, 0U};
    for (std::uint32_t table = 0U; table < kTableCount; ++table)
    {
        for (std::uint32_t i = 0U; i < kAllTables[table]->count; ++i)
        {
            for (const std::uint32_t origin : kOrigins)
            {
                const bool held = runner.Run(kAllTables[table]->cases[i], origin);
                result.cases += 1U;
                result.failures += held ? 0U : 1U;
            }
        }
    }
    result.hash = runner.HashValue();
    return result;
}

} // namespace counterpoint::conformance
