// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_LIVE_OPENED_BUS_HPP
#define HAL_HOST_LIVE_OPENED_BUS_HPP

#include "hal/host/live/address.hpp"
#include "hal/host/live/bus.hpp"
#include "hal/host/live/poll.hpp"

#include <cstdint>
#include <deque>
#include <string>

namespace counterpoint::host
{
/// What every kind of live bus has. Frames that the system has not taken yet wait in `queue_`, first in, first out.
/// While a frame waits, each further one waits behind it; that keeps the order. [SRS_LIVE_004]
class OpenedBus : public LiveBus
{
  public:
    [[nodiscard]] int Descriptor() const final
    {
        return poll_.Descriptor();
    }
    [[nodiscard]] BusHealth Health() const final
    {
        BusHealth health = health_;
        health.waiting = static_cast<std::uint32_t>(queue_.size());
        return health;
    }
    [[nodiscard]] std::string Problem() const final
    {
        return problem_;
    }
    [[nodiscard]] std::string Name() const final
    {
        return address_.text;
    }
    [[nodiscard]] bool Restart() override
    {
        return false; // Never off, or what the owner of the bus does.
    }

  protected:
    OpenedBus(const LiveAddress& address, const LiveOptions& options, const BusState state)
        : address_{address}, options_{options}
    {
        health_.state = state;
    }
    /// The state from now on. [SRS_LIVE_580]
    void SetState(const BusState state)
    {
        if (IsAway(state) && !IsAway(health_.state))
        {
            ++health_.absences;
        }
        health_.absence = IsAway(state) ? state : health_.absence;
        health_.state = state;
    }
    /// It was bus-off, whatever its state is now: unless that is still so, nobody saw it.
    void NoteBusOff()
    {
        const BusState state = health_.state;
        SetState(IsAway(state) ? state : BusState::kBusOff);
        health_.state = state;
    }
    /// Something came that is no frame. [SRS_LIVE_583]
    void NoteMalformed(const std::string& problem)
    {
        ++health_.malformed;
        problem_ = problem;
    }
    [[nodiscard]] bool IsFull() const
    {
        return queue_.size() >= kLiveQueueFrames;
    }

    LiveAddress address_;
    LiveOptions options_;
    LivePoll poll_{};
    std::deque<LiveFrame> queue_{};
    BusHealth health_{};    ///< But for what waits.
    std::string problem_{}; ///< Of the last that was no frame.
};
} // namespace counterpoint::host

#endif // HAL_HOST_LIVE_OPENED_BUS_HPP
