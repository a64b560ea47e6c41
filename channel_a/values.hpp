// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_VALUES_HPP
#define CHANNEL_A_VALUES_HPP

#include "channel_a/voice.hpp"
#include "safety_core/contract/configuration.hpp"

#include <cstddef>
#include <cstdint>

// The own copy of the configuration: what is stored, and what is read back.
namespace counterpoint::channel_a
{

/// @brief The values of one SRDO as at power-on. [SRS_CFG_002]
void SetDefaults(Record& record, std::uint8_t number, std::uint8_t node_id) noexcept;
void StoreValue(Voice& voice, const ConfigItem& item) noexcept;
/// @brief 0 for what does not exist.
[[nodiscard]] std::uint32_t LoadValue(const Voice& voice, const ConfigAddress& address) noexcept;
/// @brief The fields of a static mapping.
void StoreFields(const Voice& voice, std::size_t slot, const StaticFields& fields) noexcept;

} // namespace counterpoint::channel_a

#endif
