// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_MANAGER_OWN_DEVICE_HPP
#define CANOPEN_MANAGER_OWN_DEVICE_HPP

#include "canopen/cia301/nmt/frame_sink.hpp"
#include "canopen/cia301/nmt/heartbeat_producer.hpp"
#include "canopen/cia302/network/nmt_command.hpp"

namespace counterpoint::cia302
{

/// The manager's device as one node among the others: NMT state, boot-up message, heartbeat.
class OwnDevice
{
  public:
    /// @brief `sink` is kept by reference.
    OwnDevice(NodeId own, cia301::FrameSink& sink, std::uint16_t heartbeat_ms) noexcept;

    /// @brief PRE-OPERATIONAL from now on; a boot-up message is to be sent.
    void Restart() noexcept;
    /// @brief Follows an NMT command for this device.
    void Obey(NmtCommand command) noexcept;
    /// @brief Boot-up message and heartbeat. What the sink does not take comes in a later cycle.
    void Send(bool is_initialising, Instant now) noexcept;

    /// @brief Whether the sink did not take the last frame of Send: call it again as soon as there may be room.
    [[nodiscard]] bool IsWaiting() const noexcept
    {
        return is_waiting_;
    }

    /// @brief NMT state of this device.
    [[nodiscard]] cia301::NodeState State() const noexcept
    {
        return state_;
    }
    /// @brief Its heartbeat (1017h).
    [[nodiscard]] cia301::HeartbeatProducer& Heartbeat() noexcept
    {
        return producer_;
    }

  private:
    NodeId own_;
    cia301::FrameSink& sink_;
    cia301::HeartbeatProducer producer_;
    cia301::NodeState state_;
    bool owes_boot_up_;   ///< The boot-up message has not left.
    bool owes_heartbeat_; ///< One that was due has not left.
    bool is_waiting_;
};

} // namespace counterpoint::cia302

#endif
