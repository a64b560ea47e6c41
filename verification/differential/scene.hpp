// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_DIFFERENTIAL_SCENE_HPP
#define VERIFICATION_DIFFERENTIAL_SCENE_HPP

#include "safety_core/contract/channel.hpp"
#include "verification/differential/device.hpp"
#include "verification/differential/random.hpp"
#include "verification/differential/reached.hpp"

#include <cstdint>

namespace counterpoint::differential
{

/// What the parts of a run share: the channels, the random device, and what the generator knows of its sequence.
struct Scene
{
    Scene(Channel& channel_a, Channel& channel_b) noexcept : a{channel_a}, b{channel_b}
    {
    }
    /// @brief A new device, of which nothing is configured yet.
    void MakeDevice() noexcept;
    void StartClock() noexcept;
    [[nodiscard]] SlotIndex AnySlot() noexcept;
    [[nodiscard]] Payload AnyData() noexcept;
    [[nodiscard]] CanFrame FrameOf(SlotIndex slot, bool is_inverse, const Payload& data) const noexcept;
    void LetTimePass(std::uint32_t most_us) noexcept;
    void GoNear(SlotIndex slot) noexcept;

    Channel& a;
    Channel& b;
    Random random{};
    Device device{};
    Reached reached{};
    std::uint32_t last_us[kMaxSrdoCount]{}; ///< Stamp of the latest normal frame.
    SrdoMask request{0U};                   ///< For the next OnCycle.
    SrdoMask stand{0U};                     ///< For the next OnCycle.
    SrdoMask configured{0U};                ///< Slots whose last Validate found no fault.
    std::uint32_t clock_us{0U};             ///< Time on the bus: never behind `now_us`.
    std::uint32_t now_us{0U};               ///< Of the last OnCycle.
    NmtState nmt{NmtState::kPreOperational};
    std::uint8_t configuration_valid{0U};
    bool has_odd_mapping{false};
};

} // namespace counterpoint::differential

#endif
