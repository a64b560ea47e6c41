// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/conformance/flip_rig.hpp"
#include "verification/conformance/hash.hpp"

#include <memory>

namespace counterpoint::conformance
{

namespace
{
constexpr std::uint32_t kCycleUs = 1000U;
constexpr std::uint32_t kPastLimitsUs = 80000U;
constexpr std::uint32_t kCorruptionCount = 10U; ///< Of one byte: eight bits, zero, all ones.

/// From now on both channels read `level`, and have seen it when this is over.
void Acknowledge(FlipRig& rig, bool level)
{
    rig.Acknowledge(level);
    rig.Cycle(kCycleUs);
    rig.Cycle(kCycleUs);
}

void Released(FlipRig& rig)
{
    rig.Enter();
    rig.Pair(0x1111U, true);
    Acknowledge(rig, true);
}

void Due(FlipRig& rig)
{
    Released(rig);
    rig.Request();
    rig.Cycle(2U * kCycleUs);
}

void NormalSent(FlipRig& rig)
{
    Due(rig);
    rig.Prepare();
    rig.SendNormal();
}

/// From power-on to the phase in which the bit flips. In the phases up to kLastSafePhase the consumer is safe, and
/// nothing in the next call would release it.
constexpr std::uint32_t kLastSafePhase = 5U;
constexpr std::uint32_t kInvalidPhase = 13U;

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
        Due(rig);
        rig.Pair(0x5555U, false);
        break;
    case 8U: // A pair that the next call may release.
        rig.Enter();
        rig.Pair(0x6666U, true);
        break;
    case 9U: // Pair in flight, nothing sent.
        Due(rig);
        rig.Prepare();
        break;
    case 10U: // Normal frame confirmed, inverse frame not sent.
        NormalSent(rig);
        break;
    case 11U: // Inverse frame handed out, not confirmed.
        NormalSent(rig);
        rig.TakeInverse();
        break;
    case kInvalidPhase: // Off, because a check found the configuration invalid.
        rig.SpoilSignature();
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
    Acknowledge(rig, false);
    rig.Prepare();
    rig.SendNormal();
    rig.SendInverse();
    Acknowledge(rig, true);
    rig.WrongPair(0x00FFU);
    rig.Cycle(kCycleUs);
    rig.Pair(0x1357U, true);
    Acknowledge(rig, false);
    Acknowledge(rig, true);
    rig.Recheck();
    rig.Cycle(kPastLimitsUs);
    rig.Cycle(kCycleUs);
    rig.Leave();
    rig.Enter();
    rig.Pair(0x2468U, true);
    Acknowledge(rig, false);
    Acknowledge(rig, true);
}

bool IsSafe(SrdoState state)
{
    return state != SrdoState::kReleased;
}

/// What a byte becomes: with each bit flipped alone, zeroed, or all ones.
std::uint8_t Corrupted(std::uint8_t byte, std::uint32_t kind)
{
    if (kind < 8U)
    {
        return static_cast<std::uint8_t>(byte ^ (1U << kind));
    }
    return (kind == 8U) ? std::uint8_t{0U} : std::uint8_t{0xFFU};
}

/// After the corruption. Returns what was wrong.
Complaint Finish(FlipRig& rig, Party party, std::uint32_t phase)
{
    const bool was_safe = IsSafe(rig.StateOf(party));
    if (phase <= kLastSafePhase)
    {
        rig.Cycle(kCycleUs);
        if (!(was_safe && IsSafe(rig.StateOf(party))))
        {
            return "released by corruption alone";
        }
    }
    if (phase == kInvalidPhase)
    {
        rig.Enter();
        rig.Pair(0x1234U, true);
        Acknowledge(rig, true);
        const SrdoState state = rig.StateOf(party);
        if ((state == SrdoState::kWaiting) || (state == SrdoState::kReleased))
        {
            return "active with an invalid configuration";
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
    return rig.IsGranted() ? Complaint{} : Complaint{"nothing is granted after Restart"};
}

/// Stands for the first `count` entries of the consumer.
std::uint32_t MappingOf(const Channel& channel, std::uint32_t count)
{
    Hash hash;
    for (std::uint32_t sub = 1U; sub <= count; ++sub)
    {
        hash.Add(channel.Load(ConfigAddress{0U, ConfigField::kMapEntry, static_cast<std::uint8_t>(sub)}).value);
    }
    return hash.Value();
}

void Note(FlipResult& result, const FlipRig& rig, const Complaint& complaint, std::size_t byte, std::uint32_t kind)
{
    result.runs += 1U;
    result.granted += rig.IsGranted() ? 1U : 0U;
    if (!complaint.empty())
    {
        result.complaints += 1U;
        result.first = result.first.empty()
                           ? ("byte " + std::to_string(byte) + ", kind " + std::to_string(kind) + ": " + complaint)
                           : result.first;
    }
}
} // namespace

FlipResult FlipEveryBit(Party party, ReleasePolicy policy, std::uint32_t phase, RigKind device_kind)
{
    FlipResult result{0U, 0U, 0U, Complaint{}};
    const auto rig = std::make_unique<FlipRig>(policy, device_kind);
    const std::size_t bytes = FlipRig::ByteCount(party);
    for (std::size_t byte = 0U; byte < bytes; ++byte)
    {
        for (std::uint32_t kind = 0U; kind < kCorruptionCount; ++kind)
        {
            Reach(*rig, phase);
            std::uint8_t& place = rig->Bytes(party)[byte];
            place = Corrupted(place, kind);
            Note(result, *rig, Finish(*rig, party, phase), byte, kind);
        }
    }
    return result;
}

FlipResult FlipSignedEntries(Party party, RigKind device_kind)
{
    FlipResult result{0U, 0U, 0U, Complaint{}};
    const auto rig = std::make_unique<FlipRig>(ReleasePolicy::kAutomatic, device_kind);
    Channel& channel = rig->Of(party);
    const std::size_t bits = 8U * FlipRig::ByteCount(party);
    for (std::size_t bit = 0U; bit < bits; ++bit)
    {
        rig->Start();
        const std::uint32_t count = channel.Load(ConfigAddress{0U, ConfigField::kMapCount, 0U}).value;
        const std::uint32_t before = MappingOf(channel, count);
        std::uint8_t& place = rig->Bytes(party)[bit / 8U];
        place = static_cast<std::uint8_t>(place ^ (1U << (bit % 8U)));
        result.runs += 1U;
        if (MappingOf(channel, count) != before)
        {
            const CheckResult first = channel.Recheck(0U);
            channel.Store(ConfigItem{ConfigAddress{0U, ConfigField::kSignature, 0U}, first.signature});
            const bool is_found =
                (first.fault == ConfigFault::kSignature) && (channel.Recheck(0U).fault == ConfigFault::kTable);
            result.granted += is_found ? 1U : 0U;
            result.complaints += is_found ? 0U : 1U;
            result.first = is_found ? result.first : ("bit " + std::to_string(bit) + ": entry not found");
        }
    }
    return result;
}

FlipResult FillStorage(Party party, ReleasePolicy policy, std::uint32_t phase, std::uint8_t fill, RigKind device_kind)
{
    FlipResult result{0U, 0U, 0U, Complaint{}};
    const auto rig = std::make_unique<FlipRig>(policy, device_kind);
    Reach(*rig, phase);
    const std::size_t bytes = FlipRig::ByteCount(party);
    for (std::size_t byte = 0U; byte < bytes; ++byte)
    {
        rig->Bytes(party)[byte] = fill;
    }
    rig->Cycle(kCycleUs);
    Note(result, *rig, rig->IsGranted() ? Complaint{"granted by filled storage"} : Finish(*rig, party, phase), bytes,
         0U);
    return result;
}

} // namespace counterpoint::conformance
