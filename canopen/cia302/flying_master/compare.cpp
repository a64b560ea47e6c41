// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia302/flying_master/compare.hpp"

#include "canopen/cia302/flying_master/comparison.hpp"

namespace counterpoint::cia302
{

std::uint32_t CompareFlyingMasters(const FlyingMasterView* const masters, const std::uint8_t count,
                                   FlyingFindingListener& listener) noexcept
{
    if ((masters == nullptr) || (count == 0U))
    {
        return 0U;
    }
    Comparison comparison(masters, count, listener);
    comparison.CheckNodes();
    for (std::uint8_t i = 0U; i < count; ++i)
    {
        comparison.CheckAlone(i);
    }
    for (std::uint8_t i = 1U; i < count; ++i)
    {
        comparison.CompareWithFirst(i);
    }
    return comparison.Found();
}

} // namespace counterpoint::cia302
