// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_CONTRACT_CAN_FRAME_HPP
#define SAFETY_CORE_CONTRACT_CAN_FRAME_HPP

#include "safety_core/contract/limits.hpp"
#include "safety_core/contract/time.hpp"

#include <cstdint>

namespace counterpoint
{

/// Kinds of CAN frames. Only kData can be a frame of an SRDO or GFC; the others have values of their own so that none
/// is taken for it. [SRS_CONS_002]
enum class FrameKind : std::uint8_t
{
    kInvalid = 0U,
    kData = 0x3CU,
    kRemote = 1U,
    kExtended = 2U,
    kExtendedRemote = 3U,
    kFlexibleDataRate = 4U,
};

/// The two CAN controllers of a device; a device with one controller uses kFirst for everything.
enum class CanPortId : std::uint8_t
{
    kInvalid = 0U,
    kFirst = 1U,
    kSecond = 2U,
};

/// One raw frame as it was on the bus. Bytes behind `length_bytes` have no meaning. `length_bytes` is 0 to 8, checked
/// by hal/api; a channel treats a larger one as a wrong length.
struct CanFrame
{
    std::uint32_t identifier;
    FrameKind kind;
    CanPortId port;
    std::uint8_t length_bytes;
    std::uint8_t data[kMaxPayloadBytes]; // MISRA D-001
};

/// A frame in bus order with the moment of its reception (or of its confirmed transmission) by both counters, taken in
/// one place: the end of the frame, when the controller calls it valid. [SRS_TIME_003]
struct StampedFrame
{
    CanFrame frame;
    InstantPair stamp;
};

} // namespace counterpoint

#endif
