// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NODE_DEVICE_HPP
#define RUNTIME_NODE_DEVICE_HPP

#include "runtime/console/node_report.hpp"
#include "runtime/node/application.hpp"
#include "runtime/node/build.hpp"
#include "runtime/node/loading.hpp"
#include "runtime/node/objects/store.hpp"
#include "runtime/node/output_watch.hpp"
#include "runtime/node/ports.hpp"
#include "runtime/node/self_test.hpp"
#include "runtime/node/transfers.hpp"

#include "hal/host/output.hpp"
#include "hal/host/virtual/bus.hpp"
#include "hal/host/watchdog.hpp"
#include "runtime/device/assembly.hpp"
#include "runtime/device/model.hpp"
#include "runtime/device/owned_channel.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace counterpoint::runtime
{
/// A device of a DCF in real time: an assembly with shipped channels, the gate and the watchdog of the host, real
/// frames. Time comes in with every call. [SRS_NODE_001, SRS_NODE_006]
class NodeDevice final
{
  public:
    /// Throws cia306::InputError.
    NodeDevice(const NodeSettings& settings, NodePorts& ports, NodeReport& report);

    [[nodiscard]] const DeviceConfig& Config() const noexcept;
    [[nodiscard]] const DeviceModel& Model() const noexcept;
    /// @brief Null: the device has none.
    [[nodiscard]] const NodeSelfTest* SelfTests() const noexcept;
    [[nodiscard]] NodeTransfers& Transfers() noexcept;
    /// @brief Of the device now; 0: LSS has given none.
    [[nodiscard]] std::uint8_t NodeId() const noexcept;
    [[nodiscard]] NodeApplication& App() noexcept;
    [[nodiscard]] device::Device& Services() noexcept;
    [[nodiscard]] cia301::Dictionary& Objects() noexcept;
    [[nodiscard]] Kernel& Core() noexcept;
    [[nodiscard]] const NodeLatency& Latency() const noexcept;
    [[nodiscard]] SrdoMask Open() noexcept;

    /// @brief Supply on. False: the kernel refuses the device, told in the report.
    [[nodiscard]] bool PowerOn(const InstantPair& now, std::uint64_t now_ns);
    /// @brief A frame of the bus, with its stamp.
    void OnFrame(const host::LiveFrame& frame, CanPortId port, const InstantPair& stamp);
    void OnLoss() noexcept;
    /// @brief How the controllers feel.
    void OnBus(device::BusCondition condition) noexcept;
    /// @brief One cycle of the device; frames up to it were told.
    void Cycle(const InstantPair& now, std::uint64_t now_ns);
    /// @brief What waits, between two cycles.
    void Serve(const InstantPair& now, std::uint64_t now_ns);
    /// @brief Outputs as they are at this instant: some close by themselves.
    void LookAtOutput(std::uint64_t now_ns);
    /// @brief Whether the kernel was started anew since the last call: cycles and watchdog begin anew, at the time that
    /// it is after all that a start takes.
    [[nodiscard]] bool TakeRestart(std::uint64_t now_ns);
    /// @brief LSS gave another node-ID, and communication was reset: this device has ended, one with that node-ID has
    /// to be made. [SRS_NODE_015]
    [[nodiscard]] std::optional<std::uint8_t> NewNodeId() const noexcept;

    /// @brief A save is under way: Serve soon, it takes many steps.
    [[nodiscard]] bool IsSaving() const noexcept;
    /// @brief A person presses the acknowledge button of one SRDO; false: there is no such SRDO.
    [[nodiscard]] bool Acknowledge(std::uint8_t srdo, std::uint64_t now_ns);
    /// @brief Outputs closed, no SRDO any more.
    void Stop(std::uint64_t now_ns);

  private:
    void FurnishSelfTest();
    void FollowConfiguration(std::uint64_t now_ns);
    void SendByApplication();
    [[nodiscard]] SrdoMask AcknowledgeLevels(std::uint64_t now_ns) const noexcept;
    void SetTime(std::uint64_t now_ns);
    void TellState(std::uint64_t now_ns);

    NodeReport& report_;
    NodePorts& ports_;
    cia306::Device file_;
    bool has_lss_;
    DeviceModel model_;
    DeviceConfig config_;
    host::VirtualBus time_; ///< Nobody is on it: the time of output and watchdog.
    host::HostWatchdog watchdog_;
    host::HostOutput output_;
    std::unique_ptr<OwnedChannel> channel_a_;
    std::unique_ptr<OwnedChannel> channel_b_;
    NodeApplication application_;
    std::unique_ptr<NodeSelfTest> self_test_; ///< Null: none.
    OutputWatch outputs_;
    NodeLoading loading_;
    DeviceAssembly assembly_;
    NodeTransfers transfers_;
    std::unique_ptr<NodeStore> store_; ///< Null: none.

    std::uint64_t start_ns_{0U};
    std::array<std::uint64_t, kMaxSrdoCount> pressed_until_ns_{};
    cia301::NodeState state_{cia301::NodeState::kInvalid};
    std::uint32_t cycles_per_send_{0U};
    std::uint32_t cycles_to_send_{0U};
};
} // namespace counterpoint::runtime

#endif // RUNTIME_NODE_DEVICE_HPP
