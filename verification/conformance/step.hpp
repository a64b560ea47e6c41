// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CONFORMANCE_STEP_HPP
#define VERIFICATION_CONFORMANCE_STEP_HPP

#include "safety_core/contract/channel.hpp"

#include <cstdint>

/// Conformance cases are tables of steps. Freestanding: the same tables run on the host and on the target.
/// [SRS-CNF-001]
namespace counterpoint::conformance
{

/// Which of the two voices runs the case; they differ in the objects they write and in the frames they send.
enum class Party : std::uint8_t
{
    kA = 1U,
    kB = 2U,
};

enum class Op : std::uint8_t
{
    kConfigure,     ///< Stores the device's values of every SRDO and 13FEh, validates each: all without fault.
    kStoreAll,      ///< The same without Validate.
    kStore,         ///< slot, field, sub; x value.
    kLoad,          ///< slot, field, sub; x expected.
    kValidate,      ///< slot; x fault, y signature.
    kRecheck,       ///< slot; x fault, y signature.
    kNmt,           ///< x: state for the cycles that follow.
    kAcknowledge,   ///< x, y: levels for the cycles that follow.
    kQueue,         ///< x: state for the next cycle only.
    kToken,         ///< x: flipped bits of the guard's token in the next cycle only.
    kFrame,         ///< slot: kind, field: controller, sub: length, z identifier, x and y data, time stamp.
    kCycle,         ///< time.
    kMasks,         ///< Lower halves of released, faulted, waiting, new_fault, fresh; the upper ones are 0.
    kMask,          ///< slot: which mask; x lower, y upper half.
    kCounts,        ///< slot sct_checked, field is_tx, sub is_invalid, x not_operational.
    kGuard,         ///< x: guard view.
    kOrdinalSum,    ///< x.
    kSlot,          ///< slot; field state, sub first cause, x ordinal, y error count, z holds_pair.
    kData,          ///< slot; x, y: View's data.
    kSignals,       ///< slot; x.
    kDemote,        ///< slot.
    kCommit,        ///< x, y agreed; z, v matched.
    kAnswer,        ///< z challenge; x, y mask; v response of A, w response of B.
    kPut,           ///< x index, sub; y, z value: the application writes an object.
    kNormalObject,  ///< x index, sub; y, z: what A wrote; B leaves it alone.
    kInverseObject, ///< x index, sub; y, z: what B wrote; A leaves it alone.
    kRequest,       ///< slot: in `request` of the next cycle only.
    kStand,         ///< slot: in `stand` of the next cycle only.
    kReady,         ///< slot: Prepare is ready; field controller, sub length, z identifier, x, y data of the frame.
    kNotReady,      ///< slot: Prepare gives an empty frame; field status.
    kTakeInverse,   ///< slot, field controller, sub length, z identifier, x, y data: from B; empty from A.
    kTakeNone,      ///< slot: neither has an inverse frame.
    kConfirm,       ///< As kFrame; v: the slot that is returned, w: the step.
    kTransmitFault, ///< slot, x cause.
    kRestart,       ///< Power-on again, same device.
    kRepeat,        ///< x more times the last kFrame or kCycle, each y us later than the one before.
};

enum class MaskName : std::uint8_t
{
    kReleased,
    kFaulted,
    kWaiting,
    kNewFault,
    kFresh,
    kDue,
    kSignalled,
};

/// One call of the channel or one expectation; the comment at each Op says what the members mean for it.
struct Step
{
    Op op;
    std::uint8_t slot;
    std::uint8_t field;
    std::uint8_t sub;
    std::uint32_t time;
    std::uint32_t x;
    std::uint32_t y;
    std::uint32_t z;
    std::uint32_t v;
    std::uint32_t w;
};

constexpr std::uint32_t LowerHalf(SrdoMask mask)
{
    return static_cast<std::uint32_t>(mask & 0xFFFFFFFFU);
}

constexpr std::uint32_t UpperHalf(SrdoMask mask)
{
    return static_cast<std::uint32_t>(mask >> 32U);
}

constexpr Step Make(Op op, std::uint8_t slot = 0U, std::uint8_t field = 0U, std::uint8_t sub = 0U)
{
    return Step{op, slot, field, sub, 0U, 0U, 0U, 0U, 0U, 0U};
}

constexpr Step With(Step step, std::uint32_t x, std::uint32_t y = 0U, std::uint32_t z = 0U, std::uint32_t v = 0U,
                    std::uint32_t w = 0U)
{
    return Step{step.op, step.slot, step.field, step.sub, step.time, x, y, z, v, w};
}

constexpr Step Timed(Step step, std::uint32_t time)
{
    return Step{step.op, step.slot, step.field, step.sub, time, step.x, step.y, step.z, step.v, step.w};
}

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
    return With(Make(Op::kData, slot), low, high);
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
    return With(Make(Op::kReady, slot, static_cast<std::uint8_t>(port), length), low, high, identifier);
}

constexpr Step NotReady(SlotIndex slot, PrepareStatus status)
{
    return Make(Op::kNotReady, slot, static_cast<std::uint8_t>(status));
}

constexpr Step TakeInverse(SlotIndex slot, CanPortId port, std::uint32_t identifier, std::uint8_t length,
                           std::uint32_t low, std::uint32_t high = 0U)
{
    return With(Make(Op::kTakeInverse, slot, static_cast<std::uint8_t>(port), length), low, high, identifier);
}

constexpr Step TakeNone(SlotIndex slot)
{
    return Make(Op::kTakeNone, slot);
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
