// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_CANOPEN_MANAGER_FLYING_RIG_HPP
#define TESTS_CANOPEN_MANAGER_FLYING_RIG_HPP

#include "canopen/manager/manager.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

/// A manager with a flying master and a profile that does nothing.
namespace counterpoint::cia302
{

using Lines = std::vector<std::string>;

/// Tells when it is to lead the network.
class IdleProfile final : public StartUp
{
  public:
    explicit IdleProfile(std::vector<std::string>& log) : log_(log)
    {
    }
    void Begin(const Instant /*now*/) noexcept override
    {
        log_.emplace_back("leads");
    }
    void End() noexcept override
    {
        log_.emplace_back("leads no more");
    }
    void OnFrame(const CanFrame& /*frame*/, const Instant /*now*/) noexcept override
    {
    }
    void OnCycle(const Instant /*now*/) noexcept override
    {
    }
    void OnRoom(const Instant /*now*/) noexcept override
    {
        ++rooms;
        if (tells_room)
        {
            log_.emplace_back("room");
        }
    }
    void OnNodeEvent(const NodeId /*node*/, const NodeEvent /*event*/, const Instant /*now*/) noexcept override
    {
    }
    [[nodiscard]] NmtAnswer Command(const NmtCommand /*command*/, const NodeId /*node*/,
                                    const Instant /*now*/) noexcept override
    {
        return NmtAnswer::kTaken;
    }
    [[nodiscard]] bool Boot(const NodeId /*node*/, const Instant /*now*/) noexcept override
    {
        return true;
    }
    [[nodiscard]] bool Configure(const NodeId /*node*/, const Instant /*now*/) noexcept override
    {
        return true;
    }
    [[nodiscard]] NodeStatus Status(const NodeId /*node*/) const noexcept override
    {
        return NodeStatus{};
    }
    [[nodiscard]] std::int16_t MasterState() const noexcept override
    {
        return 0;
    }

    int rooms{0};           ///< How often it was offered room in the sink.
    bool tells_room{false}; ///< And writes that down.

  private:
    std::vector<std::string>& log_;
};

/// Node 5 of level 1, own heartbeat each 1000 ms, cycle 1 ms; nobody watches the master by 1016h but the flying master.
/// What leaves and what happens is written down; heartbeats without their time.
class ManagerFlying : public ::testing::Test, public cia301::FrameSink, public ManagerListener
{
  protected:
    void Use(const NegotiationBy by)
    {
        times.priority = 1U;
        manager.Use(profile);
        manager.Role().Use(flying, by);
    }
    void RunTo(const std::uint32_t ms)
    {
        while (now_ms < ms)
        {
            ++now_ms;
            manager.OnCycle(Now());
        }
    }
    void Hear(const std::uint32_t identifier, const std::vector<std::uint8_t>& data = {})
    {
        CanFrame frame{identifier, FrameKind::kData, CanPortId::kFirst, static_cast<std::uint8_t>(data.size()), {}};
        std::copy(data.begin(), data.end(), frame.data);
        manager.OnFrame(frame, Now());
    }
    /// Since the last call.
    Lines Log()
    {
        Lines log{};
        log.swap(log_);
        return log;
    }
    [[nodiscard]] Instant Now() const
    {
        return Instant{now_ms * 1000U};
    }

    bool Send(const CanFrame& frame) noexcept override
    {
        const bool is_taken = refuses == 0U;
        refuses -= is_taken ? 0U : 1U;
        std::array<char, 32> text{};
        std::snprintf(text.data(), text.size(), "%u %03X", static_cast<unsigned>(now_ms),
                      static_cast<unsigned>(frame.identifier));
        std::string line = text.data();
        for (std::uint8_t i = 0U; i < frame.length_bytes; ++i)
        {
            std::snprintf(text.data(), text.size(), " %02X", static_cast<unsigned>(frame.data[i]));
            line += text.data();
        }
        if (is_taken)
        {
            log_.push_back(line);
        }
        return is_taken;
    }
    void OnNodeEvent(const NodeId node, const NodeEvent event, const Instant /*now*/) noexcept override
    {
        lost += (event == NodeEvent::kHeartbeatLost)
                    ? std::to_string(now_ms) + " node " + std::to_string(node.value) + "; "
                    : "";
    }
    void OnNodeStatus(const NodeId /*node*/, const Instant /*now*/) noexcept override
    {
    }
    void OnMasterState(const std::int16_t /*state*/, const Instant /*now*/) noexcept override
    {
    }
    void OnNmtSent(const NmtRequest& /*request*/, const Instant /*now*/) noexcept override
    {
    }
    void OnNmtUnsent(const NmtRequest& request, const Instant /*now*/) noexcept override
    {
        unsent += std::to_string(static_cast<int>(request.command)) + " " + std::to_string(request.node.value) + "; ";
    }
    void OnGate(const NodeId /*node*/, const GateState /*state*/, const Instant /*now*/) noexcept override
    {
    }
    void OnEmergency(const NodeId /*node*/, const EmergencyRecord& /*emergency*/,
                     const Instant /*now*/) noexcept override
    {
    }
    void OnDuplicate(const NodeId /*node*/, const Instant /*now*/) noexcept override
    {
    }
    void OnFlyingMaster(const FlyingEvent event, const MasterClaim& claim, const Instant /*now*/) noexcept override
    {
        log_.push_back("event " + std::to_string(static_cast<int>(event)) + " " + std::to_string(claim.level) + "/" +
                       std::to_string(claim.node.value));
    }
    void OnNegotiationRefused(const FlyingStart reason, const Instant /*now*/) noexcept override
    {
        log_.push_back(std::to_string(now_ms) + " refused " + std::to_string(static_cast<int>(reason)));
    }
    void OnInitialising(const Instant /*now*/) noexcept override
    {
        log_.push_back(std::to_string(now_ms) + " initialising");
    }

    std::vector<std::string> log_{};
    std::string unsent{}; ///< Commands that never leave.
    std::string lost{};   ///< Whose heartbeat, and when.
    std::uint32_t now_ms{0U};
    std::uint32_t refuses{0U};
    std::array<SlaveSetup, kNodeRoom> slaves{};
    NetworkSetup setup{NodeId{5U}, 0x21U, 0U, 0U, 0U, slaves.data()};
    FlyingMasterTimes times{DefaultTimes(NodeId{5U})};
    FlyingMasterOptions options{DefaultFlyingMaster()};
    std::array<NodeRecord, kNodeRoom> records{};
    std::array<WatchedNode, kNodeRoom> watched{};
    std::array<GateState, kNodeRoom> gates{};
    std::array<NmtRequest, 8U> commands{};
    std::array<SafetySlot, 1U> safety{};
    SdoLanes<2U> lanes{*this, SdoTimes{500'000U, 3U}};
    IdleProfile profile{log_};
    Manager manager{ManagerParts{setup, *this, *this,
                                 ManagerRoom{records.data(),
                                             watched.data(),
                                             gates.data(),
                                             {commands.data(), 8U},
                                             {safety.data(), 1U},
                                             lanes.All(),
                                             SdoTimes{500'000U, 3U}},
                                 1000U}};
    FlyingMaster flying{FlyingMasterParts{setup, times, options, *this, manager.Role()}};
};

} // namespace counterpoint::cia302

#endif
