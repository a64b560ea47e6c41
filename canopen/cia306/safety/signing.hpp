// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_SAFETY_SIGNING_HPP
#define CANOPEN_CIA306_SAFETY_SIGNING_HPP

#include "canopen/cia306/safety/safety_configuration.hpp"
#include "canopen/cia306/text/ini_document.hpp"

#include <cstdint>
#include <optional>

namespace counterpoint::cia306
{
/// The document with ParameterValue of 13FFh sub n set to the signature of each SRDO n of the configuration, and that
/// of 5F04h, where it is there, to the device digest; all else is kept. Throws InputError where an SRDO cannot be
/// signed, 13FFh has no place for it, or the result, read back, does not hold them. [SRS_CLI_005, SRS_CLI_006,
/// SRS_CLI_021]
[[nodiscard]] IniDocument WithSignatures(const IniDocument& document, const Device& device,
                                         std::optional<std::uint8_t> node_id);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_SAFETY_SIGNING_HPP
