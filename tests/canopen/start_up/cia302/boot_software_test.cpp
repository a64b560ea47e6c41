// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Letters G, H and I, and the update of software that goes well.
#include "tests/canopen/start_up/boot_rig.hpp"
#include "verification/trace/ids/nmt_master.hpp"

namespace counterpoint::cia302
{
namespace
{

class BootSoftwareTest : public BootRig
{
};

TEST_F(BootSoftwareTest, G_NothingToCompareTheSoftwareWith)
{
    Verifies(req::SRS_BOOT_007);
    Add(5U, kBoot | kVerifySoftware);                                                // Nothing is set up.
    Add(6U, kBoot | kVerifySoftware).Put32(0x1F56U, 1U, 0x55U);                      // Set up, equal: good.
    Add(7U, kBoot | kVerifySoftware);                                                // Slave does not have the object.
    Add(8U, kBoot | kVerifySoftware | kMayUpdateSoftware).Put32(0x1F56U, 1U, 0x56U); // No program to download.
    setups[6].software.identification = 0x55U;
    setups[7].software.identification = 0x55U;
    setups[8].software.identification = 0x55U;
    Begin();
    Run(20U);
    EXPECT_EQ(Letter(5U), "G");
    EXPECT_EQ(Letter(6U), "-");
    EXPECT_EQ(Letter(7U), "G");
    EXPECT_EQ(Of(7U).abort, SdoAbort::kObjectUnknown);
    EXPECT_EQ(Letter(8U), "G");
    EXPECT_EQ(Of(8U).expected, 0x55U);
    EXPECT_EQ(Of(8U).read, 0x56U);
}

TEST_F(BootSoftwareTest, H_OtherSoftwareAndNoUpdateAllowed)
{
    Verifies(req::SRS_BOOT_007);
    FakeSlave& date = Add(5U, kBoot | kVerifySoftware);
    date.Put32(0x1F52U, 1U, 100U);
    date.Put32(0x1F52U, 2U, 201U);
    setups[5].software.date = 100U;
    setups[5].software.time = 200U;
    const Octets program(20U, 0x5AU);
    FakeSlave& kept = Add(6U, kBoot | kVerifySoftware | kMayUpdateSoftware | kKeepAlive);
    kept.Put32(0x1F56U, 1U, 0x56U);
    setups[6].software.identification = 0x55U;
    setups[6].software.program = Bytes{program.data(), 20U};
    Begin();
    Run(40U);
    EXPECT_EQ(Letter(5U), "H");
    EXPECT_EQ(Of(5U).object.index, 0x1F52U);
    EXPECT_EQ(Of(5U).object.sub, 2U);
    EXPECT_EQ(Letter(6U), "H"); // It was not OPERATIONAL, was reset, and still may not be updated.
    EXPECT_EQ(kept.resets, 2);
}

class UpdateTest : public BootRig
{
  public:
    UpdateTest()
    {
        slave.Put32(0x1F56U, 1U, 0x54U);
        slave.Put(0x1F50U, 1U, Octets{});
        slave.Put8(0x1F51U, 1U, 1U);
        slave.Put32(0x1F57U, 1U, 0U);
        setups[5].software.identification = 0x55U;
        setups[5].software.program = Bytes{program.data(), 300U};
    }

    Octets program = Octets(300U, 0x5AU);
    FakeSlave& slave = Add(5U, kBoot | kVerifySoftware | kMayUpdateSoftware);
};

TEST_F(UpdateTest, SoftwareIsDownloadedAndTheSlaveBootedWithIt)
{
    Verifies(req::SRS_BOOT_007);
    // Given a slave that takes program 5Ah... and restarts with identification 55h a reset later
    Begin();
    Run(5U);
    EXPECT_EQ(slave.Get(0x1F50U, 1U), program);
    EXPECT_EQ(slave.writes, (std::vector<std::uint32_t>{0x1F5101U, 0x1F5101U, 0x1F5001U, 0x1F5101U}));
    EXPECT_EQ(Of(5U).step, StartUpStep::kSoftwareUpdate);
    EXPECT_EQ(slave.Get(0x1F51U, 1U), (Octets{1U}));
    slave.Put32(0x1F56U, 1U, 0x55U);
    slave.Power(Now());
    Run(20U);
    EXPECT_EQ(Letter(5U), "-");
    EXPECT_EQ(Of(5U).step, StartUpStep::kDone);
}

TEST_F(UpdateTest, I_VersionThatIsStillAnother)
{
    Verifies(req::SRS_BOOT_007);
    Begin();
    Run(1100U); // No boot-up message after the start of the program: asked after 1 s.
    EXPECT_EQ(Letter(5U), "I");
    EXPECT_EQ(slave.writes.size(), 4U); // Once, not again and again.
}

TEST_F(UpdateTest, I_StepsThatFail)
{
    Verifies(req::SRS_BOOT_007);
    slave.refused[0x1F5001U] = SdoAbort::kHardware;
    Begin();
    Run(20U);
    EXPECT_EQ(Letter(5U), "I");
    EXPECT_EQ(Of(5U).object.index, 0x1F50U);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kHardware);
    EXPECT_EQ(slave.writes.size(), 4U); // Blocks were refused, segments too.
}

TEST_F(UpdateTest, I_FlashThatReportsAnErrorOrIsNeverReady)
{
    Verifies(req::SRS_BOOT_007);
    slave.Put32(0x1F57U, 1U, 0x02U); // No valid program: as it is after clearing, but not after the download.
    Begin();
    Run(20U);
    EXPECT_EQ(Letter(5U), "I");
    EXPECT_EQ(Of(5U).object.index, 0x1F57U);
    slave.Put32(0x1F57U, 1U, 0x01U);
    EXPECT_TRUE(start_up.Boot(NodeId{5U}, Now()));
    Run(59900U);
    EXPECT_EQ(Letter(5U), "-");
    Run(300U);
    EXPECT_EQ(Letter(5U), "I");
}

} // namespace
} // namespace counterpoint::cia302
