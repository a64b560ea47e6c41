// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_HAL_HOST_LIVE_SERVER_RIG_HPP
#define TESTS_HAL_HOST_LIVE_SERVER_RIG_HPP

#include "hal/host/live/address.hpp"
#include "hal/host/live/socketcand/server.hpp"

#include <atomic>
#include <cstdint>
#include <sched.h>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace counterpoint::host
{

/// A server that runs in a thread of its own until it is destroyed.
class RunningServer
{
  public:
    /// Port 0: a free one.
    explicit RunningServer(const std::string& bus, const std::uint16_t port = 0U, const std::string& host = "127.0.0.1")
        : host_{host}, server_{host, port, {{"can0", bus}}}
    {
    }
    explicit RunningServer(std::vector<ServedBus> buses) : host_{"127.0.0.1"}, server_{host_, 0U, std::move(buses)}
    {
    }
    ~RunningServer()
    {
        is_ending_ = true;
        thread_.join();
    }
    [[nodiscard]] std::uint16_t Port() const
    {
        return port_;
    }
    [[nodiscard]] std::string Address(const std::string& name) const
    {
        return "socketcand:" + HostBeforePort(host_) + ":" + std::to_string(port_) + "/" + name;
    }
    /// Only after the thread has ended, or for what does not change.
    [[nodiscard]] ServerCounts Counts() const
    {
        return {clients_, 0U, 0U, 0U, 0U, too_slow_};
    }

  private:
    void Run()
    {
        // It carries frames of devices in real time: not behind whatever else the machine does, where that is allowed.
        sched_param priority{};
        priority.sched_priority = 1;
        static_cast<void>(::sched_setscheduler(0, SCHED_FIFO, &priority));
        while (!is_ending_)
        {
            server_.Serve(10);
            clients_ = server_.Counts().clients;
            too_slow_ = server_.Counts().too_slow;
        }
    }

    std::string host_;
    SocketcandServer server_;
    std::uint16_t port_{server_.Port()};
    std::atomic<bool> is_ending_{false};
    std::atomic<std::uint32_t> clients_{0U};
    std::atomic<std::uint64_t> too_slow_{0U};
    std::thread thread_{[this] { Run(); }};
};

} // namespace counterpoint::host

#endif
