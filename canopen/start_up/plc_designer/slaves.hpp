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

/// Which SDO a slave in state 3 is sent next.
enum class PlcRow : std::uint8_t
{
    kDeviceType = 0U,
    kRestore = 1U, ///< 1011h:01.
    kList = 2U,    ///< SDOs of the configurator.
};

/// One slave: its state, and what is known besides. Zero-filled at first.
struct PlcNode
{
    NodeStatus status; ///< Its code is nStatus, which is changed by Next alone.
    PlcRow row;
    ConcisePosition place; ///< In the list.
    Instant since;         ///< Begin of the state, or of the reading of 1000h.
    bool is_listed;
    bool is_transferring;
    bool is_type_wrong;
    SdoAbort type_abort;    ///< Of 1000h.
    SdoAbort restore_abort; ///< Of 1011h:01, since Begin.
    ObjectAddress refused;  ///< First SDO of the list that was aborted; 0000h: none.
    SdoAbort list_abort;    ///< Of that one.
    bool was_reset;         ///< After 1011h:01, since Begin.
    bool is_requested;      ///< Its reset (state -1) or start (state 4) was handed over, and was not seen to be sent.
    bool is_hold_due;       ///< The command that holds it was handed over, and was not seen to be sent.
    bool is_held;           ///< Held by a command: it is not started again by itself.
    bool is_wanted;         ///< To be started.
    bool is_by_hand;        ///< Its start was ordered: no other slave is waited for.
    SafetyReading reading;
    bool ran_unread;  ///< Was OPERATIONAL since its SDOs were answered last, and not read.
    bool is_stop_due; ///< It is to be stopped: the gate refused it, or it cannot be read.
    bool has_sdos;    ///< All its SDOs were answered since Begin.
    std::uint8_t signs;
    std::uint8_t buffer[4];
};

/// The setup of a slave without one of its own.
inline constexpr PlcSlave kPlainPlcSlave{};

/// What the profile works with; all kept by reference. `nodes` has kNodeRoom elements.
struct PlcParts
{
    StartUpParts common;
    PlcNode* nodes;
};

/// The slaves of the profile: what is known of each, and the only function that changes the state. Node-IDs are 1 to
/// 127, checked by the caller.
class PlcSlaves
{
  public:
    explicit PlcSlaves(const PlcParts& parts) noexcept : parts_(parts)
    {
    }

    /// @brief Record of a slave.
    [[nodiscard]] PlcNode& Of(const NodeId node) const noexcept
    {
        return parts_.nodes[node.value & kLastNode];
    }
    /// @brief What the profile is configured to do with the slave; the defaults where nothing is.
    [[nodiscard]] const PlcSlave& SetupOf(const NodeId node) const noexcept
    {
        const PlcSlave* const slave = parts_.common.setup.Slave(node).plc;
        return (slave != nullptr) ? *slave : kPlainPlcSlave;
    }
    /// @brief Takes the slave to the state that follows `event`, and tells the listener.
    void Go(const NodeId node, const PlcEvent event, const StartUpStep step, const Instant now) noexcept
    {
        PlcNode& slave = Of(node);
        const std::int16_t state = Next(slave.status.code, event);
        const bool has_changed = (slave.status.code != state) || (slave.status.step != step);
        slave.since = (slave.status.code != state) ? now : slave.since;
        slave.status.code = state;
        slave.status.step = step;
        if (has_changed)
        {
            parts_.common.listener.OnNodeStatus(node, now);
        }
    }

  private:
    PlcParts parts_;
};

} // namespace counterpoint::cia302

#endif
