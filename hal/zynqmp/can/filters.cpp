// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// One identifier after the other: it takes a free filter, or joins the filter that it, or two filters that each other,
// widen least.
#include "hal/zynqmp/can/filters.hpp"

namespace counterpoint::zynqmp
{

namespace
{

using namespace canps;

constexpr std::uint32_t kIdentifierBits = 11U;

[[nodiscard]] AcceptanceFilter Join(const AcceptanceFilter& one, const AcceptanceFilter& other) noexcept
{
    const std::uint32_t differ = std::uint32_t{one.identifier} ^ std::uint32_t{other.identifier};
    const std::uint32_t mask = std::uint32_t{one.mask} & std::uint32_t{other.mask} & ~differ;
    return AcceptanceFilter{static_cast<std::uint16_t>(one.identifier & mask), static_cast<std::uint16_t>(mask)};
}

/// How many identifiers a filter lets pass.
[[nodiscard]] std::uint32_t WidthOf(const AcceptanceFilter& filter) noexcept
{
    std::uint32_t width = 1U;
    for (std::uint32_t bit = 0U; bit < kIdentifierBits; ++bit)
    {
        width <<= ((std::uint32_t{filter.mask} >> bit) & 1U) ^ 1U;
    }
    return width;
}

/// Joins the two of `filters` that then let fewest pass; `count` of them are there, one less afterwards.
void JoinNearest(AcceptanceFilter* const filters, const std::uint8_t count) noexcept
{
    std::uint32_t least = kIdentifierMask + 2U;
    std::uint8_t kept = 0U;
    std::uint8_t gone = 1U;
    for (std::uint8_t one = 0U; one < count; ++one)
    {
        for (std::uint8_t other = static_cast<std::uint8_t>(one + 1U); other < count; ++other)
        {
            const std::uint32_t width = WidthOf(Join(filters[one], filters[other])); // MISRA D-002
            if (width < least)
            {
                least = width;
                kept = one;
                gone = other;
            }
        }
    }
    filters[kept] = Join(filters[kept], filters[gone]); // MISRA D-002
    filters[gone] = filters[count - 1U];                // MISRA D-002
}

} // namespace

FilterPlan PlanFilters(const IdentifierList& identifiers) noexcept
{
    AcceptanceFilter filters[kMostFilters + 1U]{}; // MISRA D-001
    std::uint8_t count = 0U;
    for (std::uint8_t number = 0U; number < identifiers.count; ++number)
    {
        const std::uint16_t identifier = identifiers.first[number]; // MISRA D-002
        if (identifier > kIdentifierMask)
        {
            return FilterPlan{{}, 0U};
        }
        filters[count] = AcceptanceFilter{identifier, static_cast<std::uint16_t>(kIdentifierMask)};
        ++count;
        if (count > kMostFilters)
        {
            JoinNearest(&filters[0], count);
            --count;
        }
    }
    FilterPlan plan{{}, count};
    for (std::uint8_t number = 0U; number < count; ++number)
    {
        plan.filters[number] = filters[number];
    }
    return plan;
}

} // namespace counterpoint::zynqmp
