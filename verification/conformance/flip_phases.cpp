// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/conformance/flip_rig.hpp"

#include <memory>

namespace counterpoint::conformance
{

namespace
{
constexpr std::uint32_t kCycleUs = 1000U;
constexpr std::uint32_t kPastLimitsUs = 80000U;

void Released(FlipRig& rig)
{
    rig.Enter();
    rig.Pair(0x1111U, true);
    rig.Acknowledge(true);
    rig.Cycle(kCycleUs);
}

/// From power-on to the phase in which the bit flips. In the phases up to kLastSafePhase the consumer is safe, and nothing
/// in the next call would release it.
constexpr std::uint32_t kLastSafePhase = 5U;

void Reach(FlipRig& rig, std::uint32_t phase)
{
    rig.Start();
    switch (phase)
    {
    case 0U: // Configured, off.
        break;
    case 1U: // Waiting.
        rig.Enter();
        break;
    case 2U: // Waiting with a pending normal frame.
        rig.Enter();
        rig.Pair(0x2222U, false);
        break;
    case 3U: // Faulted.
        rig.Enter();
        rig.WrongPair(0x3333U);
        rig.Cycle(kCycleUs);
        break;
    case 4U: // Faulted, with a fault that is not reported yet, and a pair completed after it.
        rig.Enter();
        rig.WrongPair(0x3333U);
        rig.Pair(0x4444U, true);
        break;
    case 5U: // Left OPERATIONAL after a release.
        Released(rig);
        rig.Leave();
        break;
    case 6U: // Released and written.
        Released(rig);
        break;
    case 7U: // Released, next normal frame pending, producer due.
        Released(rig);
        rig.Request();
        rig.Cycle(2U * kCycleUs);
        rig.Pair(0x5555U, false);
        break;
    case 8U: // A pair that the next call may release.
        rig.Enter();
        rig.Pair(0x6666U, true);
        break;
    case 9U: // Pair in flight, nothing sent.
        Released(rig);
        rig.Request();
        rig.Cycle(2U * kCycleUs);
        rig.Launch();
        break;
    case 10U: // Normal frame confirmed, inverse frame not sent.
        Released(rig);
        rig.Request();
        rig.Cycle(2U * kCycleUs);
        rig.Launch();
        rig.SendNormal();
        break;
    default: // A newer pair, not yet written.
        Released(rig);
        rig.Pair(0x7777U, true);
        break;
    }
}

/// What comes after the flip: everything that may happen to a device.
void GoOn(FlipRig& rig, std::uint32_t phase)
{
    rig.SendNormal();
    rig.SendInverse();
    if ((phase == 2U) || (phase == 7U))
    {
        rig.InverseOf((phase == 2U) ? 0x2222U : 0x5555U);
    }
    rig.Cycle(kCycleUs);
    rig.Pair(0x0F0FU, true);
    rig.Request();
    rig.Acknowledge(false);
    rig.Cycle(kCycleUs);
    rig.Launch();
    rig.SendNormal();
    rig.SendInverse();
    rig.Acknowledge(true);
    rig.Cycle(kCycleUs);
    rig.WrongPair(0x00FFU);
    rig.Cycle(kCycleUs);
    rig.Pair(0x1357U, true);
    rig.Acknowledge(false);
    rig.Cycle(kCycleUs);
    rig.Acknowledge(true);
    rig.Cycle(kCycleUs);
    rig.Recheck();
    rig.Cycle(kPastLimitsUs);
    rig.Cycle(kCycleUs);
    rig.Leave();
    rig.Enter();
    rig.Pair(0x2468U, true);
    rig.Acknowledge(false);
    rig.Cycle(kCycleUs);
    rig.Acknowledge(true);
    rig.Cycle(kCycleUs);
}

bool IsSafe(SrdoState state)
{
    return state != SrdoState::kReleased;
}

/// One run with one flipped bit. Returns what was wrong.
Complaint RunFlip(FlipRig& rig, Party party, std::uint32_t phase, std::size_t byte, std::uint32_t bit)
{
    Reach(rig, phase);
    std::uint8_t& flipped = rig.Bytes(party)[byte];
    flipped = static_cast<std::uint8_t>(flipped ^ (1U << bit));
    if (phase <= kLastSafePhase)
    {
        rig.Cycle(kCycleUs);
        if (!IsSafe(rig.StateOf(party)))
        {
            return "released by a flipped bit alone";
        }
    }
    GoOn(rig, phase);
    const Complaint complaint = rig.Complaints();
    if (!complaint.empty())
    {
        return complaint;
    }
    // Restart heals: with everything stored anew the device works as on the first day.
    Reach(rig, 6U);
    if (!rig.IsGranted())
    {
        return "nothing is granted after Restart";
    }
    return Complaint{};
}
} // namespace

FlipResult FlipEveryBit(Party party, ReleasePolicy policy, std::uint32_t phase)
{
    FlipResult result{0U, 0U, 0U, Complaint{}};
    const auto rig = std::make_unique<FlipRig>(policy);
    const std::size_t bytes = FlipRig::ByteCount(party);
    for (std::size_t byte = 0U; byte < bytes; ++byte)
    {
        for (std::uint32_t bit = 0U; bit < 8U; ++bit)
        {
            const Complaint complaint = RunFlip(*rig, party, phase, byte, bit);
            result.runs += 1U;
            result.granted += rig->IsGranted() ? 1U : 0U;
            if (!complaint.empty())
            {
                result.complaints += 1U;
                result.first = result.first.empty() ? ("byte " + std::to_string(byte) + ", bit " + std::to_string(bit) +
                                                       ", phase " + std::to_string(phase) + ": " + complaint)
                                                    : result.first;
            }
        }
    }
    return result;
}

} // namespace counterpoint::conformance
