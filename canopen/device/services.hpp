// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_DEVICE_SERVICES_HPP
#define CANOPEN_DEVICE_SERVICES_HPP

#include "canopen/device/error_book.hpp"

#include "canopen/cia301/service_objects.hpp"

namespace counterpoint::device
{

/// The services whose objects stand in the dictionary. Members in the open, because a constant table of entries names
/// them as hooks; built before the table, used by Device alone.
struct Services final : private cia301::HeartbeatListener
{
    Services(cia301::NodeId own_node, const cia301::SupervisedNodes& room) noexcept;

    cia301::NodeId node;
    cia301::SupervisedNodes supervised;
    cia301::NmtSlave slave;
    cia301::EmergencyProducer emergency;
    ErrorBook errors;
    cia301::HeartbeatConsumer consumer;
    cia301::HeartbeatProducer producer;
    cia301::NodeGuarding guarding;
    cia301::ServiceObjects objects;

    /// @brief Reset communication: parameters as at power-on; errors that are there stay.
    void Reset() noexcept;
    /// @brief In the last step of INITIALISATION: where it leads to.
    void SetStartUp(const cia301::StartUp& start_up) noexcept;

  private:
    void OnHeartbeat(cia301::NodeId, cia301::HeartbeatEvent, std::uint8_t) noexcept override
    {
    }
};

} // namespace counterpoint::device

#endif
