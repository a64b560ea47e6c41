// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_SIMULATOR_NODE_APPLICATION_HPP
#define VERIFICATION_SIMULATOR_NODE_APPLICATION_HPP

#include "verification/simulator/device_model.hpp"
#include "verification/simulator/journal.hpp"

#include "safety_core/kernel/application.hpp"
#include "safety_core/kernel/kernel.hpp"
#include "safety_core/kernel/variable.hpp"

#include <cstdint>
#include <vector>

namespace counterpoint::simulator
{
/// What of its pairs an application has: on a CPU of two its own half.
enum class Half : std::uint8_t
{
    kBoth = 0U,
    kNormal = 1U,
    kInverse = 2U,
};

/// The application of a simulated node. Producers: the normal objects hold the input, the inverse objects are computed
/// from the input by another path. Consumers: a pair counts only while its two objects are inverse and the output of
/// its SRDO is open. Logic rules join the two. [SRS-SIM-006, SRS-SIM-007]
class NodeApplication final : public Application
{
  public:
    NodeApplication(NodeIndex node, const DeviceModel& model, Journal& journal, Half half);

    /// @brief Where details of a device fault are read from.
    void Join(const Kernel& kernel) noexcept;
    /// @brief The rule's objects exist; see Network.
    void AddRule(const LogicRule& rule);
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
    /// One pair of objects: the two paths hold their values apart.
    struct PairState
    {
        VariablePlace normal_place{nullptr, 0U};
        VariablePlace inverse_place{nullptr, 0U};
        ObjectAddress address{0U, 0U};
        std::uint64_t mask{0U};
        std::uint64_t normal{0U};
        std::uint64_t inverse{0U};
        std::uint64_t safe{0U};
        std::uint64_t disturbance{0U};
        SrdoMask slot{0U};
        std::uint32_t first_bit{0U};
        std::uint8_t srdo{0U};
        bool is_consumer{false};
    };
    struct Rule
    {
        std::size_t target{0U};
        LogicOperation operation{LogicOperation::kCopy};
        std::vector<std::size_t> inputs;
    };

    [[nodiscard]] std::size_t IndexOf(const ObjectAddress& normal) const;
    void SetSafeValues();
    void TakePair(PairState& pair, SrdoMask open, Nanoseconds now);
    void Apply(const Rule& rule);
    void Write(PairState& pair, Nanoseconds now);
    [[nodiscard]] Event At(EventKind kind, CommunicationIndex index, std::uint64_t value) const;

    NodeIndex node_;
    Half half_;
    const DeviceConfig& config_;
    Journal& journal_;
    std::vector<PairState> pairs_;
    std::vector<Rule> rules_;
    const Kernel* kernel_{nullptr};
    Nanoseconds now_{0};
    Nanoseconds disturbed_at_{kNever};
    bool has_changed_{false};
    bool knows_fault_{false};
};
} // namespace counterpoint::simulator

#endif // VERIFICATION_SIMULATOR_NODE_APPLICATION_HPP
