// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_RULES_HPP
#define CHANNEL_A_RULES_HPP

#include "channel_a/mapping.hpp"
#include "channel_a/voice.hpp"
#include "safety_core/contract/configuration.hpp"

#include <cstddef>
#include <cstdint>

// The rules of the configuration, one after the other on the stored fields, and the checks over all of them.
namespace counterpoint::channel_a
{

[[nodiscard]] CheckResult ValidateSlot(Voice& voice, std::size_t slot) noexcept;
[[nodiscard]] CheckResult RecheckSlot(const Voice& voice, std::size_t slot) noexcept;
/// @brief CRC-16 over the fields of one SRDO. O(entries) [SRS_CFG_010]
[[nodiscard]] std::uint16_t SignatureOf(const Record& record, const Mapping& mapping) noexcept;
/// @brief CRC-32 over what the signature does not cover. [SRS_CFG_034]
[[nodiscard]] DeviceDigest DigestOf(const Voice& voice, std::size_t slot, DeviceDigest before) noexcept;

} // namespace counterpoint::channel_a

#endif
