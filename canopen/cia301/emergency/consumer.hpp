// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_EMERGENCY_CONSUMER_HPP
#define CANOPEN_CIA301_EMERGENCY_CONSUMER_HPP

#include "canopen/cia301/dictionary/number_hook.hpp"
#include "canopen/cia301/nmt/bus_service.hpp"

namespace counterpoint::cia301
{

/// An emergency message of another node; code 0000h: an error is gone.
struct ReceivedEmergency
{
    NodeId node;
    std::uint16_t code;
    std::uint8_t error_register;
    std::uint8_t details[5];
};

/// Is told of the emergency messages of other nodes.
class EmergencyListener
{
  public:
    /// @brief Called within OnFrame of the consumer.
    virtual void OnEmergency(const ReceivedEmergency& emergency) noexcept = 0;

  protected:
    EmergencyListener() noexcept = default;
    ~EmergencyListener() noexcept = default;
    EmergencyListener(const EmergencyListener&) = default;
    EmergencyListener& operator=(const EmergencyListener&) = default;
};

/// Room for 1028h, kept by reference: COB-ID of the node whose ID is the sub-index, from 1 on.
struct EmergencySources
{
    std::uint32_t* cob_ids;
    std::uint8_t count; ///< 0 to 127.
};

/// Receives the emergency messages of the nodes that 1028h names; it is the hook of 1028h. Not reentrant.
class EmergencyConsumer final : public NumberHook, public BusService
{
  public:
    EmergencyConsumer(const EmergencySources& sources, EmergencyListener& listener) noexcept;

    [[nodiscard]] bool Wants(std::uint32_t identifier) const noexcept override;
    [[nodiscard]] bool Uses(std::uint32_t identifier) const noexcept override;
    /// @brief Reset communication: 1028h is as at power-on, no node is listened to.
    void ResetCommunication(NodeId node) noexcept override;
    [[nodiscard]] NumberHook* Objects() noexcept override
    {
        return this;
    }
    /// @brief A frame from the bus. O(count) [SRS_EMCY_006]
    void OnFrame(const CanFrame& frame, const Moment& moment) noexcept override;
    void OnCycle(const Moment& moment) noexcept override;

  private:
    [[nodiscard]] ObjectValue Fetch(const ObjectAddress& address) noexcept override;
    [[nodiscard]] SdoAbort Store(const ObjectAddress& address, std::uint32_t value) noexcept override;

    EmergencySources sources_;
    EmergencyListener& listener_;
};

} // namespace counterpoint::cia301

#endif
