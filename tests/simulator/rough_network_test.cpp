// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The shipped networks in simulated time whose slaves and bus do not behave, under each start-up profile.
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/tools/command_run.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/nmt_master.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::tools
{
namespace
{
class RoughNetworkTest : public test::CommandTest
{
  protected:
    /// The scenario holds; otherwise what it told. `warning`: behind its folder.
    static void ExpectHolds(const std::string& name, const std::string& warning = {},
                            const std::vector<std::string>& more = {})
    {
        const std::string file = cia306::test::NetworkFile(name + ".yaml");
        const std::string folder = file.substr(0U, file.rfind('/') + 1U);
        std::vector<std::string> words{"simulate", "--quiet", file};
        words.insert(words.end(), more.begin(), more.end());
        const test::Answer answer = test::RunCommand(words);
        EXPECT_EQ(answer.status, 0) << name << "\n" << answer.out << answer.err;
        EXPECT_EQ(answer.err, warning.empty() ? warning : (folder + warning + "\n")) << name;
    }
    static void ExpectHoldsInEachProfile(const std::string& name)
    {
        for (const char* const profile : {"cia302", "el6751", "plc_designer"})
        {
            ExpectHolds(name, {}, {"--profile", profile});
        }
    }
};

TEST_F(RoughNetworkTest, PulledResetAndReplacedSlaves)
{
    Verifies(req::SRS_MGR_003);
    Verifies(req::SRS_MGR_155);
    Verifies(req::SRS_MGR_016);
    Verifies(req::SRS_SFS_002);
    ExpectHoldsInEachProfile("pulled");
    ExpectHoldsInEachProfile("reset");
    ExpectHoldsInEachProfile("replaced");
}

TEST_F(RoughNetworkTest, StormsAndBabbling)
{
    Verifies(req::SRS_MGR_003);
    Verifies(req::SRS_MGR_011);
    Verifies(req::SRS_MGR_016);
    Verifies(req::SRS_MGR_155);
    ExpectHoldsInEachProfile("emcy_storm");
    ExpectHoldsInEachProfile("babbling");
}

TEST_F(RoughNetworkTest, TwoDevicesOfOneNodeIdWithHeartbeatAndWithout)
{
    Verifies(req::SRS_MGR_010);
    Verifies(req::SRS_MGR_015);
    Verifies(req::SRS_MGR_016);
    Verifies(req::SRS_MGR_155);
    Verifies(req::SRS_SFS_151);
    ExpectHoldsInEachProfile("duplicate");
    ExpectHoldsInEachProfile("duplicate_silent");
}

TEST_F(RoughNetworkTest, EachLetterAndTheNodeStates)
{
    Verifies(req::SRS_BOOT_003);
    Verifies(req::SRS_BOOT_004);
    Verifies(req::SRS_BOOT_005);
    Verifies(req::SRS_BOOT_006);
    Verifies(req::SRS_BOOT_007);
    Verifies(req::SRS_BOOT_009);
    Verifies(req::SRS_BOOT_011);
    Verifies(req::SRS_ELM_046);
    Verifies(req::SRS_ELM_050);
    // Letter K is that of a slave which is told to be silent and awaited, on purpose here
    ExpectHolds(
        "letters",
        "letters_network.yaml:14:5: warning: node 20 is told to send no heartbeat and awaited within 300 ms: its "
        "start-up ends with letter K, expected a heartbeat, or consumer: 0 ms");
    ExpectHolds("codes_el6751");
}

TEST_F(RoughNetworkTest, GuardingAnswersThatDoNotToggle)
{
    Verifies(req::SRS_ELM_022);
    Verifies(req::SRS_ELM_040);
    Verifies(req::SRS_ELM_043);
    ExpectHolds("guarded_el6751");
}

TEST_F(RoughNetworkTest, SomebodyElseStartsSafetySlaves)
{
    Verifies(req::SRS_SFS_006);
    Verifies(req::SRS_SFS_150);
    Verifies(req::SRS_BOOT_013);
    Verifies(req::SRS_ELM_049);
    Verifies(req::SRS_PLC_020);
    Verifies(req::SRS_BOOT_340);
    ExpectHoldsInEachProfile("foreign_start");
}

TEST_F(RoughNetworkTest, ARefusedSafetySlaveIsStoppedWhileManyCommandsWait)
{
    Verifies(req::SRS_NMM_770);
    Verifies(req::SRS_MGR_340);
    ExpectHoldsInEachProfile("crowded");
}

TEST_F(RoughNetworkTest, AManagerWithoutBus)
{
    Verifies(req::SRS_ELM_044);
    Verifies(req::SRS_ELM_045);
    Verifies(req::SRS_MGR_155);
    ExpectHolds("bus_off_el6751");
}

TEST_F(RoughNetworkTest, AManagerThatComesWhileItsSlavesRun)
{
    Verifies(req::SRS_BOOT_006);
    Verifies(req::SRS_BOOT_013);
    Verifies(req::SRS_BOOT_014);
    Verifies(req::SRS_BOOT_340);
    ExpectHolds("kept_alive");
}

TEST_F(RoughNetworkTest, PdosThatStayAwayUnderTheEl6751Profile)
{
    Verifies(req::SRS_ELM_033);
    Verifies(req::SRS_ELM_034);
    Verifies(req::SRS_ELM_037);
    Verifies(req::SRS_ELM_042);
    Verifies(req::SRS_ELM_038);
    ExpectHolds("pdos_el6751");
    ExpectHolds("pdos_restart_el6751");
    ExpectHolds("window_el6751");
}
} // namespace
} // namespace counterpoint::tools
