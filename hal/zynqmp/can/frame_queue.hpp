// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_ZYNQMP_CAN_FRAME_QUEUE_HPP
#define HAL_ZYNQMP_CAN_FRAME_QUEUE_HPP

#include "safety_core/contract/can_frame.hpp"

#include <cstdint>

namespace counterpoint::zynqmp
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

/// From the look at the controllers to the kernel, in order of the stamps. A frame that finds no room is a loss, and a
/// loss always finds room. Used by one thread, no interrupt. [SRS_ZYN_047]
class FrameQueue
{
  public:
    /// @brief Empties the queue.
    void Clear() noexcept;
    /// @brief Adds a frame behind those whose stamp by counter A is not later; without room it counts as a loss.
    void Put(const QueuedFrame& frame) noexcept;
    /// @brief Adds a loss, which is told before the frames that are there.
    void PutLoss() noexcept;
    /// @brief The next entry whose stamp by counter A is not later than `until`: an earlier one may still come.
    [[nodiscard]] QueuedFrame Take(Instant until) noexcept;

  private:
    /// Two receive FIFOs of 64 frames.
    static constexpr std::uint32_t kPlaces = 128U;

    [[nodiscard]] static std::uint32_t Place(const std::uint32_t number) noexcept
    {
        return number % kPlaces;
    }

    QueuedFrame frames_[kPlaces]{}; // MISRA D-001
    std::uint32_t put_{0U};
    std::uint32_t taken_{0U};
    bool has_lost_{false};
};

} // namespace counterpoint::zynqmp

#endif
