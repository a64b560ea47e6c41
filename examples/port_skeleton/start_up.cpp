// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "start_up.hpp"

namespace port_skeleton
{

PartState StateOfStartUp() noexcept
{
    return PartState::kMissing;
}

} // namespace port_skeleton
