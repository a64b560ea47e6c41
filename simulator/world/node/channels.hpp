// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_NODE_CHANNELS_HPP
#define SIMULATOR_WORLD_NODE_CHANNELS_HPP

#include "runtime/device/model.hpp"
#include "runtime/device/owned_channel.hpp"
#include "simulator/faults/channel_tap.hpp"
#include "simulator/scenario/scenario.hpp"

#include "hal/api/watchdog.hpp"
#include "safety_core/crosslink/peer.hpp"

#include <memory>

namespace counterpoint::simulator
{
/// What the core is told of the link. [SRS_SIM_056]
[[nodiscard]] LinkConfig LinkConfigOf(const NodeSetup& setup);

/// What channel taps of a node need; a null witness: it has none.
struct ChannelTaps
{
    PartFaults& faults;
    ChannelWitness* witness;
};

/// The shipped channels of a node; of one CPU of two the one that it runs, and its view of the other CPU. [SRS_SIM_056,
/// SRS_SIM_061]
class NodeChannels
{
  public:
    /// @brief All given outlive it.
    NodeChannels(const NodeSetup& setup, const runtime::DeviceModel& model, const ChannelTaps& taps,
                 hal::Watchdog& watchdog);

    /// @brief What the kernel is given.
    [[nodiscard]] Channel& Voice(runtime::Letter letter) noexcept;
    [[nodiscard]] hal::Watchdog& Supervision() noexcept;
    [[nodiscard]] runtime::OwnedChannel& Owned(runtime::Letter letter) noexcept;
    /// @brief Null: the device has one CPU.
    [[nodiscard]] counterpoint::Peer* Peer() const noexcept
    {
        return peer_.get();
    }

  private:
    [[nodiscard]] Channel& Real(runtime::Letter letter) noexcept;

    hal::Watchdog& watchdog_;
    std::unique_ptr<runtime::OwnedChannel> channel_a_;
    std::unique_ptr<runtime::OwnedChannel> channel_b_;
    ChannelTap tap_a_;
    ChannelTap tap_b_;
    bool is_tapped_;
    std::unique_ptr<counterpoint::Peer> peer_;
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_NODE_CHANNELS_HPP
