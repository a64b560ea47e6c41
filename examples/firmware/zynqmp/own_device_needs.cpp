// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "examples/firmware/zynqmp/board_needs.hpp"

namespace counterpoint::firmware
{
namespace
{

constexpr std::uint16_t kFirst[]{0x000U, 0x001U, 0x111U, 0x112U, 0x113U, 0x114U};

} // namespace

ZynqmpNeeds DescribeZynqmpNeeds() noexcept
{
    return ZynqmpNeeds{{&kFirst[0], sizeof(kFirst) / sizeof(kFirst[0])},
                       {nullptr, 0U},
                       zynqmp::BusLayout::kOneController,
                       0xC0U,
                       {0x4U, 0x8U}};
}

} // namespace counterpoint::firmware
