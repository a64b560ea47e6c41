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
    {0x711U, ObjectUse::kTransmit}, // Boot-up message of node 17.
    {0x121U, ObjectUse::kTransmit},
    {0x122U, ObjectUse::kTransmit},
    {0x123U, ObjectUse::kTransmit},
    {0x124U, ObjectUse::kTransmit},
    {0x111U, ObjectUse::kReceive},
    {0x112U, ObjectUse::kReceive},
    {0x113U, ObjectUse::kReceive},
    {0x114U, ObjectUse::kReceive},
};

} // namespace

BoardNeeds DescribeNeeds() noexcept
{
    return NeedsOf(kObjects, BoardPins{0xC0U, {0x4U, 0x8U}});
}

} // namespace counterpoint::firmware
