// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_ELECTIONS_WORLD_HPP
#define VERIFICATION_ELECTIONS_WORLD_HPP

#include "canopen/cia302/flying_master/flying_master.hpp"
#include "simulator/faults/random.hpp"
#include "verification/elections/bus.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace counterpoint::elections
{

/// One flying master of a run.
struct MasterPlan
{
    cia302::NodeId node;
    cia302::FlyingMasterTimes times;
    Time power_on;                                        ///< Its application calls Start at once.
    Time phase;                                           ///< Of its cycle, below WorldPlan::cycle.
    Time clock_ppm{0};                                    ///< How much faster its clock goes than that of the world.
    std::uint32_t clock_begin{0U};                        ///< Its counter at the beginning of the world.
    std::optional<cia302::FlyingMasterOptions> options{}; ///< Its own; else those of the WorldPlan.
};

/// Which complete frame is lost, counted from 0, and for whom.
struct Loss
{
    static constexpr std::uint32_t kNoFrame = 0xFFFFFFFFU;
    static constexpr std::size_t kEverybody = SIZE_MAX;
    std::uint32_t frame{kNoFrame};
    std::size_t receiver{kEverybody};
};

/// What all runs of a series have in common.
struct WorldPlan
{
    cia302::FlyingMasterOptions options;
    Time cycle{kMs};
    Time bit_us{8};
    Time heartbeat{1000 * kMs}; ///< Of the active master; its consumers wait for options.watch_ms.
    bool polls{false};          ///< Frames are handled in the next cycle, not when they are complete.
    Time traffic_gap{0};        ///< Frames of other services with 8 bytes, this apart in the mean; 0: none.
    std::uint64_t traffic_seed{0U};
};

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
    /// A device: cycle, heartbeat, controller.
    class Node final : public cia301::FrameSink, public cia302::FlyingMasterListener
    {
      public:
        bool Send(const CanFrame& frame) noexcept override;
        void OnFlyingMaster(cia302::FlyingEvent event, const cia302::MasterClaim& claim, Instant now) noexcept override;
        void OnInitialising(Instant now) noexcept override;

        World* world{nullptr};
        std::size_t index{0U};
        MasterPlan plan{};
        cia302::NetworkSetup setup{};
        std::optional<cia302::FlyingMaster> master{};
        std::vector<CanFrame> heard{}; ///< Not yet handled, with WorldPlan::polls.
        Time power_on{0};
        Time recovers_at{kNever};
        Time heartbeat_at{kNever};
        std::uint8_t part{0U};
        bool is_on{false};
        bool was_active{false};
        std::uint8_t known{0U}; ///< The master that it follows.
    };

    void OnComplete(const CanFrame& frame, const std::vector<std::size_t>& senders) override;
    void OnBusOff(std::size_t node) override;
    void PowerOn(Node& node);
    void Start(Node& node);
    void Cycle(Node& node);
    void SendTraffic();
    [[nodiscard]] Time Soonest();
    void Hear(Node& node, const CanFrame& frame);
    void Note(Node& node, Time earliest);
    void CountActive();
    /// @brief `earliest`: behind now when the node's cycle at now is over.
    void Schedule(const Node& node, Time earliest);
    [[nodiscard]] Time NextOf(const Node& node, Time earliest) const;
    [[nodiscard]] Time TickFrom(const Node& node, Time at) const;
    /// @brief By the node's own clock.
    [[nodiscard]] static Time LocalOf(const Node& node, Time at);
    /// @brief First instant of the world at which the node's clock shows `local`.
    [[nodiscard]] static Time WorldOf(const Node& node, Time local);
    [[nodiscard]] static Instant Stamp(const Node& node, Time at);

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
