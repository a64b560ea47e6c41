// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_THIRD_VOICE_TALKER_HPP
#define VERIFICATION_THIRD_VOICE_TALKER_HPP

#include "safety_core/contract/can_frame.hpp"
#include "verification/third_voice/configuration.hpp"
#include "verification/third_voice/consumer.hpp"
#include "verification/third_voice/dice.hpp"

#include <cstdint>

namespace counterpoint::third_voice
{
/// Somebody who sends the pairs of one SRDO, mostly well.
struct Talker
{
    std::uint8_t number{0U};
    Time next{0}; ///< When the next frame comes.
    Time normal_at{0};
    bool is_dense{false}; ///< Often a whole pair, or more, between two cycles, and wrong frames among them.
    bool is_inverse{false};
    bool is_wrong{false}; ///< The frame that was spoken last.
    std::uint64_t data{0U};

    /// @brief The next frame, sometimes wrong.
    [[nodiscard]] CanFrame Speak(const SrdoObjects& objects, Dice& dice);
    /// @brief What comes behind a frame at `now`, and when: within its limit, mostly.
    void Plan(const SrdoObjects& objects, Time now, Dice& dice);
};
} // namespace counterpoint::third_voice

#endif
