// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_B_TICK_HPP
#define CHANNEL_B_TICK_HPP

#include "safety_core/contract/srdo.hpp"

#include <cstdint>

namespace counterpoint::channel_b
{

/// What one call of OnCycle tells all slots.
struct Tick
{
    std::uint32_t elapsed_us; ///< What every budget is to be relieved of; 0 in the call that enters OPERATIONAL.
    SrdoMask edges;           ///< Slots whose acknowledge level rose.
    SrdoMask requests;
    SrdoMask stand;
    bool is_late;
    bool is_overflowed;
    bool is_gfc;
};

} // namespace counterpoint::channel_b

#endif
