// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_CROSSLINK_ARMED_FRAMES_HPP
#define SAFETY_CORE_CROSSLINK_ARMED_FRAMES_HPP

#include "safety_core/crosslink/link_supervisor.hpp"

#include <cstdint>

namespace counterpoint
{

/// A frame that the follower prepared, and for how long it awaits it on the bus.
struct Arming
{
    SlotIndex slot;
    CanFrame frame;
    Instant now;
    std::uint32_t limit_us;
};

/// What the follower has prepared and awaits from the leader: few at a time, each for its SRVT. [SRS_TWO_151,
/// SRS_TWO_012]
class ArmedFrames
{
  public:
    /// @brief All places are free. The numbers of frames go on from where they were.
    void Restart() noexcept;
    /// @brief Into a free place; no effect if there is none.
    void Arm(const Arming& arming) noexcept;
    /// @brief The normal frame of this slot was on the bus at `at`.
    void Answer(SlotIndex slot, Instant at) noexcept;
    /// @brief The leader gave up the frame of this number. Returns its slot, which counts as answered from now on;
    /// kNoSlot if the frame is not awaited.
    [[nodiscard]] SlotIndex Refuse(const Refusal& refusal, Instant at) noexcept;
    /// @brief Gives up what has waited for longer than its limit.
    void Examine(Instant now) noexcept;
    /// @brief A message of the leader was taken: what was answered before it was composed is done.
    void Clear(const Window& composed) noexcept;
    /// @brief Slots armed or answered.
    [[nodiscard]] SrdoMask Slots() const noexcept;
    /// @brief At most as many of `wanted`, the lowest first, as there are free places.
    [[nodiscard]] SrdoMask Fitting(SrdoMask wanted) const noexcept;
    /// @brief What the message tells at this place; slot kNoSlot unless a frame is awaited.
    [[nodiscard]] ArmedFrame At(std::uint8_t place) const noexcept;

  private:
    enum class Stage : std::uint8_t
    {
        kFree = 0U,
        kAwaited = 0x4DU,
        kAnswered = 0xB2U,
    };
    struct Place
    {
        ArmedFrame armed;
        Instant since; ///< Armed, or answered.
        std::uint32_t limit_us;
        Stage stage;
    };

    Place places_[kArmedCount]{}; // MISRA D-001
    std::uint8_t number_{0U};
};

} // namespace counterpoint

#endif
