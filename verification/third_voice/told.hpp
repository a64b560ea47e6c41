// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_THIRD_VOICE_TOLD_HPP
#define VERIFICATION_THIRD_VOICE_TOLD_HPP

#include "verification/third_voice/device.hpp"

#include <string>

namespace counterpoint::third_voice
{
/// What is not compared: the README's open questions.
struct Sparing
{
    bool frame_causes; ///< Causes of frames and limits: some came between an NMT command and the cycle behind it.
    bool gfc;          ///< While no SRDO is on.
};

[[nodiscard]] std::string TextOf(Seen seen, const Sparing& sparing);
} // namespace counterpoint::third_voice

#endif
