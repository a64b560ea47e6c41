// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_ZYNQMP_CAN_SEND_QUEUE_HPP
#define HAL_ZYNQMP_CAN_SEND_QUEUE_HPP

#include "safety_core/contract/can_frame.hpp"

#include <cstdint>

namespace counterpoint::zynqmp
{

/// Which buffer of the controller a frame is in.
enum class SendLane : std::uint8_t
{
    kInvalid = 0U, ///< None is under way.
    kFifo = 0x3CU,
    kUrgent = 0x5AU, ///< The high-priority buffer.
};

/// Frames that wait for their turn, and the one that is under way. The controller tells that a frame was sent, not
/// which one, so it is given one at a time. [SRS_ZYN_049, SRS_ZYN_050]
class SendQueue
{
  public:
    /// @brief Nothing waits and nothing is under way.
    void Clear() noexcept;
    /// @brief False: no room.
    [[nodiscard]] bool Put(const CanFrame& frame, SendLane lane) noexcept;
    /// @brief Takes the next frame on its way, urgent ones first; kInvalid: one is under way, or none waits.
    [[nodiscard]] SendLane Begin() noexcept;
    /// @brief The frame that Begin took, which is under way no more after End.
    [[nodiscard]] const CanFrame& UnderWay() const noexcept
    {
        return under_way_;
    }
    [[nodiscard]] SendLane Lane() const noexcept
    {
        return lane_;
    }
    void End() noexcept
    {
        lane_ = SendLane::kInvalid;
    }

  private:
    static constexpr std::uint32_t kPlaces = 32U;

    CanFrame waiting_[kPlaces]{}; // MISRA D-001
    CanFrame urgent_{};
    CanFrame under_way_{};
    std::uint32_t put_{0U};
    std::uint32_t taken_{0U};
    bool has_urgent_{false};
    SendLane lane_{SendLane::kInvalid};
};

} // namespace counterpoint::zynqmp

#endif
