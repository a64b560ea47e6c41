// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_CANOPEN_START_UP_PROFILE_RIG_HPP
#define TESTS_CANOPEN_START_UP_PROFILE_RIG_HPP

#include "canopen/cia302/network/start_up.hpp"
#include "tests/canopen/start_up/boot_rig.hpp"
#include "tests/canopen/start_up/bus_slave.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace counterpoint::cia302
{

using Log = std::vector<std::string>;

/// A bus, the manager (node 127) with any start-up profile, and slaves of bare frames. Time in us from the start of the
/// test, in steps of `step_us`; the counter of time wraps soon after it. Frames reach all others in the same step.
class ProfileRig : public ::testing::Test,
                   public cia301::FrameSink,
                   public NodeListener,
                   public NmtListener,
                   public StartUpListener
{
  public:
    explicit ProfileRig(const SdoTimes& times);

    bool Send(const CanFrame& frame) noexcept override;
    void OnNodeEvent(NodeId node, NodeEvent event, Instant now) noexcept override;
    void OnNmtSent(const NmtRequest& request, Instant now) noexcept override;
    void OnStartDropped(NodeId node, Instant now) noexcept override;
    void OnNodeStatus(NodeId node, Instant now) noexcept override;
    void OnMasterState(std::int16_t state, Instant now) noexcept override;

    /// A listed slave that is powered: device type 191h, vendor 2Ah, product 7, revision 3, serial 1234h.
    BusSlave& Add(std::uint8_t node);
    /// The profile's Begin, 0 ms.
    void Begin();
    /// Something that the application does, whose frames are the manager's.
    template <typename Action> auto Do(Action action)
    {
        is_manager_ = true;
        const auto result = action();
        is_manager_ = false;
        Deliver();
        return result;
    }
    void Run(std::uint32_t ms);
    void RunUs(std::uint32_t us);
    /// Steps until `is_reached`, at most `limit_ms`; the ms that passed.
    template <typename Condition> std::uint32_t RunUntil(Condition is_reached, const std::uint32_t limit_ms)
    {
        const std::uint32_t from_us = us;
        while (!is_reached() && ((us - from_us) < (1000U * limit_ms)))
        {
            RunUs(step_us);
        }
        return (us - from_us) / 1000U;
    }
    [[nodiscard]] Instant Now() const;
    [[nodiscard]] int Code(std::uint8_t node) const;
    [[nodiscard]] NodeStatus Of(std::uint8_t node) const;
    /// NMT frames as "time in ms:command node", e.g. "0:82 00".
    [[nodiscard]] Log Nmt() const;
    /// The same without their times.
    [[nodiscard]] Log Commands() const;
    /// Times in us of frames with this identifier that the manager sent.
    [[nodiscard]] std::vector<std::uint32_t> Times(std::uint32_t identifier) const;
    /// Puts a frame on the bus.
    void Put(std::uint32_t identifier, const Octets& data);

    struct Sent
    {
        std::uint32_t at_us;
        CanFrame frame;
    };

    StartUp* profile{nullptr};
    std::uint32_t us{0U};
    std::uint32_t step_us{1000U};
    std::vector<CanFrame> wire{};
    std::vector<Sent> sent{};           ///< By the manager.
    std::map<std::uint8_t, Log> told{}; ///< NodeStatus code by code: "8", "23".
    Log masters{};
    std::map<std::uint8_t, std::unique_ptr<BusSlave>> slaves{};
    bool is_bus_cut{false}; ///< Nothing reaches anybody.

    std::array<SlaveSetup, kNodeRoom> setups{};
    NetworkSetup setup{NodeId{127U}, kIsMaster, 0U, 0U, 0U, setups.data()};
    std::array<NodeRecord, kNodeRoom> nodes{};
    std::array<NmtRequest, 256> queue{};
    FakeGate gate{setup};
    NodeTable table{NodeTableParts{nodes.data(), setup, *this, *this}};
    NmtMaster nmt{NmtMasterParts{setup, NmtQueueRoom{queue.data(), 256U}, *this, table, *this, gate}};
    SdoLanes<127> lanes;
    SdoPool sdo;
    const SafetyExpectation* expectation;

    [[nodiscard]] StartUpParts Parts()
    {
        return StartUpParts{setup, table, nmt, sdo, gate, *this, *this};
    }

  protected:
    /// A frame of the manager was on the bus.
    virtual void OnOwnFrame(const CanFrame& frame);

  private:
    void Step();
    void Deliver();

    bool is_manager_{false}; ///< Who sends now.
    std::vector<bool> by_manager_{};
};

} // namespace counterpoint::cia302

#endif
