// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_NODE_APPLICATION_HPP
#define SIMULATOR_WORLD_NODE_APPLICATION_HPP

#include "runtime/device/model.hpp"
#include "runtime/device/pair_logic.hpp"
#include "simulator/journal/journal.hpp"

#include "safety_core/kernel/application.hpp"
#include "safety_core/kernel/kernel.hpp"

#include <cstdint>

namespace counterpoint::simulator
{
/// The application of a simulated node: what it does with its pairs is PairLogic, what the kernel tells it is noted.
/// [SRS_SIM_006, SRS_SIM_007]
class NodeApplication final : public Application
{
  public:
    NodeApplication(NodeIndex node, const runtime::DeviceModel& model, Journal& journal, runtime::Half half);

    /// @brief Where details of a device fault are read from.
    void Join(const Kernel& kernel) noexcept;
    /// @brief The rule's objects exist; see Network.
    void AddRule(const runtime::LogicRule& rule);
    /// @brief Pairs as the SRDOs are configured now. On entering OPERATIONAL.
    void Follow(Kernel& kernel, const runtime::DeviceModel& model);
    void SetInput(const ObjectAddress& object, std::uint64_t value);
    /// @brief From now on the inverse path computes these bits wrong; 0: none.
    void Disturb(const ObjectAddress& object, std::uint64_t bits);
    /// @brief Time for what the kernel tells during the cycle to come.
    void SetNow(Nanoseconds now) noexcept;
    /// @brief Takes the consumers' pairs with the outputs as they are now, then the rules, then writes all producers.
    /// A frozen application leaves the producers' objects as they are; true when that made a difference.
    bool Run(SrdoMask open, Nanoseconds now, bool is_frozen);
    /// @brief What the application uses of a consumer, or its input of a producer.
    [[nodiscard]] std::uint64_t ValueOf(const ObjectAddress& normal) const;
    /// @brief What the application uses of a consumer that is safe.
    [[nodiscard]] std::uint64_t SafeValueOf(const ObjectAddress& normal) const;
    /// @brief Whether any input of an SRDO changed since the last call; for applications that send by themselves.
    [[nodiscard]] bool TakeChange();
    /// @brief Since when the disturbance has been in the objects; kNever: not yet.
    [[nodiscard]] Nanoseconds DisturbedAt() const noexcept;

    /// @brief The kernel starts anew: it has told nothing.
    void ForgetFault() noexcept;
    /// @brief What OnDeviceFault would have been told by a kernel that could call it.
    void NoteUntold(const DeviceFaultReport& report) noexcept;

    [[nodiscard]] RefreshAnswer OnRefresh(CommunicationIndex index) noexcept override;
    void OnSrdoEvent(CommunicationIndex index) noexcept override;
    void OnSrdoError(CommunicationIndex index, SrdoCause cause) noexcept override;
    void OnGfc() noexcept override;
    void OnGfcNotFollowed() noexcept override;
    void OnConfigurationInvalid(CommunicationIndex index) noexcept override;
    void OnDeviceFault(const DeviceFaultReport& report) noexcept override;
    void OnFlow(const FlowCount& count) noexcept override;

  private:
    [[nodiscard]] const runtime::PairValue& PairAt(const ObjectAddress& object) const;
    [[nodiscard]] Event At(EventKind kind, CommunicationIndex index, std::uint64_t value) const;

    NodeIndex node_;
    const DeviceConfig& config_;
    Journal& journal_;
    runtime::PairLogic logic_;
    const Kernel* kernel_{nullptr};
    Nanoseconds now_{0};
    Nanoseconds disturbed_at_{kNever};
    bool knows_fault_{false};
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_NODE_APPLICATION_HPP
