// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/live/address.hpp"

#include "hal/host/live/bus.hpp"
#include "hal/host/virtual/bit_rate.hpp"

#include <algorithm>
#include <arpa/inet.h>
#include <cctype>
#include <charconv>
#include <net/if.h>
#include <netinet/in.h>

namespace counterpoint::host
{
namespace
{

constexpr char kDelete = '\x7F';

[[noreturn]] void Refuse(const std::string& address, const std::string& reason)
{
    throw LiveBusError("bus '" + address + "': " + reason);
}

/// The whole of `text` as a decimal number from 1 to `greatest`; 0: it is none.
std::uint32_t NumberOf(const std::string& text, const std::uint32_t greatest)
{
    std::uint32_t number = 0U;
    const char* const end = text.data() + text.size();
    const std::from_chars_result result = std::from_chars(text.data(), end, number);
    const bool is_number = (result.ec == std::errc{}) && (result.ptr == end);
    return (is_number && (number <= greatest)) ? number : 0U;
}

/// What Linux takes as the name of an interface.
bool IsInterfaceName(const std::string& name)
{
    const auto is_plain = [](const char letter)
    { return (std::isgraph(static_cast<unsigned char>(letter)) != 0) && (letter != '/') && (letter != ':'); };
    return !name.empty() && (name.size() < IF_NAMESIZE) && std::all_of(name.begin(), name.end(), is_plain) &&
           (name != ".") && (name != "..");
}

void ReadHostAndPort(const std::string& text, LiveAddress& parts)
{
    const HostAndPort place = SplitHostAndPort(text);
    if (place.host.empty())
    {
        Refuse(parts.text, "no host and port in '" + text + "', expected HOST:PORT, an IPv6 address in brackets");
    }
    parts.host = place.host;
    parts.port = static_cast<std::uint16_t>(NumberOf(place.port, 65'535U));
    if (parts.port == 0U)
    {
        Refuse(parts.text, "port '" + place.port + "', expected a number from 1 to 65535");
    }
}

void ReadInterface(const std::string& name, LiveAddress& parts)
{
    if (!IsInterfaceName(name))
    {
        Refuse(parts.text, "interface '" + name + "', expected a name of 1 to 15 characters such as can0");
    }
    parts.interface = name;
}

void ReadSocketcand(const std::string& text, LiveAddress& parts)
{
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos)
    {
        Refuse(parts.text, "no bus, expected socketcand:HOST:PORT/BUS");
    }
    ReadHostAndPort(text.substr(0U, slash), parts);
    ReadInterface(text.substr(slash + 1U), parts);
}

void ReadUdp(const std::string& text, LiveAddress& parts)
{
    const std::size_t mark = text.find('?');
    ReadHostAndPort(text.substr(0U, mark), parts);
    in_addr group{};
    const bool is_group = (::inet_pton(AF_INET, parts.host.c_str(), &group) == 1) && IN_MULTICAST(ntohl(group.s_addr));
    if (!is_group)
    {
        Refuse(parts.text, "group '" + parts.host + "', expected an IPv4 multicast group such as 239.74.163.2");
    }
    if (mark == std::string::npos)
    {
        return;
    }
    const std::string option = text.substr(mark + 1U);
    const std::string key = "bitrate=";
    if (option.compare(0U, key.size(), key) != 0)
    {
        Refuse(parts.text, "option '" + option + "', expected bitrate=N");
    }
    parts.bits_per_second = NumberOf(option.substr(key.size()), 1'000'000U);
    if (!BitRateFrom(parts.bits_per_second))
    {
        Refuse(parts.text, "bit rate '" + option.substr(key.size()) +
                               "', expected 10000, 20000, 50000, 100000, 125000, 250000, 500000, 800000 or 1000000");
    }
}

} // namespace

HostAndPort SplitHostAndPort(const std::string& text)
{
    const std::size_t colon = text.rfind(':');
    if (colon == std::string::npos)
    {
        return {};
    }
    const std::string before = text.substr(0U, colon);
    const bool is_bracketed = (before.size() > 2U) && (before.front() == '[') && (before.back() == ']');
    const std::string host = is_bracketed ? before.substr(1U, before.size() - 2U) : before;
    // Without brackets nobody knows where an address with colons ends.
    const bool is_plain = host.find_first_of(is_bracketed ? "[]" : "[]:") == std::string::npos;
    return is_plain ? HostAndPort{host, text.substr(colon + 1U)} : HostAndPort{};
}

std::string HostBeforePort(const std::string& host)
{
    return (host.find(':') == std::string::npos) ? host : "[" + host + "]";
}

LiveAddress ParseLiveAddress(const std::string& address)
{
    // Messages show the address as it is: one line, whatever it holds.
    const auto control = std::find_if(address.begin(), address.end(), [](const char letter)
                                      { return ((letter >= 0) && (letter < ' ')) || (letter == kDelete); });
    if (control != address.end())
    {
        throw LiveBusError("control character in column " + std::to_string(control - address.begin() + 1) +
                           " of a bus, expected printable text such as can0");
    }
    LiveAddress parts;
    parts.text = address;
    const std::size_t colon = address.find(':');
    const std::string scheme = address.substr(0U, colon);
    const std::string rest = (colon == std::string::npos) ? std::string{} : address.substr(colon + 1U);
    if (colon == std::string::npos)
    {
        parts.kind = LiveKind::kSocketCan;
        ReadInterface(address, parts);
    }
    else if (scheme == "socketcan")
    {
        parts.kind = LiveKind::kSocketCan;
        ReadInterface(rest, parts);
    }
    else if (scheme == "socketcand")
    {
        parts.kind = LiveKind::kSocketcand;
        ReadSocketcand(rest, parts);
    }
    else if (scheme == "udp")
    {
        parts.kind = LiveKind::kUdp;
        ReadUdp(rest, parts);
    }
    else
    {
        Refuse(address, "kind '" + scheme +
                            "', expected can0, socketcan:can0, socketcand:HOST:PORT/can0 or "
                            "udp:239.74.163.2:43113");
    }
    return parts;
}

} // namespace counterpoint::host
