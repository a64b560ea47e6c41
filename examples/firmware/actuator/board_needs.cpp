// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "examples/firmware/common/board_needs.hpp"

namespace counterpoint::firmware
{
namespace
{

using tms570::CanObject;
using tms570::ObjectUse;

// NMT, global fail-safe command, then two objects for each SRDO.
constexpr CanObject kObjects[]{
    {0x000U, ObjectUse::kReceive},
    {0x001U, ObjectUse::kReceive},
    {0x103U, ObjectUse::kReceive},
    {0x104U, ObjectUse::kReceive},
};

} // namespace

BoardNeeds DescribeNeeds() noexcept
{
    constexpr auto kCount = static_cast<std::uint8_t>(sizeof(kObjects) / sizeof(kObjects[0]));
    return BoardNeeds{kObjects, kCount, 33U, 0x80U, {1U}};
}

} // namespace counterpoint::firmware
