// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/third_voice/buttons.hpp"

namespace counterpoint::third_voice
{
void Buttons::Restart(const std::uint8_t count, const std::uint32_t window)
{
    buttons_.assign(count, Button{});
    window_ = window;
}

void Buttons::Press(Button& button, Dice& dice) const
{
    const std::uint32_t pause = dice.Below(dice.Pick({4U, 12U, 40U}));
    const std::uint32_t skew = dice.Pick<std::uint32_t>(
        {0U, 0U, 1U, 2U, 5U, window_ / 2U, window_ - 1U, window_, window_ + 1U, window_ + 2U, 2U * window_});
    const std::size_t first = dice.Below(2U);
    for (Input& input : button.inputs)
    {
        input.in = pause;
        input.length = dice.Pick<std::uint32_t>({0U, 1U, 1U, 2U, 3U, 3U, 8U, 8U, window_ + 3U});
    }
    button.inputs[1U - first].in = pause + skew;
    button.is_inverted = dice.Chance(15U);
}

Readings Buttons::Next(Dice& dice)
{
    Readings readings;
    for (std::size_t slot = 0U; slot < buttons_.size(); ++slot)
    {
        Button& button = buttons_[slot];
        if (button.inputs[0].length + button.inputs[1].length == 0U)
        {
            Press(button, dice);
        }
        std::array<bool, 2U> levels{};
        for (std::size_t side = 0U; side < 2U; ++side)
        {
            Input& input = button.inputs[side];
            levels[side] = (input.in == 0U && input.length != 0U) != button.is_inverted;
            std::uint32_t& counted = (input.in != 0U) ? input.in : input.length;
            counted -= (counted != 0U) ? 1U : 0U;
        }
        readings.a |= levels[0] ? SrdoMask{1U} << slot : 0U;
        readings.b |= levels[1] ? SrdoMask{1U} << slot : 0U;
    }
    return readings;
}
} // namespace counterpoint::third_voice
