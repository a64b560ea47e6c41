// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TWO_CPU_COMPARATOR_TAP_HPP
#define VERIFICATION_TWO_CPU_COMPARATOR_TAP_HPP

#include "safety_core/kernel/kernel.hpp"

namespace counterpoint::two_cpu
{

/// @brief From now on the comparator of this kernel says what it said last; null: none does. The linker leads the
/// kernel's calls here (decision 0004).
void FreezeComparator(const Kernel* kernel);

} // namespace counterpoint::two_cpu

#endif
