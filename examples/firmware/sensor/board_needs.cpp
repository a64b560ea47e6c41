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
    {0x701U, ObjectUse::kTransmit}, // Boot-up message of node 1.
    {0x101U, ObjectUse::kTransmit},
    {0x102U, ObjectUse::kTransmit},
};

} // namespace

BoardNeeds DescribeNeeds() noexcept
{
    return NeedsOf(kObjects, BoardPins{0U, {}});
}

} // namespace counterpoint::firmware
