// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/hal/host/fake_can_kernel.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <linux/can/raw.h>
#include <linux/if_link.h>
#include <linux/netlink.h>
#include <linux/rtnetlink.h>
#include <net/if.h>
#include <sys/eventfd.h>
#include <unistd.h>

namespace counterpoint::host
{
namespace
{

constexpr std::size_t kLinkBytes = sizeof(nlmsghdr) + sizeof(ifinfomsg);
constexpr unsigned kLowerUp = 0x1'0000U;

/// A descriptor is an event of the system that is readable as often as something was put in.
void Wake(const int file)
{
    const std::uint64_t one = 1U;
    static_cast<void>(::write(file, &one, sizeof(one)));
}

void Rest(const int file)
{
    std::uint64_t one = 0U;
    static_cast<void>(::read(file, &one, sizeof(one)));
}

void Append(std::vector<std::uint8_t>& to, const void* const bytes, const std::size_t count)
{
    const auto* const first = static_cast<const std::uint8_t*>(bytes);
    to.insert(to.end(), first, first + count);
}

std::vector<std::uint8_t> LinkAnswer(const FakeCanKernel::Interface& interface)
{
    ifinfomsg link{};
    link.ifi_index = interface.index;
    link.ifi_flags = interface.is_up ? static_cast<unsigned>(IFF_UP) : 0U;
    link.ifi_flags |= interface.is_carrying ? (static_cast<unsigned>(IFF_RUNNING) | kLowerUp) : 0U;
    std::vector<std::uint8_t> info{8U, 0U, 1U, 0U, 'c', 'a', 'n', 0U}; // IFLA_INFO_KIND.
    if (interface.state)
    {
        const std::vector<std::uint8_t> data{20U,
                                             0U,
                                             2U,
                                             0x80U, // IFLA_INFO_DATA.
                                             8U,
                                             0U,
                                             4U,
                                             0U,
                                             *interface.state,
                                             0U,
                                             0U,
                                             0U, // State.
                                             8U,
                                             0U,
                                             8U,
                                             0U,
                                             interface.transmit_errors,
                                             0U, // Error counters.
                                             interface.receive_errors,
                                             0U};
        info.insert(info.end(), data.begin(), data.end());
    }
    else
    {
        info = {9U, 0U, 1U, 0U, 'v', 'c', 'a', 'n', 0U, 0U, 0U, 0U};
    }
    nlmsghdr head{};
    head.nlmsg_type = RTM_NEWLINK;
    head.nlmsg_len = static_cast<std::uint32_t>(kLinkBytes + 4U + info.size());
    std::vector<std::uint8_t> answer;
    Append(answer, &head, sizeof(head));
    Append(answer, &link, sizeof(link));
    const std::vector<std::uint8_t> attribute{static_cast<std::uint8_t>(4U + info.size()), 0U, IFLA_LINKINFO, 0U};
    Append(answer, attribute.data(), attribute.size());
    Append(answer, info.data(), info.size());
    return answer;
}

std::vector<std::uint8_t> ErrorAnswer(const int failure)
{
    nlmsghdr head{};
    nlmsgerr error{};
    head.nlmsg_type = NLMSG_ERROR;
    head.nlmsg_len = sizeof(head) + sizeof(error);
    error.error = -failure;
    std::vector<std::uint8_t> answer;
    Append(answer, &head, sizeof(head));
    Append(answer, &error, sizeof(error));
    return answer;
}

/// Puts one more message of control behind those that are there.
void PutControl(msghdr& message, std::size_t& used, const int type, const void* const value, const std::size_t bytes)
{
    cmsghdr head{};
    head.cmsg_len = CMSG_LEN(bytes);
    head.cmsg_level = SOL_SOCKET;
    head.cmsg_type = type;
    auto* const at = static_cast<std::uint8_t*>(message.msg_control) + used;
    std::memcpy(at, &head, sizeof(head));
    std::memcpy(at + CMSG_LEN(0), value, bytes);
    used += CMSG_SPACE(bytes);
}

} // namespace

bool FakeCanKernel::Is(const int file, const Kind kind) const
{
    const auto found = files_.find(file);
    return (found != files_.end()) && (found->second == kind);
}

int FakeCanKernel::FileOf(const Kind kind) const
{
    return latest_.at(static_cast<std::size_t>(kind));
}

FakeCanKernel::Interface* FakeCanKernel::Find(const int index)
{
    const auto found = std::find_if(interfaces.begin(), interfaces.end(),
                                    [index](const auto& entry) { return entry.second.index == index; });
    return (found == interfaces.end()) ? nullptr : &found->second;
}

void FakeCanKernel::Put(const Coming& coming)
{
    coming_.push_back(coming);
    Wake(FileOf(Kind::kRaw));
}

void FakeCanKernel::Arrive(const canfd_frame& frame, const bool is_own, const std::size_t bytes)
{
    Put({frame, bytes, is_own, 0});
}

void FakeCanKernel::Arrive(const std::uint32_t identifier, const bool is_own)
{
    canfd_frame frame{};
    frame.can_id = identifier;
    Arrive(frame, is_own);
}

void FakeCanKernel::FailReading(const int failure)
{
    Put({{}, 0U, false, failure});
}

void FakeCanKernel::TellNews()
{
    Wake(FileOf(Kind::kNews));
}

std::optional<int> FakeCanKernel::Socket(const int domain, const int type)
{
    if ((domain != PF_CAN) && (domain != AF_NETLINK))
    {
        return std::nullopt;
    }
    if ((domain == PF_CAN) && (socket_failure != 0))
    {
        return -socket_failure;
    }
    const bool is_news = (domain == AF_NETLINK) && ((type & SOCK_NONBLOCK) != 0);
    const Kind kind = (domain == PF_CAN) ? Kind::kRaw : (is_news ? Kind::kNews : Kind::kOrders);
    const int file = ::eventfd(0U, EFD_NONBLOCK | EFD_CLOEXEC | EFD_SEMAPHORE);
    files_[file] = kind;
    latest_.at(static_cast<std::size_t>(kind)) = file;
    return file;
}

std::optional<int> FakeCanKernel::Bind(const int file, const sockaddr& address)
{
    if (!Is(file, Kind::kRaw))
    {
        return Is(file, Kind::kNews) ? std::optional<int>{0} : std::nullopt;
    }
    sockaddr_can own{};
    std::memcpy(&own, &address, sizeof(own));
    return (Find(own.can_ifindex) == nullptr) ? -ENODEV : 0;
}

std::optional<int> FakeCanKernel::SetOption(const int file, const int level, const int option, const void* const value,
                                            const socklen_t bytes)
{
    if (files_.count(file) == 0U)
    {
        return std::nullopt;
    }
    if ((level == SOL_CAN_RAW) && (option == refused_option))
    {
        return -ENOPROTOOPT;
    }
    if ((level == SOL_CAN_RAW) && (option == CAN_RAW_FILTER))
    {
        filters.resize(bytes / sizeof(can_filter));
        std::memcpy(filters.data(), value, filters.size() * sizeof(can_filter));
    }
    return 0;
}

void FakeCanKernel::Obey(const int index, const std::uint8_t* const bytes, const std::size_t count)
{
    Interface* const interface = Find(index);
    ifinfomsg link{};
    std::memcpy(&link, bytes + sizeof(nlmsghdr), sizeof(link));
    const bool is_restart = count > kLinkBytes;
    const bool is_switch_on = (link.ifi_flags & IFF_UP) != 0U;
    orders.push_back((is_restart ? "restart " : (is_switch_on ? "up " : "down ")) + std::to_string(index));
    const int failure = order_answers.empty() ? 0 : order_answers.front();
    if (!order_answers.empty())
    {
        order_answers.pop_front();
    }
    if ((failure == 0) && (interface != nullptr) && (is_restart || is_switch_on) && restarts)
    {
        interface->state = std::uint8_t{0U};
        interface->is_up = true;
        interface->is_carrying = true;
    }
    answer_ = ErrorAnswer(failure);
}

std::optional<ssize_t> FakeCanKernel::Send(const int file, const void* const bytes, const std::size_t count)
{
    if (Is(file, Kind::kRaw))
    {
        const int failure = send_failures.empty() ? 0 : send_failures.front();
        if (!send_failures.empty())
        {
            send_failures.pop_front();
        }
        if (failure != 0)
        {
            return -failure;
        }
        canfd_frame frame{};
        std::memcpy(&frame, bytes, count);
        sent.push_back(frame);
        sent_bytes.push_back(count);
        return static_cast<ssize_t>(count);
    }
    if (!Is(file, Kind::kOrders))
    {
        return std::nullopt;
    }
    if (is_link_gone)
    {
        return -ENETDOWN;
    }
    nlmsghdr head{};
    ifinfomsg link{};
    const auto* const octets = static_cast<const std::uint8_t*>(bytes);
    std::memcpy(&head, octets, sizeof(head));
    std::memcpy(&link, octets + sizeof(head), sizeof(link));
    if (head.nlmsg_type == RTM_GETLINK)
    {
        const Interface* const interface = Find(link.ifi_index);
        answer_ = (interface == nullptr) ? ErrorAnswer(ENODEV) : LinkAnswer(*interface);
    }
    else
    {
        Obey(link.ifi_index, octets, count);
    }
    return static_cast<ssize_t>(count);
}

std::optional<ssize_t> FakeCanKernel::Receive(const int file, void* const bytes, const std::size_t room)
{
    if (Is(file, Kind::kNews))
    {
        std::uint64_t told = 0U;
        const bool is_told = ::read(file, &told, sizeof(told)) > 0;
        return is_told ? (is_news_empty ? 0 : 1) : -EAGAIN;
    }
    if (!Is(file, Kind::kOrders))
    {
        return std::nullopt;
    }
    if (is_link_mute)
    {
        return -EAGAIN;
    }
    if (is_link_strange)
    {
        answer_ = LinkAnswer(Interface{});
        std::uint8_t* const type = answer_.data() + offsetof(nlmsghdr, nlmsg_type);
        *type = NLMSG_DONE;
    }
    const std::size_t count = std::min(room, answer_.size());
    std::memcpy(bytes, answer_.data(), count);
    return static_cast<ssize_t>(count);
}

std::optional<ssize_t> FakeCanKernel::ReceiveMessage(const int file, msghdr& message)
{
    if (!Is(file, Kind::kRaw))
    {
        return std::nullopt;
    }
    if (coming_.empty())
    {
        return -EAGAIN;
    }
    const Coming coming = coming_.front();
    coming_.pop_front();
    Rest(file);
    if (coming.failure != 0)
    {
        return -coming.failure;
    }
    std::memcpy(message.msg_iov->iov_base, &coming.frame, std::min(coming.bytes, message.msg_iov->iov_len));
    message.msg_flags = coming.is_own ? MSG_CONFIRM : 0;
    std::size_t used = 0U;
    if (hardware_ns)
    {
        timespec stamps[3]{};
        stamps[2].tv_sec = static_cast<time_t>(*hardware_ns / 1'000'000'000U);
        stamps[2].tv_nsec = static_cast<long>(*hardware_ns % 1'000'000'000U);
        PutControl(message, used, SO_TIMESTAMPING, stamps, sizeof(stamps));
    }
    PutControl(message, used, SO_RXQ_OVFL, &dropped, sizeof(dropped));
    message.msg_controllen = used;
    return static_cast<ssize_t>(coming.bytes);
}

std::optional<unsigned> FakeCanKernel::IndexOf(const char* const name)
{
    const auto found = interfaces.find(name);
    return (found == interfaces.end()) ? 0U : static_cast<unsigned>(found->second.index);
}

void FakeCanKernel::OnClose(const int file)
{
    files_.erase(file);
}

} // namespace counterpoint::host
