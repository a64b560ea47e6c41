// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_NODE_PAIRS_HPP
#define SIMULATOR_WORLD_NODE_PAIRS_HPP

#include "runtime/device/model.hpp"
#include "simulator/world/node/place.hpp"

#include "safety_core/contract/can_frame.hpp"
#include "safety_core/kernel/kernel.hpp"

#include <array>
#include <cstdint>

namespace counterpoint::simulator
{
/// What came behind a good pair. Of each the first one, whatever came after it.
struct BehindPair
{
    Nanoseconds next_normal{-1};   ///< Normal frame.
    Nanoseconds wrong_inverse{-1}; ///< Inverse frame that made no valid pair.
};

/// Frames of one SRDO as this node got them: what limits are counted from. [SRS_SIM_031, SRS_SIM_082, SRS_SIM_214]
struct PairTimes
{
    Nanoseconds last_good_normal{-1}; ///< Normal frame of the last complete valid pair.
    BehindPair behind_good{};         ///< Behind that pair.
    Nanoseconds judged_normal{-1};    ///< Likewise, of those that a cycle has looked at.
    BehindPair behind_judged{};       ///< Behind that one.
    Nanoseconds pending{-1};
    Payload data{};
    std::uint8_t length_bytes{0U};
};

/// The pairs that a node's consumers get, independent of both channels: a pair is good when it is complete, in order
/// and inverse over all its bytes.
class NodePairs
{
  public:
    /// @brief With the identifiers of the file. Both outlive it.
    NodePairs(const NodePlace& place, const runtime::DeviceModel& model);

    /// @brief Identifiers as they are configured now: what a manager may have written.
    void Follow(Kernel& kernel);
    /// @brief kNoSlot: the frame is no consumer's.
    [[nodiscard]] SlotIndex ConsumerOf(const CanFrame& frame) const;
    /// @brief A frame that this node got.
    void OnFrame(const CanFrame& frame);
    /// @brief A cycle has ended: it has seen what came before it.
    void OnCycle();
    [[nodiscard]] const PairTimes& TimesOf(SlotIndex slot) const
    {
        return times_.at(slot);
    }
    void Forget()
    {
        times_.fill(PairTimes{});
    }

  private:
    void TakeIdentifier(std::uint32_t identifier, SlotIndex slot);

    const NodePlace& place_;
    const runtime::DeviceModel& model_;
    std::array<SlotIndex, kSrdoIdentifierCount> slot_of_{}; ///< By identifier.
    std::array<PairTimes, kMaxSrdoCount> times_{};
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_NODE_PAIRS_HPP
