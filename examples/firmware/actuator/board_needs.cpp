// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "examples/firmware/common/board_needs.hpp"

namespace counterpoint::firmware
{
namespace
{

using tms570::CanObject;
using tms570::ObjectUse;

constexpr CanObject kObjects[]{
    kNmtObject,
    kGfcObject,
    {0x721U, ObjectUse::kTransmit}, // Boot-up message of node 33.
    {0x103U, ObjectUse::kReceive},
    {0x104U, ObjectUse::kReceive},
};

} // namespace

BoardNeeds DescribeNeeds() noexcept
{
    return NeedsOf(kObjects, BoardPins{0x80U, {1U}});
}

} // namespace counterpoint::firmware
