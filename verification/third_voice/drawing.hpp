// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_THIRD_VOICE_DRAWING_HPP
#define VERIFICATION_THIRD_VOICE_DRAWING_HPP

#include "safety_core/contract/configuration.hpp"
#include "verification/third_voice/dice.hpp"
#include "verification/third_voice/drift.hpp"

#include <cstdint>
#include <vector>

namespace counterpoint::third_voice
{
/// A device that was drawn. Its owner sets `config.srdos`, and the places of the objects.
struct Drawing
{
    std::vector<SrdoSetup> setups;
    std::vector<std::uint32_t> scts; ///< Of each SRDO, in milliseconds: the window of a told cause goes with it.
    std::vector<MappableObject> objects;
    DeviceConfig config{};
    std::uint32_t window_cycles{0U}; ///< Acknowledge window.
    bool is_dense{false};            ///< SCT and refresh times that a late cycle exceeds.
};

/// How the counters of a sequence run.
enum class Pace : std::uint8_t
{
    kAlike,
    kDrifting, ///< Producers alone, mostly with refreshes that fall due at the instants of the calls.
};

/// @brief `is_asked`: discrepancy times above the acknowledge window, too.
[[nodiscard]] Drawing Draw(Dice& dice, bool is_asked, Pace pace);
/// @brief Counters that part by 1 to 100 ppm, either way, or by one microsecond once; for a dense drawing often by as
/// much as the kernel's supervision bears.
[[nodiscard]] Drift AnyDrift(Dice& dice, const Drawing& drawing);
} // namespace counterpoint::third_voice

#endif
