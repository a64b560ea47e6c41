// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "clocks.hpp"

namespace port_skeleton
{

/// Stands still: a kernel that is cycled by it falls into its device safe state.
counterpoint::InstantPair Clocks::Now() noexcept
{
    return counterpoint::InstantPair{{0U}, {0U}};
}

PartState Clocks::State() const noexcept
{
    return PartState::kMissing;
}

} // namespace port_skeleton
