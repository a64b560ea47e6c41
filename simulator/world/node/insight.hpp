// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_NODE_INSIGHT_HPP
#define SIMULATOR_WORLD_NODE_INSIGHT_HPP

#include "runtime/device/model.hpp"
#include "simulator/faults/channel_tap.hpp"
#include "simulator/world/node/pairs.hpp"
#include "simulator/world/node/place.hpp"

#include "hal/api/safety_output.hpp"
#include "safety_core/comparator/comparator.hpp"
#include "safety_core/crosslink/peer.hpp"
#include "safety_core/selftest/self_test.hpp"

#include <array>

namespace counterpoint::simulator
{
/// What a tapped node tells about its inside: each change, once. [SRS_SIM_040]
class NodeInsight final : public ChannelWitness
{
  public:
    /// @brief All outlive it.
    NodeInsight(const NodePlace& place, const runtime::DeviceModel& model, const NodePairs& pairs) noexcept;

    void OnOutcome(Part part, const Channel& channel, const CycleOutcome& outcome) override;
    [[nodiscard]] bool Concerns(const CanFrame& frame) const override;
    /// @brief After a cycle, if the journal keeps all.
    void TellVerdict(const Verdict& verdict);
    void TellPermits(const hal::PermitSet& permits);
    void TellLink(const LinkSupervisor& link);
    void TellSelfTest(selftest::TestId first_failed);
    /// @brief The kernel starts anew.
    void Forget();

  private:
    /// What one channel said last.
    struct Voice
    {
        CycleOutcome outcome{};
        std::array<SrdoState, kMaxSrdoCount> states{};
    };

    void TellStates(Part part, const Channel& channel, Voice& voice);
    void TellCauses(Part part, const Channel& channel, const CycleOutcome& outcome);

    const NodePlace& place_;
    const runtime::DeviceModel& model_;
    const NodePairs& pairs_;
    Voice voice_a_{};
    Voice voice_b_{};
    SrdoMask agreed_{0U};
    SrdoMask matched_{0U};
    SrdoMask permitted_{0U};
    LinkState link_{LinkState::kWaiting};
    bool has_told_test_{false};
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_NODE_INSIGHT_HPP
