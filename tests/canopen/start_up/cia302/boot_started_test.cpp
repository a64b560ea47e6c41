// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Which slave is started by itself, by the bits of 1F80h and 1F81h.
#include "tests/canopen/start_up/boot_rig.hpp"
#include "verification/trace/ids/nmt_master.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace counterpoint::cia302
{
namespace
{

using cia301::NodeState;

class BootStartedTest : public BootRig
{
  public:
    [[nodiscard]] int Sum(const std::string& command) const
    {
        const std::vector<std::string> commands = Commands();
        return static_cast<int>(std::count_if(commands.begin(), commands.end(), [&command](const std::string& line)
                                              { return line.substr(line.find(':') + 1U) == command; }));
    }
};

TEST_F(BootStartedTest, WhoIsListedWithBit0Or2AloneIsNotStarted)
{
    Verifies(req::SRS_BOOT_014);
    // Given 5 with bit 0 of 1F81h, 6 with bit 2, and 7 with both, all as expected
    Add(5U, 0x01U);
    Add(6U, 0x04U);
    Add(7U, 0x05U);
    Begin();
    Run(1000U);
    EXPECT_EQ(Letter(5U) + Letter(7U), "--");
    EXPECT_EQ(Sum("01 05") + Sum("01 06") + Sum("01 00"), 0);
    EXPECT_EQ(Sum("01 07"), 1);
    EXPECT_EQ(slaves[5]->State(), NodeState::kPreOperational);
    EXPECT_EQ(slaves[6]->State(), NodeState::kPreOperational);
}

TEST_F(BootStartedTest, WithBit1TheSlaveIsStartedByItselfOnlyWhereTheMasterRuns)
{
    Verifies(req::SRS_BOOT_014);
    // Given a start of all at once, for which the master waits for an order, and a slave that boots late
    setup.start_up = kIsMaster | kStartAllAtOnce | kApplicationStartsSelf;
    Add(5U, kMust);
    Add(6U, kBoot).boot_ms = 2000U;
    Begin();
    Run(1000U);
    EXPECT_EQ(Letter(5U), "-");
    EXPECT_EQ(Step(), MasterStep::kReady);
    EXPECT_EQ(Sum("01 05") + Sum("01 00"), 0);
    // When the master runs, then who boots behind that is started by itself
    EXPECT_EQ(start_up.Command(NmtCommand::kStart, NodeId{127U}, Now()), NmtAnswer::kTaken);
    Run(500U);
    EXPECT_EQ(Step(), MasterStep::kOperational);
    EXPECT_EQ(Sum("01 06"), 0);
    Run(1000U);
    EXPECT_EQ(Sum("01 06"), 1);
    EXPECT_EQ(slaves[6]->State(), NodeState::kOperational);
}

} // namespace
} // namespace counterpoint::cia302
