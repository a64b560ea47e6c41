// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_SDO_PARAMETERS_HPP
#define CANOPEN_CIA301_SDO_PARAMETERS_HPP

#include "canopen/cia301/base/cob_id.hpp"
#include "canopen/cia301/dictionary/number_hook.hpp"

#include <cstdint>

// What the objects of further SDO servers (1201h..) and of SDO clients (1280h..) have in common, after CiA 301.
namespace counterpoint::cia301
{

/// Which side of an SDO connection the device is.
enum class SdoSide : std::uint8_t
{
    kInvalid = 0U,
    kServer = 1U,
    kClient = 2U, ///< May use the identifiers of default servers.
};

/// Sub-index 1, 2 and 3 of a connection.
struct SdoParameters
{
    std::uint32_t request{kCobOff}; ///< COB-ID from client to server.
    std::uint32_t answer{kCobOff};  ///< COB-ID from server to client.
    std::uint8_t partner{0U};       ///< Node-ID of the other side; 0: not told.
};

/// @brief Whether both COB-IDs are valid; there is no connection otherwise.
[[nodiscard]] constexpr bool IsOn(const SdoParameters& parameters) noexcept
{
    return ((parameters.request | parameters.answer) & kCobOff) == 0U;
}
/// @brief Whether one of the COB-IDs is valid and has this identifier.
[[nodiscard]] constexpr bool HasIdentifier(const SdoParameters& parameters, const std::uint32_t identifier) noexcept
{
    return (parameters.request == identifier) || (parameters.answer == identifier);
}
/// @brief A sub-index as the bus reads it; 0 is 3. O(1)
[[nodiscard]] ObjectValue FetchSdo(const SdoParameters& parameters, std::uint8_t sub) noexcept;
/// @brief Changes a sub-index: a COB-ID changes only while it is off, the node is 0 to 127. O(1) [SRS_SDO_018]
[[nodiscard]] SdoAbort StoreSdo(SdoParameters& parameters, SdoSide side, std::uint8_t sub,
                                std::uint32_t value) noexcept;
/// @brief The same for a value of a configuration: an identifier changes also while it is on. O(1) [SRS_OBD_016]
[[nodiscard]] SdoAbort LoadSdo(SdoParameters& parameters, SdoSide side, std::uint8_t sub, std::uint32_t value) noexcept;

} // namespace counterpoint::cia301

#endif
