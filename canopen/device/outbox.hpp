// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_DEVICE_OUTBOX_HPP
#define CANOPEN_DEVICE_OUTBOX_HPP

#include "canopen/cia301/nmt/frame_sink.hpp"

#include "hal/api/can_ports.hpp"
#include "safety_core/contract/time.hpp"

#include <atomic>
#include <cstdint>

namespace counterpoint::device
{

/// Frames of services on their way out, in their order. Few are with the controller at a time, so that an SRDO waits
/// for few. OnConfirm may interrupt the others. [SRS_DEV_009]
class Outbox final : public cia301::FrameSink
{
  public:
    static constexpr std::uint32_t kRoom = 16U;
    static constexpr std::uint32_t kUnconfirmed = 2U;

    explicit Outbox(hal::CanPorts& can) noexcept;

    /// @brief Whether there was room.
    [[nodiscard]] bool Send(const CanFrame& frame) noexcept override;
    [[nodiscard]] bool HasRoom() const noexcept;
    /// @brief A frame of a service was on the bus.
    void OnConfirm() noexcept;
    /// @brief Hands over what the controller may have. O(kUnconfirmed)
    void Poll(Instant now) noexcept;
    /// @brief Forgets everything, the controller's frames too.
    void Clear() noexcept;

  private:
    void TakeConfirmations(Instant now) noexcept;

    hal::CanPorts& can_;
    CanFrame frames_[kRoom]; ///< A ring: the oldest at `first_`.
    std::uint32_t first_;
    std::uint32_t count_;
    std::uint32_t unconfirmed_;
    Instant sent_; ///< Of the last frame handed over.
    std::atomic<std::uint32_t> confirmed_;
    std::uint32_t confirmations_seen_; ///< Of `confirmed_`.
};

} // namespace counterpoint::device

#endif
