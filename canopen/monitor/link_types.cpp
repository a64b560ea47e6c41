// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What stands before a CAN frame in captures of Linux.
#include "canopen/monitor/readers.hpp"

namespace counterpoint::monitor
{
namespace
{
constexpr std::uint16_t kProtocolCan = 0x000CU;
constexpr std::uint16_t kProtocolCanFd = 0x000DU;
constexpr std::size_t kCookedHead = 16U;
constexpr std::size_t kCookedProtocol = 14U;
constexpr std::size_t kCooked2Head = 20U;
constexpr std::size_t kCooked2Protocol = 0U;

/// The packet of CAN_SOCKETCAN that a cooked one holds: the identifier in network order.
std::string SocketCanOf(std::string_view packet, const bool is_big_endian)
{
    std::string bytes(packet);
    if (!is_big_endian)
    {
        std::swap(bytes[0U], bytes[3U]);
        std::swap(bytes[1U], bytes[2U]);
    }
    return bytes;
}
} // namespace

bool IsReadable(const std::uint32_t link_type) noexcept
{
    return link_type == kLinkSocketCan || link_type == kLinkCooked || link_type == kLinkCooked2;
}

const char* ReadableLinkTypes() noexcept
{
    return "227 (CAN_SOCKETCAN), 113 or 276 (Linux cooked)";
}

PacketResult ReadPacketOf(const std::uint32_t link_type, const std::string_view packet, const bool is_big_endian,
                          LogFrame& frame)
{
    if (link_type == kLinkSocketCan)
    {
        return {true, ReadSocketCan(packet, frame)};
    }
    const bool is_second = link_type == kLinkCooked2;
    const std::size_t head = is_second ? kCooked2Head : kCookedHead;
    if (packet.size() < head)
    {
        return {false, cia306::Problem{"cooked packet of " + std::to_string(packet.size()) + " bytes",
                                       "at least " + std::to_string(head)}};
    }
    const std::uint16_t protocol = CaptureBytes(packet, true).Number16(is_second ? kCooked2Protocol : kCookedProtocol);
    if (protocol != kProtocolCan && protocol != kProtocolCanFd)
    {
        return {false, std::nullopt};
    }
    const std::string_view rest = packet.substr(head);
    return {true, ReadSocketCan(rest.size() < 4U ? std::string(rest) : SocketCanOf(rest, is_big_endian), frame)};
}
} // namespace counterpoint::monitor
