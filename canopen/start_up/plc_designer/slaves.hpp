// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_PLC_DESIGNER_SLAVES_HPP
#define CANOPEN_START_UP_PLC_DESIGNER_SLAVES_HPP

#include "canopen/cia302/network/concise_dcf.hpp"
#include "canopen/cia302/network/safety_reader.hpp"
#include "canopen/start_up/plc_designer/setup.hpp"
#include "canopen/start_up/plc_designer/states.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// What a slave in state 3 is sent.
enum class PlcRow : std::uint8_t
{
    kDeviceType = 0U,
    kRestore = 1U, ///< 1011h:01.
    kList = 2U,    ///< SDOs of the configurator.
};

/// One slave. Zero-filled at first.
struct PlcNode
{
    NodeStatus status; ///< nStatus is its code and changes by Next alone.
    PlcRow row;
    ConcisePosition place; ///< In the list.
    Instant since;         ///< Begin of the state, or of the reading of 1000h.
    bool is_listed;
    bool is_transferring;
    bool is_type_wrong;
    bool was_reset;  ///< After 1011h:01, since Begin.
    bool is_held;    ///< By a command: not started again by itself.
    bool is_wanted;  ///< To be started.
    bool is_by_hand; ///< By a command: no other slave is waited for.
    SafetyReading reading;
    bool ran_unread;  ///< Was OPERATIONAL since its SDOs were answered last, and not read.
    bool is_stop_due; ///< The gate refused, or it cannot be read.
    bool has_sdos;    ///< All were answered since Begin.
    std::uint8_t signs;
    std::uint8_t buffer[4];
};

/// `nodes` has kNodeRoom elements. All kept by reference.
struct PlcParts
{
    StartUpParts common;
    PlcNode* nodes;
};

/// The slaves of the profile, by node-ID from 1 to 127, checked by the caller: what is known of each, and the one way
/// by which its state changes.
class PlcSlaves
{
  public:
    explicit PlcSlaves(const PlcParts& parts) noexcept : parts_(parts)
    {
    }

    [[nodiscard]] PlcNode& Of(const NodeId node) const noexcept
    {
        return parts_.nodes[node.value & kLastNode];
    }
    /// @brief A slave without a setup of this profile has the defaults.
    [[nodiscard]] const PlcSlave& SetupOf(NodeId node) const noexcept;
    /// @brief The next state, and what is told of it.
    void Go(NodeId node, PlcEvent event, StartUpStep step, Instant now) noexcept;

  private:
    PlcParts parts_;
};

} // namespace counterpoint::cia302

#endif
