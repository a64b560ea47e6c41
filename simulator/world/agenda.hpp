// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_AGENDA_HPP
#define SIMULATOR_WORLD_AGENDA_HPP

#include "simulator/scenario/values.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace counterpoint::simulator
{
/// What a scenario makes happen, in the order of time; of two at one instant the one that was planned first.
class Agenda
{
  public:
    /// @brief Adds something that happens at `at`.
    void Plan(const Nanoseconds at, std::function<void()> act)
    {
        acts_.push_back({at, std::move(act)});
    }
    /// @brief Call it once, after everything was planned.
    void Sort()
    {
        std::stable_sort(acts_.begin(), acts_.end(),
                         [](const Act& left, const Act& right) { return left.at < right.at; });
    }
    /// @brief When the next one happens; kNever: none is left.
    [[nodiscard]] Nanoseconds NextEvent() const noexcept
    {
        return (next_ < acts_.size()) ? acts_[next_].at : kNever;
    }
    /// @brief Does everything up to and including `now`.
    void Run(const Nanoseconds now)
    {
        while (NextEvent() <= now && next_ < acts_.size())
        {
            acts_[next_].act();
            ++next_;
        }
    }

  private:
    struct Act
    {
        Nanoseconds at{0};
        std::function<void()> act;
    };

    std::vector<Act> acts_;
    std::size_t next_{0U};
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_AGENDA_HPP
