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

/// `sender` is the channel that has to have the frame; the other must have none.
void Runner::CheckNextFrame(const Step& step, Party sender) noexcept
{
    const CanFrame frame = channel_.NextFrame(step.slot);
    hash_.AddFrame(frame);
    if ((sender != party_) || (step.op == Op::kNextNone))
    {
        Expect("kind of the next frame (none)", static_cast<std::uint64_t>(FrameKind::kInvalid),
               static_cast<std::uint64_t>(frame.kind));
        return;
    }
    Expect("kind of the next frame", static_cast<std::uint64_t>(FrameKind::kData),
           static_cast<std::uint64_t>(frame.kind));
    Expect("identifier of the next frame", step.z, frame.identifier);
    Expect("controller of the next frame", step.field, static_cast<std::uint64_t>(frame.port));
    Expect("length of the next frame", step.sub, frame.length_bytes);
    for (std::uint32_t i = 0U; i < step.sub; ++i)
    {
        const std::uint32_t half = (i < 4U) ? step.x : step.y;
        Expect("data of the next frame", (half >> (8U * (i % 4U))) & 0xFFU, frame.data[i]);
    }
}

void Runner::RunProducerStep(const Step& step) noexcept
{
    if (step.op == Op::kRequest)
    {
        channel_.Request(step.slot);
    }
    else if (step.op == Op::kHold)
    {
        channel_.Hold(step.slot);
    }
    else if (step.op == Op::kPrepare)
    {
        const PreparedPair pair = channel_.Prepare(step.slot);
        hash_.Add(static_cast<std::uint32_t>(pair.status));
        hash_.Add(pair.length_bytes);
        hash_.Add(pair.normal.low);
        hash_.Add(pair.normal.high);
        Expect("status of Prepare", step.field, static_cast<std::uint64_t>(pair.status));
        Expect("length of the prepared pair", step.sub, pair.length_bytes);
        Expect("prepared data, bytes 0 to 3", step.x, pair.normal.low);
        Expect("prepared data, bytes 4 to 7", step.y, pair.normal.high);
    }
    else if (step.op == Op::kLaunch)
    {
        channel_.Launch(step.slot);
    }
    else if ((step.op == Op::kNextNormal) || (step.op == Op::kNextNone))
    {
        CheckNextFrame(step, Party::kA);
    }
    else if (step.op == Op::kNextInverse)
    {
        CheckNextFrame(step, Party::kB);
    }
    else if (step.op == Op::kConfirm)
    {
        const SlotIndex slot = channel_.OnConfirm(FrameOf(step), Instant{step.time + origin_});
        hash_.Add(slot);
        Expect("slot of the confirmation", step.v, slot);
    }
    else if (step.op == Op::kTransmitFault)
    {
        channel_.OnTransmitFault(step.slot, static_cast<SrdoCause>(step.x));
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
