// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/console/told_count.hpp"

namespace counterpoint::runtime
{
namespace
{
constexpr std::uint64_t kNsPerSecond = 1000000000U;
} // namespace

bool ToldCount::Learn(const std::uint32_t count) noexcept
{
    const bool is_other = count != count_;
    count_ = count;
    return is_other;
}

std::uint32_t ToldCount::Due(const std::uint64_t now_ns) noexcept
{
    const bool may_tell = told_ns_ == 0U || now_ns - told_ns_ >= kNsPerSecond;
    const std::uint32_t due = may_tell ? count_ - told_ : 0U;
    if (due != 0U)
    {
        told_ = count_;
        told_ns_ = now_ns;
    }
    return due;
}

std::string MalformedText(const std::uint32_t count, const std::string& problem)
{
    return std::to_string(count) + (count == 1U ? " malformed element" : " malformed elements") +
           " of the bus left out" + (problem.empty() ? "" : ", the last: " + problem);
}
} // namespace counterpoint::runtime
