// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Somebody else starts a safety slave that tells no state by itself, while the manager starts it up and behind it.
#include "tests/canopen/manager/rig.hpp"
#include "verification/trace/ids/manager.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr NodeId kSlave{5U};

/// Given a safety slave 5 without heartbeat or guarding, one with a box under EL6751.
class ForeignStartTest : public ManagerRig, public ::testing::WithParamInterface<Profile>
{
  public:
    ForeignStartTest()
    {
        Add(5U);
        MakeSafe(5U);
        setups[5].el6751 = &box;
    }
    /// What PLC Designer compares is another object.
    void MakeOther()
    {
        const bool is_plc = (GetParam() == Profile::kPlcDesigner);
        devices[0]->Put32(is_plc ? 0x1000U : 0x1018U, is_plc ? 0U : 4U, is_plc ? 0x192U : 0x4321U);
    }
    /// At each instant from its first question on: somebody starts the slave, which is not left running.
    void ExpectStopped(const std::uint32_t last)
    {
        Begin(GetParam());
        Run(6000U);
        for (std::uint32_t cycles = 0U; cycles < last; ++cycles)
        {
            EXPECT_TRUE(manager->Role().Boot(kSlave, Now()));
            const int before = devices[0]->reads;
            for (int i = 0; (i < 9000) && (devices[0]->reads == before); ++i)
            {
                Run(1U);
            }
            Run(cycles);
            Put(Nmt(NmtCommand::kStart, 5U));
            Run(6000U);
            EXPECT_EQ(Running(5U), 0) << cycles;
        }
    }

    /// A reset by this device (true) or somebody else, whose boot-up message comes behind the start of somebody else.
    void ExpectStoppedBehindLateBootUp(const bool is_own)
    {
        constexpr std::uint32_t kOfSlave = 0x705U;
        if (is_own)
        {
            EXPECT_EQ(Order(NmtCommand::kResetCommunication, 5U), NmtAnswer::kTaken);
        }
        else
        {
            Put(Nmt(NmtCommand::kResetCommunication, 5U));
        }
        Run(2U);
        Put(Nmt(NmtCommand::kStart, 5U));
        EXPECT_EQ(Running(5U), 1);
        Put(CanFrame{kOfSlave, FrameKind::kData, CanPortId::kFirst, 1U, {}});
        Run(6000U);
        EXPECT_EQ(Running(5U), 0) << is_own;
    }

    El6751Slave box{};
};

TEST_P(ForeignStartTest, OfAnotherDeviceIsFoundAtEachInstantOfItsStartUpAndBehindIt)
{
    Verifies(req::SRS_SFS_006);
    Verifies(req::SRS_SFS_150);
    MakeOther();
    ExpectStopped(30U);
    EXPECT_TRUE(manager->Status(kSlave).is_other);
}

TEST_P(ForeignStartTest, OfAnotherDeviceWhoseBootUpMessageWasLostIsFound)
{
    Verifies(req::SRS_SFS_006);
    Verifies(req::SRS_SFS_150);
    devices[0]->has_boot_up = false;
    MakeOther();
    ExpectStopped(30U);
    EXPECT_TRUE(manager->Status(kSlave).is_other);
}

TEST_P(ForeignStartTest, OfAChangedOneThatTheManagerDoesNotStartIsFoundAtEachInstantOfItsStartUp)
{
    Verifies(req::SRS_SFS_006);
    Verifies(req::SRS_SFS_150);
    // Given one that the application is to start
    setup.start_up |= kApplicationStartsSlaves;
    box.is_started = false;
    devices[0]->Put(0x1301U, 2U, {26U, 0U});
    ExpectStopped(30U);
}

TEST_P(ForeignStartTest, OfAChangedOneWhoseBootUpMessageWasLostIsFound)
{
    Verifies(req::SRS_SFS_006);
    Verifies(req::SRS_SFS_150);
    setup.start_up |= kApplicationStartsSlaves;
    box.is_started = false;
    devices[0]->has_boot_up = false;
    devices[0]->Put(0x1301U, 2U, {26U, 0U});
    ExpectStopped(30U);
}

TEST_P(ForeignStartTest, OfAnotherDeviceBeforeItsBootUpMessageIsFound)
{
    Verifies(req::SRS_SFS_006);
    Verifies(req::SRS_SFS_150);
    MakeOther();
    Begin(GetParam());
    Run(6000U);
    devices[0]->has_boot_up = false; // The test sends it.
    ExpectStoppedBehindLateBootUp(true);
    ExpectStoppedBehindLateBootUp(false);
    EXPECT_TRUE(manager->Status(kSlave).is_other);
}

TEST_P(ForeignStartTest, OfAChangedOneThatTheManagerDoesNotStartIsFoundBeforeItsBootUpMessage)
{
    Verifies(req::SRS_SFS_006);
    Verifies(req::SRS_SFS_150);
    setup.start_up |= kApplicationStartsSlaves;
    box.is_started = false;
    devices[0]->Put(0x1301U, 2U, {26U, 0U});
    Begin(GetParam());
    Run(6000U);
    devices[0]->has_boot_up = false;
    ExpectStoppedBehindLateBootUp(true);
    ExpectStoppedBehindLateBootUp(false);
}

INSTANTIATE_TEST_SUITE_P(Profiles, ForeignStartTest, ::testing::ValuesIn(kProfiles));

} // namespace
} // namespace counterpoint::cia302
