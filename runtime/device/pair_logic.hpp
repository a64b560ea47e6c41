// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_DEVICE_PAIR_LOGIC_HPP
#define RUNTIME_DEVICE_PAIR_LOGIC_HPP

#include "runtime/device/logic_rule.hpp"
#include "runtime/device/model.hpp"

#include "safety_core/kernel/kernel.hpp"
#include "safety_core/kernel/variable.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace counterpoint::runtime
{
/// Which objects of its pairs an application has: with two CPUs each CPU has one half.
enum class Half : std::uint8_t
{
    kBoth = 0U,
    kNormal = 1U,
    kInverse = 2U,
};

/// The values of one pair of objects; the normal and the inverse path keep them apart.
struct PairValue
{
    VariablePlace normal_place{nullptr, 0U};
    VariablePlace inverse_place{nullptr, 0U};
    ObjectAddress address{0U, 0U}; ///< Address of the normal object.
    std::uint64_t mask{0U};
    std::uint64_t normal{0U};
    std::uint64_t inverse{0U};
    std::uint64_t safe{0U};
    std::uint64_t disturbance{0U}; ///< Bits that the inverse path computes wrong.
    SrdoMask slot{0U};
    std::uint8_t srdo{0U};
    bool is_consumer{false};
    bool is_mapped{true}; ///< An SRDO that is on maps it; before Follow: the file maps it.
};

/// What the application of a simulated or live device does with its pairs. Producer: the normal object holds the input,
/// and the inverse object is computed from it by another path. Consumer: a pair counts only while its two objects are
/// inverse and the output of its SRDO is open. Logic rules compute producers from consumers.
class PairLogic
{
  public:
    /// Is told of a consumer whose value has changed.
    using OnValue = std::function<void(const PairValue&)>;

    /// @brief With the pairs that the DCF maps.
    PairLogic(const DeviceModel& model, Half half);

    /// @brief Takes the pairs as the SRDOs are configured now, whoever configured them. New pairs come behind the known
    /// ones; pairs that no SRDO has any more rest. Call it on entering OPERATIONAL. [SRS_NODE_019]
    void Follow(Kernel& kernel, const DeviceModel& model);
    /// @brief All pairs.
    [[nodiscard]] const std::vector<PairValue>& Pairs() const noexcept;
    /// @brief The pair of this normal object, if possible one that is mapped; null: there is none.
    [[nodiscard]] const PairValue* Find(const ObjectAddress& normal) const noexcept;
    /// @brief Adds a rule, if the device can follow it. [SRS_NODE_160]
    [[nodiscard]] RuleFinding AddRule(const LogicRule& rule);
    /// @brief Whether a rule computes this object, so that an input of it would not last. [SRS_NODE_710]
    [[nodiscard]] bool IsComputed(const ObjectAddress& normal) const noexcept;
    /// @brief Sets an input; the object is one of a pair, and the value is cut to its bits.
    void SetInput(const ObjectAddress& normal, std::uint64_t value) noexcept;
    /// @brief From now on the inverse path of that pair computes these bits wrongly; 0: none.
    void Disturb(const ObjectAddress& normal, std::uint64_t bits) noexcept;
    /// @brief Reads the pairs of consumers, whose outputs are open as `open` says, then applies the rules. Tells the
    /// consumers' values that have changed.
    void Take(SrdoMask open, const OnValue& on_value);
    /// @brief Writes the two objects of a producer.
    void Write(const PairValue& pair) const noexcept;
    /// @brief Whether any input of a producer changed since the last call.
    [[nodiscard]] bool TakeChange() noexcept;

  private:
    struct Rule
    {
        std::size_t target{0U};
        LogicOperation operation{LogicOperation::kCopy};
        std::vector<std::size_t> inputs;
    };

    /// Two entries of a mapping.
    struct MappedPair
    {
        VariablePlace normal{nullptr, 0U};
        VariablePlace inverse{nullptr, 0U};
        ObjectAddress address{0U, 0U};
    };

    void FollowSrdo(Kernel& kernel, const DeviceConfig& config, SlotIndex slot, std::uint8_t number);
    [[nodiscard]] PairValue& TakeMapped(const MappedPair& mapped);
    [[nodiscard]] std::size_t IndexOf(const ObjectAddress& normal) const noexcept;
    void TakePair(PairValue& pair, SrdoMask open, const OnValue& on_value) const;
    void Apply(const Rule& rule);

    Half half_;
    std::vector<PairValue> pairs_;
    std::vector<Rule> rules_;
    bool has_changed_{false};
};
} // namespace counterpoint::runtime

#endif // RUNTIME_DEVICE_PAIR_LOGIC_HPP
