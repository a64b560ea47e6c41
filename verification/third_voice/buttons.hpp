// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_THIRD_VOICE_BUTTONS_HPP
#define VERIFICATION_THIRD_VOICE_BUTTONS_HPP

#include "safety_core/contract/configuration.hpp"
#include "verification/third_voice/dice.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace counterpoint::third_voice
{
/// What the two acknowledge inputs of a device read in a cycle.
struct Readings
{
    SrdoMask a{0U};
    SrdoMask b{0U};
};

/// One button for each SRDO, with an input for each channel: pressed for one reading or for many, seen by the second
/// channel at once, within the acknowledge window, at its end, behind it, or never.
class Buttons
{
  public:
    /// @brief The window in cycles.
    void Restart(std::uint8_t count, std::uint32_t window);
    [[nodiscard]] Readings Next(Dice& dice);

  private:
    /// One input: in how many cycles its level rises, and for how many it is high.
    struct Input
    {
        std::uint32_t in{0U};
        std::uint32_t length{0U};
    };
    struct Button
    {
        std::array<Input, 2U> inputs{};
        bool is_inverted{false}; ///< Rests at 1.
    };

    void Press(Button& button, Dice& dice) const;

    std::vector<Button> buttons_;
    std::uint32_t window_{0U};
};
} // namespace counterpoint::third_voice

#endif
