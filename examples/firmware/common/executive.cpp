// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "examples/firmware/common/executive.hpp"

#include "hal/tms570/chip/processor.hpp"
#include "hal/tms570/output/cut_off.hpp"
#include "hal/tms570/output/gio_registers.hpp"
#include "hal/tms570/start/exceptions.hpp"
#include "hal/tms570/start/memory_map.hpp"

namespace counterpoint::firmware
{
namespace
{

using namespace tms570;

constexpr std::uint32_t kCycleUs = 1000U;
/// A look takes some cycles of the processor; a cycle of 1 ms has 160 000 of the fastest one.
constexpr std::uint32_t kMostLooks = 160000U;
/// More than the queue of the port has room for.
constexpr std::uint32_t kMostFrames = 128U;

} // namespace

Executive::Executive(Board& board, const DrivenDevice& driven, const BoardNeeds& needs) noexcept
    : board_{board}, driven_{driven}, needs_{needs}
{
}

void Executive::Start() noexcept
{
    Write(At(gio::kPortB, gio::kClear), needs_.output_pins);
    Write(At(gio::kPortB, gio::kDirection), needs_.output_pins);
    cycle_ = board_.Clocks().Now().a;
}

// False: the moment of the cycle does not come.
bool Executive::WaitForCycle() const noexcept
{
    std::uint32_t looks = 0U;
    while ((looks < kMostLooks) && ((board_.Clocks().Now().a.us - cycle_.us) >= (1U << 31U)))
    {
        ++looks;
    }
    return looks < kMostLooks;
}

// Stamp and queue belong together: whatever comes after the look that found the queue empty has a later stamp.
InstantPair Executive::TakeFrames() noexcept
{
    InstantPair now{};
    tms570::QueuedFrame queued{};
    std::uint32_t taken = 0U;
    do
    {
        const std::uint32_t before = LockInterrupts();
        queued = board_.NextFrame();
        now = board_.Clocks().Now();
        UnlockInterrupts(before);
        Deliver(queued);
        ++taken;
    } while ((queued.kind != QueuedKind::kNothing) && (taken < kMostFrames));
    return now;
}

void Executive::Deliver(const QueuedFrame& queued) noexcept
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

void Executive::Cycle() noexcept
{
    cycle_.us += kCycleUs;
    const bool is_time = WaitForCycle();
    if ((board_.BeginCycle() != BoardFault::kNone) || (!is_time))
    {
        CutOffEverything();
        return;
    }
    const InstantPair now = TakeFrames();
    // Each channel's levels come from a reading of its own, and each its own way.
    const SrdoMask acknowledge_a = ReadInputs(Pins{Read(At(gio::kPortB, gio::kInput)) & ~needs_.output_pins});
    const SrdoMask acknowledge_b = ReadAcknowledge(Pins{needs_.output_pins | ~Read(At(gio::kPortB, gio::kInput))});
    driven_.device.Cycle(CycleCall{now, acknowledge_a, acknowledge_b});
    // Bit 0 of the device's outputs is the lowest of its output pins.
    const std::uint32_t pins = needs_.output_pins;
    const std::uint32_t outputs = (SetOutputs(board_.Output().Open()).bits * (pins & (~pins + 1U))) & pins;
    Write(At(gio::kPortB, gio::kSet), outputs);
    Write(At(gio::kPortB, gio::kClear), needs_.output_pins & ~outputs);
    RunUnprivileged(RunNonSafety, stack_non_safety_top);
}

} // namespace counterpoint::firmware
