// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NODE_DEVICE_HPP
#define RUNTIME_NODE_DEVICE_HPP

#include "runtime/console/node_report.hpp"
#include "runtime/node/application.hpp"
#include "runtime/node/objects/store.hpp"
#include "runtime/node/output_watch.hpp"
#include "runtime/node/ports.hpp"
#include "runtime/node/self_test.hpp"
#include "runtime/node/srdo_report.hpp"
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
#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// What the command line says about a live node.
struct NodeSettings
{
    std::string dcf;
    std::optional<std::uint8_t> node_id;
    std::optional<std::uint32_t> cycle_us; ///< Instead of 5F00h:01.
    std::string store;                     ///< File of 1010h; empty: nothing is saved.
    bool has_lss{false};                   ///< LSS gives the node-ID, also where the file does not say so.
    bool has_self_tests{true};
    std::uint32_t domain_bytes{kDomainBytes};  ///< Room of a DOMAIN that can be written.
    std::optional<std::uint8_t> lss_node_id{}; ///< Node-ID that LSS gave in this run; counts before all others.
    /// Gets what the device refuses of the file: values of services as warnings, all else as errors; null: the report
    /// alone is told.
    std::vector<cia306::Finding>* refused{nullptr};
};

/// Tells what a device refuses of its file.
class NodeRefusals
{
  public:
    /// @brief All outlive it; `list` may be null.
    NodeRefusals(NodeReport& report, const std::string& file, std::vector<cia306::Finding>* list) noexcept;

    /// @brief Values that were refused at `at_ns`.
    void Tell(std::uint64_t at_ns, const std::vector<cia306::Finding>& findings);
    /// @brief The kernel refused the device.
    void TellNoStart(std::uint64_t at_ns, StartResult result);

  private:
    void Keep(const cia306::Finding& finding);

    NodeReport& report_;
    const std::string& file_;
    std::vector<cia306::Finding>* list_;
};

/// A device of a DCF in real time: an assembly with shipped channels, output gate and watchdog of the host, and frames
/// of a live bus. At its resets it tests itself, loads what was saved, and tells each value that is refused. Time comes
/// in with every call. [SRS_NODE_001, SRS_NODE_006, SRS_NODE_012]
class NodeDevice final : private AssemblyOwner
{
  public:
    /// Builds the device; its supply is off. Throws cia306::InputError.
    NodeDevice(const NodeSettings& settings, NodePorts& ports, NodeReport& report);

    /// @brief The description that the kernel has.
    [[nodiscard]] const DeviceConfig& Config() const noexcept
    {
        return config_;
    }
    /// @brief What the file says.
    [[nodiscard]] const DeviceModel& Model() const noexcept
    {
        return model_;
    }
    /// @brief Kernel, dictionary and services, and the device for frames that were lost and the condition of the
    /// controllers.
    [[nodiscard]] DeviceAssembly& Assembly() noexcept
    {
        return assembly_;
    }
    /// @brief SDO transfers and times that it sends by order.
    [[nodiscard]] NodeTransfers& Transfers() noexcept
    {
        return transfers_;
    }
    /// @brief Its application.
    [[nodiscard]] NodeApplication& App() noexcept
    {
        return application_;
    }
    /// @brief Its outputs, and the times from reception to released output.
    [[nodiscard]] const OutputWatch& Outputs() const noexcept
    {
        return outputs_;
    }
    /// @brief Tells what it is, on which buses, what is tested and what its SRDOs are. Before PowerOn.
    void TellStart(const std::string& buses, std::uint64_t now_ns);
    /// @brief Switches the supply on. False: the kernel refused the device, which the report tells.
    [[nodiscard]] bool PowerOn(const InstantPair& now, std::uint64_t now_ns);
    /// @brief A frame of the bus with its stamp.
    void OnFrame(const host::LiveFrame& frame, CanPortId port, const InstantPair& stamp);
    /// @brief One cycle of the device; all frames up to `now` were told before.
    void Cycle(const InstantPair& now, std::uint64_t now_ns);
    /// @brief Serves what waits, between two cycles.
    void Serve(const InstantPair& now, std::uint64_t now_ns);
    /// @brief Looks at the outputs at this instant: some close by themselves.
    void LookAtOutput(std::uint64_t now_ns);
    /// @brief Whether the kernel was started again since the last call. Cycles and watchdog then begin again at
    /// `now_ns`, which is after the start has ended.
    [[nodiscard]] bool TakeRestart(std::uint64_t now_ns);
    /// @brief Whether a save is under way: Serve should be called soon, because it takes many steps. A reset
    /// waits for its end. [SRS_DEV_025]
    [[nodiscard]] bool IsSaving() const noexcept override;
    /// @brief A person presses the acknowledge button of an SRDO. False: there is no such SRDO.
    [[nodiscard]] bool Acknowledge(std::uint8_t srdo, std::uint64_t now_ns);
    /// @brief Closes the outputs and sends no SRDO any more.
    void Stop(std::uint64_t now_ns);

  private:
    void OnStart() noexcept override;
    void OnNoStart(StartResult result) noexcept override;
    void OnLoaded(std::uint8_t groups) noexcept override;
    void OnRefused(const ConfigurationWrite& write, AbortCode code) noexcept override;
    void OnResetCommunication(const std::vector<cia306::Finding>& refusals) noexcept override;
    void OnTime(const cia301::TimeOfDay& time, Instant now) noexcept override;
    void OnEmergency(const cia301::ReceivedEmergency& emergency) noexcept override;
    void TellSelfTest();
    void FurnishSelfTest();
    void FollowConfiguration(std::uint64_t now_ns, bool is_told_invalid);
    void SendByApplication();
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
    SrdoReport srdos_;
    DeviceAssembly assembly_;
    NodeTransfers transfers_;
    std::unique_ptr<NodeStore> store_; ///< Null: none.

    NodeRefusals refusals_;
    std::string store_warning_; ///< The last one that was told.
    std::uint64_t start_ns_{0U};
    std::uint64_t now_ns_{0U}; ///< Of what is told next.
    std::array<std::uint64_t, kMaxSrdoCount> pressed_until_ns_{};
    cia301::NodeState state_{cia301::NodeState::kInvalid};
    std::uint8_t node_id_{0U}; ///< With which it was on the bus; 0: none.
    bool has_restarted_{false};
    bool has_reset_{false}; ///< States and values count as not told yet.
    bool has_told_test_{false};
    std::uint32_t cycles_per_send_{0U};
    std::uint32_t cycles_to_send_{0U};
};
} // namespace counterpoint::runtime

#endif // RUNTIME_NODE_DEVICE_HPP
