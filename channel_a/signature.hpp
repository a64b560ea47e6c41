// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_SIGNATURE_HPP
#define CHANNEL_A_SIGNATURE_HPP

#include "channel_a/storage.hpp"
#include "channel_a/voice.hpp"

#include <cstdint>

namespace counterpoint::channel_a
{

/// @brief CRC-16 over the values of one SRDO, each fed to the table as it is read. O(entries) [SRS-CFG-010]
[[nodiscard]] std::uint32_t Signature(const Record& record, const Mapping& mapping) noexcept;

} // namespace counterpoint::channel_a

#endif
