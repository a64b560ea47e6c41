// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/voice.hpp"

namespace counterpoint::channel_a
{

void PutIn(SrdoMask& mask, const std::size_t slot) noexcept
{
    mask |= BitOf(slot);
}

void TakeOut(SrdoMask& mask, const std::size_t slot) noexcept
{
    mask &= ~BitOf(slot);
}

} // namespace counterpoint::channel_a
