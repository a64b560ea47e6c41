// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/memcheck/tell.hpp"

namespace counterpoint::host
{

void TellMemcheck(const volatile std::uint32_t* const /*cell*/) noexcept
{
}

} // namespace counterpoint::host
