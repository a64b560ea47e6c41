// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_HAL_HOST_LIVE_RIG_HPP
#define TESTS_HAL_HOST_LIVE_RIG_HPP

#include "hal/host/live/bus.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <poll.h>
#include <string>
#include <vector>

namespace counterpoint::host
{

[[nodiscard]] inline LiveFrame Live(const std::uint32_t identifier, const std::initializer_list<std::uint8_t> data)
{
    LiveFrame frame;
    frame.identifier = identifier;
    frame.length_bytes = static_cast<std::uint8_t>(data.size());
    std::copy(data.begin(), data.end(), frame.data);
    return frame;
}

/// @brief Waits on the descriptor, as an owner does, at most minutes; empty: nothing came.
[[nodiscard]] inline std::optional<LiveFrame> Wait(LiveBus& bus)
{
    constexpr std::uint64_t kPatienceNs = 300'000'000'000U;
    const std::uint64_t start_ns = LiveNow();
    LiveFrame frame;
    while (LiveNow() - start_ns < kPatienceNs)
    {
        if (bus.Receive(frame))
        {
            return frame;
        }
        pollfd wait{bus.Descriptor(), POLLIN, 0};
        static_cast<void>(::poll(&wait, 1U, 100));
    }
    return std::nullopt;
}

/// @brief The text of the LiveBusError that `act` throws; empty: it threw none.
[[nodiscard]] inline std::string ProblemOf(const std::function<void()>& act)
{
    try
    {
        act();
    }
    catch (const LiveBusError& error)
    {
        return error.what();
    }
    return {};
}

} // namespace counterpoint::host

#endif
