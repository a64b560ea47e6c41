// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CONFORMANCE_STEPS_HPP
#define VERIFICATION_CONFORMANCE_STEPS_HPP

#include "verification/conformance/step.hpp"

#include <cstdint>

/// The words of the case tables, one for each kind of step.
namespace counterpoint::conformance
{

// ---- configuration

constexpr Step Configure()
{
    return Make(Op::kConfigure);
}

constexpr Step StoreAll()
{
    return Make(Op::kStoreAll);
}

constexpr Step Store(SlotIndex slot, ConfigField field, std::uint32_t value, std::uint8_t sub = 0U)
{
    return With(Make(Op::kStore, slot, static_cast<std::uint8_t>(field), sub), value);
}

constexpr Step Load(SlotIndex slot, ConfigField field, std::uint32_t value, std::uint8_t sub = 0U)
{
    return With(Make(Op::kLoad, slot, static_cast<std::uint8_t>(field), sub), value);
}

constexpr Step Validate(SlotIndex slot, ConfigFault fault, std::uint16_t signature)
{
    return With(Make(Op::kValidate, slot), static_cast<std::uint32_t>(fault), signature);
}

constexpr Step Recheck(SlotIndex slot, ConfigFault fault, std::uint16_t signature)
{
    return With(Make(Op::kRecheck, slot), static_cast<std::uint32_t>(fault), signature);
}

constexpr Step Restart()
{
    return Make(Op::kRestart);
}

/// The last frame or cycle once more, `times` times, each `apart_us` later than the one before. Outcomes in between are
/// free.
constexpr Step Repeat(std::uint32_t times, std::uint32_t apart_us)
{
    return With(Make(Op::kRepeat), times, apart_us);
}

/// Names an object for Fields; index 0 is none.
constexpr std::uint32_t Place(std::uint16_t index, std::uint8_t sub)
{
    return (static_cast<std::uint32_t>(index) << 8U) | sub;
}

constexpr Step Fields(SlotIndex slot, std::uint32_t normal, std::uint32_t inverse)
{
    return With(Make(Op::kFields, slot), normal, inverse);
}

constexpr Step Digest(SlotIndex slot, std::uint32_t before, std::uint32_t digest)
{
    return With(Make(Op::kDigest, slot), before, digest);
}

/// The same device but for one parameter (of the setup of `slot`, one of the first two), from power-on.
constexpr Step Alter(Parameter parameter, std::uint32_t value, SlotIndex slot = 0U)
{
    return With(Make(Op::kAlter, slot, static_cast<std::uint8_t>(parameter)), value);
}

// ---- the cycle

constexpr Step Nmt(NmtState state)
{
    return With(Make(Op::kNmt), static_cast<std::uint32_t>(state));
}

constexpr Step Acknowledge(SrdoMask mask)
{
    return With(Make(Op::kAcknowledge), LowerHalf(mask), UpperHalf(mask));
}

constexpr Step Queue(QueueState state)
{
    return With(Make(Op::kQueue), static_cast<std::uint32_t>(state));
}

constexpr Step Token(std::uint32_t flipped)
{
    return With(Make(Op::kToken), flipped);
}

constexpr Step Cycle(std::uint32_t now)
{
    return Timed(Make(Op::kCycle), now);
}

/// What the last cycle must have returned for the first 32 slots; the others must be in no mask.
constexpr Step Masks(std::uint32_t released, std::uint32_t faulted, std::uint32_t waiting, std::uint32_t new_fault,
                     std::uint32_t fresh)
{
    return With(Make(Op::kMasks), released, faulted, waiting, new_fault, fresh);
}

constexpr Step Mask(MaskName name, SrdoMask mask)
{
    return With(Make(Op::kMask, static_cast<std::uint8_t>(name)), LowerHalf(mask), UpperHalf(mask));
}

constexpr Step Due(SrdoMask mask)
{
    return Mask(MaskName::kDue, mask);
}

/// Whose refresh waits.
constexpr Step Refresh(SrdoMask mask)
{
    return Mask(MaskName::kRefresh, mask);
}

constexpr Step Signalled(SrdoMask mask)
{
    return Mask(MaskName::kSignalled, mask);
}

constexpr Step Counts(std::uint8_t sct_checked, std::uint8_t is_tx, std::uint8_t is_invalid,
                      std::uint8_t not_operational)
{
    return With(Make(Op::kCounts, sct_checked, is_tx, is_invalid), not_operational);
}

constexpr Step Guard(GuardView view)
{
    return With(Make(Op::kGuard), static_cast<std::uint32_t>(view));
}

constexpr Step OrdinalSum(std::uint32_t sum)
{
    return With(Make(Op::kOrdinalSum), sum);
}

// ---- details of a slot

/// `pair` is 1 when a pair is held.
constexpr Step Slot(SlotIndex slot, SrdoState state, SrdoCause cause, std::uint32_t ordinal, std::uint32_t errors,
                    std::uint32_t pair)
{
    return With(Make(Op::kSlot, slot, static_cast<std::uint8_t>(state), static_cast<std::uint8_t>(cause)), ordinal,
                errors, pair);
}

constexpr Step Data(SlotIndex slot, std::uint32_t low, std::uint32_t high = 0U)
{
    return With(Make(Op::kData, slot), low, high, low, high);
}

/// Of a producer whose sides are not inverse: what A read, and the complement of what B read.
constexpr Step UnequalData(SlotIndex slot, std::uint32_t of_a, std::uint32_t of_b)
{
    return With(Make(Op::kData, slot), of_a, 0U, of_b);
}

constexpr std::uint32_t Bit(SrdoCause cause)
{
    return 1U << static_cast<std::uint8_t>(cause);
}

constexpr Step Signals(SlotIndex slot, std::uint32_t bits)
{
    return With(Make(Op::kSignals, slot), bits);
}

// ---- frames

/// A data frame on the first controller; the first byte is bits 0 to 7 of `low`.
constexpr Step Frame(std::uint32_t identifier, std::uint8_t length, std::uint32_t low, std::uint32_t high,
                     std::uint32_t stamp)
{
    return Timed(With(Make(Op::kFrame, static_cast<std::uint8_t>(FrameKind::kData),
                           static_cast<std::uint8_t>(CanPortId::kFirst), length),
                      low, high, identifier),
                 stamp);
}

constexpr Step OfKind(Step frame, FrameKind kind)
{
    return Step{frame.op,    static_cast<std::uint8_t>(kind),
                frame.field, frame.sub,
                frame.time,  frame.x,
                frame.y,     frame.z,
                frame.v,     frame.w};
}

constexpr Step On(Step frame, CanPortId port)
{
    return Step{frame.op, frame.slot, static_cast<std::uint8_t>(port), frame.sub, frame.time, frame.x, frame.y, frame.z,
                frame.v,  frame.w};
}

// ---- release

constexpr Step Demote(SlotIndex slot)
{
    return Make(Op::kDemote, slot);
}

constexpr Step Commit(SrdoMask agreed, SrdoMask matched)
{
    return With(Make(Op::kCommit), LowerHalf(agreed), UpperHalf(agreed), LowerHalf(matched), UpperHalf(matched));
}

/// What the next Commit is to read again, and the slots that it must find otherwise than written.
constexpr Step Examine(SrdoMask examine, SrdoMask found)
{
    return With(Make(Op::kExamine), LowerHalf(examine), UpperHalf(examine), LowerHalf(found), UpperHalf(found));
}

/// The first object lies where the second one does: what is written into one is read from the other.
constexpr Step Share(std::uint16_t index, std::uint8_t sub, std::uint16_t other_index, std::uint8_t other_sub)
{
    return With(Make(Op::kShare, other_sub, 0U, sub), index, other_index);
}

constexpr Step Answer(std::uint32_t challenge, SrdoMask mask, std::uint32_t response_a, std::uint32_t response_b)
{
    return With(Make(Op::kAnswer), LowerHalf(mask), UpperHalf(mask), challenge, response_a, response_b);
}

constexpr Step Put(std::uint16_t index, std::uint8_t sub, std::uint32_t low, std::uint32_t high = 0U)
{
    return With(Make(Op::kPut, 0U, 0U, sub), index, low, high);
}

constexpr Step NormalObject(std::uint16_t index, std::uint8_t sub, std::uint32_t low, std::uint32_t high = 0U)
{
    return With(Make(Op::kNormalObject, 0U, 0U, sub), index, low, high);
}

constexpr Step InverseObject(std::uint16_t index, std::uint8_t sub, std::uint32_t low, std::uint32_t high = 0U)
{
    return With(Make(Op::kInverseObject, 0U, 0U, sub), index, low, high);
}

// ---- producer

constexpr Step Stand(SlotIndex slot)
{
    return Make(Op::kStand, slot);
}

constexpr Step Request(SlotIndex slot)
{
    return Make(Op::kRequest, slot);
}

/// Prepare of both channels gives this normal frame.
constexpr Step Ready(SlotIndex slot, CanPortId port, std::uint32_t identifier, std::uint8_t length, std::uint32_t low,
                     std::uint32_t high = 0U)
{
    return With(Make(Op::kReady, slot, static_cast<std::uint8_t>(port), length), low, high, identifier, low, high);
}

/// Prepare of both channels gives a normal frame, but the objects are not inverse: each has its own data.
constexpr Step Unequal(SlotIndex slot, std::uint32_t identifier, std::uint8_t length, const Payload& of_a,
                       const Payload& of_b)
{
    return With(Make(Op::kReady, slot, static_cast<std::uint8_t>(CanPortId::kFirst), length), of_a.low, of_a.high,
                identifier, of_b.low, of_b.high);
}

constexpr Step NotReady(SlotIndex slot, PrepareStatus status)
{
    return Make(Op::kNotReady, slot, static_cast<std::uint8_t>(status));
}

constexpr Step TakeInverse(SlotIndex slot, CanPortId port, std::uint32_t identifier, std::uint8_t length,
                           std::uint32_t low, std::uint32_t high = 0U)
{
    return With(Make(Op::kTakeInverse, slot, static_cast<std::uint8_t>(port), length), low, high, identifier, low,
                high);
}

/// The inverse frames of a pair whose objects are not inverse: each channel has its own data.
constexpr Step TakeUnequal(SlotIndex slot, std::uint32_t identifier, std::uint8_t length, const Payload& of_a,
                           const Payload& of_b)
{
    return With(Make(Op::kTakeInverse, slot, static_cast<std::uint8_t>(CanPortId::kFirst), length), of_a.low, of_a.high,
                identifier, of_b.low, of_b.high);
}

constexpr Step TakeNone(SlotIndex slot)
{
    return Make(Op::kTakeNone, slot);
}

/// The normal frame that Prepare gave last was on the bus, of each channel its own.
constexpr Step ConfirmOwn(SlotIndex slot, std::uint32_t stamp)
{
    return Timed(Make(Op::kConfirmOwn, slot), stamp);
}

/// A data frame of the device that was on the bus.
constexpr Step Confirmed(SlotIndex slot, ConfirmStep step, std::uint32_t identifier, std::uint8_t length,
                         std::uint32_t low, std::uint32_t high, std::uint32_t stamp)
{
    return Timed(With(Make(Op::kConfirm, static_cast<std::uint8_t>(FrameKind::kData),
                           static_cast<std::uint8_t>(CanPortId::kFirst), length),
                      low, high, identifier, slot, static_cast<std::uint32_t>(step)),
                 stamp);
}

/// It must be the normal frame of `slot`.
constexpr Step ConfirmNormal(SlotIndex slot, std::uint32_t identifier, std::uint8_t length, std::uint32_t low,
                             std::uint32_t high, std::uint32_t stamp)
{
    return Confirmed(slot, ConfirmStep::kNormal, identifier, length, low, high, stamp);
}

/// It must complete the pair of `slot`.
constexpr Step ConfirmPair(SlotIndex slot, std::uint32_t identifier, std::uint8_t length, std::uint32_t low,
                           std::uint32_t high, std::uint32_t stamp)
{
    return Confirmed(slot, ConfirmStep::kPair, identifier, length, low, high, stamp);
}

/// It must be none of those, or end the pair with a fault.
constexpr Step ConfirmNone(std::uint32_t identifier, std::uint8_t length, std::uint32_t low, std::uint32_t high,
                           std::uint32_t stamp)
{
    return Confirmed(kNoSlot, ConfirmStep::kNone, identifier, length, low, high, stamp);
}

constexpr Step TransmitFault(SlotIndex slot, SrdoCause cause)
{
    return With(Make(Op::kTransmitFault, slot), static_cast<std::uint32_t>(cause));
}

} // namespace counterpoint::conformance

#endif
