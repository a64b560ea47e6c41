// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Which objects of the manager an order can set, whatever its state.
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
} // namespace
} // namespace counterpoint::tools
