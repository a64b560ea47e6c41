// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_B_IMAGE_HPP
#define CHANNEL_B_IMAGE_HPP

#include "channel_b/packed.hpp"
#include "channel_b/storage.hpp"
#include "safety_core/contract/can_frame.hpp"
#include "safety_core/contract/channel.hpp"

#include <cstddef>
#include <cstdint>

/// Reads the rows: canonical images, the only copy of the configuration that this channel has, and marks.
namespace counterpoint::channel_b
{

/// Limit of a budget that nothing can exceed.
constexpr std::uint32_t kNothingRuns = 0xFFFFFFFFU;
/// Entries of a static mapping at most.
constexpr std::uint8_t kLargestMapping = 2U * kMaxPayloadBits;
/// Not the place of an object.
constexpr std::uint16_t kNoPlace = 0xFFFFU;
/// Row::words of all other mappings: no place of an object.
constexpr std::uint32_t kNoWords = 0xFFFFFFFFU;
/// Length in bits of common objects.
constexpr std::uint32_t kFourBytes = 32U;
/// Place of a dummy entry.
constexpr std::uint16_t kDummyPlace = 0xFFFEU;

// Places in the image of one SRDO.
constexpr std::uint8_t kDirectionAt = 0U;
constexpr std::uint8_t kSctAt = 1U;
constexpr std::uint8_t kSrvtAt = 3U;
constexpr std::uint8_t kCobId1At = 4U;
constexpr std::uint8_t kCobId2At = 8U;
constexpr std::uint8_t kMapCountAt = 12U;
constexpr std::uint8_t kTransmissionTypeAt = 13U;
constexpr std::uint8_t kSignatureAt = 14U;
// Places in Storage::device.
constexpr std::uint8_t kGfcParameterAt = 0U;
constexpr std::uint8_t kConfigurationValidAt = 1U;

// What OnCycle finds for all slots alike.
constexpr std::uint32_t kEntering = 0x01U;
constexpr std::uint32_t kLeaving = 0x02U;
constexpr std::uint32_t kLate = 0x04U;
constexpr std::uint32_t kOverflowed = 0x08U;
constexpr std::uint32_t kGfc = 0x10U; ///< A global fail-safe command came since the last OnCycle.

static_assert(kImageBytes == (kSignatureAt + 2U), "nothing behind the signature");
static_assert(kLookUpBytes == kSrdoIdentifierCount, "one byte an identifier");

/// Reading past a row's own image is excluded by the constants above.
[[nodiscard]] inline std::uint32_t ByteAt(const Row& row, std::size_t at) noexcept
{
    return row.image[at]; // MISRA D-002
}

[[nodiscard]] inline std::uint32_t TwoBytesAt(const Row& row, std::size_t at) noexcept
{
    return ByteAt(row, at) | (ByteAt(row, at + 1U) << 8U);
}

[[nodiscard]] inline std::uint32_t WordAt(const Row& row, std::size_t at) noexcept
{
    return PackFourBytes(&row.image[at]); // MISRA D-002
}

/// Identifier of the frames of this parity: normal frames are odd, inverse frames are even.
[[nodiscard]] inline std::uint32_t OwnIdentifier(const Row& row, std::uint32_t parity) noexcept
{
    return WordAt(row, kCobId2At - (parity * (kCobId2At - kCobId1At)));
}

/// SCT of a consumer, refresh time of a producer.
[[nodiscard]] inline std::uint32_t SctUs(const Row& row) noexcept
{
    return TwoBytesAt(row, kSctAt) * kMicrosecondsPerMillisecond;
}

[[nodiscard]] inline std::uint32_t SrvtUs(const Row& row) noexcept
{
    return ByteAt(row, kSrvtAt) * kMicrosecondsPerMillisecond;
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

/// Whatever else a corrupted consumer is, it stays one that OnCycle makes safe.
[[nodiscard]] inline bool IsConsumer(const Row& row) noexcept
{
    return (static_cast<std::uint32_t>(row.standing) >> 4U) == 6U;
}

[[nodiscard]] inline bool IsHeld(const Row& row) noexcept
{
    return row.held == kHeld;
}

[[nodiscard]] inline bool IsInFlight(const Row& row) noexcept
{
    return row.awaited.identifier != 0U;
}

/// Slot to which the identifier leads; no existing slot if to none.
[[nodiscard]] inline SlotIndex LookUp(const Storage& storage, const CanFrame& frame) noexcept
{
    const std::size_t offset = std::size_t{frame.identifier} - kFirstSrdoIdentifier;
    return (offset < kSrdoIdentifierCount) ? storage.slot_of[offset] : kNoSlot;
}

/// Whether it is not the frame in flight, whatever its data. [SRS_PROD_007]
[[nodiscard]] inline bool IsOther(const Row& row, const CanFrame& frame) noexcept
{
    return (frame.identifier != row.awaited.identifier) || (frame.kind != FrameKind::kData);
}

[[nodiscard]] inline bool HasNews(const Row& row, std::uint32_t bits) noexcept
{
    return (row.news & bits) != 0U;
}

inline void SetNews(Row& row, std::uint32_t bits) noexcept
{
    row.news = static_cast<std::uint8_t>(row.news | bits);
}

inline void ClearNews(Row& row, std::uint32_t bits) noexcept
{
    row.news = static_cast<std::uint8_t>(row.news & (bits ^ 0xFFU));
}

[[nodiscard]] constexpr std::uint8_t Code(SrdoCause cause) noexcept
{
    return static_cast<std::uint8_t>(cause);
}

/// Nothing is held and nothing in flight.
inline void Ground(Row& row, Stage stage) noexcept
{
    row.limit = kNothingRuns;
    row.awaited.identifier = 0U;
    row.stage = stage;
}

inline void ForgetEdge(Row& row) noexcept
{
    row.edge = kUnset;
    ClearNews(row, kEdge);
}

/// @brief Counts a fault; the first one is kept.
void Count(Row& row, SrdoCause cause) noexcept;
/// @brief A fault that the next OnCycle, or this one, reports.
void Record(Row& row, SrdoCause cause) noexcept;
/// @brief Of a consumer: nothing is granted any longer. A pending normal frame stays.
void Discard(Row& row) noexcept;
/// @brief A fault of a consumer.
void Fault(Row& row, SrdoCause cause) noexcept;
/// @brief A fault of a producer that gives up the pair in flight; returns what OnConfirm then tells. [SRS_PROD_009]
[[nodiscard]] Confirmation Fail(Row& row, SrdoCause cause) noexcept;

} // namespace counterpoint::channel_b

#endif
