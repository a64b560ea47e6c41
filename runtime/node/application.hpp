// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NODE_APPLICATION_HPP
#define RUNTIME_NODE_APPLICATION_HPP

#include "runtime/console/node_report.hpp"

#include "runtime/device/model.hpp"
#include "runtime/device/pair_logic.hpp"
#include "safety_core/kernel/application.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>

namespace counterpoint::runtime
{
/// The application of a live node. It does with its pairs what a simulated application does, and writes a line for each
/// thing that the kernel tells it. [SRS_NODE_003, SRS_NODE_004]
class NodeApplication final : public Application
{
  public:
    /// Is told of each pair that was released or confirmed.
    using OnPair = std::function<void(std::uint8_t srdo)>;

    /// @brief All outlive it; `file` is what the model was made of.
    NodeApplication(const runtime::DeviceModel& model, const cia306::Device& file, NodeReport& report);

    /// @brief Whom to tell of pairs.
    void Tell(OnPair on_pair);
    /// @brief Takes the pairs as the SRDOs are configured now, whoever configured them. Call it on entering
    /// OPERATIONAL. [SRS_NODE_019]
    void Follow(Kernel& kernel, const runtime::DeviceModel& model);
    /// @brief Adds a rule, if the device can follow it. [SRS_NODE_160]
    [[nodiscard]] RuleFinding AddRule(const LogicRule& rule);
    /// @brief Whether a rule computes this object. [SRS_NODE_710]
    [[nodiscard]] bool IsComputed(const ObjectAddress& object) const noexcept
    {
        return logic_.IsComputed(object);
    }
    /// @brief The highest pattern of bits that an input takes; nothing: there is no such input. [SRS_NODE_531]
    [[nodiscard]] std::optional<std::uint64_t> HighestInput(const ObjectAddress& object) const;
    /// @brief Sets an input: the normal object of a producer, as configured or as in the file. False: there is no such
    /// input.
    [[nodiscard]] bool SetInput(const ObjectAddress& object, std::uint64_t value);
    /// @brief The file that says which types its objects have.
    [[nodiscard]] const cia306::Device& File() const noexcept
    {
        return file_;
    }
    /// @brief Sets the time of what the kernel tells next.
    void SetNow(std::uint64_t now_ns) noexcept
    {
        now_ns_ = now_ns;
    }
    /// @brief Reads the consumers, whose outputs are open as `open` says, applies the rules, and writes the producers.
    /// Once a cycle.
    void Run(SrdoMask open);
    /// @brief Writes the producers as inputs and rules are now; `Run` does it, too.
    void WriteOut();
    /// @brief Whether an input of a producer changed since the last call.
    [[nodiscard]] bool TakeChange() noexcept
    {
        return logic_.TakeChange();
    }
    /// @brief Whether the kernel has told since the last call that the configuration does not hold. [SRS_NODE_053]
    [[nodiscard]] bool TakeInvalid() noexcept
    {
        return std::exchange(has_told_invalid_, false);
    }
    /// @brief The values of all pairs: "2200:01=1 ...".
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

    const cia306::Device& file_;
    NodeReport& report_;
    OnPair on_pair_;
    runtime::PairLogic logic_;
    std::uint64_t now_ns_{0U};
    bool has_told_invalid_{false};
};
} // namespace counterpoint::runtime

#endif // RUNTIME_NODE_APPLICATION_HPP
