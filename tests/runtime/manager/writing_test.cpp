// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Safety slaves whose configuration differs and that the network file lets be written: once for each boot-up, and what
// breaks a writing off.
#include "tests/canopen/cia302/fake_slave.hpp"
#include "tests/runtime/manager/rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/nmt_master.hpp"
#include "verification/trace/verifies.hpp"

#include <optional>

namespace counterpoint::tools
{
namespace
{
constexpr std::uint16_t kSrdo = 0x1301U;
constexpr std::uint16_t kValid = 0x13FEU;

/// Slave 33 with services of its own beside the manager. What it has differs in its SCT: 51 ms instead of 50.
class ManagerWritingTest : public test::ManagerRig, private cia301::FrameSink
{
  protected:
    void MakeBoth(const std::string& manager, const std::string& more = "write_safety: true")
    {
        Make("manager: {node: 127" + manager + "}\nslaves: [{node: 33, dcf: actuator.dcf, " + more +
             "}, {node: 5, boot: false, mandatory: false}]\n");
        slave.emplace(std::uint8_t{33U}, static_cast<cia301::FrameSink&>(*this));
        const cia302::SlaveSetup& setup = net->Setup().Slave(cia302::NodeId{33U});
        slave->Put32(0x1000U, 0U, setup.device_type);
        const std::uint32_t identity[] = {setup.vendor_id, setup.product_code, setup.revision_number,
                                          setup.serial_number};
        for (std::uint8_t sub = 1U; sub <= 4U; ++sub)
        {
            slave->Put32(0x1018U, sub, identity[sub - 1U]);
        }
        slave->Put(0x1017U, 0U, {0U, 0U});
        slave->Put8(kValid, 0U, 0xA5U);
        slave->heartbeat_ms = 100U;
        slave->is_period_kept = true; // Many heartbeats in a row are those of two devices.
        for (const cia302::ExpectedObject& object : net->Find(33U)->objects)
        {
            cia302::Octets bytes;
            for (std::uint8_t place = 0U; place < cia302::SizeOf(object.address); ++place)
            {
                bytes.push_back(static_cast<std::uint8_t>((object.value >> (8U * place)) & 0xFFU));
            }
            slave->Put(object.address.index, object.address.sub, bytes);
        }
        slave->Put(kSrdo, 2U, {51U, 0U});
        sent.clear();
        slave->Power(Instant{static_cast<std::uint32_t>(now_us)});
    }
    /// Both for so many ms, or until the event.
    void Live(const int ms, const std::string& event = "", const std::string& word = "")
    {
        const int before = Told(event, word);
        for (int i = 0; i < ms && (event.empty() || Told(event, word) == before); ++i)
        {
            Run(1U);
            const Instant now{static_cast<std::uint32_t>(now_us)};
            const std::vector<CanFrame> heard = std::exchange(sent, {});
            for (const CanFrame& frame : heard)
            {
                slave->OnFrame(frame, now);
            }
            slave->OnCycle(now);
            const std::vector<CanFrame> said = std::exchange(said_, {});
            for (const CanFrame& frame : said)
            {
                station->OnFrame(frame, now_us);
            }
        }
    }
    /// An NMT command of somebody else, to both.
    void Command(const std::uint8_t command)
    {
        Hear(0U, {command, 33U});
        CanFrame frame{0U, FrameKind::kData, CanPortId::kFirst, 2U, {}};
        frame.data[0] = command;
        frame.data[1] = 33U;
        slave->OnFrame(frame, Instant{static_cast<std::uint32_t>(now_us)});
    }
    /// How often node 33 was told to have this.
    [[nodiscard]] int Told(const std::string& kind, const std::string& word = "") const
    {
        return static_cast<int>(
            std::count_if(events.begin(), events.end(), [&](const runtime::ManagerEvent& event)
                          { return event.node == 33U && event.kind == kind && (word.empty() || event.word == word); }));
    }

    std::optional<cia302::FakeSlave> slave;

  private:
    [[nodiscard]] bool Send(const CanFrame& frame) noexcept override
    {
        said_.push_back(frame);
        return true;
    }

    std::vector<CanFrame> said_;
};

TEST_F(ManagerWritingTest, WhatDiffersIsWrittenOnceAndStarted)
{
    Verifies(req::SRS_SFS_005);
    Verifies(req::SRS_SFS_214);
    for (const std::string profile : {"cia302", "el6751", "plc_designer"})
    {
        events.clear();
        MakeBoth(", profile: " + profile);
        Live(6000);
        EXPECT_EQ(Told("write_safety"), 1) << profile;
        EXPECT_EQ(slave->Get(kSrdo, 2U), (cia302::Octets{50U, 0U})) << profile;
        EXPECT_EQ(slave->Get(kValid, 0U), (cia302::Octets{0xA5U})) << profile;
        EXPECT_EQ(slave->State(), cia301::NodeState::kOperational) << profile;
        EXPECT_EQ(Row(33U).safety, "open") << profile;
    }
    // Without the permission of the network file nothing is written
    events.clear();
    MakeBoth("", "mandatory: true");
    Live(6000);
    EXPECT_EQ(Told("write_safety"), 0);
    EXPECT_EQ(slave->Get(kSrdo, 2U), (cia302::Octets{51U, 0U}));
    EXPECT_EQ(slave->State(), cia301::NodeState::kPreOperational);
    EXPECT_EQ(Row(33U).finding, "safety configuration: 0x1301:02 is 0x33, expected 0x32");
    // But by an order
    EXPECT_EQ(Order("write-safety 33"), "taken");
    Live(2000);
    EXPECT_EQ(slave->Get(kSrdo, 2U), (cia302::Octets{50U, 0U}));
}

TEST_F(ManagerWritingTest, AWritingThatFailsIsTriedAgainBehindABootUpOnly)
{
    Verifies(req::SRS_SFS_211);
    // Given a slave that takes no SCT
    MakeBoth("");
    slave->refused[cia301::KeyOf(kSrdo, 2U)] = cia302::SdoAbort::kDeviceState;
    Live(10000);
    EXPECT_EQ(Told("write_safety"), 1);
    EXPECT_NE(slave->Get(kValid, 0U), (cia302::Octets{0xA5U}));
    EXPECT_EQ(Row(33U).safety, "failed");
    // When it is off for a moment and then takes it
    slave->refused.clear();
    slave->Put(kSrdo, 2U, {51U, 0U});
    slave->Power(Instant{static_cast<std::uint32_t>(now_us)});
    Live(10000);
    EXPECT_EQ(Told("write_safety"), 2);
    EXPECT_EQ(slave->Get(kValid, 0U), (cia302::Octets{0xA5U}));
    EXPECT_EQ(slave->State(), cia301::NodeState::kOperational);
}

TEST_F(ManagerWritingTest, AWritingThatIsInterruptedIsTakenUpUnlessByAStop)
{
    Verifies(req::SRS_SFS_213);
    for (const std::string profile : {"cia302", "el6751", "plc_designer"})
    {
        for (const bool is_stop : {false, true})
        {
            // When a command of somebody else comes in the middle of the writing
            events.clear();
            MakeBoth(", profile: " + profile);
            Live(6000, "write_safety");
            ASSERT_EQ(Told("write_safety"), 1) << profile << is_stop;
            Live(8);
            Command(is_stop ? std::uint8_t{0x02U} : std::uint8_t{0x80U});
            Live(6000);
            EXPECT_EQ(Told("write_safety"), is_stop ? 1 : 2) << profile << is_stop;
            EXPECT_EQ(slave->State(), is_stop ? cia301::NodeState::kStopped : cia301::NodeState::kOperational)
                << profile << is_stop;
            EXPECT_EQ(Row(33U).safety, is_stop ? "closed" : "open") << profile << is_stop;
        }
    }
}

TEST_F(ManagerWritingTest, AWritingWaitsForCommandsThatWait)
{
    Verifies(req::SRS_SFS_213);
    // Given commands to another slave that wait for the inhibit time when the difference is found
    MakeBoth(", inhibit: 300 ms");
    Live(6000, "boot_up");
    EXPECT_EQ(Order("preop 5"), "taken");
    EXPECT_EQ(Order("stop 5"), "taken");
    EXPECT_EQ(Order("preop 5"), "taken");
    Live(6000, "gate", "differs");
    ASSERT_EQ(Told("gate", "differs"), 1);
    Live(20);
    EXPECT_EQ(Told("write_safety"), 0);
    Live(6000);
    EXPECT_EQ(Told("write_safety"), 1);
    EXPECT_EQ(slave->Get(kSrdo, 2U), (cia302::Octets{50U, 0U}));
}

TEST_F(ManagerWritingTest, WhatIsTakenForRunningBehindLostFramesIsNotHeardToRun)
{
    Verifies(req::SRS_MGR_082);
    Verifies(req::SRS_MGR_523);
    const cia302::NodeId node{33U};
    MakeBoth("");
    Live(6000);
    ASSERT_TRUE(station->Assembly().Runs(node));
    // When frames are lost, and among them may have been its boot-up message, then its next heartbeat tells
    station->Assembly().Core().OnLost(Instant{static_cast<std::uint32_t>(now_us)});
    EXPECT_FALSE(station->Assembly().Runs(node));
    Live(500);
    EXPECT_TRUE(station->Assembly().Runs(node));
    // And when somebody else commands it before that, then this is told, and not that it has said so itself
    for (const std::string profile : {"el6751", "plc_designer"})
    {
        MakeBoth(", profile: " + profile);
        Live(6000);
        ASSERT_TRUE(station->Assembly().Runs(node)) << profile;
        station->Assembly().Core().OnLost(Instant{static_cast<std::uint32_t>(now_us)});
        Hear(0U, {0x80U, 33U});
        EXPECT_EQ(Row(33U).finding, "started, but told by somebody else to be PRE-OPERATIONAL") << profile;
    }
}

TEST_F(ManagerWritingTest, BehindAStopOfAllItIsWrittenAndWaitsForAnOrder)
{
    Verifies(req::SRS_BOOT_343);
    // Given 1F80h bit 6, by which a mandatory slave that differs stops all
    MakeBoth(", start_up: 0x41");
    Live(6000);
    EXPECT_EQ(Told("write_safety"), 2); // The first one was broken off by that stop.
    EXPECT_EQ(slave->Get(kSrdo, 2U), (cia302::Octets{50U, 0U}));
    EXPECT_EQ(Row(33U).safety, "open");
    EXPECT_NE(slave->State(), cia301::NodeState::kOperational);
    EXPECT_EQ(Order("start 33").rfind("taken", 0U), 0U);
    Live(2000);
    EXPECT_EQ(slave->State(), cia301::NodeState::kOperational);
}
} // namespace
} // namespace counterpoint::tools
