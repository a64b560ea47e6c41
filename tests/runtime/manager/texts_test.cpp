// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Words for results, findings and events, one by one.
#include "runtime/manager/pdos.hpp"
#include "runtime/manager/report/journal.hpp"
#include "runtime/manager/report/texts.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/nmt_master.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::tools
{
namespace
{
using cia302::NodeStatus;
using cia302::StartUpStep;
using network_plan::StartProfile;
using runtime::FindingText;
using runtime::ResultText;
using runtime::StatusText;

/// Of object 1018h:02: it is 3, 7 was expected.
NodeStatus Different(const char letter, const std::int16_t code)
{
    NodeStatus status{};
    status.letter = letter;
    status.code = code;
    status.object = {0x1018U, 2U};
    status.read = 3U;
    status.expected = 7U;
    return status;
}

TEST(ManagerTextsTest, AFindingOfTheGateNamesItsObjectOrWhatIsDoubted)
{
    Verifies(req::SRS_MGR_026);
    cia302::GateFinding finding{{0U, 0U}, cia301::SdoAbort::kNone, 0U, 0U};
    EXPECT_EQ(FindingText(finding), "");
    finding.abort = cia301::SdoAbort::kGeneral;
    EXPECT_EQ(FindingText(finding), "two devices seem to have this node-ID, expected one and a reset");
    finding.object = {0x1301U, 2U};
    EXPECT_EQ(FindingText(finding).rfind("0x1301:02: 0x08000000", 0U), 0U) << FindingText(finding);
    finding.abort = cia301::SdoAbort::kNone;
    finding.read = 0x33U;
    finding.expected = 0x32U;
    EXPECT_EQ(FindingText(finding), "0x1301:02 is 0x33, expected 0x32");
}

TEST(ManagerTextsTest, AToggleBitThatDoesNotChangeIsToldInWords)
{
    Verifies(req::SRS_MGR_026);
    NodeStatus status{};
    status.letter = 'K';
    status.abort = cia301::SdoAbort::kToggle;
    EXPECT_EQ(FindingText(StartProfile::kCia302, status),
              "the toggle bit of its guarding answers does not change, expected another one in each answer");
    status.object = {0x1F83U, 1U};
    EXPECT_EQ(FindingText(StartProfile::kCia302, status), "0x1F83:01: 0x05030000 (toggle bit not alternated)");
}

TEST(ManagerTextsTest, UnderCia302AFindingIsWhatALetterSays)
{
    Verifies(req::SRS_MGR_026);
    const std::string differs = "0x1018:02 is 0x3, expected 0x7";
    EXPECT_EQ(FindingText(StartProfile::kCia302, Different('M', 0)), differs);
    EXPECT_EQ(FindingText(StartProfile::kCia302, Different('L', 0)), "");
    EXPECT_EQ(FindingText(StartProfile::kCia302, Different(0, 0)), "");
    NodeStatus alike = Different('M', 0);
    alike.read = 7U;
    EXPECT_EQ(FindingText(StartProfile::kCia302, alike), "");
    alike.abort = cia301::SdoAbort::kTimeOut;
    EXPECT_EQ(FindingText(StartProfile::kCia302, alike), "0x1018:02: 0x05040000 (no answer)");
    // Asked again each second: 1000h was refused, in the start-up, without a letter
    NodeStatus again{};
    again.is_busy = true;
    again.step = StartUpStep::kDeviceType;
    again.object = {0x1000U, 0U};
    again.abort = cia301::SdoAbort::kTimeOut;
    EXPECT_EQ(ResultText(StartProfile::kCia302, again), "asked again each second: 0x1000:00: 0x05040000 (no answer)");
    EXPECT_EQ(StatusText(StartProfile::kCia302, again), "asked again each second (0x1000:00: 0x05040000 (no answer))");
    NodeStatus others[4] = {again, again, again, again};
    others[0].letter = 'B';
    others[1].is_busy = false;
    others[2].step = StartUpStep::kVendorId;
    others[3].abort = cia301::SdoAbort::kNone;
    for (const NodeStatus& other : others)
    {
        EXPECT_FALSE(runtime::IsAskedAgain(other));
    }
}

TEST(ManagerTextsTest, UnderEl6751AFindingIsWhatNodeStateSays)
{
    Verifies(req::SRS_MGR_026);
    Verifies(req::SRS_ELM_520);
    const std::string differs = "0x1018:02 is 0x3, expected 0x7";
    for (const std::int16_t code : {std::int16_t{2}, std::int16_t{4}, std::int16_t{5}})
    {
        EXPECT_EQ(FindingText(StartProfile::kEl6751, Different(0, code)), differs) << code;
    }
    EXPECT_EQ(FindingText(StartProfile::kEl6751, Different(0, 8)), "");
    // What failed stays told, whatever NodeState says since
    NodeStatus failed = Different(0, 5);
    failed.has_failed = true;
    EXPECT_EQ(ResultText(StartProfile::kEl6751, failed), "SDO value differs: " + differs);
    failed.code = 4;
    EXPECT_EQ(ResultText(StartProfile::kEl6751, failed), "SDO aborted or of wrong length: " + differs);
    failed.code = 12;
    EXPECT_EQ(ResultText(StartProfile::kEl6751, failed), "pre-operational, its start-up failed: " + differs);
    failed.is_started = true;
    EXPECT_EQ(ResultText(StartProfile::kEl6751, failed),
              "pre-operational, started though its start-up failed: " + differs);
    failed.code = 0;
    EXPECT_EQ(ResultText(StartProfile::kEl6751, failed), "started though its start-up failed: " + differs);
    EXPECT_EQ(StatusText(StartProfile::kEl6751, failed), "0: started though its start-up failed (" + differs + ")");
    EXPECT_FALSE(runtime::IsDespite(NodeStatus{}));
}

TEST(ManagerTextsTest, UnderPlcDesignerAFindingIsAnAbortOrAnotherDeviceType)
{
    Verifies(req::SRS_MGR_026);
    EXPECT_EQ(FindingText(StartProfile::kPlcDesigner, Different(0, 98)), "0x1018:02 is 0x3, expected 0x7");
    EXPECT_EQ(FindingText(StartProfile::kPlcDesigner, Different(0, 5)), "");
    NodeStatus aborted = Different(0, 5);
    aborted.abort = cia301::SdoAbort::kReadOnly;
    EXPECT_EQ(FindingText(StartProfile::kPlcDesigner, aborted), "0x1018:02: 0x06010002 (read only)");
}

TEST(ManagerTextsTest, StatesOfTheMasterAreWordsWhereTheProfileHasSome)
{
    Verifies(req::SRS_MGR_026);
    EXPECT_EQ(runtime::MasterText(StartProfile::kCia302, 5), "operational");
    EXPECT_EQ(runtime::MasterText(StartProfile::kCia302, 77), "77");
    EXPECT_EQ(runtime::MasterText(StartProfile::kEl6751, 2), "all started");
    EXPECT_EQ(runtime::MasterText(StartProfile::kEl6751, 77), "77");
    EXPECT_EQ(runtime::MasterText(StartProfile::kPlcDesigner, 5), "5");
    EXPECT_EQ(runtime::CodeText(StartProfile::kCia302, 5), "");
    EXPECT_EQ(runtime::CodeText(StartProfile::kEl6751, 77), "");
}

TEST(ManagerTextsTest, AnEventIsALineForPeopleAndOneForPrograms)
{
    Verifies(req::SRS_MGR_007);
    runtime::ManagerEvent event{1234567U, 5U, "state", "", {{"state", "stopped"}}, ""};
    EXPECT_EQ(runtime::JsonLine(event), "{\"format\":\"counterpoint-manager-1\",\"t_us\":1234567,\"node\":5,\"event\":"
                                        "\"state\",\"state\":\"stopped\"}");
    event.details = {};
    event.text = "stopped";
    EXPECT_EQ(runtime::JsonLine(event), "{\"format\":\"counterpoint-manager-1\",\"t_us\":1234567,\"node\":5,\"event\":"
                                        "\"state\",\"text\":\"stopped\"}");
    EXPECT_EQ(runtime::TextLine(event), "     1.235 s  node   5  stopped");
    event.node = 0U;
    EXPECT_EQ(runtime::TextLine(event), "     1.235 s  network   stopped");
}

TEST(ManagerTextsTest, AJournalWithoutAnybodyWhoWaitsForRoomTellsNothingOfIt)
{
    Verifies(req::SRS_MGR_007);
    runtime::ManagerJournal journal;
    journal.OnRoom(Instant{0U});
    EXPECT_EQ(journal.Take().size(), 0U);
    int rooms = 0;
    journal.WhenRoom([&rooms](const Instant) { ++rooms; });
    journal.OnRoom(Instant{0U});
    EXPECT_EQ(rooms, 1);
}

TEST(ManagerTextsTest, ACommandThatNeverLeavesIsAnEvent)
{
    Verifies(req::SRS_MGR_800);
    runtime::ManagerJournal journal;
    journal.OnNmtUnsent({cia302::NmtCommand::kStop, cia302::NodeId{5U}}, Instant{0U});
    journal.OnNmtUnsent({cia302::NmtCommand::kStart, cia302::NodeId{0U}}, Instant{0U});
    const std::vector<runtime::ManagerEvent> events = journal.Take();
    ASSERT_EQ(events.size(), 2U);
    EXPECT_EQ(
        runtime::JsonLine(events[0]),
        "{\"format\":\"counterpoint-manager-1\",\"t_us\":0,\"node\":5,\"event\":\"nmt_unsent\",\"command\":\"stop\","
        "\"text\":\"NMT stop has not left: no active master any more\"}");
    EXPECT_EQ(events[1].node, 0U);
    EXPECT_EQ(events[1].text, "NMT start all has not left: no active master any more");
}

TEST(ManagerTextsTest, BytesAreTwoDigitsEach)
{
    Verifies(req::SRS_MGR_022);
    EXPECT_EQ(runtime::BytesFrom("01FF a0"), (std::vector<std::uint8_t>{0x01U, 0xFFU, 0xA0U}));
    for (const char* const wrong : {"", " ", "01 ", "0", "0 1", "0g", "000102030405060708"})
    {
        EXPECT_FALSE(runtime::BytesFrom(wrong).has_value()) << wrong;
    }
}
} // namespace
} // namespace counterpoint::tools
