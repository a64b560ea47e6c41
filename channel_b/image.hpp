// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_B_IMAGE_HPP
#define CHANNEL_B_IMAGE_HPP

#include "channel_b/packed.hpp"
#include "channel_b/storage.hpp"
#include "safety_core/contract/can_frame.hpp"

#include <cstddef>
#include <cstdint>

/// Reads the canonical images, the only copy of the configuration that this channel has.
namespace counterpoint::channel_b
{

/// Limit of a budget that nothing can exceed.
constexpr std::uint32_t kNothingRuns = 0xFFFFFFFFU;
/// A budget above has gone below zero; SRVT has long run out at this one, whatever instants a frame may have.
constexpr std::uint32_t kLongestLeft = 0x7FFFFFFFU;
constexpr std::uint32_t kLongOver = 0x80040000U;
/// No phase and no refresh lasts longer: 2^27 us are 134 s. What is above is below zero.
constexpr std::uint32_t kLongestPhase = 0x07FFFFFFU;
/// Entries of a static mapping at most.
constexpr std::uint8_t kLargestMapping = 2U * kMaxPayloadBits;
/// Not the place of an object.
constexpr std::uint16_t kNoPlace = 0xFFFFU;
/// Place of a dummy entry.
constexpr std::uint16_t kDummyPlace = 0xFFFEU;

// Places in the image of one SRDO.
constexpr std::uint8_t kSctAt = 0U;
constexpr std::uint8_t kSrvtAt = 2U;
constexpr std::uint8_t kCobId1At = 3U;
constexpr std::uint8_t kCobId2At = 7U;
constexpr std::uint8_t kMapCountAt = 11U;
constexpr std::uint8_t kTransmissionTypeAt = 12U;
constexpr std::uint8_t kSignatureAt = 13U;
// Places in Storage::device.
constexpr std::uint8_t kGfcParameterAt = 0U;
constexpr std::uint8_t kConfigurationValidAt = 1U;

static_assert(kImageBytes == (kSignatureAt + 2U), "nothing behind the signature");
static_assert(kLookUpBytes == kSrdoIdentifierCount, "one byte an identifier");

/// Reading past a row's own image is excluded by the constants above.
[[nodiscard]] inline std::uint32_t ByteAt(const Row& row, std::size_t at) noexcept
{
    return row.image[at]; // MISRA D-002
}

[[nodiscard]] inline std::uint32_t WordAt(const Row& row, std::size_t at) noexcept
{
    return PackFourBytes(&row.image[at]); // MISRA D-002
}

[[nodiscard]] inline std::uint32_t NormalIdentifier(const Row& row) noexcept
{
    return WordAt(row, kCobId1At);
}

[[nodiscard]] inline std::uint32_t InverseIdentifier(const Row& row) noexcept
{
    return WordAt(row, kCobId2At);
}

/// Of the frame whose identifier has this lowest bit: normal frames are odd, inverse frames are even.
[[nodiscard]] inline std::uint32_t OwnIdentifier(const Row& row, std::uint32_t parity) noexcept
{
    return WordAt(row, kCobId2At - (parity * (kCobId2At - kCobId1At)));
}

[[nodiscard]] inline std::uint32_t SctMs(const Row& row) noexcept
{
    return ByteAt(row, kSctAt) | (ByteAt(row, kSctAt + 1U) << 8U);
}

/// SCT of a consumer, refresh time of a producer.
[[nodiscard]] inline std::uint32_t SctUs(const Row& row) noexcept
{
    return SctMs(row) * kMicrosecondsPerMillisecond;
}

[[nodiscard]] inline std::uint32_t SrvtUs(const Row& row) noexcept
{
    return ByteAt(row, kSrvtAt) * kMicrosecondsPerMillisecond;
}

[[nodiscard]] inline bool IsStatic(const Mapping& mapping) noexcept
{
    return mapping.first == kStatic;
}

/// Where the slot's part of entries and table begins.
[[nodiscard]] inline std::uint32_t FirstEntryOf(const Storage& storage, SlotIndex slot) noexcept
{
    return std::uint32_t{slot} * storage.map_entries;
}

/// Entries of a stored mapping that count; of a static one, whose count is not stored, 0.
[[nodiscard]] inline std::uint8_t StoredCount(const Row& row, std::uint8_t most) noexcept
{
    const std::uint8_t declared = row.image[kMapCountAt];
    return (declared < most) ? declared : most;
}

/// Slot to which the identifier leads; no existing slot if to none.
[[nodiscard]] inline SlotIndex LookUp(const Storage& storage, const CanFrame& frame) noexcept
{
    const std::uint32_t offset = frame.identifier - kFirstSrdoIdentifier;
    return (offset < kSrdoIdentifierCount) ? storage.slot_of[offset] : kNoSlot;
}

/// A corrupted stage has nothing in flight, and nothing can follow it.
[[nodiscard]] inline bool IsInFlight(Stage stage) noexcept
{
    switch (stage)
    {
    case Stage::kInvalid:
    case Stage::kOff:
    case Stage::kIdle:
        return false;
    case Stage::kAwaitNormal:
    case Stage::kAwaitInverse:
        return true;
    }
    return false;
}

/// SRVT counts from the normal frame: the next OnCycle takes away what lay before it.
inline void StartBudget(const Storage& storage, SlotIndex slot, std::uint32_t since_call) noexcept
{
    const std::uint32_t srvt_us = SrvtUs(storage.rows[slot]);
    storage.pair_limit[slot] = srvt_us;
    storage.pair_left[slot] = srvt_us + since_call;
}

[[nodiscard]] constexpr std::uint8_t Code(SrdoCause cause) noexcept
{
    return static_cast<std::uint8_t>(cause);
}

/// Any other value is corrupted, or was put there because something else was. [SRS-CONS-024]
[[nodiscard]] inline bool IsRecordable(std::uint8_t cause) noexcept
{
    const std::uint32_t above_invalid = static_cast<std::uint32_t>(cause) - 1U;
    return (above_invalid < Code(SrdoCause::kWrongEcho)) || (cause == Code(SrdoCause::kNone));
}

} // namespace counterpoint::channel_b

#endif
