// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NODE_LOADING_HPP
#define RUNTIME_NODE_LOADING_HPP

#include "runtime/console/node_report.hpp"
#include "runtime/node/objects/store.hpp"
#include "runtime/node/self_test.hpp"

#include "runtime/device/assembly.hpp"
#include "runtime/device/model.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// What a live node does at its resets besides loading its file: self tests, saved values, and a line for each value
/// that is refused and for what its services hear. [SRS_NODE_001, SRS_NODE_012]
class NodeLoading final : public AssemblyOwner
{
  public:
    /// All outlive it. `self_test` null: the device has none.
    NodeLoading(const DeviceModel& model, NodeSelfTest* self_test, NodeReport& report);

    /// @brief Where saved values are loaded from. Before power-on.
    void Use(NodeStore& store) noexcept
    {
        store_ = &store;
    }
    /// @brief Time of what is told next.
    void SetNow(std::uint64_t now_ns) noexcept
    {
        now_ns_ = now_ns;
    }
    /// @brief Tells once when a self test has failed. Call it once a cycle: a cycle that a self test ends before any
    /// part is called tells nobody.
    void TellSelfTest();
    /// @brief Whether the kernel was started again since the last call.
    [[nodiscard]] bool TakeRestart() noexcept;
    /// @brief Whether communication was reset since the last call: states and values count as not told yet.
    [[nodiscard]] bool TakeReset() noexcept;

    void OnStart() noexcept override;
    void OnNoStart(StartResult result) noexcept override;
    void OnLoaded(std::uint8_t groups) noexcept override;
    void OnRefused(const ConfigurationWrite& write, AbortCode code) noexcept override;
    void OnResetCommunication(const std::vector<std::string>& refusals) noexcept override;
    void OnTime(const cia301::TimeOfDay& time, Instant now) noexcept override;
    void OnEmergency(const cia301::ReceivedEmergency& emergency) noexcept override;

  private:
    const DeviceModel& model_;
    NodeSelfTest* self_test_;
    NodeStore* store_{nullptr};
    NodeReport& report_;
    std::string store_warning_; ///< The last one that was told.
    std::uint64_t now_ns_{0U};
    bool has_restarted_{false};
    bool has_reset_{false};
    bool has_told_test_{false};
};
} // namespace counterpoint::runtime

#endif // RUNTIME_NODE_LOADING_HPP
