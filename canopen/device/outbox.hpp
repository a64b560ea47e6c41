// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_DEVICE_OUTBOX_HPP
#define CANOPEN_DEVICE_OUTBOX_HPP

#include "canopen/cia301/nmt/frame_sink.hpp"
#include "canopen/cia301/time/sync.hpp"

#include "hal/api/can_ports.hpp"
#include "safety_core/contract/time.hpp"

#include <atomic>
#include <cstdint>

namespace counterpoint::device
{

/// Frames of services that are to be sent, in their order. At most kUnconfirmed of them are with the controller at a
/// time, so that an SRDO waits for few. Process data leave places to the others, and the device's own messages have
/// places beside. OnConfirm may interrupt the other calls. [SRS_DEV_009, SRS_DEV_150]
class Outbox final : public cia301::FrameSink
{
  public:
    static constexpr std::uint32_t kRoom = 16U;        ///< Of process data and transfers together.
    static constexpr std::uint32_t kProcessRoom = 12U; ///< Of these for process data.
    static constexpr std::uint32_t kOwnRoom = 4U;      ///< Beside; the last one is for a boot-up message.
    static constexpr std::uint32_t kUnconfirmed = 2U;

    /// @brief `can` is kept by reference.
    explicit Outbox(hal::CanPorts& can) noexcept;

    /// @brief Takes a frame of a transfer. False: there is no room.
    [[nodiscard]] bool Send(const CanFrame& frame) noexcept override;
    /// @brief Takes a SYNC or PDO. False: there is no room.
    [[nodiscard]] bool SendProcessData(const CanFrame& frame) noexcept;
    /// @brief Takes a message about the device itself: heartbeat, emergency, answer to guarding, boot-up message.
    /// False: there is no room.
    [[nodiscard]] bool SendOwn(const CanFrame& frame) noexcept;
    /// @brief Whether SendOwn would take a message and keep a place for a boot-up message.
    [[nodiscard]] bool HasOwnRoom() const noexcept;
    /// @brief Whether the newest frame with this identifier that waits begins with this byte. O(kRoom) [SRS_DEV_024]
    [[nodiscard]] bool Waits(std::uint32_t identifier, std::uint8_t first_byte) const noexcept;
    /// @brief A frame of a service was on the bus.
    void OnConfirm() noexcept;
    /// @brief Hands frames over to the controller, as many as it may have. O(kUnconfirmed)
    void Poll(Instant now) noexcept;
    /// @brief Forgets the PDOs that wait: process data that are no SYNC. O(kRoom) [SRS_DEV_151]
    void ForgetPdos(const cia301::Sync& sync) noexcept;
    /// @brief Forgets all frames, those that the controller has too.
    void Clear() noexcept;

  private:
    /// Who has the place of a frame.
    enum class Owner : std::uint8_t
    {
        kTransfer = 0U,
        kProcess = 1U,
        kDevice = 2U,
    };
    static constexpr std::uint32_t kOwners = 3U;
    static constexpr std::uint32_t kAllRoom = kRoom + kOwnRoom;

    [[nodiscard]] std::uint32_t CountOf(Owner owner) const noexcept;
    [[nodiscard]] bool Put(const CanFrame& frame, Owner owner, bool has_room) noexcept;
    void TakeConfirmations(Instant now) noexcept;

    hal::CanPorts& can_;
    CanFrame frames_[kAllRoom]; ///< A ring: the oldest at `first_`.
    Owner owners_[kAllRoom];    ///< Of each frame.
    std::uint32_t counts_[kOwners];
    std::uint32_t first_;
    std::uint32_t count_;
    std::uint32_t unconfirmed_;
    Instant sent_; ///< Of the last frame handed over.
    std::atomic<std::uint32_t> confirmed_;
    std::uint32_t confirmations_seen_; ///< Of `confirmed_`.
};

/// The way of SYNC and PDOs through an outbox, which is kept by reference.
class ProcessSink final : public cia301::FrameSink
{
  public:
    explicit ProcessSink(Outbox& outbox) noexcept;
    [[nodiscard]] bool Send(const CanFrame& frame) noexcept override;

  private:
    Outbox& outbox_;
};

} // namespace counterpoint::device

#endif
