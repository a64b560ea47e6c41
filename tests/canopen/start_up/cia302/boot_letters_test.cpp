// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The letters of CiA 302-2, each provoked by a slave that misbehaves in that very way, and the update of software that
// goes well.
#include "tests/canopen/start_up/boot_rig.hpp"
#include "verification/trace/ids/nmt_master.hpp"

namespace counterpoint::cia302
{
namespace
{

using Lines = std::vector<std::string>;

using BootLettersTest = BootRig;

TEST_F(BootLettersTest, SlaveThatIsAsExpectedIsConfiguredSupervisedAndStarted)
{
    Verifies(req::SRS_BOOT_001);
    Verifies(req::SRS_BOOT_002);
    Verifies(req::SRS_BOOT_014);
    Verifies(req::SRS_BOOT_015);
    // Given a mandatory slave 5 with one object to be written
    FakeSlave& slave = Add(5U, kMust);
    slave.Put8(0x2000U, 0U, 0U);
    Octets dcf{};
    AddEntry(dcf, 0x2000U, 0U, {0x77U});
    setups[5].concise_dcf = Bytes{dcf.data(), static_cast<std::uint32_t>(dcf.size())};
    // When the start-up runs
    Begin();
    Run(20U);
    // Then the bus is reset, the slave configured and started, and the master with it
    EXPECT_EQ(Letter(5U), "-");
    EXPECT_EQ(Of(5U).step, StartUpStep::kDone);
    EXPECT_EQ(Commands(), (Lines{"0:82 00", "1:01 05"}));
    EXPECT_EQ(slave.Get(0x2000U, 0U), (Octets{0x77U}));
    EXPECT_EQ(slave.State(), cia301::NodeState::kOperational);
    EXPECT_EQ(Step(), MasterStep::kOperational);
    ASSERT_EQ(own.size(), 2U);
    EXPECT_EQ(own[0].command, NmtCommand::kResetCommunication);
    EXPECT_EQ(own[1].command, NmtCommand::kStart);
}

TEST_F(BootLettersTest, A_NodeThatIsNotListed)
{
    Verifies(req::SRS_BOOT_003);
    // Given a listed slave 5 and a node 6 that nobody listed
    Add(5U, kBoot);
    Add(6U, 0U);
    // When both boot up
    Begin();
    Run(20U);
    // Then node 6 gets its letter, and nothing else
    EXPECT_EQ(Letter(6U), "A");
    EXPECT_EQ(Letter(5U), "-");
    EXPECT_EQ(Count(0x606U), 0);
    EXPECT_EQ(slaves[6]->State(), cia301::NodeState::kPreOperational);
    EXPECT_FALSE(start_up.Boot(NodeId{6U}, Now()));
    // Nor does a node that nobody heard, when somebody asks for its start
    EXPECT_EQ(Letter(7U), "-");
    EXPECT_FALSE(start_up.Boot(NodeId{7U}, Now()));
    Run(20U);
    EXPECT_EQ(Letter(7U), "A");
    EXPECT_EQ(Count(0x607U), 0);
    // Just not: the same node, listed
    setups[6].assignment = kBoot;
    EXPECT_TRUE(start_up.Boot(NodeId{6U}, Now()));
    Run(20U);
    EXPECT_EQ(Letter(6U), "-");
}

TEST_F(BootLettersTest, B_MandatorySlaveThatDoesNotAnswerWithinTheBootTime)
{
    Verifies(req::SRS_BOOT_004);
    Verifies(req::SRS_BOOT_016);
    Add(5U, kMust).is_sdo_mute = true;
    setup.boot_time_ms = 3000U;
    Begin();
    // Asked at 1 ms three times for 100 ms, and again 1 s after each silence
    Run(2900U);
    EXPECT_EQ(Letter(5U), "-");
    EXPECT_TRUE(Of(5U).is_busy);
    EXPECT_EQ(Step(), MasterStep::kBooting);
    EXPECT_EQ(table.RequestValue(NodeId{5U}), 1U);
    Run(120U);
    EXPECT_EQ(Letter(5U), "B");
    EXPECT_EQ(Of(5U).step, StartUpStep::kDeviceType);
    EXPECT_EQ(Of(5U).object.index, 0x1000U);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kTimeOut);
    EXPECT_EQ(Step(), MasterStep::kHalted);
    // When it answers at last, after a boot-up message
    slaves[5]->is_sdo_mute = false;
    slaves[5]->Power(Now());
    Run(300U);
    EXPECT_EQ(Letter(5U), "-");
    EXPECT_EQ(Step(), MasterStep::kOperational);
}

TEST_F(BootLettersTest, B_OptionalSlaveIsAskedWithoutEnd)
{
    Verifies(req::SRS_BOOT_004);
    Add(5U, kBoot).is_sdo_mute = true;
    setup.boot_time_ms = 3000U;
    Begin();
    Run(20000U);
    EXPECT_EQ(Letter(5U), "-");
    EXPECT_TRUE(Of(5U).is_busy);
    EXPECT_EQ(Step(), MasterStep::kOperational); // It does not wait for optional slaves.
    slaves[5]->is_sdo_mute = false;
    Run(1400U);
    EXPECT_EQ(Of(5U).step, StartUpStep::kDone);
    EXPECT_EQ(slaves[5]->State(), cia301::NodeState::kOperational);
}

TEST_F(BootLettersTest, MandatorySlaveIsWaitedForWithoutEndIfThereIsNoBootTime)
{
    Verifies(req::SRS_BOOT_004);
    Add(5U, kMust).is_sdo_mute = true;
    Begin();
    Run(60000U);
    EXPECT_EQ(Letter(5U), "-");
    EXPECT_EQ(Step(), MasterStep::kBooting);
}

TEST_F(BootLettersTest, AnIdentityThatIsTooLongIsThatOfAnotherDevice)
{
    Verifies(req::SRS_BOOT_480);
    // Given slaves with a device type of 8 bytes that begins with the right number, of one of which none is expected
    Add(5U, kBoot).Put(0x1000U, 0U, {0x91U, 1U, 0U, 0U, 0U, 0U, 0U, 0U});
    Add(6U, kBoot).Put(0x1000U, 0U, {0x91U, 1U, 0U, 0U, 0U, 0U, 0U, 0U});
    setups[6].device_type = 0U;
    // And one with such a serial number
    Add(7U, kBoot).Put(0x1018U, 4U, {0x34U, 0x12U, 0U, 0U, 0U, 0U, 0U, 0U});
    // And of each further number of the identity
    Add(9U, kBoot).Put(0x1018U, 1U, {0x2AU, 0U, 0U, 0U, 0U});
    Add(10U, kBoot).Put(0x1018U, 2U, {7U, 0U, 0U, 0U, 0U});
    Add(11U, kBoot).Put(0x1018U, 3U, {3U, 0U, 0U, 0U, 0U});
    // And one that refuses to be read with the code of a client without room
    Add(8U, kBoot).refused[0x100000U] = SdoAbort::kOutOfMemory;
    // When they are booted
    Begin();
    Run(100U);
    // Then each of the first three is another device, told by the length, but the one whose type nobody compares
    const std::vector<std::string> letters{"C", "-", "O"};
    for (std::uint8_t node = 5U; node <= 7U; ++node)
    {
        const bool is_good = (node == 6U);
        EXPECT_EQ(Letter(node), letters[node - 5U]) << int{node};
        EXPECT_EQ(Of(node).abort, is_good ? SdoAbort::kNone : SdoAbort::kLengthMismatch) << int{node};
        EXPECT_EQ(Of(node).is_started, is_good) << int{node};
        EXPECT_FALSE(Of(node).is_busy) << int{node};
    }
    EXPECT_EQ(Of(5U).expected, 0x191U);
    EXPECT_EQ(Of(7U).expected, 0x1234U);
    EXPECT_EQ(Letter(9U) + Letter(10U) + Letter(11U), "DMN");
    EXPECT_EQ(static_cast<std::uint32_t>(Of(9U).abort), 0x06070010U);
    EXPECT_EQ(static_cast<std::uint32_t>(Of(10U).abort), 0x06070010U);
    EXPECT_EQ(static_cast<std::uint32_t>(Of(11U).abort), 0x06070010U);
    EXPECT_EQ(Letter(8U), "-");
    EXPECT_EQ(Of(8U).abort, SdoAbort::kOutOfMemory);
    EXPECT_TRUE(Of(8U).is_busy);
}

struct IdentityCase
{
    std::uint16_t index;
    std::uint8_t sub;
    const char* letter;
    StartUpStep step;
    std::uint32_t expected;
};

TEST_F(BootLettersTest, CDMNO_EachNumberOfTheIdentity)
{
    Verifies(req::SRS_BOOT_005);
    Verifies(req::SRS_BOOT_019);
    const IdentityCase cases[] = {{0x1000U, 0U, "C", StartUpStep::kDeviceType, 0x191U},
                                  {0x1018U, 1U, "D", StartUpStep::kVendorId, 0x2AU},
                                  {0x1018U, 2U, "M", StartUpStep::kProductCode, 7U},
                                  {0x1018U, 3U, "N", StartUpStep::kRevisionNumber, 3U},
                                  {0x1018U, 4U, "O", StartUpStep::kSerialNumber, 0x1234U}};
    for (std::uint8_t i = 0U; i < 5U; ++i)
    {
        Add(static_cast<std::uint8_t>(10U + i), kBoot).Put32(cases[i].index, cases[i].sub, 0xBADU);
    }
    Begin();
    Run(20U);
    for (std::uint8_t i = 0U; i < 5U; ++i)
    {
        const auto node = static_cast<std::uint8_t>(10U + i);
        EXPECT_EQ(Letter(node), cases[i].letter);
        EXPECT_EQ(Of(node).step, cases[i].step);
        EXPECT_EQ(Of(node).object.index, cases[i].index);
        EXPECT_EQ(Of(node).object.sub, cases[i].sub);
        EXPECT_EQ(Of(node).abort, SdoAbort::kNone);
        EXPECT_EQ(Of(node).expected, cases[i].expected);
        EXPECT_EQ(Of(node).read, 0xBADU);
        EXPECT_EQ(slaves[node]->State(), cia301::NodeState::kPreOperational);
    }
}

// What is told of a slave whose boot failed, and for how long.
class ToldStatusTest : public BootRig
{
  public:
    void OnNodeStatus(const NodeId node, const Instant /*now*/) noexcept override
    {
        changes += (node.value == 10U) ? 1U : 0U;
    }

    std::uint32_t changes{0U};
};

TEST_F(ToldStatusTest, EachTryAtTheDeviceTypeIsTold)
{
    Verifies(req::SRS_BOOT_004);
    // Given a slave that is silent: asked three times for 100 ms from 1 ms on, and again 1 s after each silence
    Add(10U, kMust).is_sdo_mute = true;
    Begin();
    Run(290U);
    for (int tries = 0; tries < 3; ++tries)
    {
        const std::uint32_t before = changes;
        Run(20U);
        EXPECT_GT(changes, before) << tries;
        EXPECT_EQ(Of(10U).abort, SdoAbort::kTimeOut);
        const std::uint32_t told = changes;
        Run(900U);
        EXPECT_EQ(changes, told) << tries;
        Run(380U);
    }
    // And of one that refuses it each second
    slaves[10]->is_sdo_mute = false;
    slaves[10]->refused[0x100000U] = SdoAbort::kHardware;
    Run(1500U);
    const std::uint32_t before = changes;
    Run(3000U);
    EXPECT_GE(changes, before + 3U);
    EXPECT_EQ(Of(10U).abort, SdoAbort::kHardware);
}

TEST_F(ToldStatusTest, IsKeptUntilTheNextBootBeginsAndEachChangeIsTold)
{
    Verifies(req::SRS_BOOT_019);
    // Given a slave that does not give its serial number
    Add(10U, kBoot).refused[0x101804U] = SdoAbort::kHardware;
    Begin();
    Run(20U);
    const std::uint32_t failed = changes;
    EXPECT_GT(failed, 0U);
    // Then letter, step, object, abort code and values stay, and nothing more is told
    for (const std::uint32_t later_ms : {0U, 1U, 10000U})
    {
        Run(later_ms);
        EXPECT_EQ(Letter(10U), "O") << later_ms;
        EXPECT_EQ(Of(10U).step, StartUpStep::kSerialNumber) << later_ms;
        EXPECT_EQ(Of(10U).object.index, 0x1018U) << later_ms;
        EXPECT_EQ(Of(10U).object.sub, 4U) << later_ms;
        EXPECT_EQ(Of(10U).abort, SdoAbort::kHardware) << later_ms;
        EXPECT_EQ(Of(10U).expected, 0x1234U) << later_ms;
        EXPECT_EQ(Of(10U).read, 0U) << later_ms;
        EXPECT_EQ(changes, failed) << later_ms;
    }
    // When its next boot begins, then nothing of it is left, which is told
    slaves[10]->refused.clear();
    EXPECT_TRUE(start_up.Boot(NodeId{10U}, Now()));
    EXPECT_EQ(Letter(10U), "-");
    EXPECT_EQ(Of(10U).object.index, 0x1000U); // What this boot asks first.
    EXPECT_EQ(Of(10U).abort, SdoAbort::kNone);
    EXPECT_EQ(Of(10U).expected, 0U);
    EXPECT_GT(changes, failed);
    Run(100U);
    EXPECT_EQ(Of(10U).step, StartUpStep::kDone);
}

TEST_F(BootLettersTest, CDMNO_NumbersThatCannotBeReadAndNumbersThatAreNotCompared)
{
    Verifies(req::SRS_BOOT_005);
    Add(10U, kBoot).refused[0x101804U] = SdoAbort::kHardware;
    FakeSlave& other = Add(11U, kBoot);
    other.Put32(0x1000U, 0U, 0xBADU);
    other.Put32(0x1018U, 1U, 0xBADU);
    other.refused[0x101802U] = SdoAbort::kHardware;
    setups[11] = SlaveSetup{};
    setups[11].assignment = kBoot;
    Begin();
    Run(20U);
    EXPECT_EQ(Letter(10U), "O");
    EXPECT_EQ(Of(10U).abort, SdoAbort::kHardware);
    EXPECT_EQ(Letter(11U), "-");
    EXPECT_EQ(Of(11U).step, StartUpStep::kDone);
}

TEST_F(BootLettersTest, E_KeptAliveSlaveWithoutHeartbeat)
{
    Verifies(req::SRS_BOOT_006);
    Add(5U, kBoot | kKeepAlive);
    setups[5].heartbeat = HeartbeatSetup{250U, 100U, Arming::kFirstHeartbeat};
    Begin();
    Run(249U);
    EXPECT_EQ(Letter(5U), "-");
    EXPECT_EQ(Of(5U).step, StartUpStep::kStateCheck);
    Run(4U);
    EXPECT_EQ(Letter(5U), "E");
    // The slave was not touched: others were reset one by one, but not the own node
    EXPECT_EQ(slaves[5]->resets, 1);
    EXPECT_EQ(Commands().size(), 125U);
    EXPECT_EQ(Commands().front(), "0:82 01");
    EXPECT_EQ(Commands()[4], "0:82 06");
    EXPECT_EQ(Commands().back(), "0:82 7e");
}

TEST_F(BootLettersTest, F_KeptAliveSlaveThatDoesNotAnswerARemoteFrame)
{
    Verifies(req::SRS_BOOT_006);
    Add(5U, kBoot | kKeepAlive).heartbeat_ms = 60000U; // Guarding rests while there is a heartbeat.
    Begin();
    Run(100U);
    EXPECT_EQ(Letter(5U), "-");
    EXPECT_EQ(Count(0x705U), 1);
    Run(4U);
    EXPECT_EQ(Letter(5U), "F");
}

TEST_F(BootLettersTest, J_FirstEntryThatIsRefused)
{
    Verifies(req::SRS_BOOT_010);
    FakeSlave& slave = Add(5U, kMust);
    slave.Put8(0x2000U, 0U, 0U);
    slave.Put8(0x2001U, 3U, 0U);
    slave.Put8(0x2002U, 0U, 0U);
    slave.refused[0x200103U] = SdoAbort::kValueHigh;
    Octets dcf{};
    AddEntry(dcf, 0x2000U, 0U, {1U});
    AddEntry(dcf, 0x2001U, 3U, {2U});
    AddEntry(dcf, 0x2002U, 0U, {3U});
    setups[5].concise_dcf = Bytes{dcf.data(), static_cast<std::uint32_t>(dcf.size())};
    Begin();
    Run(20U);
    EXPECT_EQ(Letter(5U), "J");
    EXPECT_EQ(Of(5U).step, StartUpStep::kConfigure);
    EXPECT_EQ(Of(5U).object.index, 0x2001U);
    EXPECT_EQ(Of(5U).object.sub, 3U);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kValueHigh);
    EXPECT_EQ(slave.Get(0x2000U, 0U), (Octets{1U}));
    EXPECT_EQ(slave.Get(0x2002U, 0U), (Octets{0U}));
    EXPECT_EQ(Step(), MasterStep::kHalted);
}

TEST_F(BootLettersTest, J_SilenceAndDomainsThatAreNotWellFormed)
{
    Verifies(req::SRS_BOOT_010);
    FakeSlave& slave = Add(5U, kBoot);
    slave.Put8(0x2000U, 0U, 0U);
    slave.Put8(0x2001U, 0U, 0U);
    slave.mute_after_writes = 1U;
    Octets dcf{};
    AddEntry(dcf, 0x2000U, 0U, {1U});
    AddEntry(dcf, 0x2001U, 0U, {1U});
    setups[5].concise_dcf = Bytes{dcf.data(), static_cast<std::uint32_t>(dcf.size())};
    Add(6U, kBoot).Put8(0x2000U, 0U, 0U);
    setups[6].concise_dcf = Bytes{dcf.data(), 15U}; // Cut inside the second entry.
    Begin();
    Run(320U);
    EXPECT_EQ(Letter(5U), "J");
    EXPECT_EQ(Of(5U).object.index, 0x2001U);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kTimeOut);
    EXPECT_EQ(Letter(6U), "J");
    EXPECT_EQ(Of(6U).object.index, 0x1F22U);
    EXPECT_EQ(Of(6U).object.sub, 6U);
}

TEST_F(BootLettersTest, J_RestoringDefaultsFails)
{
    Verifies(req::SRS_BOOT_009);
    // Given slave 5 that is restored and reset, 6 that refuses, 7 that does not come back
    for (std::uint8_t node = 5U; node <= 7U; ++node)
    {
        Add(node, kBoot | kRestoreDefaults).Put32(0x1011U, 1U, 1U);
        setups[node].restore_sub = 1U;
    }
    FakeSlave& communication = Add(8U, kBoot | kRestoreDefaults);
    communication.Put32(0x1011U, 2U, 1U);
    setups[8].restore_sub = 2U;
    slaves[6]->refused[0x101101U] = SdoAbort::kNotStored;
    Begin();
    slaves[7]->boot_ms = 3000U;
    Run(40U);
    EXPECT_EQ(Letter(5U), "-");
    EXPECT_EQ(slaves[5]->Get(0x1011U, 1U), (Octets{0x6CU, 0x6FU, 0x61U, 0x64U}));
    EXPECT_EQ(Letter(6U), "J");
    EXPECT_EQ(Of(6U).step, StartUpStep::kRestore);
    EXPECT_EQ(Of(6U).abort, SdoAbort::kNotStored);
    EXPECT_EQ(Letter(8U), "-");
    const Lines commands = Commands();
    EXPECT_EQ(std::count(commands.begin(), commands.end(), "1:81 05"), 1);
    EXPECT_EQ(std::count(commands.begin(), commands.end(), "1:82 08"), 1);
}

TEST_F(BootLettersTest, J_NoBootUpMessageAfterRestoring)
{
    Verifies(req::SRS_BOOT_009);
    FakeSlave& slave = Add(5U, kBoot | kRestoreDefaults);
    slave.Put32(0x1011U, 1U, 1U);
    setups[5].restore_sub = 1U;
    Begin();
    slave.boot_ms = 1U;
    Run(1U);
    slave.has_boot_up = false;
    Run(1000U);
    EXPECT_EQ(Letter(5U), "-");
    Run(3U);
    EXPECT_EQ(Letter(5U), "J");
    EXPECT_EQ(Of(5U).step, StartUpStep::kRestore);
    // And no SDO of it was unanswered
    Verifies(req::SRS_BOOT_471);
    EXPECT_EQ(Of(5U).object.index, 0U);
    EXPECT_EQ(Of(5U).object.sub, 0U);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kTimeOut);
}

TEST_F(BootLettersTest, K_NoHeartbeatAtTheStartOfErrorControl)
{
    Verifies(req::SRS_BOOT_011);
    Add(5U, kMust);
    setups[5].heartbeat = HeartbeatSetup{300U, 0U, Arming::kFirstHeartbeat};
    Add(6U, kMust).heartbeat_ms = 200U;
    setups[6].heartbeat = HeartbeatSetup{300U, 200U, Arming::kFirstHeartbeat};
    Begin();
    Run(300U);
    EXPECT_EQ(Letter(5U), "-");
    EXPECT_EQ(Of(5U).step, StartUpStep::kErrorControl);
    Run(4U);
    EXPECT_EQ(Letter(5U), "K"); // The boot-up message is no heartbeat.
    EXPECT_EQ(Letter(6U), "-");
    EXPECT_EQ(Of(6U).step, StartUpStep::kDone);
    EXPECT_EQ(Step(), MasterStep::kHalted);
}

TEST_F(BootLettersTest, L_SlaveThatWasOperationalGoesOn)
{
    Verifies(req::SRS_BOOT_006);
    Verifies(req::SRS_BOOT_001);
    Verifies(req::SRS_BOOT_014);
    // Given slaves 5 (heartbeat), 6 (remote frame) kept alive and OPERATIONAL, 7 kept alive in PRE-OPERATIONAL
    Add(5U, kMust | kKeepAlive).heartbeat_ms = 50U;
    setups[5].heartbeat = HeartbeatSetup{150U, 50U, Arming::kFirstHeartbeat};
    Add(6U, kMust | kKeepAlive);
    Add(7U, kMust | kKeepAlive);
    // And a configuration for each
    Octets list{};
    AddEntry(list, 0x2000U, 0U, {0x77U});
    for (const std::uint8_t node : {std::uint8_t{5U}, std::uint8_t{6U}, std::uint8_t{7U}})
    {
        slaves[node]->Put8(0x2000U, 0U, 0x11U);
        setups[node].concise_dcf = Bytes{list.data(), static_cast<std::uint32_t>(list.size())};
    }
    PowerAll();
    Run(10U);
    const CanFrame start5{0U, FrameKind::kData, CanPortId::kFirst, 2U, {1U, 5U}};
    const CanFrame start6{0U, FrameKind::kData, CanPortId::kFirst, 2U, {1U, 6U}};
    slaves[5]->OnFrame(start5, Now());
    slaves[6]->OnFrame(start6, Now());
    log.clear();
    begun_ms = ms;
    is_begun = true;
    start_up.Begin(Now());
    Run(150U);
    EXPECT_EQ(Letter(5U) + Letter(6U), "LL");
    EXPECT_EQ(slaves[5]->resets, 1);
    EXPECT_EQ(slaves[6]->resets, 1);
    EXPECT_EQ(slaves[5]->Get(0x2000U, 0U), (Octets{0x11U}));
    EXPECT_EQ(slaves[6]->Get(0x2000U, 0U), (Octets{0x11U}));
    EXPECT_EQ(slaves[7]->Get(0x2000U, 0U), (Octets{0x77U}));
    EXPECT_EQ(Letter(7U), "-");
    EXPECT_EQ(slaves[7]->resets, 2);
    EXPECT_EQ(slaves[7]->State(), cia301::NodeState::kOperational);
    EXPECT_EQ(Step(), MasterStep::kOperational);
    const std::string sent = ::testing::PrintToString(Commands());
    EXPECT_EQ(sent.find(":01 05"), std::string::npos) << sent;
    EXPECT_EQ(sent.find(":01 06"), std::string::npos) << sent;
}

using BootSoftwareTest = BootRig;

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
