// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/memcheck/tell.hpp"

#include <valgrind/memcheck.h>

namespace counterpoint::host
{

void TellMemcheck(const volatile std::uint32_t* const cell) noexcept
{
    static_cast<void>(VALGRIND_MAKE_MEM_DEFINED(cell, sizeof(*cell)));
}

} // namespace counterpoint::host
