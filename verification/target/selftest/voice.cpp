// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/target/selftest/voice.hpp"

#ifndef __clang__
#error "channel B's compiler is not Clang: the launcher did not replace the compiler"
#endif

namespace counterpoint::target
{

ClangVoice::ClangVoice(const Note& first) noexcept : kept_(first)
{
}

Note ClangVoice::Answer(const Note& note) noexcept
{
    const Note answer = {kept_.pitch + note.pitch,
                         kept_.mask ^ (note.mask << 8U),
                         {note.bytes[3], note.bytes[2], note.bytes[1], note.bytes[0]}};
    kept_ = note;
    return answer;
}

} // namespace counterpoint::target
