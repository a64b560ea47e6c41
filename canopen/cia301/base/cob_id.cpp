// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/base/cob_id.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint32_t kLast = 0x7FFU;
constexpr std::uint32_t kRestricted[][2] = {{0x000U, 0x07FU}, {0x101U, 0x180U}, {0x581U, 0x5FFU},
                                            {0x601U, 0x67FU}, {0x6E0U, 0x6FFU}, {0x701U, 0x7FFU}};

} // namespace

bool IsConfigurable(const std::uint32_t identifier) noexcept
{
    bool is_free = (identifier <= kLast);
    for (const auto& range : kRestricted)
    {
        is_free = is_free && ((identifier < range[0]) || (identifier > range[1]));
    }
    return is_free;
}

} // namespace counterpoint::cia301
