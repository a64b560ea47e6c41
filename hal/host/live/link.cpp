// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/live/link.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <iterator>
#include <linux/can/netlink.h>
#include <linux/if_link.h>
#include <linux/netlink.h>
#include <linux/rtnetlink.h>
#include <net/if.h>
#include <sys/socket.h>

namespace counterpoint::host
{
namespace
{

/// IFF_LOWER_UP, which <net/if.h> does not have and <linux/if.h> not beside it.
constexpr unsigned int kLowerUp = 0x1'0000U;
constexpr std::size_t kAnswerBytes = 16U * 1024U;

/// A stretch of attributes, each: length (2 bytes, with this head), type (2 bytes), value, filled up to 4 bytes.
struct Attributes
{
    const std::uint8_t* bytes;
    std::size_t count;
};

/// The value of the first attribute of `type`; without bytes: there is none.
Attributes Find(const Attributes& all, const std::uint16_t type)
{
    std::size_t at = 0U;
    while (at + sizeof(nlattr) <= all.count)
    {
        nlattr head{};
        std::memcpy(&head, all.bytes + at, sizeof(head));
        const std::size_t length = head.nla_len;
        if ((length < sizeof(head)) || (at + length > all.count))
        {
            break;
        }
        if ((head.nla_type & NLA_TYPE_MASK) == type)
        {
            return {all.bytes + at + sizeof(head), length - sizeof(head)};
        }
        at += (length + 3U) & ~std::size_t{3U};
    }
    return {nullptr, 0U};
}

template <typename Value> std::optional<Value> ValueOf(const Attributes& attribute)
{
    Value value{};
    if (attribute.count < sizeof(value))
    {
        return std::nullopt;
    }
    std::memcpy(&value, attribute.bytes, sizeof(value));
    return value;
}

std::optional<BusState> StateOf(const std::uint32_t can_state)
{
    switch (can_state)
    {
    case CAN_STATE_ERROR_ACTIVE:
        return BusState::kActive;
    case CAN_STATE_ERROR_WARNING:
        return BusState::kWarning;
    case CAN_STATE_ERROR_PASSIVE:
        return BusState::kPassive;
    case CAN_STATE_BUS_OFF:
        return BusState::kBusOff;
    default:
        return BusState::kDown; // Stopped or sleeping: takes part in nothing.
    }
}

std::uint8_t Limited(const std::uint16_t count)
{
    return static_cast<std::uint8_t>(std::min<std::uint16_t>(count, 255U));
}

void Append(std::vector<std::uint8_t>& message, const void* const bytes, const std::size_t count)
{
    const auto* const first = static_cast<const std::uint8_t*>(bytes);
    std::copy(first, first + count, std::back_inserter(message));
}

std::vector<std::uint8_t> LinkMessage(const std::uint16_t type, const std::uint16_t flags, const ifinfomsg& link,
                                      const std::vector<std::uint8_t>& attributes)
{
    nlmsghdr head{};
    head.nlmsg_len = static_cast<std::uint32_t>(sizeof(head) + sizeof(link) + attributes.size());
    head.nlmsg_type = type;
    head.nlmsg_flags = static_cast<std::uint16_t>(NLM_F_REQUEST | flags);
    std::vector<std::uint8_t> message;
    Append(message, &head, sizeof(head));
    Append(message, &link, sizeof(link));
    Append(message, attributes.data(), attributes.size());
    return message;
}

std::vector<std::uint8_t> Attribute(const std::uint16_t type, const std::vector<std::uint8_t>& value)
{
    nlattr head{};
    head.nla_len = static_cast<std::uint16_t>(sizeof(head) + value.size());
    head.nla_type = type;
    std::vector<std::uint8_t> bytes;
    Append(bytes, &head, sizeof(head));
    Append(bytes, value.data(), value.size());
    bytes.resize((bytes.size() + 3U) & ~std::size_t{3U});
    return bytes;
}

std::vector<std::uint8_t> operator+(std::vector<std::uint8_t> left, const std::vector<std::uint8_t>& right)
{
    left.insert(left.end(), right.begin(), right.end());
    return left;
}

ifinfomsg LinkOf(const int index)
{
    ifinfomsg link{};
    link.ifi_family = AF_UNSPEC;
    link.ifi_index = index;
    return link;
}

} // namespace

std::optional<LinkState> ReadLinkMessage(const std::uint8_t* const bytes, const std::size_t count)
{
    nlmsghdr head{};
    ifinfomsg link{};
    if (count < sizeof(head) + sizeof(link))
    {
        return std::nullopt;
    }
    std::memcpy(&head, bytes, sizeof(head));
    std::memcpy(&link, bytes + sizeof(head), sizeof(link));
    if ((head.nlmsg_type != RTM_NEWLINK) || (head.nlmsg_len > count) || (head.nlmsg_len < sizeof(head) + sizeof(link)))
    {
        return std::nullopt;
    }
    const std::size_t fixed = sizeof(head) + sizeof(link);
    const Attributes info = Find({bytes + fixed, head.nlmsg_len - fixed}, IFLA_LINKINFO);
    LinkState state;
    state.index = link.ifi_index;
    state.is_up = (link.ifi_flags & IFF_UP) != 0U;
    // Running follows the carrier when the kernel has also set the queue going, or stopped it.
    state.is_carrying = state.is_up && ((link.ifi_flags & IFF_RUNNING) != 0U) && ((link.ifi_flags & kLowerUp) != 0U);
    const Attributes kind = Find(info, IFLA_INFO_KIND);
    constexpr char kCan[]{'c', 'a', 'n', '\0'};
    if ((kind.count != sizeof(kCan)) || !std::equal(std::begin(kCan), std::end(kCan), kind.bytes))
    {
        return state;
    }
    const Attributes can = Find(info, IFLA_INFO_DATA);
    if (const auto can_state = ValueOf<std::uint32_t>(Find(can, IFLA_CAN_STATE)))
    {
        state.controller = StateOf(*can_state);
    }
    if (const auto counters = ValueOf<can_berr_counter>(Find(can, IFLA_CAN_BERR_COUNTER)))
    {
        state.transmit_errors = Limited(counters->txerr);
        state.receive_errors = Limited(counters->rxerr);
    }
    state.restart_ms = ValueOf<std::uint32_t>(Find(can, IFLA_CAN_RESTART_MS)).value_or(0U);
    return state;
}

std::vector<std::uint8_t> AskLinkMessage(const int index)
{
    return LinkMessage(RTM_GETLINK, 0U, LinkOf(index), {});
}

std::vector<std::uint8_t> RestartLinkMessage(const int index)
{
    const std::vector<std::uint8_t> data = Attribute(IFLA_CAN_RESTART, {1U, 0U, 0U, 0U});
    const std::vector<std::uint8_t> info = Attribute(IFLA_INFO_KIND, {'c', 'a', 'n'}) + Attribute(IFLA_INFO_DATA, data);
    return LinkMessage(RTM_NEWLINK, NLM_F_ACK, LinkOf(index), Attribute(IFLA_LINKINFO, info));
}

std::vector<std::uint8_t> SwitchLinkMessage(const int index, const bool is_up)
{
    ifinfomsg link = LinkOf(index);
    link.ifi_change = IFF_UP;
    link.ifi_flags = is_up ? static_cast<unsigned int>(IFF_UP) : 0U;
    return LinkMessage(RTM_NEWLINK, NLM_F_ACK, link, {});
}

LiveLink::LiveLink()
    : news_{::socket(AF_NETLINK, SOCK_RAW | SOCK_NONBLOCK | SOCK_CLOEXEC, NETLINK_ROUTE)},
      orders_{::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_ROUTE)}
{
    sockaddr_nl own{};
    own.nl_family = AF_NETLINK;
    own.nl_groups = RTMGRP_LINK;
    // The kernel answers within the call that asks; the limit is for a kernel that does not.
    const timeval patience{1, 0};
    const bool is_open = (news_.Get() >= 0) && (orders_.Get() >= 0) &&
                         (::bind(news_.Get(), reinterpret_cast<const sockaddr*>(&own), sizeof(own)) == 0) &&
                         (::setsockopt(orders_.Get(), SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof(patience)) == 0);
    if (!is_open)
    {
        throw LiveBusError(std::string("rtnetlink: ") + std::strerror(errno) + ", expected news of interfaces");
    }
}

bool LiveLink::TakeNews()
{
    std::array<std::uint8_t, kAnswerBytes> bytes{};
    bool has_some = false;
    bool is_more = true;
    while (is_more)
    {
        const ssize_t got = ::recv(news_.Get(), bytes.data(), bytes.size(), MSG_DONTWAIT);
        // ENOBUFS: there were more than fit, and the next read goes on.
        is_more = (got > 0) || ((got < 0) && (errno == ENOBUFS));
        has_some = has_some || is_more;
    }
    return has_some;
}

std::optional<LinkState> LiveLink::Ask(const int index)
{
    const std::vector<std::uint8_t> question = AskLinkMessage(index);
    std::array<std::uint8_t, kAnswerBytes> bytes{};
    if (::send(orders_.Get(), question.data(), question.size(), 0) < 0)
    {
        return std::nullopt;
    }
    const ssize_t got = ::recv(orders_.Get(), bytes.data(), bytes.size(), 0);
    return (got > 0) ? ReadLinkMessage(bytes.data(), static_cast<std::size_t>(got)) : std::nullopt;
}

int LiveLink::Restart(const int index)
{
    return Order(RestartLinkMessage(index));
}

int LiveLink::Switch(const int index, const bool is_up)
{
    return Order(SwitchLinkMessage(index, is_up));
}

int LiveLink::Order(const std::vector<std::uint8_t>& message)
{
    std::array<std::uint8_t, kAnswerBytes> bytes{};
    if (::send(orders_.Get(), message.data(), message.size(), 0) < 0)
    {
        return errno;
    }
    const ssize_t got = ::recv(orders_.Get(), bytes.data(), bytes.size(), 0);
    nlmsghdr head{};
    nlmsgerr answer{};
    if (got < static_cast<ssize_t>(sizeof(head) + sizeof(answer)))
    {
        return EIO;
    }
    std::memcpy(&head, bytes.data(), sizeof(head));
    std::memcpy(&answer, bytes.data() + sizeof(head), sizeof(answer));
    return (head.nlmsg_type == NLMSG_ERROR) ? -answer.error : EIO;
}

} // namespace counterpoint::host
