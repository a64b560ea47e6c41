// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_ELECTIONS_WORLD_HPP
#define VERIFICATION_ELECTIONS_WORLD_HPP

#include "simulator/faults/random.hpp"
#include "verification/elections/bus.hpp"
#include "verification/elections/node.hpp"
#include "verification/elections/world_plan.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

namespace counterpoint::elections
{

/// What was seen in a run, or since Forget.
struct Seen
{
    Time last_change{0};      ///< Some master began or ended, or a standby changed its master.
    Time longest_two{0};      ///< Longest time with two active masters on one bus.
    std::uint32_t resets{0U}; ///< Reset communication of all nodes.
    std::uint32_t forces{0U}; ///< 076h.
    std::uint32_t bus_offs{0U};
    std::uint32_t configuration_errors{0U};
};

/// Flying masters on one bus, or on two parts of it, with the complete product code of each. Deterministic.
class World final : private BusUser
{
  public:
    explicit World(const WorldPlan& plan);
    ~World() override = default;
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    /// @brief A new run; nobody is on before its `power_on`.
    void Begin(const std::vector<MasterPlan>& masters, const Loss& loss);
    /// @brief Does everything up to and including `until`.
    void Run(Time until);
    /// @brief Nodes of `part` are alone with each other from now on.
    void Split(const std::vector<std::uint8_t>& part);
    void Join();
    /// @brief Without power for ever.
    void Kill(std::size_t master);
    /// @brief Loses the power, and comes back.
    void Restart(std::size_t master, Time power_on);
    void SetLoss(const Loss& loss);
    void Forget();

    [[nodiscard]] Time Now() const
    {
        return now_;
    }
    [[nodiscard]] const Seen& Found() const
    {
        return seen_;
    }
    /// @brief Complete frames, destroyed ones.
    [[nodiscard]] std::uint32_t Frames() const
    {
        return frames_;
    }
    [[nodiscard]] std::uint32_t Collisions() const
    {
        return parts_[0].Collisions() + parts_[1].Collisions();
    }
    [[nodiscard]] std::size_t Count() const
    {
        return count_;
    }
    [[nodiscard]] const cia302::FlyingMaster& Master(const std::size_t master) const
    {
        return *nodes_[master].master;
    }
    /// @brief Active masters among those that are on and on the first part of the bus.
    [[nodiscard]] std::size_t ActiveCount() const;
    /// @brief The first of them; Count() if there is none.
    [[nodiscard]] std::size_t Active() const;
    /// @brief One active master, and all others that are on are standbys that know it.
    [[nodiscard]] bool IsAgreed() const;
    /// @brief No device that is on has a lower level than the active master.
    [[nodiscard]] bool IsBest() const;
    /// @brief When the last heartbeat or 071h of a master was complete on the bus: signs of life for its standbys.
    [[nodiscard]] Time LastSign() const
    {
        return last_sign_;
    }
    /// @brief When somebody became active master last.
    [[nodiscard]] Time LastMaster() const
    {
        return last_master_;
    }

  private:
    void OnComplete(const CanFrame& frame, const std::vector<std::size_t>& senders) override;
    void OnBusOff(std::size_t node) override;
    void SendTraffic();
    [[nodiscard]] Time Soonest();
    void Hear(Node& node, const CanFrame& frame);
    void Note(Node& node, Time earliest);
    void CountActive();
    /// @brief `earliest`: behind now when the node's cycle at now is over.
    void Schedule(const Node& node, Time earliest);

    WorldPlan plan_;
    Bus parts_[2];
    Bus* completes_{nullptr}; ///< The part whose frame ends now.
    std::deque<Node> nodes_{};
    std::vector<cia302::SlaveSetup> slaves_;
    std::vector<Time> next_{}; ///< By node.
    Time soonest_{kNever};     ///< Least of these, if it is known.
    bool is_soonest_known_{false};
    std::size_t count_{0U};
    Loss loss_{};
    Seen seen_{};
    Time now_{0};
    Time two_since_{kNever};
    simulator::Random random_;
    Time traffic_at_{kNever};
    Time last_sign_{0};
    Time last_master_{0};
    std::uint32_t frames_{0U};
    bool is_counting_due_{false};
};

} // namespace counterpoint::elections

#endif
