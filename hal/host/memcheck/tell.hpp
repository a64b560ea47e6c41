// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_MEMCHECK_TELL_HPP
#define HAL_HOST_MEMCHECK_TELL_HPP

#include <cstdint>

namespace counterpoint::host
{

/// @brief Tells valgrind's memcheck that a cell may be read whoever wrote it. Where the library was built without
/// valgrind's headers (cell_untold.cpp), it
///        tells nothing and memcheck takes tests of live memory for errors.
void TellMemcheck(const volatile std::uint32_t* cell) noexcept;

} // namespace counterpoint::host

#endif
