// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/elections/world.hpp"

#include <algorithm>
#include <utility>

namespace counterpoint::elections
{
namespace
{

constexpr std::uint32_t kErrorControl = 0x700U;
constexpr std::uint32_t kClaim = 0x71U;
constexpr std::uint32_t kForce = 0x76U;
/// 128 times 11 recessive bits.
constexpr Time kRecoveryBits = 128 * 11;

} // namespace

World::World(const WorldPlan& plan)
    : plan_(plan), parts_{Bus(*this, plan.bit_us), Bus(*this, plan.bit_us)}, slaves_(cia302::kNodeRoom),
      random_(plan.traffic_seed)
{
}

void World::Begin(const std::vector<MasterPlan>& masters, const Loss& loss)
{
    count_ = masters.size();
    while (nodes_.size() < count_)
    {
        nodes_.emplace_back();
    }
    next_.assign(count_, kNever);
    is_soonest_known_ = false;
    parts_[0].Clear(count_ + 1U); // The last one sends what is no flying master's.
    parts_[1].Clear(count_ + 1U);
    parts_[0].Attach(count_, true, 0);
    now_ = 0;
    traffic_at_ = (plan_.traffic_gap > 0) ? 0 : kNever;
    frames_ = 0U;
    loss_ = loss;
    two_since_ = kNever;
    last_sign_ = 0;
    last_master_ = 0;
    seen_ = Seen{};
    for (std::size_t i = 0U; i < count_; ++i)
    {
        Node& node = nodes_[i];
        node.bus = &parts_[0];
        node.index = i;
        node.plan = masters[i];
        node.plan.options = masters[i].options.value_or(plan_.options);
        node.clock = NodeClock(masters[i], plan_.cycle);
        node.heartbeat = plan_.heartbeat;
        node.has_manager = plan_.has_managers;
        node.setup = cia302::NetworkSetup{masters[i].node, 0x21U, 0U, 0U, 0U, slaves_.data()};
        node.power_on = masters[i].power_on;
        node.part = 0U;
        node.is_on = false;
        node.was_active = false;
        node.known = 0U;
        node.configuration_errors = 0U;
        node.heard.clear();
        node.to_send.clear();
        Schedule(node, 0);
    }
}

void World::Kill(const std::size_t master)
{
    Restart(master, kNever);
}

void World::Restart(const std::size_t master, const Time power_on)
{
    Node& node = nodes_[master];
    node.bus->Drop(master);
    node.bus->Attach(master, false, now_);
    node.is_on = false;
    node.power_on = power_on;
    node.was_active = false;
    node.known = 0U;
    node.heard.clear();
    node.to_send.clear();
    CountActive();
    Schedule(node, now_);
}

void World::Split(const std::vector<std::uint8_t>& part)
{
    for (std::size_t i = 0U; i < count_; ++i)
    {
        Node& node = nodes_[i];
        if (part[i] != node.part)
        {
            // What waits in the controller goes out at the other part.
            node.bus->Move(i, parts_[part[i]], now_);
            node.part = part[i];
            node.bus = &parts_[node.part];
        }
    }
    CountActive();
}

void World::Join()
{
    Split(std::vector<std::uint8_t>(count_, 0U));
}

/// Of an identifier that no flying master listens to, and with a length that holds the bus.
void World::SendTraffic()
{
    const CanFrame frame{0x180U + random_.Below(0x400U), FrameKind::kData, CanPortId::kFirst, 8U, {}};
    static_cast<void>(parts_[0].Submit(count_, frame));
    traffic_at_ = now_ + 1 + random_.Below(static_cast<std::uint32_t>(2 * plan_.traffic_gap));
}

void World::SetLoss(const Loss& loss)
{
    loss_ = loss;
}

void World::Forget()
{
    seen_ = Seen{};
    seen_.last_change = now_;
    two_since_ = (two_since_ == kNever) ? kNever : now_;
}

void World::Run(const Time until)
{
    for (;;)
    {
        const Time of_bus = std::min(parts_[0].Next(), parts_[1].Next());
        const Time next = std::max(now_, std::min({Soonest(), of_bus, traffic_at_}));
        if (next > until)
        {
            break;
        }
        now_ = next;
        for (Bus& part : parts_)
        {
            completes_ = &part;
            part.Finish(now_);
        }
        const bool is_one_due = Soonest() <= now_;
        for (std::size_t i = 0U; is_one_due && (i < count_); ++i)
        {
            if (next_[i] <= now_)
            {
                nodes_[i].Cycle(now_);
                Note(nodes_[i], now_ + 1);
            }
        }
        if (is_counting_due_)
        {
            CountActive();
        }
        if (traffic_at_ <= now_)
        {
            SendTraffic();
        }
        parts_[0].Arbitrate(now_);
        parts_[1].Arbitrate(now_);
    }
    now_ = std::max(now_, until);
}

void World::OnComplete(const CanFrame& frame, const std::vector<std::size_t>& senders)
{
    const std::uint32_t number = frames_;
    ++frames_;
    seen_.resets += (frame.identifier == 0U) ? 1U : 0U;
    seen_.forces += (frame.identifier == kForce) ? 1U : 0U;
    const bool is_sign = (frame.identifier > kErrorControl) || (frame.identifier == kClaim);
    last_sign_ = is_sign ? now_ : last_sign_;
    for (const std::size_t sender : senders)
    {
        if (sender < count_)
        {
            nodes_[sender].OnSent();
        }
    }
    const bool is_of_interest = (frame.identifier <= kForce) || (frame.identifier > kErrorControl);
    if (!is_of_interest)
    {
        return;
    }
    const bool is_lost = number == loss_.frame;
    for (std::size_t i = 0U; i < count_; ++i)
    {
        Node& node = nodes_[i];
        const bool is_sender = std::find(senders.begin(), senders.end(), i) != senders.end();
        const bool misses = is_lost && ((loss_.receiver == Loss::kEverybody) || (loss_.receiver == i));
        if (completes_->IsAttached(i) && !is_sender && !misses)
        {
            Hear(node, frame);
        }
    }
}

void World::Hear(Node& node, const CanFrame& frame)
{
    const bool is_of_interest =
        (frame.identifier < kErrorControl) || node.has_manager || node.master->State() == cia302::FlyingState::kSlave;
    if (is_of_interest && plan_.polls)
    {
        node.heard.push_back(frame);
        if (next_[node.index] > now_) // Else the cycle of this very instant takes it along.
        {
            Schedule(node, now_ + 1);
        }
    }
    else if (is_of_interest)
    {
        node.Hear(frame, now_);
        Note(node, now_);
    }
    else
    {
        // A heartbeat, which only standbys listen to.
    }
}

void World::OnBusOff(const std::size_t node)
{
    Node& gone = nodes_[node];
    ++seen_.bus_offs;
    gone.recovers_at = now_ + (kRecoveryBits * plan_.bit_us);
    gone.bus->Attach(node, false, now_);
    gone.heard.clear();
    gone.OnBusOff(now_);
    Note(gone, now_);
}

/// Role, standby's master and the next instant of a device after it did something.
void World::Note(Node& node, const Time earliest)
{
    const bool is_active = node.master->IsActiveMaster();
    const std::uint8_t known = node.master->Master().node.value;
    if ((is_active != node.was_active) || (known != node.known))
    {
        seen_.last_change = now_;
        is_counting_due_ = true;
        const bool begins = is_active && !node.was_active;
        node.heartbeat_at = begins ? now_ : node.heartbeat_at;
        last_master_ = begins ? now_ : last_master_;
        node.was_active = is_active;
        node.known = known;
    }
    seen_.configuration_errors += std::exchange(node.configuration_errors, 0U);
    Schedule(node, earliest);
}

void World::CountActive()
{
    std::size_t active[2] = {0U, 0U};
    for (std::size_t i = 0U; i < count_; ++i)
    {
        active[nodes_[i].part] += nodes_[i].was_active ? 1U : 0U;
    }
    const bool are_two = (active[0] > 1U) || (active[1] > 1U);
    if (are_two && (two_since_ == kNever))
    {
        two_since_ = now_;
    }
    if (!are_two && (two_since_ != kNever))
    {
        seen_.longest_two = std::max(seen_.longest_two, now_ - two_since_);
        two_since_ = kNever;
    }
    is_counting_due_ = false;
}

/// Earliest instant at which a device does something; most frames change nothing about it.
Time World::Soonest()
{
    if (!is_soonest_known_)
    {
        soonest_ = (count_ > 0U) ? *std::min_element(next_.begin(), next_.end()) : kNever;
        is_soonest_known_ = true;
    }
    return soonest_;
}

void World::Schedule(const Node& node, const Time earliest)
{
    const Time next = node.Next(now_, earliest);
    Time& kept = next_[node.index];
    is_soonest_known_ = is_soonest_known_ && (kept > soonest_);
    soonest_ = is_soonest_known_ ? std::min(soonest_, next) : soonest_;
    kept = next;
}

std::size_t World::ActiveCount() const
{
    std::size_t count = 0U;
    for (std::size_t i = 0U; i < count_; ++i)
    {
        count += (nodes_[i].was_active && (nodes_[i].part == 0U)) ? 1U : 0U;
    }
    return count;
}

std::size_t World::Active() const
{
    std::size_t found = count_;
    for (std::size_t i = count_; i > 0U; --i)
    {
        found = (nodes_[i - 1U].was_active && (nodes_[i - 1U].part == 0U)) ? (i - 1U) : found;
    }
    return found;
}

bool World::IsAgreed() const
{
    const std::size_t active = Active();
    bool is_agreed = ActiveCount() == 1U;
    for (std::size_t i = 0U; is_agreed && (i < count_); ++i)
    {
        const Node& node = nodes_[i];
        is_agreed = !node.is_on || (node.known == nodes_[active].plan.node.value);
    }
    return is_agreed;
}

bool World::IsBest() const
{
    const std::size_t active = Active();
    bool is_best = active < count_;
    for (std::size_t i = 0U; is_best && (i < count_); ++i)
    {
        const Node& node = nodes_[i];
        is_best = !node.is_on || (node.plan.times.priority >= nodes_[active].plan.times.priority);
    }
    return is_best;
}

} // namespace counterpoint::elections
