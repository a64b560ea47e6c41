// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_OBJECTS_HPP
#define CHANNEL_A_OBJECTS_HPP

#include "channel_a/bytes.hpp"
#include "channel_a/voice.hpp"

#include <cstddef>

// The only source that reads and writes objects of the application: the normal ones, by the steps of the mapping.
namespace counterpoint::channel_a
{

/// @brief The data that the normal objects hold. [SRS_PROD_005]
[[nodiscard]] Bytes ReadObjects(Voice& voice, std::size_t slot) noexcept;
/// @brief Data into the normal objects. [SRS_REL_002]
void WriteObjects(Voice& voice, std::size_t slot, const Bytes& data) noexcept;
/// @brief Whether every normal object holds its part of the data. [SRS_REL_011]
[[nodiscard]] bool HoldObjects(Voice& voice, std::size_t slot, const Bytes& data) noexcept;

} // namespace counterpoint::channel_a

#endif
