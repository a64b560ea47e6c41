// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What the world of an election knows of its masters' roles and clocks.
#include "verification/elections/world.hpp"

namespace counterpoint::elections
{

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

Time World::LocalOf(const Node& node, const Time at)
{
    return at + ((at * node.plan.clock_ppm) / kSecond);
}

Time World::WorldOf(const Node& node, const Time local)
{
    Time at = (node.plan.clock_ppm == 0) ? local : ((local * kSecond) / (kSecond + node.plan.clock_ppm));
    while (LocalOf(node, at) < local)
    {
        ++at;
    }
    return at;
}

Instant World::Stamp(const Node& node, const Time at)
{
    return Instant{node.plan.clock_begin + static_cast<std::uint32_t>(LocalOf(node, at))};
}

} // namespace counterpoint::elections
