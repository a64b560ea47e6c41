// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/live/poll.hpp"

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>
#include <sys/epoll.h>
#include <sys/timerfd.h>
#include <unistd.h>
#include <utility>

namespace counterpoint::host
{

LiveFile::~LiveFile()
{
    if (descriptor_ >= 0)
    {
        static_cast<void>(::close(descriptor_));
    }
}

LiveFile::LiveFile(LiveFile&& other) noexcept : descriptor_{std::exchange(other.descriptor_, -1)}
{
}

LiveFile& LiveFile::operator=(LiveFile&& other) noexcept
{
    std::swap(descriptor_, other.descriptor_);
    return *this;
}

LivePoll::LivePoll()
    : set_{::epoll_create1(EPOLL_CLOEXEC)}, timer_{::timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC)}
{
    Add(timer_.Get());
}

void LivePoll::Add(const int descriptor)
{
    epoll_event event{};
    event.events = EPOLLIN;
    event.data.fd = descriptor;
    if (::epoll_ctl(set_.Get(), EPOLL_CTL_ADD, descriptor, &event) != 0)
    {
        throw std::runtime_error(std::string("no descriptor to wait with: ") + std::strerror(errno));
    }
}

void LivePoll::WakeAt(const std::uint64_t time_ns)
{
    if (time_ns == wake_ns_)
    {
        return;
    }
    constexpr std::uint64_t kSecondNs = 1'000'000'000U;
    itimerspec when{};
    when.it_value.tv_sec = static_cast<time_t>(time_ns / kSecondNs);
    when.it_value.tv_nsec = static_cast<long>(time_ns % kSecondNs);
    // Setting it also clears an expiry that nobody read.
    static_cast<void>(::timerfd_settime(timer_.Get(), TFD_TIMER_ABSTIME, &when, nullptr));
    wake_ns_ = time_ns;
}

} // namespace counterpoint::host
