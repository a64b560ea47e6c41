// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_LIVE_ADDRESS_HPP
#define HAL_HOST_LIVE_ADDRESS_HPP

#include <cstdint>
#include <string>

namespace counterpoint::host
{

enum class LiveKind : std::uint8_t
{
    kInvalid = 0U,
    kSocketCan = 1U,
    kSocketcand = 2U,
    kUdp = 3U,
};

/// The parts of an address of a live bus; those that its kind does not have are empty.
struct LiveAddress
{
    LiveKind kind{LiveKind::kInvalid};
    std::string text; ///< As it was given.
    std::string host; ///< Host of socketcand, group of UDP.
    std::uint16_t port{0U};
    std::string interface;             ///< Name of the interface or of the bus.
    std::uint32_t bits_per_second{0U}; ///< 0: no pace.
};

/// HOST:PORT before its port is a number.
struct HostAndPort
{
    std::string host; ///< Without the brackets that an address with colons has here; empty: the text is none.
    std::string port;
};
[[nodiscard]] HostAndPort SplitHostAndPort(const std::string& text);
/// @brief As it stands before a port: with colons in brackets.
[[nodiscard]] std::string HostBeforePort(const std::string& host);

/// @brief Throws LiveBusError with the address and what was expected. [SRS_LIVE_001]
[[nodiscard]] LiveAddress ParseLiveAddress(const std::string& address);

} // namespace counterpoint::host

#endif
