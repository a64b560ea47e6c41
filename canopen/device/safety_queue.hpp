// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_DEVICE_SAFETY_QUEUE_HPP
#define CANOPEN_DEVICE_SAFETY_QUEUE_HPP

#include "canopen/device/frame_ring.hpp"

#include "safety_core/contract/limits.hpp"

namespace counterpoint::device
{

/// @brief Whether an identifier belongs to SRDOs or GFC: 001h, 101h to 180h.
[[nodiscard]] constexpr bool IsSafetyIdentifier(const std::uint32_t identifier) noexcept
{
    return (identifier == kGfcIdentifier) ||
           ((identifier >= kFirstSrdoIdentifier) && (identifier <= kLastSrdoIdentifier));
}

/// The receive queue of the safety part: nothing enters it but data frames of admitted SRDOs, confirmations of own
/// ones, and one GFC at a time. One writer, one reader. [SRS_DEV_007, SRS_DEV_008]
class SafetyQueue
{
  public:
    /// @brief Empty; no identifier is admitted.
    explicit SafetyQueue(const FrameRoom& room) noexcept;

    /// @brief Whether the room is enough for a device with so many SRDOs.
    [[nodiscard]] bool HasRoomFor(std::uint8_t srdo_count) const noexcept;
    /// @brief Frames with this identifier (101h to 180h) enter from now on.
    void Admit(std::uint32_t identifier) noexcept;
    /// @brief No frame of an SRDO enters from now on.
    void AdmitNone() noexcept;

    /// @brief A frame with a safety identifier; what is not admitted is dropped. For the writer. O(1)
    void Offer(const StampedFrame& frame, Origin origin) noexcept;
    /// @brief Frames were lost before they reached this queue.
    void MarkLoss() noexcept;
    /// @brief Whether a frame was lost since the last call. Ask before Oldest.
    [[nodiscard]] bool TakeLoss() noexcept;
    /// @brief The oldest frame where it lies, or null; Drop when it is done with. For the reader. O(1)
    [[nodiscard]] const QueuedFrame* Oldest() noexcept;
    /// @brief Takes the oldest frame out. Only after Oldest returned it. O(1)
    void Drop() noexcept;

  private:
    static constexpr std::uint32_t kWordBits = 32U;
    static constexpr std::uint32_t kWords = kSrdoIdentifierCount / kWordBits;

    [[nodiscard]] bool IsAdmitted(const CanFrame& frame) const noexcept;

    FrameRing ring_;
    std::atomic<std::uint32_t> admitted_[kWords]; ///< Bit n: identifier 101h + n.
    std::atomic<bool> has_gfc_;                   ///< One is in the ring.
    std::atomic<bool> has_lost_;
};

} // namespace counterpoint::device

#endif
