// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_NODE_APPLICATION_HPP
#define TOOLS_NODE_APPLICATION_HPP

#include "tools/node_report.hpp"

#include "safety_core/kernel/application.hpp"
#include "safety_core/kernel/variable.hpp"
#include "verification/simulator/device_model.hpp"
#include "verification/simulator/scenario.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace counterpoint::tools
{
/// The application of a live node. Inputs go into the producers' normal objects, and by another path into the inverse
/// ones; what consumers release counts while its two objects are inverse and the output of its SRDO is open; rules join
/// the two. [SRS-NODE-003, SRS-NODE-004]
class NodeApplication final : public Application
{
  public:
    /// Is told of each pair that was released or confirmed.
    using OnPair = std::function<void(std::uint8_t srdo)>;

    NodeApplication(const simulator::DeviceModel& model, NodeReport& report);

    void Tell(OnPair on_pair);
    /// @brief Pairs as the SRDOs are configured now, whoever did it: new ones come behind those that are known, and
    /// those that no SRDO has any more rest. On entering OPERATIONAL. [SRS-NODE-019]
    void Follow(Kernel& kernel, const simulator::DeviceModel& model);
    /// @brief Whether the rule's objects are pairs of this device: the target of a producer.
    [[nodiscard]] bool AddRule(const simulator::LogicRule& rule);
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
    /// One pair of objects. Both paths keep a value of their own.
    struct Pair
    {
        VariablePlace normal_place{nullptr, 0U};
        VariablePlace inverse_place{nullptr, 0U};
        ObjectAddress address{0U, 0U};
        std::uint64_t mask{0U};
        std::uint64_t normal{0U};
        std::uint64_t inverse{0U};
        std::uint64_t safe{0U};
        SlotIndex slot{0U};
        std::uint8_t srdo{0U};
        bool is_consumer{false};
        bool is_mapped{true}; ///< By an SRDO that is on, or by the file while nothing was followed yet.
    };
    /// Two entries of a mapping.
    struct MappedPair
    {
        VariablePlace normal{nullptr, 0U};
        VariablePlace inverse{nullptr, 0U};
        ObjectAddress address{0U, 0U};
    };
    struct Rule
    {
        std::size_t target{0U};
        simulator::LogicOperation operation{simulator::LogicOperation::kCopy};
        std::vector<std::size_t> inputs;
    };

    [[nodiscard]] std::size_t Find(const ObjectAddress& normal) const;
    void FollowSrdo(Kernel& kernel, const DeviceConfig& config, SlotIndex slot, std::uint8_t number);
    [[nodiscard]] Pair& Take(const MappedPair& mapped);
    static void SetSafe(Pair& pair, const Payload& safe, std::uint32_t first_bit);
    void TakePair(Pair& pair, SrdoMask open);
    void Apply(const Rule& rule);
    void TellValue(const Pair& pair);

    NodeReport& report_;
    OnPair on_pair_;
    std::vector<Pair> pairs_;
    std::vector<Rule> rules_;
    std::uint64_t now_ns_{0U};
    bool has_changed_{false};
};
} // namespace counterpoint::tools

#endif // TOOLS_NODE_APPLICATION_HPP
