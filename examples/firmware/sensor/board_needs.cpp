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
    {0x101U, ObjectUse::kTransmit},
    {0x102U, ObjectUse::kTransmit},
};

} // namespace

BoardNeeds DescribeNeeds() noexcept
{
    return NeedsOf(kObjects, 1U, BoardPins{0U, {}});
}

} // namespace counterpoint::firmware
