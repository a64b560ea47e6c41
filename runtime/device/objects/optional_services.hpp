// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_DEVICE_OBJECTS_OPTIONAL_SERVICES_HPP
#define RUNTIME_DEVICE_OBJECTS_OPTIONAL_SERVICES_HPP

#include "canopen/cia301/emergency/consumer.hpp"
#include "canopen/cia301/sdo/client_port.hpp"
#include "canopen/cia301/time/time_stamp.hpp"
#include "canopen/cia306/file/device.hpp"
#include "canopen/device/services.hpp"

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// Who is told what a device hears of others; called within calls of the device.
struct HeardBy
{
    cia301::TimeListener& times;
    cia301::EmergencyListener& emergencies;
};

/// The services that only some devices have: TIME, emergency consumer, further SDO servers, SDO clients, as many as the
/// file has objects of. It cannot be moved or copied. [SRS_NODE_012, SRS_SIM_061]
class OptionalServices final
{
  public:
    /// `longest_bytes`: length of the longest object of this device. All arguments but the file outlive it; `services`
    /// gets the list of these services.
    OptionalServices(const cia306::Device& file, cia301::Dictionary& dictionary, device::Services& services,
                     const HeardBy& heard_by, std::uint32_t longest_bytes);
    OptionalServices(const OptionalServices&) = delete;
    OptionalServices& operator=(const OptionalServices&) = delete;

    /// @brief The hook of an object of these services; null: the object is none of theirs.
    [[nodiscard]] cia301::NumberHook* HookOf(std::uint16_t index) noexcept;
    /// @brief TIME.
    [[nodiscard]] cia301::TimeStamp& Time() noexcept;
    /// @brief The SDO client that is connected with this server; null: there is none.
    [[nodiscard]] cia301::SdoClientPort* ClientOf(std::uint8_t server) noexcept;

  private:
    struct Client
    {
        cia301::SdoClientPort port;
        std::uint16_t index;
    };
    struct Serving
    {
        Serving(cia301::Dictionary& dictionary, cia301::FrameSink& sink, std::uint8_t number,
                std::uint32_t longest_bytes);

        std::vector<std::uint8_t> buffer;
        cia301::SdoServer server;
        cia301::SdoServerPort port;
        std::uint16_t index;
    };

    std::vector<std::uint32_t> sources_; ///< Of 1028h.
    cia301::TimeStamp time_;
    cia301::EmergencyConsumer emergencies_;
    std::deque<Client> clients_;
    std::deque<Serving> servers_;
    std::vector<cia301::BusService*> list_;
};

/// @brief A received time as text.
[[nodiscard]] std::string TextOf(const cia301::TimeOfDay& time);
/// @brief A received emergency message as text.
[[nodiscard]] std::string TextOf(const cia301::ReceivedEmergency& emergency);
/// @brief Bytes as text: "01 AB ..."; of many only the first ones.
[[nodiscard]] std::string BytesText(const std::uint8_t* bytes, std::size_t count);
} // namespace counterpoint::runtime

#endif // RUNTIME_DEVICE_OBJECTS_OPTIONAL_SERVICES_HPP
