// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_LIVE_ADDRESS_HPP
#define HAL_HOST_LIVE_ADDRESS_HPP

#include <cstdint>
#include <string>

namespace counterpoint::host
{

/// Kinds of live buses.
enum class LiveKind : std::uint8_t
{
    kInvalid = 0U,
    kSocketCan = 1U,
    kSocketcand = 2U,
    kUdp = 3U,
};

/// The parts of the address of a live bus; parts that its kind does not have are empty.
struct LiveAddress
{
    LiveKind kind{LiveKind::kInvalid};
    std::string text; ///< As it was given.
    std::string host; ///< Host of socketcand, group of UDP.
    std::uint16_t port{0U};
    std::string interface;             ///< Name of the interface or of the bus.
    std::uint32_t bits_per_second{0U}; ///< 0: no pace.
};

/// HOST:PORT in two parts; the port is not a number yet.
struct HostAndPort
{
    std::string host; ///< Without the brackets that an address with colons has here; empty: the text is none.
    std::string port;
};
/// @brief Splits a text at its last colon. A host with colons must stand in brackets; the text is none otherwise.
[[nodiscard]] HostAndPort SplitHostAndPort(const std::string& text);
/// @brief A host as it is written before a port: an address with colons in brackets.
[[nodiscard]] std::string HostBeforePort(const std::string& host);

/// @brief Reads an address. Throws LiveBusError, which names the address and what was expected. [SRS_LIVE_001]
[[nodiscard]] LiveAddress ParseLiveAddress(const std::string& address);

} // namespace counterpoint::host

#endif
