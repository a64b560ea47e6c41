// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/contract_test/bench.hpp"

namespace counterpoint::hal::contract
{

namespace
{

constexpr std::uint32_t kByteBits = 8U;
constexpr std::uint8_t kNumberBytes = 2U;
constexpr std::uint32_t kMostEvents = 2000U;

} // namespace

CanFrame NumberedFrame(const FrameName& name, const FrameNumber number) noexcept
{
    return CanFrame{name.identifier,
                    FrameKind::kData,
                    name.port,
                    kNumberBytes,
                    {static_cast<std::uint8_t>(number & 0xFFU), static_cast<std::uint8_t>(number >> kByteBits)}};
}

FrameNumber NumberOf(const CanFrame& frame) noexcept
{
    return static_cast<FrameNumber>(frame.data[0]) | (static_cast<FrameNumber>(frame.data[1]) << kByteBits);
}

bool AreEqual(const CanFrame& left, const CanFrame& right) noexcept
{
    const bool same_kind = (left.kind == right.kind) && (left.port == right.port);
    const bool same_name = (left.identifier == right.identifier) && (left.length_bytes == right.length_bytes);
    bool same_bytes = true;
    for (std::uint32_t byte = 0U; byte < kMaxPayloadBytes; ++byte)
    {
        const bool has_meaning = byte < left.length_bytes;
        same_bytes = same_bytes && (!has_meaning || (left.data[byte] == right.data[byte]));
    }
    return same_kind && same_name && same_bytes;
}

void Settle(const PortUnderTest& port) noexcept
{
    port.bench.restart(port.bench.bench);
    if (port.bench.hold_bus != nullptr)
    {
        port.bench.hold_bus(port.bench.bench, Hold::kReleased);
    }
    PassCycles(port, CyclesForFrames(port, 1U));
    static_cast<void>(Drain(port));
}

void PassCycles(const PortUnderTest& port, const std::uint32_t cycles) noexcept
{
    for (std::uint32_t cycle = 0U; cycle < cycles; ++cycle)
    {
        port.bench.pass(port.bench.bench, port.numbers.cycle_us);
        Serve(port);
    }
}

void Serve(const PortUnderTest& port) noexcept
{
    if (port.parts.watchdog != nullptr)
    {
        const std::uint32_t question = port.parts.watchdog->Question().value;
        port.parts.watchdog->Answer(WatchdogAnswer{(kFlowReference + question) * kWatchdogConstant});
    }
}

std::uint32_t CyclesForFrames(const PortUnderTest& port, const std::uint32_t frames) noexcept
{
    return ((frames * port.numbers.frame_us) / port.numbers.cycle_us) + 1U;
}

bool Receive(const PortUnderTest& port, const CanFrame& frame) noexcept
{
    const bool is_sent = port.bench.peer_send(port.bench.bench, frame);
    PassCycles(port, CyclesForFrames(port, 1U));
    return is_sent;
}

Drained Drain(const PortUnderTest& port) noexcept
{
    Drained drained{0U, 0U, 0U, 0U, PortEvent{EventKind::kNothing, StampedFrame{}}};
    PortEvent event = port.bench.next(port.bench.bench);
    for (std::uint32_t taken = 0U; (taken < kMostEvents) && (event.kind != EventKind::kNothing); ++taken)
    {
        drained.first = (taken == 0U) ? event : drained.first;
        const bool is_frame = (event.kind == EventKind::kReceived) || (event.kind == EventKind::kConfirmed);
        drained.received += (event.kind == EventKind::kReceived) ? 1U : 0U;
        drained.confirmed += (event.kind == EventKind::kConfirmed) ? 1U : 0U;
        drained.losses += (event.kind == EventKind::kLoss) ? 1U : 0U;
        drained.others += (!is_frame && (event.kind != EventKind::kLoss)) ? 1U : 0U;
        event = port.bench.next(port.bench.bench);
    }
    return drained;
}

PermitSet RightPermits(const std::uint32_t challenge, const std::uint32_t slots) noexcept
{
    // contract/channel.hpp has the formula; a mask below slot 32 has no high word.
    const std::uint32_t base = challenge + slots;
    return PermitSet{Permit{slots, base * kPermitConstantA}, Permit{slots, base * kPermitConstantB},
                     Permit{slots, base * kPermitConstantKernel}};
}

void Arm(const PortUnderTest& port) noexcept
{
    port.parts.output->Drive(PermitSet{}); // Answers what may be outstanding.
    port.parts.output->Drive(PermitSet{});
}

void Open(const PortUnderTest& port) noexcept
{
    port.parts.output->Drive(RightPermits(port.parts.output->Challenge(), 1U));
    port.bench.pass(port.bench.bench, 1U);
}

} // namespace counterpoint::hal::contract
