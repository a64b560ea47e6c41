// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CONFORMANCE_STEP_HPP
#define VERIFICATION_CONFORMANCE_STEP_HPP

#include "safety_core/contract/channel.hpp"

#include <cstdint>

/// Conformance cases are tables of steps. Freestanding: the same tables run on the host and on the target.
/// [SRS_CNF_001]
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
    kData,          ///< slot; View's data: x, y of A, z, v of B.
    kSignals,       ///< slot; x.
    kDemote,        ///< slot.
    kCommit,        ///< x, y agreed; z, v matched.
    kExamine,       ///< Of the next kCommit only: x, y examine; z, v the slots that it must return, else none.
    kAnswer,        ///< z challenge; x, y mask; v response of A, w response of B.
    kPut,           ///< x index, sub; y, z value: the application writes an object.
    kShare,         ///< x index, sub; y index, slot its sub-index: the first object lies where the second one does.
    kNormalObject,  ///< x index, sub; y, z: what A wrote; B leaves it alone.
    kInverseObject, ///< x index, sub; y, z: what B wrote; A leaves it alone.
    kRequest,       ///< slot: in `request` of the next cycle only.
    kStand,         ///< slot: in `stand` of the next cycle only.
    kReady,         ///< slot: Prepare is ready; field controller, sub length, z identifier, data x, y of A, v, w of B.
    kNotReady,      ///< slot: Prepare gives an empty frame; field status.
    kTakeInverse,   ///< slot, field controller, sub length, z identifier, x, y data of A, v, w of B.
    kTakeNone,      ///< slot: neither has an inverse frame.
    kConfirmOwn,    ///< slot: what Prepare gave last, of each channel its own, was on the bus; it is its normal frame.
    kConfirm,       ///< As kFrame; v: the slot that is returned, w: the step.
    kTransmitFault, ///< slot, x cause.
    kRestart,       ///< Power-on again, same device.
    kRepeat,        ///< x more times the last kFrame or kCycle, each y us later than the one before.
    kFields,        ///< slot: SetFields with the places of two objects, x normal, y inverse; 0: null.
    kDigest,        ///< slot; x continued from, y expected.
    kAlter,         ///< field parameter, slot whose setup it is in; x value: power-on again as another device.
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
    kRefresh,
};

/// Members of DeviceConfig and SrdoSetup.
enum class Parameter : std::uint8_t
{
    kNodeId,
    kGranularity,
    kMapEntries,
    kDummyMapping,
    kNumberGaps,
    kGfc,
    kNormalPort,
    kInversePort,
    kCycle,
    kCycleTolerance,
    kDiscrepancy,
    kAcknowledgeWindow,
    kDiagnosticInterval,
    kTestInterval,
    kClockTolerance,
    kClockInterval,
    kOutputTime,
    kDigest,
    kNumber,
    kPolicy,
    kForm,
    kDetection,
    kSafeLow,
    kSafeHigh,
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

/// @brief The frame that a step of kind kFrame or kConfirm describes.
constexpr CanFrame FrameOf(const Step& step)
{
    CanFrame frame{step.z, static_cast<FrameKind>(step.slot), static_cast<CanPortId>(step.field), step.sub, {}};
    for (std::uint32_t i = 0U; i < kMaxPayloadBytes; ++i)
    {
        const std::uint32_t half = (i < 4U) ? step.x : step.y;
        frame.data[i] = static_cast<std::uint8_t>((half >> (8U * (i % 4U))) & 0xFFU);
    }
    return frame;
}

} // namespace counterpoint::conformance

#endif
