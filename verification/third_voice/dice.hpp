// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_THIRD_VOICE_DICE_HPP
#define VERIFICATION_THIRD_VOICE_DICE_HPP

#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace counterpoint::third_voice
{
/// Draws from a seed, the same everywhere.
class Dice
{
  public:
    explicit Dice(const std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15U + 0x1234567U)
    {
    }
    std::uint64_t Next()
    {
        state_ ^= state_ << 13U;
        state_ ^= state_ >> 7U;
        state_ ^= state_ << 17U;
        return state_;
    }
    /// @brief From 0 to `count` - 1.
    std::uint32_t Below(const std::uint32_t count)
    {
        return static_cast<std::uint32_t>((Next() >> 20U) % count);
    }
    bool Chance(const std::uint32_t percent)
    {
        return Below(100U) < percent;
    }
    template <typename Value> Value Pick(std::initializer_list<Value> values)
    {
        return *(values.begin() + Below(static_cast<std::uint32_t>(values.size())));
    }

  private:
    std::uint64_t state_;
};
} // namespace counterpoint::third_voice

#endif
