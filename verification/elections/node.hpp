// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_ELECTIONS_NODE_HPP
#define VERIFICATION_ELECTIONS_NODE_HPP

#include "canopen/cia302/flying_master/flying_master.hpp"
#include "verification/elections/bus.hpp"
#include "verification/elections/network_side.hpp"
#include "verification/elections/node_clock.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

namespace counterpoint::elections
{

/// A device with a flying master: cycle, heartbeat, controller; with a whole manager around it where the plan says so.
class Node final : public cia301::FrameSink, public cia302::FlyingMasterListener
{
  public:
    /// @brief What it does at `now`, when it has a cycle or something to do before its next one.
    void Cycle(Time now);
    /// @brief A frame from the bus.
    void Hear(const CanFrame& frame, Time now);
    /// @brief The oldest of its frames was on the bus.
    void OnSent();
    /// @brief The controller went bus-off; it comes back at `recovers_at`.
    void OnBusOff(Time now);
    /// @brief When it does something next; `earliest`: behind `now` when its cycle at `now` is over.
    [[nodiscard]] Time Next(Time now, Time earliest) const;

    bool Send(const CanFrame& frame) noexcept override;
    void OnFlyingMaster(cia302::FlyingEvent event, const cia302::MasterClaim& claim, Instant now) noexcept override;
    void OnInitialising(Instant now) noexcept override;

    Bus* bus{nullptr};
    std::size_t index{0U}; ///< On the bus.
    MasterPlan plan{};
    NodeClock clock{};
    Time heartbeat{0};
    cia302::NetworkSetup setup{};
    std::optional<cia302::FlyingMaster> master{};
    std::unique_ptr<NetworkSide> network{}; ///< Behind `master`, which it drives; null: no manager.
    bool has_manager{false};
    std::deque<CanFrame> to_send{}; ///< Of a manager: its controller sends in the order of the calls.
    std::vector<CanFrame> heard{};  ///< Not yet handled, with WorldPlan::polls.
    Time power_on{0};
    Time recovers_at{kNever};
    Time heartbeat_at{kNever};
    std::uint32_t configuration_errors{0U}; ///< That the world has not counted yet.
    std::uint8_t part{0U};
    bool is_on{false};
    bool was_active{false};
    std::uint8_t known{0U}; ///< The master that it follows.

  private:
    void PowerOn(Time now);
    void Start(Time now);
};

} // namespace counterpoint::elections

#endif
