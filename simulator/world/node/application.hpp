// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_NODE_APPLICATION_HPP
#define SIMULATOR_WORLD_NODE_APPLICATION_HPP

#include "runtime/device/model.hpp"
#include "runtime/device/pair_logic.hpp"
#include "simulator/faults/part_faults.hpp"
#include "simulator/world/node/place.hpp"

#include "safety_core/kernel/application.hpp"
#include "safety_core/kernel/kernel.hpp"

#include <array>
#include <cstdint>

namespace counterpoint::simulator
{
/// The application of a simulated node: what it does with its pairs is PairLogic, what the kernel tells it is noted.
/// [SRS_SIM_006, SRS_SIM_007]
class NodeApplication final : public Application
{
  public:
    /// @brief All given outlive it.
    NodeApplication(const NodePlace& place, const runtime::DeviceModel& model, runtime::Half half, PartFaults& faults);

    /// @brief Where details of a device fault are read from.
    void Join(const Kernel& kernel) noexcept
    {
        kernel_ = &kernel;
    }
    /// @brief Its pairs and rules.
    [[nodiscard]] runtime::PairLogic& Logic() noexcept
    {
        return logic_;
    }
    void SetInput(const ObjectAddress& object, std::uint64_t value);
    /// @brief From now on the inverse path computes these bits wrong; 0: none.
    void Disturb(const ObjectAddress& object, std::uint64_t bits);
    /// @brief Somebody presses the acknowledge input of an SRDO, or lets it go who pressed it before.
    void SetAcknowledge(std::uint8_t srdo, bool level);
    /// @brief The acknowledge inputs as one channel gets them; they may be frozen.
    [[nodiscard]] SrdoMask AcknowledgeFor(Part part);
    /// @brief Takes the consumers' pairs with the outputs as they are now, then the rules, then writes all producers.
    /// A frozen application leaves the producers' objects as they are.
    void Run(SrdoMask open);
    /// @brief Writes the producers' objects as the inputs and rules are now; `Run` does it, too.
    void WriteOut();
    /// @brief Without supply no value counts.
    void PowerOff()
    {
        logic_.Take(0U, on_value_);
    }
    /// @brief What the application uses of a consumer that is safe.
    [[nodiscard]] std::uint64_t SafeValueOf(const ObjectAddress& normal) const;

    /// @brief The kernel starts anew; what it told before is forgotten.
    void ForgetFault() noexcept
    {
        knows_fault_ = false;
    }
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

    const NodePlace& place_;
    const runtime::DeviceModel& model_;
    PartFaults& faults_;
    runtime::PairLogic logic_;
    const runtime::PairLogic::OnValue on_value_;
    const Kernel* kernel_{nullptr};
    SrdoMask acknowledge_{0U};
    std::array<std::uint32_t, kMaxSrdoCount> presses_{}; ///< Of each slot: how many press its acknowledge input.
    SrdoMask seen_a_{0U};                                ///< Acknowledge inputs that the channels got last.
    SrdoMask seen_b_{0U};
    bool knows_fault_{false};
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_NODE_APPLICATION_HPP
