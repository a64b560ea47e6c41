// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_AGENDA_HPP
#define SIMULATOR_WORLD_AGENDA_HPP

#include "simulator/scenario/values.hpp"

#include <functional>
#include <map>
#include <utility>

namespace counterpoint::simulator
{
/// What a scenario makes happen, in the order of time; of two at one instant the one that was planned first.
class Agenda
{
  public:
    /// @brief Adds something that happens at `at`.
    void Plan(const Nanoseconds at, std::function<void()> act)
    {
        acts_.emplace(at, std::move(act));
    }
    /// @brief When the next one happens; kNever: none is left.
    [[nodiscard]] Nanoseconds NextEvent() const noexcept
    {
        return acts_.empty() ? kNever : acts_.begin()->first;
    }
    /// @brief Does everything up to and including `now`.
    void Run(const Nanoseconds now)
    {
        while (!acts_.empty() && acts_.begin()->first <= now)
        {
            const std::function<void()> act = std::move(acts_.begin()->second);
            acts_.erase(acts_.begin());
            act();
        }
    }

  private:
    std::multimap<Nanoseconds, std::function<void()>> acts_; ///< Of one instant in the order of planning.
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_AGENDA_HPP
