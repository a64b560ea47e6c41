// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_NMT_SLAVE_HPP
#define CANOPEN_CIA301_NMT_SLAVE_HPP

#include "canopen/cia301/nmt/command.hpp"
#include "safety_core/contract/can_frame.hpp"
#include "safety_core/contract/channel.hpp"

#include <cstdint>

namespace counterpoint::cia301
{

/// Node-ID, 1 to 127; every other value means that there is none.
struct NodeId
{
    std::uint8_t value;
};

/// States and sub-states of a slave.
enum class NodeState : std::uint8_t
{
    kInvalid = 0U,
    kInitialising = 1U,
    kResetApplication = 2U,
    kResetCommunication = 3U,
    kPreOperational = 4U,
    kOperational = 5U,
    kStopped = 6U,
};

/// Whether the device has 1F80h, and its value.
struct StartUp
{
    bool is_present;
    std::uint32_t value;
};

/// A frame that is to be sent, or none: `frame` has a meaning only with `is_present`.
struct FrameToSend
{
    bool is_present;
    CanFrame frame;
};

/// @brief The NMT state of the kernel in a state of the node. [SRS_NMT_008]
[[nodiscard]] NmtState KernelState(NodeState state) noexcept;
/// @brief The state as heartbeat and guarding tell it; 0 in INITIALISATION. [SRS_HB_002]
[[nodiscard]] std::uint8_t StateByte(NodeState state) noexcept;
/// @brief One data byte on 700h + node-ID.
[[nodiscard]] CanFrame ErrorControlFrame(NodeId node, std::uint8_t byte) noexcept;

/// The state machine of a slave. It keeps nothing but the state: its owner loads parameters on entering a reset
/// sub-state, calls Advance until PRE-OPERATIONAL is reached and sends the frame that it returns. Not reentrant.
class NmtSlave
{
  public:
    NmtSlave(NodeId node, const StartUp& start_up) noexcept;

    /// @brief The present state.
    [[nodiscard]] NodeState State() const noexcept
    {
        return state_;
    }
    /// @brief One step of INITIALISATION; from the last one the boot-up message comes back. Elsewhere nothing.
    /// [SRS_NMT_001, SRS_NMT_002, SRS_NMT_005]
    [[nodiscard]] FrameToSend Advance() noexcept;
    /// @brief The node-ID from now on, in RESET COMMUNICATION; without one the slave stays there. [SRS_NMT_009]
    void SetNodeId(NodeId node) noexcept;
    /// @brief A frame from the bus; what is no command for this node is ignored. [SRS_NMT_003, SRS_NMT_004]
    void OnFrame(const CanFrame& frame) noexcept;
    /// @brief The device itself leaves OPERATIONAL for PRE-OPERATIONAL or STOPPED. True: it was OPERATIONAL and has
    /// left. [SRS_NMT_007]
    [[nodiscard]] bool Leave(NodeState to) noexcept;

  private:
    void Obey(NmtCommand command) noexcept;

    NodeId node_;
    StartUp start_up_;
    NodeState state_;
};

} // namespace counterpoint::cia301

#endif
