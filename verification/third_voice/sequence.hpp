// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_THIRD_VOICE_SEQUENCE_HPP
#define VERIFICATION_THIRD_VOICE_SEQUENCE_HPP

#include "verification/third_voice/device.hpp"

#include <cstdint>
#include <string>

namespace counterpoint::third_voice
{
/// Where the semantics are silent, or kernel and channels do otherwise: the README has the list.
enum class Questions : std::uint8_t
{
    kSpared = 0U,
    kAsked, ///< The model answers as the text reads, and a difference is one.
};

/// What one sequence came to.
struct SequenceResult
{
    bool is_equal{true};
    std::string difference; ///< What was seen where, and what the model expects.
    std::string story;      ///< The last steps before it.
    std::uint32_t steps{0U};
    std::uint32_t releases{0U}; ///< How often the model released a pair, and
    std::uint32_t faults{0U};   ///< how many causes it signalled: a sequence of which nothing happens shows nothing.
    std::uint32_t refusals{0U}; ///< Writes that both refused.
    bool is_undecided{false};   ///< It ended early, at an open question of the README.
};

/// @brief Draws a device and what happens to it from the seed; compares device and model behind every step. `flaw`
/// breaks the model.
[[nodiscard]] SequenceResult RunSequence(std::uint64_t seed, Flaw flaw = Flaw::kNone,
                                         Questions questions = Questions::kSpared);
} // namespace counterpoint::third_voice

#endif
