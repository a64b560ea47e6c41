// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "examples/firmware/zynqmp/board_needs.hpp"

namespace counterpoint::firmware
{
namespace
{

constexpr std::uint16_t kFirst[]{0x000U, 0x001U};

} // namespace

ZynqmpNeeds DescribeZynqmpNeeds() noexcept
{
    return ZynqmpNeeds{
        {&kFirst[0], sizeof(kFirst) / sizeof(kFirst[0])}, {nullptr, 0U}, zynqmp::BusLayout::kOneController, 0U, {}};
}

} // namespace counterpoint::firmware
