// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/proof/protocols/link_rig.hpp"

namespace counterpoint::protocols
{
namespace
{

constexpr std::uint32_t kCycleUs = 10000U;
constexpr std::uint32_t kOldest = 5U;
constexpr std::int32_t kUnknown = 99;
constexpr LinkSender kPeer{PeerRole::kB, 5U};
/// The clock and the numbers of the other CPU are others than the own ones.
constexpr std::uint32_t kPeerClockUs = 123456U;
constexpr std::uint32_t kPeerNumber = 2U;

// Places and values of the input, by Tell of link.pml.
constexpr std::size_t kAct = 0U;
constexpr std::size_t kComposed = 1U;
constexpr std::size_t kEchoed = 2U;
constexpr std::size_t kHold = 3U;
constexpr std::size_t kHasEcho = 4U;
constexpr std::size_t kSender = 5U;
constexpr std::int32_t kActCycle = 0;
constexpr std::int32_t kActMessage = 1;
constexpr std::int32_t kDamaged = 1;
constexpr std::int32_t kOtherRole = 2;
constexpr std::int32_t kOtherNode = 3;

std::uint32_t Back(const std::uint32_t cycle, const std::int32_t cycles)
{
    return cycle - static_cast<std::uint32_t>(cycles);
}

hal::LinkFrame FrameOf(const Numbers& input, const std::uint32_t now)
{
    const std::uint32_t composed = Back(now, input[kComposed]);
    const std::uint32_t echoed = Back(now, input[kEchoed]);
    LinkMessage message{};
    message.sender = kPeer;
    message.sender.role = (input[kSender] == kOtherRole) ? PeerRole::kA : kPeer.role;
    message.sender.node_id = (input[kSender] == kOtherNode) ? std::uint8_t{6U} : kPeer.node_id;
    message.fault = DeviceFault::kNone;
    message.sequence = composed + kPeerNumber;
    message.stamp = Instant{(composed * kCycleUs) + kPeerClockUs};
    if (input[kHasEcho] != 0)
    {
        const std::uint32_t hold_us = static_cast<std::uint32_t>(input[kHold]) * kCycleUs;
        message.echo = LinkEcho{echoed, Instant{echoed * kCycleUs}, hold_us, kHeard};
    }
    hal::LinkFrame frame{};
    Encode(message, frame);
    if (input[kSender] == kDamaged)
    {
        frame.bytes[9U] ^= 0x10U;
    }
    return frame;
}

/// Which count moved, by the numbers of link.pml.
std::int32_t Moved(const LinkCounts& before, const LinkCounts& after)
{
    const std::uint32_t moved = (after.taken - before.taken) + (2U * (after.repeated - before.repeated)) +
                                (3U * (after.old - before.old)) + (4U * (after.late - before.late)) +
                                (5U * (after.corrupt - before.corrupt));
    return static_cast<std::int32_t>(moved);
}

} // namespace

LinkRig::LinkRig(const LinkDefect defect) : defect_(defect), cycle_(0xFFFFFFFDU)
{
    Start();
}

void LinkRig::Start()
{
    constexpr std::uint32_t kNever = 0x20000000U; // The clocks of the model do not drift.
    const std::uint32_t cycles = (defect_ == LinkDefect::kLongerTimeout) ? 4U : 3U;
    link_.Restart(LinkConfig{PeerRole::kA, cycles * kCycleUs, kNever, kNever, 100U});
    if (defect_ == LinkDefect::kOlderAnswers)
    {
        link_.Examine(Instant{cycle_ * kCycleUs});
        for (std::uint32_t older = kOldest; older != 0U; --older)
        {
            link_.OnCompose(cycle_ - older);
        }
    }
}

void LinkRig::Cycle()
{
    link_.Examine(Instant{cycle_ * kCycleUs});
    link_.OnCompose(cycle_);
    ++cycle_;
}

std::int32_t LinkRig::Receive(const Numbers& input)
{
    const LinkCounts before = link_.Counts();
    const Instant now{cycle_ * kCycleUs};
    LinkMessage message{};
    const bool is_intact = Decode(FrameOf(input, cycle_), kPeer, message) == DecodeResult::kIntact;
    if (is_intact || (defect_ == LinkDefect::kTakesForeign))
    {
        static_cast<void>(link_.Take(message, now));
    }
    else
    {
        link_.CountCorrupt();
    }
    return Moved(before, link_.Counts());
}

Numbers LinkRig::Apply(const Numbers& input)
{
    std::int32_t result = 0;
    if (input.at(kAct) == kActCycle)
    {
        Cycle();
    }
    else if (input[kAct] == kActMessage)
    {
        result = Receive(input);
    }
    else
    {
        Start();
    }
    const LinkEcho echo = link_.Echo(Instant{cycle_ * kCycleUs});
    const bool is_heard = echo.heard == kHeard;
    const std::uint32_t age = cycle_ - (echo.sequence - kPeerNumber);
    const bool is_told = is_heard && (age <= kOldest);
    const std::int32_t waiting = (link_.State() == LinkState::kWaiting) ? 1 : 0;
    return {link_.IsAlive() ? 2 : waiting, result, is_heard ? 1 : 0,
            is_told ? static_cast<std::int32_t>(age) : kUnknown};
}

} // namespace counterpoint::protocols
