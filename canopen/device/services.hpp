// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_DEVICE_SERVICES_HPP
#define CANOPEN_DEVICE_SERVICES_HPP

#include "canopen/device/outbox.hpp"
#include "canopen/device/service_set.hpp"

#include "canopen/cia301/emergency/communication_errors.hpp"
#include "canopen/cia301/nmt/heartbeat_consumer.hpp"
#include "canopen/cia301/objects/service_objects.hpp"
#include "canopen/cia301/pdo/objects.hpp"
#include "canopen/cia301/sdo/server_port.hpp"
#include "canopen/cia301/time/sync.hpp"
#include "canopen/cia305/lss_slave.hpp"

namespace counterpoint::device
{

class KernelWatch;

/// Room for what differs from device to device, kept by reference.
struct ServiceRooms
{
    cia301::SupervisedNodes supervised; ///< Entries of 1016h.
    cia301::TpdoTable tpdos;
    cia301::RpdoTable rpdos;
    cia301::Room sdo_buffer; ///< As long as the longest object.
};

/// @brief How many places a device with so many SRDOs and these rooms needs so that none of its emergencies is ever
/// lost. [SRS_EMCY_010]
[[nodiscard]] std::uint16_t EmergencyPlaces(std::uint8_t srdo_count, const ServiceRooms& rooms) noexcept;

/// Services that not every device has, in the order in which they are called; the list is kept by reference.
struct FurtherServices
{
    cia301::BusService* const* list;
    std::uint8_t count;
};

/// What the services work with; all kept by reference. `emergency` is made before the kernel, which has errors to tell.
struct ServiceParts
{
    cia301::EmergencyProducer& emergency;
    hal::CanPorts& can;
    cia301::Dictionary& dictionary;
    ServiceRooms rooms;
};

/// The services of CiA 301 of one device. The members are public because entries of the dictionary name them as hooks;
/// whoever builds the table needs only their addresses. Used by Device. [SRS_DEV_009, SRS_DEV_010, SRS_DEV_012]
struct Services final : public ServiceSet, public cia301::WriteRule
{
    /// @brief As at power-on, before any configuration.
    Services(cia301::NodeId own_node, const ServiceParts& parts) noexcept;

    cia301::SupervisedNodes supervised;
    Outbox outbox;
    ProcessSink process; ///< Of SYNC and PDOs.
    cia301::EmergencyProducer& emergency;
    cia301::CommunicationErrors errors; ///< Hook of 1029h.
    cia301::HeartbeatConsumer consumer;
    cia301::HeartbeatProducer producer;
    cia301::NodeGuarding guarding;
    cia301::ServiceObjects objects; ///< Hook of 1001h, 1003h, 100Ch, 100Dh, 1014h to 1017h.
    cia301::Tpdos tpdos;
    cia301::Rpdos rpdos;
    cia301::PdoObjects pdos; ///< Hook of 1400h to 1BFFh.
    cia301::Sync sync;       ///< Hook of 1005h, 1006h, 1007h, 1019h.
    cia301::SdoServer sdo;
    cia301::SdoServerPort sdo_port; ///< Hook of 1200h.
    cia305::LssSlave* lss;          ///< Null: the node-ID is what it was at the construction. Set before PowerOn.
    FurtherServices further;        ///< None at first; they send by `outbox`. Set before PowerOn. [SRS_DEV_020,
                                    ///< SRS_DEV_210, SRS_DEV_211, SRS_DEV_212]

    KernelWatch* watch;             ///< Set by Device.
    cia301::Dictionary* dictionary; ///< The dictionary of the whole device; set by Device.

    void PowerOff() noexcept override;
    [[nodiscard]] bool MayBoot() const noexcept override;
    void OnResetNode() noexcept override;
    [[nodiscard]] bool TakeNodeId() noexcept override;
    /// @brief As ServiceSet. Errors that are active stay active.
    void BeginConfiguration() noexcept override;
    /// @brief As ServiceSet. 1F80h says where INITIALISATION leads to.
    void EndConfiguration() noexcept override;
    void Send(const cia301::FrameToSend& frame) noexcept override;
    void OnState(NmtState left, NmtState entered) noexcept override;
    void OnOperational() noexcept override;
    [[nodiscard]] bool Wants(const CanFrame& frame) const noexcept override;
    void OnConfirm() noexcept override;
    void OnOverrun(bool has_lost) noexcept override;
    void OnFrame(const CanFrame& frame, const cia301::Moment& moment) noexcept override;
    void OnCycle(const cia301::Moment& moment) noexcept override;
    void OnBus(BusCondition left, BusCondition entered) noexcept override;
    void Flush(Instant now) noexcept override;
    /// @brief Whether a PDO keeps off the identifiers of the other services and, unless both are received, of the other
    /// PDOs, and another service off those of PDOs. [SRS_PDO_009]
    [[nodiscard]] bool Allows(const ObjectAddress& object, std::uint32_t value) const noexcept override;
};

} // namespace counterpoint::device

#endif
