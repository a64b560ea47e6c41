// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_CANOPEN_START_UP_BOOT_RIG_HPP
#define TESTS_CANOPEN_START_UP_BOOT_RIG_HPP

#include "canopen/start_up/cia302/start_up.hpp"
#include "tests/canopen/cia302/fake_slave.hpp"
#include "verification/trace/verifies.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace counterpoint::cia302
{

/// 1F81h of an optional and of a mandatory slave.
inline constexpr std::uint32_t kBoot = kInNetwork | kBootSlave;
inline constexpr std::uint32_t kMust = kInNetwork | kBootSlave | kMandatory;

/// Expects nothing of a safety slave: the test says how verification ends, and after how many cycles.
class FakeGate final : public StartGate
{
  public:
    explicit FakeGate(const NetworkSetup& setup) : setup_(setup)
    {
    }

    void Verify(NodeId node, Instant) noexcept override
    {
        ++verifications;
        states[node.value] = GateState::kBusy;
        left_ = cycles;
    }
    void OnCycle(Instant) noexcept override
    {
        for (auto& [node, state] : states)
        {
            const bool is_over = (state == GateState::kBusy) && (left_ == 0);
            state = is_over ? verdict : state;
        }
        left_ -= (left_ > 0) ? 1 : 0;
    }
    void Close(NodeId node) noexcept override
    {
        states[node.value] = GateState::kClosed;
    }
    [[nodiscard]] GateState State(NodeId node) const noexcept override
    {
        const auto found = states.find(node.value);
        const GateState state = (found == states.end()) ? GateState::kClosed : found->second;
        return setup_.IsSafetySlave(node) ? state : GateState::kOpen;
    }
    [[nodiscard]] GateFinding Finding(NodeId) const noexcept override
    {
        return finding;
    }

    GateState verdict{GateState::kOpen};
    GateFinding finding{{0x13FEU, 0U}, SdoAbort::kNone, 0xA5U, 0U};
    std::map<std::uint8_t, GateState> states{};
    int cycles{0};
    int verifications{0};

  private:
    const NetworkSetup& setup_;
    int left_{0};
};

/// A bus, the manager (node 127) with the CiA 302-2 start-up, and slaves. One cycle is 1 ms; frames of a cycle reach
/// all others in it. SDO: 100 ms, 3 tries. The counter of time wraps soon after the start.
class BootRig : public ::testing::Test,
                public cia301::FrameSink,
                public NodeListener,
                public NmtListener,
                public StartUpListener
{
  public:
    struct Sent
    {
        std::uint32_t at_ms;
        CanFrame frame;
    };

    explicit BootRig(const SdoTimes& sdo_times = SdoTimes{100'000U, 3U});

    bool Send(const CanFrame& frame) noexcept override;
    void OnNodeEvent(NodeId node, NodeEvent event, Instant now) noexcept override;
    void OnNmtSent(const NmtRequest& request, Instant now) noexcept override;
    void OnStartDropped(NodeId node, Instant now) noexcept override;
    void OnNodeStatus(NodeId node, Instant now) noexcept override;
    void OnMasterState(std::int16_t state, Instant now) noexcept override;

    /// A listed slave with 1F81h as given, identity expected and present; not yet powered.
    FakeSlave& Add(std::uint8_t node, std::uint32_t assignment);
    /// The slave becomes one of safety; of its expectation is looked only at whether it is there.
    void Protect(std::uint8_t node);
    void PowerAll();
    /// Powers what is there and begins the start-up.
    void Begin();
    void Run(std::uint32_t ms);
    /// So many commands wait in the queue, which has room for 256, each 1 ms after the other.
    void FillQueue(std::uint16_t count = 256U);
    /// Carries frames until nobody sends any more.
    void Deliver();
    /// A frame that only the manager hears.
    void ToManager(const CanFrame& frame);
    [[nodiscard]] Instant Now() const;
    [[nodiscard]] NodeStatus Of(std::uint8_t node) const;
    [[nodiscard]] std::string Letter(std::uint8_t node) const;
    [[nodiscard]] MasterStep Step() const;
    /// NMT frames as "time:command node", all in ms since Begin, e.g. "0:82 00".
    [[nodiscard]] std::vector<std::string> Commands() const;
    [[nodiscard]] int Count(std::uint32_t identifier) const;
    /// One entry of a concise DCF behind those that `octets` has.
    static void AddEntry(Octets& octets, std::uint16_t index, std::uint8_t sub, const Octets& value);

    std::uint32_t ms{0U};
    std::vector<CanFrame> wire{};
    std::vector<Sent> log{};
    std::vector<NmtRequest> own{}; ///< Commands that hit the manager itself.
    std::vector<std::string> events{};
    std::vector<std::int16_t> master_states{};
    std::map<std::uint8_t, std::unique_ptr<FakeSlave>> slaves{};
    bool is_begun{false};
    std::uint32_t begun_ms{0U};
    int lost_answer{-1}; ///< As many frames of slaves come through, then one is lost. -1: none.

    std::array<SlaveSetup, kNodeRoom> setups{};
    NetworkSetup setup{NodeId{127U}, kIsMaster, 0U, 0U, 0U, setups.data()};
    std::array<NodeRecord, kNodeRoom> nodes{};
    std::array<NmtRequest, 256> queue{};
    std::array<BootRecord, kNodeRoom> boots{};
    FakeGate gate{setup};
    NodeTable table{NodeTableParts{nodes.data(), setup, *this, *this}};
    NmtMaster nmt{NmtMasterParts{setup, NmtQueueRoom{queue.data(), 256U}, *this, table, *this, gate}};
    SdoLanes<127> lanes;
    SdoPool sdo;
    Cia302StartUp start_up{StartUpParts{setup, table, nmt, sdo, gate, *this, *this}, boots.data()};
};

} // namespace counterpoint::cia302

#endif
