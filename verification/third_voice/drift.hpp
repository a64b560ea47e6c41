// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_THIRD_VOICE_DRIFT_HPP
#define VERIFICATION_THIRD_VOICE_DRIFT_HPP

#include "verification/third_voice/consumer.hpp"

namespace counterpoint::third_voice
{
/// How counter B runs beside counter A, which tells the model's time. Below a million parts: it never goes back.
struct Drift
{
    Time parts_per_million{0};
    Time step_us{0}; ///< Once, at `step_at`: at most a microsecond back.
    Time step_at{0};

    /// @brief What counter B says at `now`.
    [[nodiscard]] Time ByB(const Time now) const
    {
        constexpr Time kMillion = 1000000;
        return now + ((now * parts_per_million) / kMillion) + ((now >= step_at) ? step_us : 0);
    }
};
} // namespace counterpoint::third_voice

#endif
