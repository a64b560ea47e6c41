// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Orders that are refused: by which state, and without a command.
#include "tests/runtime/manager/rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::tools
{
namespace
{
using test::Lines;
using RefusedOrdersTest = test::ManagerRig;

constexpr std::uint32_t kDeviceState = 0x08000022U;

TEST_F(RefusedOrdersTest, AControlNamesTheStateThatTheTableWasAskedBy)
{
    Verifies(req::SRS_ELM_670);
    // Given a slave without heartbeat and guarding that was started: it was heard last when it booted
    Make("manager: {node: 127, profile: el6751}\nslaves: [{node: 6, device_type: 0x191}]\n");
    Run(5U);
    Hear(0x706U, {0U});
    Answer(6U, {0x43U, 0x00U, 0x10U, 0x00U, 0x91U, 0x01U, 0x00U, 0x00U}, 20);
    ASSERT_EQ(Read(0x1F82U, 6U) & 0xFFU, 5U);
    EXPECT_EQ(Order("control 6 5 1").rfind("control 5/1 is no command for node 6, which is operational with ", 0U), 0U)
        << Order("control 6 5 1");
    // One that the table of the transitions takes from there
    EXPECT_EQ(Order("control 6 6 0"), "taken");
    Run(5U);
    EXPECT_EQ(Order("control 6 6 0").rfind("control 6/0 is no command for node 6, which is stopped with ", 0U), 0U)
        << Order("control 6 6 0");
}

TEST_F(RefusedOrdersTest, AClientStartsNoSafetySlaveThatMayBeTwoDevices)
{
    Verifies(req::SRS_MGR_670);
    Make("manager: {node: 127}\nslaves: [{node: 33, dcf: actuator.dcf, boot: false}, {node: 6, boot: false}]\n");
    Run(10U);
    for (const std::uint8_t node : {std::uint8_t{33U}, std::uint8_t{6U}})
    {
        Hear(0x700U + node, {0U});
        Run(10U);
        for (const std::uint8_t sub : {std::uint8_t{1U}, std::uint8_t{2U}, std::uint8_t{3U}})
        {
            Hear(0x600U + node, {0x40U, 0x18U, 0x10U, sub, 0U, 0U, 0U, 0U});
            Hear(0x580U + node, {0x43U, 0x18U, 0x10U, sub, 1U, 0U, 0U, 0U});
            Hear(0x580U + node, {0x43U, 0x18U, 0x10U, sub, 2U, 0U, 0U, 0U});
        }
    }
    ASSERT_EQ(Row(33U).finding, "two devices with this node-ID?");
    Run(5U);
    EXPECT_EQ(Write(0x1F82U, 33U, 5U, 1U), kDeviceState);
    Run(5U);
    EXPECT_EQ(Commands(), (Lines{}));
    // What makes it leave OPERATIONAL is taken, and so is the start of a slave that is no safety slave
    EXPECT_EQ(Write(0x1F82U, 33U, 4U, 1U), 0U);
    Run(2U);
    EXPECT_EQ(Commands(), (Lines{"2 33"}));
    EXPECT_EQ(Write(0x1F82U, 6U, 5U, 1U), 0U);
    Run(2U);
    EXPECT_EQ(Commands(), (Lines{"1 6"}));
}
} // namespace
} // namespace counterpoint::tools
