// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Another device has the node-ID of the manager itself.
#include "tests/runtime/manager/rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::tools
{
namespace
{
class ManagerOwnDoubleTest : public test::ManagerRig
{
  protected:
    /// As table, JSON and exit status say.
    [[nodiscard]] bool IsAlone()
    {
        const std::string table = runtime::StatusTable(*station, now_us);
        const std::string first = table.substr(0U, table.find('\n'));
        const bool is_alone = station->Assembly().HasStarted();
        EXPECT_EQ(first.find("; another device has its node-ID, expected one and a reset") == std::string::npos,
                  is_alone)
            << first;
        EXPECT_EQ(runtime::StatusJson(*station, now_us)["duplicate"], !is_alone);
        return is_alone;
    }
};

TEST_F(ManagerOwnDoubleTest, AFlyingMasterThatHaltsSaysSoAtItsEnd)
{
    Verifies(req::SRS_MGR_588);
    // Given a flying master with no slave that has to be there
    Make("manager: {node: 127, heartbeat: 100 ms, flying: {priority: 1}}\n"
         "slaves: [{node: 6, device_type: 0x191, mandatory: false}]\n");
    Run(300U);
    EXPECT_TRUE(IsAlone());
    // When another master claims the network, then this one is a standby
    Hear(0x071U, {0U, 5U});
    Run(5U);
    EXPECT_TRUE(IsAlone());
    // When one with its own node-ID does
    Hear(0x071U, {0U, 127U});
    Run(5U);
    EXPECT_FALSE(IsAlone());
    Run(60000U);
    EXPECT_FALSE(IsAlone());
}

TEST_F(ManagerOwnDoubleTest, SoDoesAManagerOfEachProfileUntilItIsReset)
{
    Verifies(req::SRS_MGR_588);
    for (const char* const profile : {"cia302", "el6751", "plc_designer"})
    {
        Make("manager: {node: 127, profile: " + std::string(profile) +
             "}\nslaves: [{node: 6, device_type: 0x191, mandatory: false}]\n");
        Run(300U);
        Hear(0x706U, {0U});
        EXPECT_TRUE(IsAlone()) << profile;
        Hear(0x77FU, {0x05U});
        Run(5U);
        EXPECT_FALSE(IsAlone()) << profile;
        EXPECT_EQ(Order("reset 127"), "taken") << profile;
        Run(5U);
        EXPECT_TRUE(IsAlone()) << profile;
    }
}
} // namespace
} // namespace counterpoint::tools
