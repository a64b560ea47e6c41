// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_CANOPEN_MANAGER_RIG_HPP
#define TESTS_CANOPEN_MANAGER_RIG_HPP

#include "canopen/manager/manager.hpp"
#include "canopen/start_up/cia302/start_up.hpp"
#include "canopen/start_up/el6751/start_up.hpp"
#include "canopen/start_up/plc_designer/start_up.hpp"
#include "tests/canopen/cia302/fake_slave.hpp"
#include "verification/trace/verifies.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace counterpoint::cia302
{

enum class Profile : std::uint8_t
{
    kCia302 = 1U,
    kEl6751 = 2U,
    kPlcDesigner = 3U,
};

inline constexpr Profile kProfiles[] = {Profile::kCia302, Profile::kEl6751, Profile::kPlcDesigner};

/// The frame of an NMT command, whoever sends it.
[[nodiscard]] inline CanFrame Nmt(const NmtCommand command, const std::uint8_t node)
{
    const auto byte = static_cast<std::uint8_t>(command);
    return CanFrame{0U, FrameKind::kData, CanPortId::kFirst, 2U, {byte, node, 0U, 0U, 0U, 0U, 0U, 0U}};
}

/// A bus, the whole manager (node 127) with any of its profiles and the real safety gate, and slaves of real services.
/// One cycle is 1 ms; frames of a cycle reach all others in it, own ones come back to the manager as sent.
class ManagerRig : public ::testing::Test, public cia301::FrameSink, public ManagerListener
{
  public:
    bool Send(const CanFrame& frame) noexcept override;
    void OnNodeEvent(NodeId node, NodeEvent event, Instant now) noexcept override;
    void OnNodeStatus(NodeId node, Instant now) noexcept override;
    void OnMasterState(std::int16_t state, Instant now) noexcept override;
    void OnNmtSent(const NmtRequest& request, Instant now) noexcept override;
    void OnGate(NodeId node, GateState state, Instant now) noexcept override;
    void OnEmergency(NodeId node, const EmergencyRecord& emergency, Instant now) noexcept override;
    void OnDuplicate(NodeId node, Instant now) noexcept override;
    void OnFlyingMaster(FlyingEvent event, const MasterClaim& claim, Instant now) noexcept override;

    /// A device on the bus, powered at Begin; the first one of a node-ID lists it too.
    FakeSlave& Add(std::uint8_t node);
    /// Makes the node a safety slave with one SRDO whose configuration its devices have.
    void MakeSafe(std::uint8_t node);
    void Begin(Profile profile);
    void Run(std::uint32_t ms);
    /// A command of the application.
    NmtAnswer Order(NmtCommand command, std::uint8_t node);
    /// A frame of somebody else on the bus.
    void Put(const CanFrame& frame);
    [[nodiscard]] Instant Now() const;
    [[nodiscard]] bool IsSuspected(std::uint8_t node) const;
    /// Devices of the node that are OPERATIONAL.
    [[nodiscard]] int Running(std::uint8_t node) const;
    [[nodiscard]] GateState Gate(std::uint8_t node = 5U) const;

    std::uint32_t ms{0U};
    bool is_echo_heard{true}; ///< Own frames come back.
    bool is_sink_full{false}; ///< What the manager hands over is not taken.
    std::vector<std::unique_ptr<FakeSlave>> devices{};
    std::vector<std::uint8_t> duplicates{}; ///< As told.
    std::vector<std::string> starts{};      ///< "node" of each NMT start that left.
    int stops{0};                           ///< NMT stops that left.
    int asked{0};                           ///< SDO requests and commands of the manager.
    std::array<SlaveSetup, kNodeRoom> setups{};
    NetworkSetup setup{NodeId{127U}, kIsMaster, 0U, 0U, 0U, setups.data()};
    std::unique_ptr<Manager> manager{};

  private:
    struct OnWire
    {
        CanFrame frame;
        bool is_ours;
    };
    void Deliver();
    template <typename Action> void AsManager(Action action)
    {
        is_ours_ = true;
        action();
        is_ours_ = false;
    }

    bool is_ours_{false};
    std::vector<OnWire> wire_{};
    std::array<NodeRecord, kNodeRoom> records_{};
    std::array<WatchedNode, kNodeRoom> watched_{};
    std::array<GateState, kNodeRoom> gates_{};
    std::array<NmtRequest, 256> queue_{};
    std::array<SafetySlot, 4> slots_{};
    std::array<ExpectedObject, 9> objects_{};
    SafetyExpectation expectation_{objects_.data(), 9U};
    SdoLanes<127> lanes_{*this, SdoTimes{500'000U, 1U}};
    std::array<BootRecord, kNodeRoom> boots_{};
    std::array<El6751Node, kNodeRoom> el6751_nodes_{};
    std::array<PlcNode, kNodeRoom> plc_nodes_{};
    std::unique_ptr<Cia302StartUp> cia302_{};
    std::unique_ptr<El6751StartUp> el6751_{};
    std::unique_ptr<PlcStartUp> plc_{};
};

} // namespace counterpoint::cia302

#endif
