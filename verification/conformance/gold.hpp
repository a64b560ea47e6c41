// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CONFORMANCE_GOLD_HPP
#define VERIFICATION_CONFORMANCE_GOLD_HPP

#include "verification/conformance/case.hpp"
#include "verification/conformance/cases.hpp"

/// Words of the case tables: frames of the gold device, and short names of what every second line needs.
namespace counterpoint::conformance
{

constexpr SrdoState kOff = SrdoState::kOff;
constexpr SrdoState kWaiting = SrdoState::kWaiting;
constexpr SrdoState kFaulted = SrdoState::kFaulted;
constexpr SrdoState kReleased = SrdoState::kReleased;
constexpr SrdoState kProducing = SrdoState::kProducer;
using Cause = SrdoCause;
constexpr SrdoCause kNoCause = SrdoCause::kNone;

/// Normal frame 12h 34h and its inverse EDh CBh.
constexpr Step Normal(std::uint32_t stamp)
{
    return Frame(0x111U, 2U, 0x3412U, 0U, stamp);
}

constexpr Step Inverse(std::uint32_t stamp)
{
    return Frame(0x112U, 2U, 0xCBEDU, 0U, stamp);
}

/// Another pair: 56h 78h and A9h 87h.
constexpr Step OtherNormal(std::uint32_t stamp)
{
    return Frame(0x111U, 2U, 0x7856U, 0U, stamp);
}

constexpr Step OtherInverse(std::uint32_t stamp)
{
    return Frame(0x112U, 2U, 0x87A9U, 0U, stamp);
}

/// Bit `bit` of the inverse frame is not inverted.
constexpr Step WrongInverse(std::uint32_t bit, std::uint32_t stamp)
{
    return Frame(0x112U, 2U, 0xCBEDU ^ (1U << bit), 0U, stamp);
}

constexpr Step Gfc(std::uint32_t stamp)
{
    return Frame(0x001U, 0U, 0U, 0U, stamp);
}

// ---- producer of kSender and kProvider: objects 12h 34h and EDh CBh, frames 101h and 102h

/// Two bytes of which B read something else than the complement of what A read.
constexpr Step UnequalPair(SlotIndex slot, std::uint32_t of_a, std::uint32_t of_b)
{
    return Unequal(slot, 0x101U, 2U, Payload{of_a, 0U}, Payload{of_b, 0U});
}

/// What follows the comparison of an unequal pair.
constexpr Step NotInverse(SlotIndex slot)
{
    return TransmitFault(slot, SrdoCause::kNotInverse);
}

constexpr Step NotProducing(SlotIndex slot)
{
    return NotReady(slot, PrepareStatus::kNotProducer);
}

constexpr Step ReadyPair(SlotIndex slot)
{
    return Ready(slot, CanPortId::kFirst, 0x101U, 2U, 0x3412U);
}

constexpr Step TakeSecond(SlotIndex slot)
{
    return TakeInverse(slot, CanPortId::kFirst, 0x102U, 2U, 0xCBEDU);
}

constexpr Step ConfirmFirst(SlotIndex slot, std::uint32_t stamp)
{
    return ConfirmNormal(slot, 0x101U, 2U, 0x3412U, 0U, stamp);
}

constexpr Step ConfirmSecond(SlotIndex slot, std::uint32_t stamp)
{
    return ConfirmPair(slot, 0x102U, 2U, 0xCBEDU, 0U, stamp);
}

/// Neither frame is awaited.
constexpr Step StrangeFirst(std::uint32_t stamp)
{
    return ConfirmNone(0x101U, 2U, 0x3412U, 0U, stamp);
}

constexpr Step StrangeSecond(std::uint32_t stamp)
{
    return ConfirmNone(0x102U, 2U, 0xCBEDU, 0U, stamp);
}

} // namespace counterpoint::conformance

#endif
