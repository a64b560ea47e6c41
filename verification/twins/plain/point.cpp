// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/twins/plain/point.hpp"

#include <utility>

namespace counterpoint::twins::plain
{

namespace
{
const char* TextOf(Slip slip)
{
    static const char* const kTexts[] = {"",
                                         "always",
                                         "never",
                                         "the opposite",
                                         "left out",
                                         "0",
                                         "one more",
                                         "one less",
                                         "all bits 1",
                                         "the limit itself is refused",
                                         "only below the limit",
                                         "sum of the instants",
                                         "a thousandth",
                                         "one of the two suffices",
                                         "both are needed",
                                         "exactly one of the two",
                                         "down instead of up",
                                         "difference instead of sum",
                                         "quotient instead of product",
                                         "sum instead of difference",
                                         "only the first",
                                         "all but the first",
                                         "the greater",
                                         "always the room",
                                         "or instead of exclusive or",
                                         "and instead of exclusive or"};
    return kTexts[static_cast<std::uint8_t>(slip)];
}
} // namespace

Point::Point(const char* requirement, const char* what, std::vector<Slip> slips)
    : requirement_{requirement}, what_{what}, slips_{std::move(slips)}
{
    All().push_back(this);
}

std::string Point::Text(Slip slip) const
{
    return std::string{what_} + ": " + TextOf(slip);
}

/// Not told to the compiler, which knows that no enumeration has it.
std::uint64_t Point::Ones() noexcept
{
    return ~std::uint64_t{0U};
}

std::vector<const Point*>& Point::All()
{
    static std::vector<const Point*> all;
    return all;
}

} // namespace counterpoint::twins::plain
