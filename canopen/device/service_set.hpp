// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_DEVICE_SERVICE_SET_HPP
#define CANOPEN_DEVICE_SERVICE_SET_HPP

#include "canopen/cia301/nmt/bus_service.hpp"
#include "canopen/cia301/nmt/slave.hpp"
#include "hal/api/can_ports.hpp"
#include "safety_core/contract/time.hpp"

namespace counterpoint::device
{

/// Condition of the CAN controller, as it tells.
enum class BusCondition : std::uint8_t
{
    kInvalid = 0U, ///< Read as off.
    kActive = 0x3CU,
    kPassive = 1U,
    kOff = 2U,
};

/// What every device has beside its kernel: node-ID, NMT state machine, boot-up message. A device with no more than
/// this links nothing of SDO, PDO, dictionary and emergency; Services has those. Device calls the functions, in the
/// order in which they stand here. [SRS_DEV_022]
struct ServiceSet
{
    /// @brief `sender` is kept by reference. Null: the other CPU of the device sends the boot-up message.
    ServiceSet(cia301::NodeId own_node, hal::CanPorts* sender) noexcept;

    cia301::NodeId node;
    cia301::NmtSlave slave;
    hal::CanPorts* can;
    cia301::FrameToSend waiting; ///< The boot-up message until the controller has taken it.

    /// @brief The supply is gone: no frame waits, and the state machine is at its beginning. [SRS_DEV_023]
    virtual void PowerOff() noexcept;
    /// @brief Whether a device that waited for a node-ID has one now.
    [[nodiscard]] virtual bool MayBoot() const noexcept;
    /// @brief The kernel is about to be started again.
    virtual void OnResetNode() noexcept;
    /// @brief Reset communication: takes the node-ID that holds from now on. False: there is none. [SRS_DEV_019]
    [[nodiscard]] virtual bool TakeNodeId() noexcept;
    /// @brief Reset communication: parameters as at power-on. Until EndConfiguration values may come in any order.
    virtual void BeginConfiguration() noexcept;
    /// @brief All values are there; INITIALISATION can be left.
    virtual void EndConfiguration() noexcept;
    /// @brief Sends what the NMT state machine gives out: the boot-up message.
    virtual void Send(const cia301::FrameToSend& frame) noexcept;
    /// @brief The kernel is about to leave one state for another.
    virtual void OnState(NmtState left, NmtState entered) noexcept;
    /// @brief The kernel is in OPERATIONAL.
    virtual void OnOperational() noexcept;

    /// @brief Whether a frame that is neither SRDO, GFC nor NMT may concern this node. May interrupt all others. O(1)
    [[nodiscard]] virtual bool Wants(const CanFrame& frame) const noexcept;
    /// @brief A frame of a service was on the bus. May interrupt all others.
    virtual void OnConfirm() noexcept;
    /// @brief `has_lost`: frames of services were lost since the last call.
    virtual void OnOverrun(bool has_lost) noexcept;
    /// @brief A frame for the services, in bus order.
    virtual void OnFrame(const CanFrame& frame, const cia301::Moment& moment) noexcept;
    /// @brief Once a cycle.
    virtual void OnCycle(const cia301::Moment& moment) noexcept;
    /// @brief The condition of the CAN controller changed.
    virtual void OnBus(BusCondition left, BusCondition entered) noexcept;
    /// @brief Hands frames over to the controller, as many as it may have.
    virtual void Flush(Instant now) noexcept;

  protected:
    ~ServiceSet() noexcept = default;
    ServiceSet(const ServiceSet&) = default;
    ServiceSet& operator=(const ServiceSet&) = default;

    /// @brief The state machine at the end of reset communication.
    void Rejoin(const cia301::StartUp& start_up) noexcept;
};

/// The services of a device that has none: ServiceSet and nothing more.
struct NoServices final : public ServiceSet
{
    NoServices(cia301::NodeId own_node, hal::CanPorts* sender) noexcept;
};

} // namespace counterpoint::device

#endif
