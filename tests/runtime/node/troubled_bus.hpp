// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_RUNTIME_NODE_TROUBLED_BUS_HPP
#define TESTS_RUNTIME_NODE_TROUBLED_BUS_HPP

#include "hal/host/live/bus.hpp"

#include <deque>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace counterpoint::tools::test
{
/// A bus whose answers, frames and condition are those that the test says.
class TroubledBus final : public host::LiveBus
{
  public:
    using Condition = std::function<host::BusHealth()>;

    explicit TroubledBus(Condition condition = {}, std::deque<host::LiveFrame> frames = {})
        : condition_(std::move(condition)), frames_(std::move(frames))
    {
    }
    host::SendResult Send(const host::LiveFrame& frame) override
    {
        sent.push_back(frame);
        if (answer == host::SendResult::kSent)
        {
            own_.push_back(frame);
            own_.back().own = true;
        }
        return answer;
    }
    bool Receive(host::LiveFrame& frame) override
    {
        std::deque<host::LiveFrame>& next = own_.empty() ? frames_ : own_;
        const bool is_one = !next.empty();
        if (is_one)
        {
            frame = next.front();
            next.pop_front();
        }
        return is_one;
    }
    int Descriptor() const override
    {
        return -1;
    }
    host::BusHealth Health() const override
    {
        host::BusHealth health;
        health.state = host::BusState::kActive;
        return condition_ ? condition_() : health;
    }
    std::string Problem() const override
    {
        return problem.empty() ? LiveBus::Problem() : problem;
    }
    std::string Name() const override
    {
        return "troubled";
    }
    bool Restart() override
    {
        return false;
    }

    host::SendResult answer{host::SendResult::kSent};
    std::string problem{}; ///< Empty: as a bus that knows nothing of it.
    std::vector<host::LiveFrame> sent{};

  private:
    Condition condition_;
    std::deque<host::LiveFrame> frames_;
    std::deque<host::LiveFrame> own_{};
};
} // namespace counterpoint::tools::test

#endif // TESTS_RUNTIME_NODE_TROUBLED_BUS_HPP
