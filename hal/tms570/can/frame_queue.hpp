// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_CAN_FRAME_QUEUE_HPP
#define HAL_TMS570_CAN_FRAME_QUEUE_HPP

#include "hal/tms570/chip/shared.hpp"
#include "safety_core/contract/can_frame.hpp"

#include <cstdint>

namespace counterpoint::tms570
{

/// What an entry of the queue is.
enum class QueuedKind : std::uint8_t
{
    kInvalid = 0U, ///< Read as a loss.
    kNothing = 1U,
    kReceived = 0x3CU,
    kConfirmed = 0x5AU,
    kLoss = 2U, ///< Frames were lost, or their order or stamps are not known; `frame` has no meaning.
};

/// One entry of the queue.
struct QueuedFrame
{
    QueuedKind kind;
    StampedFrame frame;
};

/// From the interrupt to the program, in order: one side puts, one takes. A frame that finds no room is a loss, and a
/// loss always finds room. [SRS_TMS_014]
class FrameQueue
{
  public:
    /// @brief Empties the queue.
    void Clear() noexcept;
    /// @brief Adds a frame; without room it counts as a loss. For the interrupt.
    void Put(const QueuedFrame& frame) noexcept;
    /// @brief Adds a loss. For the interrupt.
    void PutLoss() noexcept;
    /// @brief The next entry; losses come before the frames that are there. For the program.
    [[nodiscard]] QueuedFrame Take() noexcept;

  private:
    /// Room for all frames of two controllers at 1 Mbit/s in a cycle of 1 ms, of the shortest length: 2 * 1000 / 47,
    /// rounded up to a power of two.
    static constexpr std::uint32_t kPlaces = 64U;
    static_assert((kPlaces & (kPlaces - 1U)) == 0U, "the counters wrap");

    QueuedFrame frames_[kPlaces]{}; // MISRA D-001
    Shared<std::uint32_t> put_{0U};
    Shared<std::uint32_t> taken_{0U};
    Shared<std::uint32_t> losses_{0U}; ///< Written by the side that puts.
    std::uint32_t told_{0U};           ///< Written by the side that takes.
};

} // namespace counterpoint::tms570

#endif
