// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_EMERGENCY_COMMUNICATION_ERRORS_HPP
#define CANOPEN_CIA301_EMERGENCY_COMMUNICATION_ERRORS_HPP

#include "canopen/cia301/dictionary/number_hook.hpp"
#include "canopen/cia301/emergency/producer.hpp"
#include "canopen/cia301/nmt/heartbeat_consumer.hpp"

namespace counterpoint::cia301
{

/// Errors of communication, each with its emergency error code. Those with 1029h also leave OPERATIONAL as 1029h:01
/// says.
enum class CommunicationError : std::uint8_t
{
    kInvalid = 0U,
    kOverrun = 1U,      ///< 8110h: frames were lost in this device.
    kPassive = 2U,      ///< 8120h: error passive.
    kLifeGuard = 3U,    ///< 8130h, 1029h: the master guards no more.
    kHeartbeat = 4U,    ///< 8130h, 1029h: a node is silent; source is its node-ID.
    kBusOff = 5U,       ///< 1029h; 8140h when it is over.
    kCollision = 6U,    ///< 8150h: another node uses an identifier of this one.
    kPdoShort = 7U,     ///< 8210h; the source is the number of the RPDO, as it is for kPdoLong and kRpdoTimeOut.
    kPdoLong = 8U,      ///< 8220h.
    kSyncLength = 9U,   ///< 8240h.
    kRpdoTimeOut = 10U, ///< 8250h.
};

constexpr std::uint8_t kErrorClasses = 6U; ///< Sub-indices of 1029h: 1 communication, 2 to 6 of the device's profile.

/// One place for errors of communication: emergency messages by source, and the error behaviour of 1029h. As a listener
/// it turns lost heartbeats into errors of their own node. Also the hook of 1029h. Not reentrant.
class CommunicationErrors final : public HeartbeatListener, public NumberHook
{
  public:
    /// @brief Both are kept by reference.
    CommunicationErrors(EmergencyProducer& emergency, NmtSlave& slave) noexcept;

    /// @brief An error appeared; nothing happens if it is active for this source. O(room) [SRS_ERR_001, SRS_ERR_002]
    void Raise(CommunicationError error, std::uint16_t source) noexcept;
    /// @brief The error of this source is gone. O(room) [SRS_ERR_001]
    void Clear(CommunicationError error, std::uint16_t source) noexcept;
    /// @brief An error of class 2 to 6: leaves OPERATIONAL as 1029h says. [SRS_ERR_002]
    void OnDeviceError(std::uint8_t error_class) noexcept;
    /// @brief A lost node is an error of that node; its next heartbeat or boot-up message ends it. [SRS_ERR_003]
    void OnHeartbeat(NodeId node, HeartbeatEvent event, std::uint8_t state) noexcept override;
    /// @brief Reset communication: 1029h as at power-on, all 0.
    void Reset() noexcept;

  private:
    [[nodiscard]] ObjectValue Fetch(const ObjectAddress& address) noexcept override;
    [[nodiscard]] SdoAbort Store(const ObjectAddress& address, std::uint32_t value) noexcept override;

    EmergencyProducer& emergency_;
    NmtSlave& slave_;
    std::uint8_t behaviour_[kErrorClasses];
};

} // namespace counterpoint::cia301

#endif
