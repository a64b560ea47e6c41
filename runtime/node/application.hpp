// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NODE_APPLICATION_HPP
#define RUNTIME_NODE_APPLICATION_HPP

#include "runtime/console/node_report.hpp"

#include "runtime/device/model.hpp"
#include "runtime/device/pair_logic.hpp"
#include "safety_core/kernel/application.hpp"

#include <cstdint>
#include <functional>
#include <string>

namespace counterpoint::runtime
{
/// The application of a live node: what it does with its pairs is that of a simulated one, what the kernel tells it is
/// a line. [SRS_NODE_003, SRS_NODE_004]
class NodeApplication final : public Application
{
  public:
    /// Is told of each pair that was released or confirmed.
    using OnPair = std::function<void(std::uint8_t srdo)>;

    NodeApplication(const runtime::DeviceModel& model, NodeReport& report);

    void Tell(OnPair on_pair);
    /// @brief Pairs as the SRDOs are configured now, whoever did it. On entering OPERATIONAL. [SRS_NODE_019]
    void Follow(Kernel& kernel, const runtime::DeviceModel& model);
    /// @brief Whether the rule's objects are pairs of this device: the target of a producer.
    [[nodiscard]] bool AddRule(const runtime::LogicRule& rule);
    /// @brief Whether there is such an input: the normal object of a producer, whose configuration is followed or that
    /// of the file.
    [[nodiscard]] bool SetInput(const ObjectAddress& object, std::uint64_t value);
    /// @brief Time of what the kernel tells next.
    void SetNow(std::uint64_t now_ns) noexcept
    {
        now_ns_ = now_ns;
    }
    /// @brief Takes consumers with the outputs as they are, then the rules, then writes the producers.
    void Run(SrdoMask open);
    /// @brief Whether an input of a producer changed since the last call.
    [[nodiscard]] bool TakeChange() noexcept;
    /// @brief "2200:01=1 ..." of all pairs.
    [[nodiscard]] std::string Values() const;

    [[nodiscard]] RefreshAnswer OnRefresh(CommunicationIndex index) noexcept override;
    void OnSrdoEvent(CommunicationIndex index) noexcept override;
    void OnSrdoError(CommunicationIndex index, SrdoCause cause) noexcept override;
    void OnGfc() noexcept override;
    void OnGfcNotFollowed() noexcept override;
    void OnConfigurationInvalid(CommunicationIndex index) noexcept override;
    void OnDeviceFault(const DeviceFaultReport& report) noexcept override;
    void OnFlow(const FlowCount& count) noexcept override;

  private:
    void TellValue(const runtime::PairValue& pair);

    NodeReport& report_;
    OnPair on_pair_;
    runtime::PairLogic logic_;
    std::uint64_t now_ns_{0U};
};
} // namespace counterpoint::runtime

#endif // RUNTIME_NODE_APPLICATION_HPP
