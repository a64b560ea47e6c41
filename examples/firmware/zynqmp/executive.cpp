// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "examples/firmware/zynqmp/executive.hpp"

#include "hal/zynqmp/output/cut_off.hpp"
#include "hal/zynqmp/start/exceptions.hpp"
#include "hal/zynqmp/start/memory_map.hpp"

namespace counterpoint::firmware
{
namespace
{

using zynqmp::QueuedKind;

constexpr std::uint32_t kCycleUs = 1000U;
/// A look takes many cycles of the processor; a cycle of 1 ms has 600 000 of the fastest one.
constexpr std::uint32_t kMostLooks = 60000U;
/// What the queue of the port has room for, and a loss.
constexpr std::uint32_t kMostFrames = 129U;

} // namespace

PolledExecutive::PolledExecutive(zynqmp::Board& board, const DrivenDevice& driven) noexcept
    : board_{board}, driven_{driven}
{
}

void PolledExecutive::Start() noexcept
{
    cycle_ = board_.Clocks().Now().a;
}

// False: the moment of the cycle does not come.
bool PolledExecutive::WaitForCycle() noexcept
{
    std::uint32_t looks = 0U;
    while ((looks < kMostLooks) && ((board_.Look().a.us - cycle_.us) >= (1U << 31U)))
    {
        ++looks;
    }
    return looks < kMostLooks;
}

InstantPair PolledExecutive::TakeFrames() noexcept
{
    const InstantPair now = board_.Look();
    zynqmp::QueuedFrame queued = board_.NextFrame();
    for (std::uint32_t taken = 0U; (taken < kMostFrames) && (queued.kind != QueuedKind::kNothing); ++taken)
    {
        Deliver(queued);
        queued = board_.NextFrame();
    }
    return now;
}

void PolledExecutive::Deliver(const zynqmp::QueuedFrame& queued) noexcept
{
    switch (queued.kind)
    {
    case QueuedKind::kReceived:
        driven_.device.OnFrame(queued.frame);
        break;
    case QueuedKind::kConfirmed:
        driven_.device.OnConfirm(queued.frame);
        break;
    case QueuedKind::kNothing:
        break;
    case QueuedKind::kLoss:
    case QueuedKind::kInvalid:
        driven_.device.OnLoss();
        break;
    }
}

void PolledExecutive::Cycle() noexcept
{
    cycle_.us += kCycleUs;
    const bool is_time = WaitForCycle();
    if ((board_.BeginCycle() != zynqmp::BoardFault::kNone) || (!is_time))
    {
        board_.Output().CutOff();
        zynqmp::CutOffEverything();
        return;
    }
    const InstantPair now = TakeFrames();
    // Each channel's levels come from a reading of its own, and each its own way.
    const SrdoMask acknowledge_a = ReadInputs(Pins{board_.Output().Inputs()});
    const SrdoMask acknowledge_b = ReadAcknowledge(Pins{~board_.Output().Inputs()});
    driven_.device.Cycle(CycleCall{now, acknowledge_a, acknowledge_b});
    board_.Output().SetOutputs(SetOutputs(board_.Output().Open()).bits);
    RunUnprivileged(RunNonSafety, stack_non_safety_top);
}

} // namespace counterpoint::firmware
