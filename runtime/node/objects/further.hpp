// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NODE_OBJECTS_FURTHER_HPP
#define RUNTIME_NODE_OBJECTS_FURTHER_HPP

#include "canopen/cia301/emergency/consumer.hpp"
#include "canopen/cia301/sdo/client_port.hpp"
#include "canopen/cia301/time/time_stamp.hpp"
#include "canopen/cia306/file/device.hpp"
#include "canopen/device/services.hpp"
#include "runtime/console/node_report.hpp"
#include "runtime/node/order.hpp"

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// The services that not every device has, as many as the file of a live node has objects of; what they hear becomes
/// lines. Stays where it is. [SRS_NODE_012]
class NodeFurther final : private cia301::TimeListener, private cia301::EmergencyListener
{
  public:
    /// `longest_bytes`: of an object of this device. All given outlive it; `services` gets its list.
    NodeFurther(const cia306::Device& file, cia301::Dictionary& dictionary, device::Services& services,
                NodeReport& report, std::uint32_t longest_bytes);
    NodeFurther(const NodeFurther&) = delete;
    NodeFurther& operator=(const NodeFurther&) = delete;

    /// @brief The hook of an object of these services; null: it is none.
    [[nodiscard]] cia301::NumberHook* HookOf(std::uint16_t index) noexcept;
    /// @brief Sends the time of the system; empty, or what was in the way and what is expected.
    [[nodiscard]] std::string SendTime(cia301::NodeState state, Instant now);
    /// @brief Begins to read from another node, or to write there; empty, or why not.
    [[nodiscard]] std::string StartTransfer(const NodeOrder& order, Instant now);
    /// @brief Time of what is told next.
    void SetNow(std::uint64_t now_ns) noexcept
    {
        now_ns_ = now_ns;
    }
    /// @brief Tells of transfers that have ended.
    void Look();

  private:
    /// A client and what its transfer is about.
    struct Asking
    {
        cia301::SdoClientPort port;
        std::uint16_t index;
        NodeOrder order{};
        std::vector<std::uint8_t> bytes{};
        bool is_asking{false};
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

    void OnTime(const cia301::TimeOfDay& time, Instant now) noexcept override;
    void OnEmergency(const cia301::ReceivedEmergency& emergency) noexcept override;
    void Tell(Asking& asking);

    NodeReport& report_;
    std::uint64_t now_ns_{0U};
    std::vector<std::uint32_t> sources_; ///< Of 1028h.
    cia301::TimeStamp time_;
    cia301::EmergencyConsumer emergencies_;
    std::deque<Asking> clients_;
    std::deque<Serving> servers_;
    std::vector<cia301::BusService*> list_;
};
} // namespace counterpoint::runtime

#endif // RUNTIME_NODE_OBJECTS_FURTHER_HPP
