// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Which objects of the manager can be set, by an order or from the bus, whatever its state.
#include "tests/runtime/manager/rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::tools
{
namespace
{
using ManagerCanSetTest = test::ManagerRig;

TEST_F(ManagerCanSetTest, NumbersThatItHasAndThatCanBeWritten)
{
    Verifies(req::SRS_MGR_587);
    Make("manager: {node: 127}\nslaves: [{node: 6, device_type: 0x191}]\n");
    const runtime::ManagerStation& made = *station;
    EXPECT_TRUE(made.CanSet({0x1017U, 0U}));
    EXPECT_TRUE(made.CanSet({0x1F82U, 6U}));
    // Write only
    EXPECT_TRUE(made.CanSet({0x1F25U, 6U}));
    // Not there, read only, and no number
    EXPECT_FALSE(made.CanSet({0x9999U, 3U}));
    EXPECT_FALSE(made.CanSet({0x1000U, 0U}));
    EXPECT_FALSE(made.CanSet({0x1F22U, 6U}));
}

TEST_F(ManagerCanSetTest, TimesOfTheManagerItselfAreSetAtAnyTime)
{
    Verifies(req::SRS_MGR_021);
    // Given a manager whose start-up asks a slave, then inhibit time, boot time and heartbeat are set from the bus
    Make("manager: {node: 127, heartbeat: 500 ms}\nslaves: [{node: 6, device_type: 0x191}]\n");
    Run(2U);
    Hear(0x706U, {0U});
    Run(2U);
    ASSERT_EQ(Row(6U).step, "device type");
    EXPECT_EQ(Write(0x102AU, 0U, 20U, 2U), 0U);
    EXPECT_EQ(Write(0x1F89U, 0U, 3000U, 4U), 0U);
    EXPECT_EQ(Write(0x1017U, 0U, 100U, 2U), 0U);
    EXPECT_EQ(Read(0x102AU, 0U), 20U);
    EXPECT_EQ(Read(0x1F89U, 0U), 3000U);
    EXPECT_EQ(Read(0x1017U, 0U), 100U);
    // And by an order, with the same limits
    EXPECT_EQ(Order("set 0x102A:00 65535"), "taken");
    EXPECT_EQ(Order("set 0x102A:00 65536"), "0x102A:00 = 65536, expected at most 2 bytes");
    EXPECT_EQ(Order("set 0x1F89:00 4000"), "taken");
    EXPECT_EQ(Order("set 0x1017:00 200"), "taken");
    EXPECT_EQ(Read(0x102AU, 0U), 65535U);
    EXPECT_EQ(Read(0x1F89U, 0U), 4000U);
    EXPECT_EQ(Read(0x1017U, 0U), 200U);
    // Given one that does not lead the network, and has no SDO server yet
    Make("manager: {node: 127, heartbeat: 500 ms, flying: {start: by_order}}\nslaves: [{node: 6}]\n");
    Run(2U);
    for (const std::string object : {"0x102A:00", "0x1F89:00", "0x1017:00"})
    {
        EXPECT_EQ(Order("set " + object + " 40"), "taken") << object;
        EXPECT_EQ(Order("get " + object), object + " = 40 (0x28)") << object;
    }
}
} // namespace
} // namespace counterpoint::tools
