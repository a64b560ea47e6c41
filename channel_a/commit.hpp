// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_COMMIT_HPP
#define CHANNEL_A_COMMIT_HPP

#include "channel_a/voice.hpp"

// What Commit does with the objects, once it is settled for which slots.
namespace counterpoint::channel_a
{

/// @brief Writes the objects of those `slots` that are not in `kept`, then reads those of all `slots`: they hold the
/// safe value where the slot is in `safe`, else the held pair. Returns the slots of which an object holds something
/// else. [SRS_REL_002, SRS_REL_011]
[[nodiscard]] SrdoMask WriteAndHold(Voice& voice, SrdoMask slots, SrdoMask kept, SrdoMask safe) noexcept;

} // namespace counterpoint::channel_a

#endif
