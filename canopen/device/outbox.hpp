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

/// Frames of services that are to be sent, in their order. At most kUnconfirmed of them are with the controller at a
/// time, so that an SRDO waits for few. OnConfirm may interrupt the other calls. [SRS_DEV_009]
class Outbox final : public cia301::FrameSink
{
  public:
    static constexpr std::uint32_t kRoom = 16U;
    static constexpr std::uint32_t kUnconfirmed = 2U;

    /// @brief `can` is kept by reference.
    explicit Outbox(hal::CanPorts& can) noexcept;

    /// @brief Takes a frame. False: there is no room.
    [[nodiscard]] bool Send(const CanFrame& frame) noexcept override;
    /// @brief Whether Send would take a frame.
    [[nodiscard]] bool HasRoom() const noexcept;
    /// @brief Whether the newest frame with this identifier that waits begins with this byte. O(kRoom) [SRS_DEV_024]
    [[nodiscard]] bool Waits(std::uint32_t identifier, std::uint8_t first_byte) const noexcept;
    /// @brief A frame of a service was on the bus.
    void OnConfirm() noexcept;
    /// @brief Hands frames over to the controller, as many as it may have. O(kUnconfirmed)
    void Poll(Instant now) noexcept;
    /// @brief Forgets all frames, those that the controller has too.
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
