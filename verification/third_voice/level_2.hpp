// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_THIRD_VOICE_LEVEL_2_HPP
#define VERIFICATION_THIRD_VOICE_LEVEL_2_HPP

namespace counterpoint::third_voice
{
/// The safe state of the device, once demanded for ever: consumers release nothing, producers send nothing, no own GFC
/// leaves. [semantics 4]
class Level2
{
  public:
    void Demand()
    {
        is_on_ = true;
    }

    [[nodiscard]] bool IsOn() const
    {
        return is_on_;
    }

    /// @brief Of a cycle: whether it tells of it. The first one behind the demand does.
    [[nodiscard]] bool Tell()
    {
        const bool is_new = is_on_ && !is_told_;
        is_told_ = is_on_;
        return is_new;
    }

  private:
    bool is_on_{false};
    bool is_told_{false};
};
} // namespace counterpoint::third_voice

#endif
