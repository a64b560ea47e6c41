// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_FAULTS_RIGHT_RESPONSE_HPP
#define SIMULATOR_FAULTS_RIGHT_RESPONSE_HPP

#include "safety_core/contract/channel.hpp"

#include <cstdint>

namespace counterpoint::simulator
{
/// The rule of SRS_REL_010, written down once more: what a healthy party answers for this mask.
[[nodiscard]] inline std::uint32_t RightResponse(const SrdoMask mask, const std::uint32_t challenge,
                                                 const std::uint32_t constant) noexcept
{
    constexpr std::uint32_t kWordBits = 32U;
    constexpr std::uint32_t kRotation = 16U;
    const auto low = static_cast<std::uint32_t>(mask);
    const auto high = static_cast<std::uint32_t>(mask >> kWordBits);
    const std::uint32_t rotated = (high << kRotation) | (high >> (kWordBits - kRotation));
    return ((challenge + low) ^ rotated) * constant;
}
} // namespace counterpoint::simulator

#endif // SIMULATOR_FAULTS_RIGHT_RESPONSE_HPP
