// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia302/network/objects.hpp"
#include "canopen/cia302/safety_gate/safety_check.hpp"
#include "tests/canopen/start_up/boot_rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/nmt_master.hpp"

#include <algorithm>

namespace counterpoint::cia302
{
namespace
{

using Lines = std::vector<std::string>;
using cia301::NodeState;
using cia301::Reading;

constexpr std::uint32_t kGuarded = (3U << 8U) | (100U << 16U);
constexpr std::uint32_t kConf = 0x666E6F63U;

/// Slaves 5, 6, 7 run; the own node is 127.
class NetworkObjectsTest : public BootRig
{
  public:
    void SetUp() override
    {
        Add(5U, kBoot | kGuarded);
        Add(6U, kBoot);
        Add(7U, kBoot);
        Begin();
        Run(20U);
        objects.OnCycle(Now());
        log.clear();
        own.clear();
    }
    SdoAbort Write(std::uint16_t index, std::uint8_t sub, std::uint32_t value)
    {
        const std::uint8_t bytes[4] = {
            static_cast<std::uint8_t>(value & 0xFFU), static_cast<std::uint8_t>((value >> 8U) & 0xFFU),
            static_cast<std::uint8_t>((value >> 16U) & 0xFFU), static_cast<std::uint8_t>(value >> 24U)};
        const SdoAbort abort = objects.OnWrite(ObjectAddress{index, sub}, Bytes{bytes, 4U});
        Deliver();
        return abort;
    }
    SdoAbort WriteAgain(std::uint16_t index, std::uint8_t sub, std::uint8_t value)
    {
        const SdoAbort abort = objects.OnWriteAgain(ObjectAddress{index, sub}, Bytes{&value, 1U});
        Deliver();
        return abort;
    }
    /// Value with its size in the upper half, or the abort code with size 0.
    std::uint64_t Read(std::uint16_t index, std::uint8_t sub)
    {
        std::uint8_t bytes[4] = {};
        const Reading reading = objects.OnRead(ObjectAddress{index, sub}, Room{bytes, 4U});
        std::uint64_t value = 0U;
        for (std::uint32_t i = reading.size_bytes; i > 0U; --i)
        {
            value = (value << 8U) | bytes[i - 1U];
        }
        return (reading.abort == SdoAbort::kNone) ? (value | (std::uint64_t{reading.size_bytes} << 32U))
                                                  : static_cast<std::uint64_t>(reading.abort);
    }
    [[nodiscard]] Lines Told() const
    {
        Lines told{};
        for (const std::string& command : Commands())
        {
            told.push_back(command.substr(command.find(':') + 1U));
        }
        return told;
    }

    NetworkObjects objects{NetworkObjectParts{setup, &setup, setups.data(), table, start_up}};
    NetworkObjects constant{NetworkObjectParts{setup, nullptr, nullptr, table, start_up}};
};

TEST_F(NetworkObjectsTest, RequestForOneNode)
{
    Verifies(req::SRS_NMM_006);
    Verifies(req::SRS_NMM_210);
    EXPECT_EQ(Write(0x1F82U, 5U, 4U), SdoAbort::kNone);
    EXPECT_EQ(Write(0x1F82U, 5U, 127U), SdoAbort::kNone);
    EXPECT_EQ(Write(0x1F82U, 5U, 5U), SdoAbort::kNone);
    EXPECT_EQ(Write(0x1F82U, 6U, 6U), SdoAbort::kNone);
    EXPECT_EQ(Write(0x1F82U, 7U, 7U), SdoAbort::kNone);
    EXPECT_EQ(Told(), (Lines{"02 05", "80 05", "01 05", "81 06", "82 07"}));
    EXPECT_EQ(Write(0x1F82U, 127U, 127U), SdoAbort::kNone);
    ASSERT_EQ(own.size(), 1U);
    EXPECT_EQ(own[0].command, NmtCommand::kPreOperational);
    // The own node takes each value, and none of them is on the bus
    const std::pair<std::uint32_t, NmtCommand> values[] = {{4U, NmtCommand::kStop},
                                                           {5U, NmtCommand::kStart},
                                                           {6U, NmtCommand::kResetNode},
                                                           {7U, NmtCommand::kResetCommunication}};
    for (const auto& [value, command] : values)
    {
        own.clear();
        EXPECT_EQ(Write(0x1F82U, 127U, value), SdoAbort::kNone) << value;
        ASSERT_EQ(own.size(), 1U) << value;
        EXPECT_EQ(own[0].command, command) << value;
    }
    EXPECT_EQ(Told().size(), 5U);
    // Refused
    EXPECT_EQ(Write(0x1F82U, 9U, 5U), SdoAbort::kValueRange); // Not listed.
    EXPECT_EQ(Write(0x1F82U, 5U, 3U), SdoAbort::kValueRange);
    EXPECT_EQ(Write(0x1F82U, 5U, 15U), SdoAbort::kValueRange);
    EXPECT_EQ(Write(0x1F82U, 5U, 0x85U), SdoAbort::kValueRange); // Only for all.
    EXPECT_EQ(Write(0x1F82U, 0U, 5U), SdoAbort::kReadOnly);
    nmt.SetActive(false);
    EXPECT_EQ(Write(0x1F82U, 5U, 5U), SdoAbort::kDeviceState);
}

TEST_F(NetworkObjectsTest, AnotherDeviceIsNotStartedAndKeepsNobodyElseFromIt)
{
    Verifies(req::SRS_SFS_009);
    Verifies(req::SRS_NMM_211);
    Verifies(req::SRS_SFS_340);
    // Given a safety slave 5 that is another device
    const SafetyExpectation nothing{nullptr, 0U};
    setups[5].safety = &nothing;
    boots[5].status.is_other = true;
    EXPECT_EQ(Write(0x1F82U, 5U, 5U), SdoAbort::kDeviceState);
    EXPECT_EQ(Told(), (Lines{}));
    EXPECT_EQ(Write(0x1F82U, 0x80U, 5U), SdoAbort::kDeviceState);
    EXPECT_EQ(Told(), (Lines{"01 06", "01 07"}));
    log.clear();
    EXPECT_EQ(Write(0x1F82U, 0x80U, 0x85U), SdoAbort::kDeviceState);
    EXPECT_EQ(Told(), (Lines{"01 06", "01 07"}));
    // What is no start is for all
    log.clear();
    EXPECT_EQ(Write(0x1F82U, 0x80U, 0x84U), SdoAbort::kNone);
    EXPECT_EQ(Told(), (Lines{"02 05", "02 06", "02 07"}));
}

TEST_F(NetworkObjectsTest, RequestForAll)
{
    Verifies(req::SRS_NMM_006);
    EXPECT_EQ(Write(0x1F82U, 0x80U, 4U), SdoAbort::kNone);
    EXPECT_EQ(Told(), (Lines{"02 00"}));
    EXPECT_EQ(own.size(), 1U); // The master too.
    log.clear();
    // All but master and requester
    objects.SetRequester(NodeId{6U});
    EXPECT_EQ(Write(0x1F82U, 0x80U, 0x85U), SdoAbort::kNone);
    EXPECT_EQ(Write(0x1F82U, 0x80U, 0x84U), SdoAbort::kNone);
    EXPECT_EQ(Write(0x1F82U, 0x80U, 0x8FU), SdoAbort::kNone);
    EXPECT_EQ(Write(0x1F82U, 0x80U, 0xFFU), SdoAbort::kNone);
    EXPECT_EQ(Told(), (Lines{"01 05", "01 07", "02 05", "02 07", "80 05", "80 07", "80 05", "80 07"}));
    EXPECT_EQ(own.size(), 1U);
    objects.SetRequester(NodeId{0U});
    log.clear();
    EXPECT_EQ(Write(0x1F82U, 0x80U, 0x87U), SdoAbort::kNone);
    EXPECT_EQ(Write(0x1F82U, 0x80U, 0x83U), SdoAbort::kValueRange);
    Run(5U);
    EXPECT_EQ(Count(0U), 6); // Three resets; the boot-up messages came, and the slaves were started again.
}

TEST_F(NetworkObjectsTest, AStartOfEachLeavesOutWhoAStartOfAllLeavesOut)
{
    Verifies(req::SRS_BOOT_470);
    // Given slave 6, of which another serial number is expected than it has: letter O
    setups[6].serial_number = 0x9999U;
    EXPECT_TRUE(start_up.Boot(NodeId{6U}, Now()));
    Run(50U);
    ASSERT_EQ(Letter(6U), "O");
    log.clear();
    // When each is started, then the other ones are
    EXPECT_EQ(Write(0x1F82U, 0x80U, 0x85U), SdoAbort::kNone);
    EXPECT_EQ(Told(), (Lines{"01 05", "01 07"}));
    EXPECT_FALSE(Of(6U).is_started);
    // And so they are by the start of all behind it
    log.clear();
    EXPECT_EQ(Write(0x1F82U, 0x80U, 5U), SdoAbort::kNone);
    EXPECT_EQ(Told(), (Lines{"01 05", "01 07"}));
    // What is no start goes to it, too; so does a start of its own
    log.clear();
    EXPECT_EQ(Write(0x1F82U, 0x80U, 0x84U), SdoAbort::kNone);
    EXPECT_EQ(Write(0x1F82U, 6U, 5U), SdoAbort::kNone);
    EXPECT_EQ(Told(), (Lines{"02 05", "02 06", "02 07", "01 06"}));
    // Started so, it is one of them
    log.clear();
    EXPECT_EQ(Write(0x1F82U, 0x80U, 0x85U), SdoAbort::kNone);
    EXPECT_EQ(Told(), (Lines{"01 05", "01 06", "01 07"}));
}

TEST_F(NetworkObjectsTest, StartOfAllWithASafetySlaveIsOneStartEachAfterVerification)
{
    Verifies(req::SRS_NMM_003);
    Verifies(req::SRS_BOOT_023);
    setups[6].safety = reinterpret_cast<const SafetyExpectation*>(&gate); // Only looked at whether it is there.
    EXPECT_EQ(Write(0x1F82U, 0x80U, 127U), SdoAbort::kNone);
    log.clear();
    EXPECT_EQ(Write(0x1F82U, 0x80U, 5U), SdoAbort::kNone);
    EXPECT_EQ(Told(), (Lines{"01 05", "01 07"}));
    Run(10U);
    EXPECT_EQ(Told(), (Lines{"01 05", "01 07", "01 06"}));
    EXPECT_EQ(gate.verifications, 1);
}

TEST_F(NetworkObjectsTest, RequestForAllTakesEachValue)
{
    Verifies(req::SRS_NMM_006);
    Verifies(req::SRS_NMM_210);
    const std::pair<std::uint32_t, std::string> values[] = {
        {4U, "02 00"}, {5U, "01 00"}, {127U, "80 00"}, {6U, "81 00"}, {7U, "82 00"}};
    for (const auto& [value, command] : values)
    {
        log.clear();
        EXPECT_EQ(Write(0x1F82U, 0x80U, value), SdoAbort::kNone) << value;
        EXPECT_EQ(Told(), Lines{command}) << value;
    }
    for (const std::uint32_t value : {0U, 1U, 3U, 8U, 126U, 128U})
    {
        EXPECT_EQ(Write(0x1F82U, 0x80U, value), SdoAbort::kValueRange) << value;
    }
}

TEST_F(NetworkObjectsTest, RequestForEachTakesEachValue)
{
    Verifies(req::SRS_NMM_006);
    const std::pair<std::uint32_t, std::string> values[] = {{0x84U, "02"}, {0x8FU, "80"}, {0xFFU, "80"},
                                                            {0x85U, "01"}, {0x86U, "81"}, {0x87U, "82"}};
    for (const auto& [value, command] : values)
    {
        log.clear();
        EXPECT_EQ(Write(0x1F82U, 0x80U, value), SdoAbort::kNone) << value;
        EXPECT_EQ(Told(), (Lines{command + " 05", command + " 06", command + " 07"})) << value;
    }
    EXPECT_TRUE(own.empty()); // The master is none of them.
}

TEST_F(NetworkObjectsTest, AFullQueueDelaysTheAnswer)
{
    Verifies(req::SRS_NMM_212);
    FillQueue(255U);
    ASSERT_EQ(nmt.Waiting(), 255U);
    EXPECT_EQ(Write(0x1F82U, 0x80U, 0x84U), SdoAbort::kPending); // Room for one.
    Run(10U);
    EXPECT_EQ(WriteAgain(0x1F82U, 0x80U, 0x84U), SdoAbort::kNone);
    Run(400U);
    const Lines told = Told();
    ASSERT_GE(told.size(), 3U);
    EXPECT_EQ(std::count(told.begin(), told.end(), "02 05"), 1); // It went on where it had stopped.
    EXPECT_EQ(std::count(told.begin(), told.end(), "02 06"), 1);
    EXPECT_EQ(std::count(told.begin(), told.end(), "02 07"), 1);
}

// Given a start of each that the full queue holds up behind node 5: a stop of each is no rest of it.
TEST_F(NetworkObjectsTest, ACommandToEachThatWasGivenUpLeavesNobodyOutOfTheNextOne)
{
    Verifies(req::SRS_NMM_212);
    FillQueue(254U);
    EXPECT_EQ(Write(0x1F82U, 0x80U, 0x85U), SdoAbort::kPending);
    Run(400U);
    log.clear();
    EXPECT_EQ(Write(0x1F82U, 0x80U, 0x84U), SdoAbort::kNone);
    // And whoever had begun the first one is told that another one has its place
    EXPECT_EQ(WriteAgain(0x1F82U, 0x80U, 0x85U), SdoAbort::kLocalControl);
    Run(400U);
    EXPECT_EQ(Told(), (Lines{"02 05", "02 06", "02 07"}));
}

TEST_F(NetworkObjectsTest, ReadingOfTheRequestObject)
{
    Verifies(req::SRS_NMM_007);
    EXPECT_EQ(Read(0x1F82U, 0U), 0x1'0000'0080U);
    EXPECT_EQ(Read(0x1F82U, 6U), 0x1'0000'0005U);
    EXPECT_EQ(Read(0x1F82U, 9U), 0x1'0000'0000U);
    EXPECT_EQ(Read(0x1F82U, 0x80U), 0x06010001U);
    // Its own state: as it started itself, then as it was told
    EXPECT_EQ(Read(0x1F82U, 127U), 0x1'0000'0005U);
    EXPECT_EQ(Write(0x1F82U, 127U, 127U), SdoAbort::kNone);
    EXPECT_EQ(Read(0x1F82U, 127U), 0x1'0000'007FU);
    table.SetMissing(NodeId{6U});
    EXPECT_EQ(Read(0x1F82U, 6U), 0x1'0000'0001U);
    // A command to all makes nobody OPERATIONAL who is not there
    EXPECT_EQ(Write(0x1F82U, 0x80U, 5U), SdoAbort::kNone);
    EXPECT_EQ(Read(0x1F82U, 6U), 0x1'0000'0001U);
    EXPECT_EQ(Read(0x1F82U, 7U), 0x1'0000'0005U);
    EXPECT_EQ(Read(0x1F82U, 9U), 0x1'0000'0000U);
}

TEST_F(NetworkObjectsTest, RequestForGuarding)
{
    Verifies(req::SRS_NMM_008);
    EXPECT_EQ(Read(0x1F83U, 5U), 0x1'0000'0001U);
    EXPECT_EQ(Read(0x1F83U, 6U), 0x1'0000'0000U);
    EXPECT_EQ(Write(0x1F83U, 5U, 0U), SdoAbort::kNone);
    EXPECT_EQ(Read(0x1F83U, 5U), 0x1'0000'0000U);
    EXPECT_EQ(Write(0x1F83U, 6U, 1U), SdoAbort::kDeviceState); // Without times.
    EXPECT_EQ(Write(0x1F83U, 6U, 0U), SdoAbort::kNone);
    EXPECT_EQ(Write(0x1F83U, 9U, 1U), SdoAbort::kValueRange);
    EXPECT_EQ(Write(0x1F83U, 5U, 2U), SdoAbort::kValueRange);
    EXPECT_EQ(Write(0x1F83U, 0U, 1U), SdoAbort::kReadOnly);
    EXPECT_EQ(Write(0x1F83U, 0x80U, 1U), SdoAbort::kNone);
    EXPECT_EQ(Read(0x1F83U, 5U), 0x1'0000'0001U);
    EXPECT_EQ(Read(0x1F83U, 0x80U), 0x06010001U);
    Run(5U);
    EXPECT_GE(Count(0x705U), 1);
    // By the times of 1F81h: a remote frame each 100 ms, and its answer; none when all are told to stop
    log.clear();
    Run(400U);
    EXPECT_EQ(Count(0x705U), 8);
    EXPECT_EQ(Write(0x1F83U, 0x80U, 0U), SdoAbort::kNone);
    EXPECT_EQ(Read(0x1F83U, 5U), 0x1'0000'0000U);
    log.clear();
    Run(400U);
    EXPECT_EQ(Count(0x705U), 0);
    EXPECT_EQ(Write(0x1F83U, 0x80U, 1U), SdoAbort::kNone);
    // Who is supervised by heartbeat answers no remote frame, and stays supervised
    setups[5].heartbeat = HeartbeatSetup{100U, 50U, Arming::kFirstHeartbeat};
    table.WatchAsSetUp(NodeId{5U}, Now());
    EXPECT_EQ(Write(0x1F83U, 5U, 1U), SdoAbort::kDeviceState);
    EXPECT_EQ(Write(0x1F83U, 0x80U, 1U), SdoAbort::kNone);
    EXPECT_EQ(Write(0x1F83U, 5U, 0U), SdoAbort::kNone);
    EXPECT_EQ(nodes[5].watch, Watch::kHeartbeat);
}

TEST_F(NetworkObjectsTest, RequestForConfiguration)
{
    Verifies(req::SRS_NMM_150);
    Verifies(req::SRS_NMM_009);
    Octets dcf{};
    AddEntry(dcf, 0x1018U, 4U, {1U, 2U, 3U, 4U});
    setups[5].concise_dcf = Bytes{dcf.data(), static_cast<std::uint32_t>(dcf.size())};
    EXPECT_EQ(Write(0x1F25U, 5U, kConf), SdoAbort::kNone);
    EXPECT_EQ(Write(0x1F25U, 5U, kConf), SdoAbort::kNone); // The first one is done by then.
    Run(5U);
    EXPECT_EQ(slaves[5]->Get(0x1018U, 4U), (Octets{1U, 2U, 3U, 4U}));
    EXPECT_EQ(slaves[5]->State(), NodeState::kOperational);
    EXPECT_TRUE(Told().empty()); // Neither reset nor started.
    EXPECT_EQ(Write(0x1F25U, 5U, kConf + 1U), SdoAbort::kNotStored);
    EXPECT_EQ(Write(0x1F25U, 9U, kConf), SdoAbort::kValueRange);
    EXPECT_EQ(Write(0x1F25U, 0U, kConf), SdoAbort::kReadOnly);
    EXPECT_EQ(Write(0x1F25U, 0x80U, kConf), SdoAbort::kNone);
    EXPECT_EQ(Read(0x1F25U, 5U), 0x06010001U);
    // A failure is told, and the slave still counts as booted
    slaves[5]->refused[0x101804U] = SdoAbort::kHardware;
    EXPECT_EQ(Write(0x1F25U, 5U, kConf), SdoAbort::kNone);
    Run(5U);
    EXPECT_EQ(Letter(5U), "J");
    EXPECT_EQ(Of(5U).abort, SdoAbort::kHardware);
    EXPECT_EQ(Step(), MasterStep::kOperational);
    EXPECT_EQ(table.Record(NodeId{5U}).watch, Watch::kGuarding);
    // While it is booted it cannot be asked for
    slaves[5]->is_sdo_mute = true;
    slaves[5]->Power(Now());
    Run(5U);
    EXPECT_EQ(Write(0x1F25U, 5U, kConf), SdoAbort::kDeviceState);
}

TEST_F(NetworkObjectsTest, AnotherDeviceIsNotConfigured)
{
    Verifies(req::SRS_NMM_150);
    Verifies(req::SRS_NMM_152);
    Verifies(req::SRS_SFS_009);
    // Given a safety slave 5 that is another device, whose defaults were to be restored
    const SafetyExpectation nothing{nullptr, 0U};
    setups[5].safety = &nothing;
    setups[5].assignment |= kRestoreDefaults;
    setups[5].restore_sub = 1U;
    boots[5].status.is_other = true;
    boots[5].status.letter = 'O';
    EXPECT_EQ(Write(0x1F25U, 5U, kConf), SdoAbort::kDeviceState);
    EXPECT_EQ(Write(0x1F25U, 0x80U, kConf), SdoAbort::kDeviceState);
    Run(5U);
    EXPECT_EQ(Count(0x605U), 0);
    EXPECT_EQ(Letter(5U), "O");
    // Without safety it is configured
    setups[5].safety = nullptr;
    EXPECT_EQ(Write(0x1F25U, 5U, kConf), SdoAbort::kNone);
}

TEST_F(NetworkObjectsTest, SetupIsReadAndWritten)
{
    Verifies(req::SRS_NMM_010);
    const std::uint16_t arrays[] = {0x1F26U, 0x1F27U, 0x1F53U, 0x1F54U, 0x1F55U, 0x1F81U,
                                    0x1F84U, 0x1F85U, 0x1F86U, 0x1F87U, 0x1F88U};
    std::uint32_t value = 0x1234'5601U;
    for (const std::uint16_t index : arrays)
    {
        EXPECT_EQ(Write(index, 9U, ++value), SdoAbort::kNone);
        EXPECT_EQ(Read(index, 9U), 0x4'0000'0000U + value);
        EXPECT_EQ(Read(index, 0U), 0x1'0000'007FU);
        EXPECT_EQ(Read(index, 128U), 0x06090011U);
        EXPECT_EQ(Write(index, 128U, 1U), SdoAbort::kSubUnknown);
        EXPECT_EQ(Write(index, 0U, 1U), SdoAbort::kReadOnly);
    }
    EXPECT_EQ(setups[9].revision_number, 0x1234'560BU);
    EXPECT_EQ(setups[9].software.identification, 0x1234'5606U);
    EXPECT_EQ(Write(0x1F8AU, 9U, 4U), SdoAbort::kNone);
    EXPECT_EQ(Write(0x1F8AU, 9U, 128U), SdoAbort::kValueRange);
    EXPECT_EQ(Read(0x1F8AU, 9U), 0x1'0000'0004U);
    EXPECT_EQ(Write(0x1F80U, 0U, 0x7FU), SdoAbort::kNone);
    EXPECT_EQ(Write(0x1F80U, 0U, 0x80U), SdoAbort::kValueRange);
    EXPECT_EQ(Read(0x1F80U, 0U), 0x4'0000'007FU);
    EXPECT_EQ(Write(0x1F89U, 0U, 60000U), SdoAbort::kNone);
    EXPECT_EQ(Read(0x1F89U, 0U), 0x4'0000'EA60U);
    EXPECT_EQ(Write(0x102AU, 0U, 0xFFFFU), SdoAbort::kNone);
    EXPECT_EQ(Write(0x102AU, 0U, 0x10000U), SdoAbort::kValueRange);
    EXPECT_EQ(Read(0x102AU, 0U), 0x2'0000'FFFFU);
    EXPECT_EQ(Read(0x1FFFU, 1U), 0x06020000U);
    EXPECT_EQ(Write(0x1FFFU, 1U, 0U), SdoAbort::kObjectUnknown);
    // A constant setup
    const std::uint8_t four[4] = {};
    EXPECT_EQ(constant.OnWrite(ObjectAddress{0x1F80U, 0U}, Bytes{four, 4U}), SdoAbort::kReadOnly);
    EXPECT_EQ(constant.OnWrite(ObjectAddress{0x1F81U, 5U}, Bytes{four, 4U}), SdoAbort::kReadOnly);
    EXPECT_EQ(constant.OnWrite(ObjectAddress{0x1F8AU, 5U}, Bytes{four, 1U}), SdoAbort::kReadOnly);
}

TEST_F(NetworkObjectsTest, EachObjectIsItsOwnNumberOfTheSetup)
{
    Verifies(req::SRS_NMM_010);
    // Given a number for each object of slave 9
    SlaveSetup& slave = setups[9];
    slave.configuration_date = 0x1F26U;
    slave.configuration_time = 0x1F27U;
    slave.software.date = 0x1F53U;
    slave.software.time = 0x1F54U;
    slave.software.identification = 0x1F55U;
    slave.assignment = 0x1F81U;
    slave.device_type = 0x1F84U;
    slave.vendor_id = 0x1F85U;
    slave.product_code = 0x1F86U;
    slave.revision_number = 0x1F87U;
    slave.serial_number = 0x1F88U;
    slave.restore_sub = 127U;
    setup.start_up = 0x41U;
    setup.boot_time_ms = 0x12345U;
    setup.inhibit_100us = 0x102AU;
    // Then each reads its own, and writes no other one
    const std::uint16_t arrays[] = {0x1F26U, 0x1F27U, 0x1F53U, 0x1F54U, 0x1F55U, 0x1F81U,
                                    0x1F84U, 0x1F85U, 0x1F86U, 0x1F87U, 0x1F88U};
    for (const std::uint16_t index : arrays)
    {
        EXPECT_EQ(Read(index, 9U), 0x4'0000'0000U + index) << index;
    }
    EXPECT_EQ(Read(0x1F8AU, 9U), 0x1'0000'007FU);
    EXPECT_EQ(Read(0x1F80U, 0U), 0x4'0000'0041U);
    EXPECT_EQ(Read(0x1F89U, 0U), 0x4'0001'2345U);
    EXPECT_EQ(Read(0x102AU, 0U), 0x2'0000'102AU);
    EXPECT_EQ(Write(0x1F85U, 9U, 0xFFFF'FFFFU), SdoAbort::kNone);
    EXPECT_EQ(slave.vendor_id, 0xFFFF'FFFFU);
    EXPECT_EQ(slave.product_code, 0x1F86U);
    EXPECT_EQ(slave.device_type, 0x1F84U);
    // And a value out of range changes nothing, whichever of the bits above 6 it is
    for (std::uint32_t bit = 7U; bit < 32U; ++bit)
    {
        EXPECT_EQ(static_cast<std::uint32_t>(Write(0x1F80U, 0U, 1U << bit)), 0x06090030U) << bit;
    }
    EXPECT_EQ(static_cast<std::uint32_t>(Write(0x1F8AU, 9U, 128U)), 0x06090030U);
    EXPECT_EQ(static_cast<std::uint32_t>(Write(0x102AU, 0U, 0x10000U)), 0x06090030U);
    EXPECT_EQ(setup.start_up, 0x41U);
    EXPECT_EQ(slave.restore_sub, 127U);
    EXPECT_EQ(setup.inhibit_100us, 0x102AU);
    EXPECT_EQ(Write(0x1F8AU, 9U, 127U), SdoAbort::kNone);
}

TEST_F(NetworkObjectsTest, DomainsAreRead)
{
    Verifies(req::SRS_NMM_010);
    NetworkDomains domains{setup};
    const Octets dcf{'[', 'x', ']'};
    const Octets concise{0U, 0U, 0U, 9U};
    const Octets program{1U, 2U};
    setups[5].dcf = Bytes{dcf.data(), 3U};
    setups[5].concise_dcf = Bytes{concise.data(), 4U};
    setups[5].software.program = Bytes{program.data(), 2U};
    std::array<std::uint8_t, 8> got{};
    EXPECT_EQ(domains.OnRead(ObjectAddress{0x1F20U, 5U}, Room{got.data(), 8U}).size_bytes, 3U);
    EXPECT_EQ(got[1], 'x');
    EXPECT_EQ(domains.OnRead(ObjectAddress{0x1F22U, 5U}, Room{got.data(), 8U}).size_bytes, 4U);
    EXPECT_EQ(got[3], 9U);
    EXPECT_EQ(domains.OnRead(ObjectAddress{0x1F58U, 5U}, Room{got.data(), 8U}).size_bytes, 2U);
    EXPECT_EQ(got[1], 2U);
    EXPECT_EQ(domains.OnRead(ObjectAddress{0x1F58U, 6U}, Room{got.data(), 8U}).size_bytes, 0U);
    EXPECT_EQ(domains.OnRead(ObjectAddress{0x1F58U, 5U}, Room{got.data(), 1U}).abort, SdoAbort::kOutOfMemory);
    EXPECT_EQ(domains.OnRead(ObjectAddress{0x1F58U, 0U}, Room{got.data(), 8U}).abort, SdoAbort::kSubUnknown);
    EXPECT_EQ(domains.OnRead(ObjectAddress{0x1F58U, 128U}, Room{got.data(), 8U}).abort, SdoAbort::kSubUnknown);
}

} // namespace
} // namespace counterpoint::cia302
