// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/two_cpu/comparator_tap.hpp"

#include <functional>

namespace counterpoint::two_cpu
{
namespace
{
const Kernel* frozen_kernel = nullptr;

bool IsInside(const Comparator& comparator)
{
    const auto* const place = reinterpret_cast<const unsigned char*>(&comparator);
    const auto* const begin = reinterpret_cast<const unsigned char*>(frozen_kernel);
    const std::less<const unsigned char*> is_before{};
    return (frozen_kernel != nullptr) && !is_before(place, begin) && is_before(place, begin + sizeof(Kernel));
}
} // namespace

Verdict RealCompare(Comparator& self, const Comparison& comparison) noexcept
    __asm__("__real__ZN12counterpoint10Comparator7CompareERKNS_10ComparisonE");
Verdict WrapCompare(Comparator& self, const Comparison& comparison) noexcept
    __asm__("__wrap__ZN12counterpoint10Comparator7CompareERKNS_10ComparisonE");

Verdict WrapCompare(Comparator& self, const Comparison& comparison) noexcept
{
    return IsInside(self) ? frozen_kernel->LastVerdict() : RealCompare(self, comparison);
}

void FreezeComparator(const Kernel* const kernel)
{
    frozen_kernel = kernel;
}

} // namespace counterpoint::two_cpu
