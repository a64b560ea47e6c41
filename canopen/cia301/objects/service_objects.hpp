// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_OBJECTS_SERVICE_OBJECTS_HPP
#define CANOPEN_CIA301_OBJECTS_SERVICE_OBJECTS_HPP

#include "canopen/cia301/dictionary/number_hook.hpp"
#include "canopen/cia301/emergency/producer.hpp"
#include "canopen/cia301/nmt/heartbeat_consumer.hpp"
#include "canopen/cia301/nmt/heartbeat_producer.hpp"
#include "canopen/cia301/nmt/node_guarding.hpp"

namespace counterpoint::cia301
{

/// The services whose objects the dictionary shows, kept by reference.
struct ServiceParts
{
    EmergencyProducer& emergency;
    HeartbeatConsumer& consumer;
    HeartbeatProducer& producer;
    NodeGuarding& guarding;
    std::uint8_t consumer_count; ///< Sub-index 0 of 1016h.
};

/// Hook of the entries 1001h, 1003h, 100Ch, 100Dh, 1014h to 1017h; the entries need no place. [SRS_OBD_013]
class ServiceObjects final : public NumberHook
{
  public:
    /// @brief 100Ch and 100Dh are 0 at first.
    explicit ServiceObjects(const ServiceParts& parts) noexcept;

  private:
    [[nodiscard]] ObjectValue Fetch(const ObjectAddress& address) noexcept override;
    [[nodiscard]] SdoAbort Store(const ObjectAddress& address, std::uint32_t value) noexcept override;
    [[nodiscard]] SdoAbort StoreConsumerTime(std::uint8_t sub, std::uint32_t value) noexcept;
    [[nodiscard]] ObjectValue FetchNumber(const ObjectAddress& address) const noexcept;
    [[nodiscard]] ObjectValue FetchList(const ObjectAddress& address) const noexcept;

    ServiceParts parts_;
    std::uint16_t guard_time_ms_;
    std::uint8_t life_factor_;
};

} // namespace counterpoint::cia301

#endif
