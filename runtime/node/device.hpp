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
/// A device of a DCF in real time: an assembly with shipped channels, output gate and watchdog of the host, and frames
/// of a live bus. Time comes in with every call. [SRS_NODE_001, SRS_NODE_006]
class NodeDevice final
{
  public:
    /// Builds the device; its supply is off. Throws cia306::InputError.
    NodeDevice(const NodeSettings& settings, NodePorts& ports, NodeReport& report);

    /// @brief The description that the kernel has.
    [[nodiscard]] const DeviceConfig& Config() const noexcept;
    /// @brief What the file says.
    [[nodiscard]] const DeviceModel& Model() const noexcept;
    /// @brief Its self tests; null: they are left out.
    [[nodiscard]] const NodeSelfTest* SelfTests() const noexcept;
    /// @brief SDO transfers and times that it sends by order.
    [[nodiscard]] NodeTransfers& Transfers() noexcept;
    /// @brief The present node-ID; 0: LSS has not given one yet.
    [[nodiscard]] std::uint8_t NodeId() const noexcept;
    /// @brief Its application.
    [[nodiscard]] NodeApplication& App() noexcept;
    /// @brief NMT and services.
    [[nodiscard]] device::Device& Services() noexcept;
    /// @brief Its object dictionary.
    [[nodiscard]] cia301::Dictionary& Objects() noexcept;
    /// @brief Its kernel.
    [[nodiscard]] Kernel& Core() noexcept;
    /// @brief Times from reception to released output.
    [[nodiscard]] const NodeLatency& Latency() const noexcept;
    /// @brief Slots whose outputs are open.
    [[nodiscard]] SrdoMask Open() noexcept;

    /// @brief Switches the supply on. False: the kernel refused the device, which the report tells.
    [[nodiscard]] bool PowerOn(const InstantPair& now, std::uint64_t now_ns);
    /// @brief A frame of the bus with its stamp.
    void OnFrame(const host::LiveFrame& frame, CanPortId port, const InstantPair& stamp);
    /// @brief Frames were lost.
    void OnLoss() noexcept;
    /// @brief The condition of the controllers.
    void OnBus(device::BusCondition condition) noexcept;
    /// @brief One cycle of the device; all frames up to `now` were told before.
    void Cycle(const InstantPair& now, std::uint64_t now_ns);
    /// @brief Serves what waits, between two cycles.
    void Serve(const InstantPair& now, std::uint64_t now_ns);
    /// @brief Looks at the outputs at this instant: some close by themselves.
    void LookAtOutput(std::uint64_t now_ns);
    /// @brief Whether the kernel was started again since the last call. Cycles and watchdog then begin again at
    /// `now_ns`, which is after the start has ended.
    [[nodiscard]] bool TakeRestart(std::uint64_t now_ns);
    /// @brief The node-ID, if LSS gave another one and communication was reset: this device has ended, and a new one
    /// with this node-ID has to be made. [SRS_NODE_015]
    [[nodiscard]] std::optional<std::uint8_t> NewNodeId() const noexcept;

    /// @brief Whether a save is under way: Serve should be called soon, because it takes many steps.
    [[nodiscard]] bool IsSaving() const noexcept;
    /// @brief A person presses the acknowledge button of an SRDO. False: there is no such SRDO.
    [[nodiscard]] bool Acknowledge(std::uint8_t srdo, std::uint64_t now_ns);
    /// @brief Closes the outputs and sends no SRDO any more.
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
