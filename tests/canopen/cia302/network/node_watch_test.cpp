// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Emergencies, and two devices behind one node-ID, frame by frame; with whole networks: tests/canopen/manager.
#include "canopen/cia302/network/node_watch.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/verifies.hpp"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace counterpoint::cia302
{
namespace
{

using Lines = std::vector<std::string>;

class NodeWatchTest : public ::testing::Test, public NodeWatchListener
{
  public:
    void OnEmergency(const NodeId node, const EmergencyRecord& emergency, const Instant now) noexcept override
    {
        emergencies.push_back(std::to_string((now.us - kStartUs) / 1000U) + ":" + std::to_string(node.value) + " " +
                              std::to_string(emergency.code) + " untold " + std::to_string(emergency.untold));
    }
    void OnDuplicate(const NodeId node, Instant) noexcept override
    {
        duplicates.push_back(node.value);
    }
    [[nodiscard]] Instant Now() const
    {
        return Instant{kStartUs + (1000U * ms)};
    }
    void Hear(const CanFrame& frame)
    {
        watch.OnFrame(frame, Now());
    }
    /// A frame of 8 bytes.
    static CanFrame Eight(const std::uint32_t identifier, const std::array<std::uint8_t, 4>& first)
    {
        CanFrame frame{identifier, FrameKind::kData, CanPortId::kFirst, 8U, {}};
        std::copy(first.begin(), first.end(), frame.data);
        return frame;
    }
    static CanFrame Emergency(const std::uint16_t code, const std::uint8_t error_register,
                              const std::uint32_t identifier = 0x85U)
    {
        return Eight(identifier, {static_cast<std::uint8_t>(code & 0xFFU), static_cast<std::uint8_t>(code >> 8U),
                                  error_register, 0U});
    }
    static CanFrame Sign(const std::uint8_t byte, const std::uint8_t node = 5U)
    {
        return CanFrame{0x700U + node, FrameKind::kData, CanPortId::kFirst, 1U, {byte}};
    }
    static CanFrame Remote(const std::uint8_t node = 5U)
    {
        return CanFrame{0x700U + node, FrameKind::kRemote, CanPortId::kFirst, 1U, {}};
    }
    static CanFrame Command(const std::uint8_t command, const std::uint8_t node)
    {
        return CanFrame{0U, FrameKind::kData, CanPortId::kFirst, 2U, {command, node}};
    }
    /// The manager asks for 2000h + `number`, sub-index 0, and node 5 answers so many times.
    void Ask(const std::uint8_t number, const int answers, const std::uint8_t answer = 0x43U,
             const std::uint8_t question = 0x40U)
    {
        watch.OnSent(Eight(0x605U, {question, number, 0x20U, 0U}));
        for (int i = 0; i < answers; ++i)
        {
            Hear(Eight(0x585U, {answer, number, 0x20U, 0U}));
        }
    }
    [[nodiscard]] bool IsSuspected() const
    {
        return watch.Of(NodeId{5U}).is_duplicate;
    }

    static constexpr std::uint32_t kStartUs = 0xFFFF'0000U; // The counter wraps soon.

    std::uint32_t ms{0U};
    Lines emergencies{};
    std::vector<std::uint8_t> duplicates{};
    std::array<SlaveSetup, kNodeRoom> slaves{};
    NetworkSetup setup{NodeId{127U}, kIsMaster, 0U, 0U, 0U, slaves.data()};
    std::array<WatchedNode, kNodeRoom> nodes{};
    NodeWatch watch{setup, nodes.data(), *this};
};

TEST_F(NodeWatchTest, AnEmergencyIsToldWithItsFields)
{
    Verifies(req::SRS_MGR_011);
    CanFrame frame = Emergency(0x8130U, 0x11U);
    frame.data[3] = 1U;
    frame.data[7] = 5U;
    Hear(frame);
    const EmergencyRecord& record = watch.Of(NodeId{5U}).emergency;
    EXPECT_EQ(emergencies, (Lines{"0:5 33072 untold 0"}));
    EXPECT_EQ(record.error_register, 0x11U);
    EXPECT_EQ(record.details[0], 1U);
    EXPECT_EQ(record.details[4], 5U);
    EXPECT_EQ(record.count, 1U);
}

TEST_F(NodeWatchTest, OfAStormOneIsToldEachTenthOfASecondAndTheLastOne)
{
    Verifies(req::SRS_MGR_011);
    for (; ms < 250U; ++ms)
    {
        Hear(Emergency(static_cast<std::uint16_t>(0x1000U + ms), 1U));
        watch.OnCycle(Now());
    }
    EXPECT_EQ(emergencies, (Lines{"0:5 4096 untold 0", "100:5 4196 untold 99", "200:5 4296 untold 99"}));
    for (; ms < 500U; ++ms)
    {
        watch.OnCycle(Now());
    }
    EXPECT_EQ(emergencies.back(), "300:5 4345 untold 48");
    EXPECT_EQ(emergencies.size(), 4U);
    // And the next one at once, also when the counter has come round
    ms += 4'294'967U;
    Hear(Emergency(0x1000U, 1U));
    EXPECT_EQ(emergencies.size(), 5U);
}

TEST_F(NodeWatchTest, AnEmergencyIsOfWhomItsIdentifierIsOf)
{
    Verifies(req::SRS_MGR_025);
    // Given node 9, whose emergencies come with the identifier that 5 would have, and 6 with one of its own
    slaves[9].emergency_id = 0x85U;
    slaves[6].emergency_id = 0x1FFU;
    EXPECT_EQ(watch.EmergencySender(Emergency(0x1000U, 1U)).value, 9U);
    EXPECT_EQ(watch.EmergencySender(Emergency(0x1000U, 1U, 0x1FFU)).value, 6U);
    EXPECT_EQ(watch.EmergencySender(Emergency(0x1000U, 1U, 0x86U)).value, 0U);
    EXPECT_EQ(watch.EmergencySender(Emergency(0x1000U, 1U, 0x87U)).value, 7U);
    // What is shorter, or a remote frame, is none
    CanFrame frame = Emergency(0x1000U, 1U, 0x87U);
    frame.length_bytes = 7U;
    EXPECT_EQ(watch.EmergencySender(frame).value, 0U);
    frame.length_bytes = 8U;
    frame.kind = FrameKind::kRemote;
    EXPECT_EQ(watch.EmergencySender(frame).value, 0U);
    Hear(frame);
    EXPECT_TRUE(emergencies.empty());
}

TEST_F(NodeWatchTest, ADeviceIsFaultyFromItsFirstFaultUntilAllIsTakenBack)
{
    Verifies(req::SRS_MGR_025);
    const auto fault_after = [this](const std::uint16_t code, const std::uint8_t error_register)
    {
        Hear(Emergency(code, error_register));
        return watch.Of(NodeId{5U}).fault;
    };
    EXPECT_EQ(fault_after(0x4FFFU, 1U), 0U);
    EXPECT_EQ(fault_after(0x8130U, 0x10U), 0U);
    EXPECT_EQ(fault_after(0x5000U, 1U), 0x5000U);
    EXPECT_EQ(fault_after(0x7FFFU, 1U), 0x5000U); // The first one.
    EXPECT_EQ(fault_after(0x0000U, 1U), 0x5000U); // One error alone is taken back.
    EXPECT_EQ(fault_after(0x0000U, 0U), 0U);
    EXPECT_EQ(fault_after(0x7FFFU, 1U), 0x7FFFU);
    EXPECT_EQ(fault_after(0x0100U, 0U), 0x7FFFU);
    // A boot-up message ends it, a heartbeat does not
    Hear(Sign(5U));
    EXPECT_EQ(watch.Of(NodeId{5U}).fault, 0x7FFFU);
    Hear(Sign(0U));
    EXPECT_EQ(watch.Of(NodeId{5U}).fault, 0U);
}

TEST_F(NodeWatchTest, EighteenSignsInTenPeriodsAreOfTwo)
{
    Verifies(req::SRS_MGR_010);
    slaves[5].heartbeat.producer_ms = 100U;
    // Given seventeen heartbeats in ten times 100 ms
    for (int i = 0; i < 17; ++i)
    {
        Hear(Sign(5U));
        ms += 50U;
    }
    EXPECT_FALSE(IsSuspected());
    ms += 1000U; // Another window.
    for (int i = 0; i < 17; ++i)
    {
        Hear(Sign(5U));
        ms += 50U;
    }
    EXPECT_FALSE(IsSuspected());
    Hear(Sign(5U));
    EXPECT_TRUE(IsSuspected());
    // Then it is told once, until a reset of it
    for (int i = 0; i < 40; ++i)
    {
        Hear(Sign(5U));
    }
    EXPECT_EQ(duplicates, (std::vector<std::uint8_t>{5U}));
    watch.OnReset(NodeId{6U});
    EXPECT_TRUE(IsSuspected());
    watch.OnReset(NodeId{5U});
    EXPECT_FALSE(IsSuspected());
}

TEST_F(NodeWatchTest, TheCountBeginsAnewWhereItHasTo)
{
    Verifies(req::SRS_MGR_010);
    slaves[5].heartbeat.producer_ms = 100U;
    const auto signs = [this](const int count)
    {
        for (int i = 0; i < count; ++i)
        {
            Hear(Sign(5U));
        }
    };
    signs(17);
    Hear(Sign(0U)); // A boot-up message.
    signs(17);
    watch.CountAnew(NodeId{5U});
    signs(17);
    watch.OnLost();
    signs(17);
    watch.OnReset(NodeId{0U});
    signs(17);
    EXPECT_FALSE(IsSuspected());
    signs(1);
    EXPECT_TRUE(IsSuspected());
}

TEST_F(NodeWatchTest, WithoutATimeOrWithOneThatItRefusedNothingIsTooOften)
{
    Verifies(req::SRS_MGR_083);
    const auto signs = [this]
    {
        for (int i = 0; i < 40; ++i)
        {
            Hear(Sign(5U));
        }
    };
    signs();
    EXPECT_FALSE(IsSuspected());
    slaves[5].heartbeat.producer_ms = 100U;
    Hear(Eight(0x585U, {0x80U, 0x17U, 0x10U, 0U})); // 1017h was refused.
    signs();
    EXPECT_FALSE(IsSuspected());
    // The answer to another object, or to a reading, or a shorter frame, changes nothing
    Hear(Eight(0x585U, {0x60U, 0x17U, 0x20U, 0U}));
    Hear(Eight(0x585U, {0x60U, 0x16U, 0x10U, 0U}));
    Hear(Eight(0x585U, {0x4BU, 0x17U, 0x10U, 0U}));
    CanFrame shorter = Eight(0x585U, {0x60U, 0x17U, 0x10U, 0U});
    shorter.length_bytes = 7U;
    Hear(shorter);
    signs();
    EXPECT_FALSE(IsSuspected());
    // One that was taken is the time by which it is measured
    Hear(Eight(0x585U, {0x60U, 0x17U, 0x10U, 0U}));
    signs();
    EXPECT_TRUE(IsSuspected());
}

TEST_F(NodeWatchTest, NobodyElseHasTheNodeIdOfTheManager)
{
    Verifies(req::SRS_MGR_224);
    Hear(Sign(5U, 126U));
    EXPECT_TRUE(duplicates.empty());
    Hear(Sign(5U, 127U));
    EXPECT_EQ(duplicates, (std::vector<std::uint8_t>{127U}));
    // What has no node, or is no sign, is nobody's
    Hear(CanFrame{0x700U, FrameKind::kData, CanPortId::kFirst, 1U, {5U}});
    Hear(CanFrame{0x705U, FrameKind::kData, CanPortId::kFirst, 2U, {5U}});
    Hear(CanFrame{0x305U, FrameKind::kData, CanPortId::kFirst, 1U, {5U}});
    Hear(CanFrame{0x600U, FrameKind::kData, CanPortId::kFirst, 8U, {0x40U}});
    EXPECT_EQ(duplicates.size(), 1U);
}

TEST_F(NodeWatchTest, ThreeQuestionsInARowThatAreAnsweredTwiceAreAnsweredByTwo)
{
    Verifies(req::SRS_MGR_015);
    Ask(1U, 2);
    Ask(2U, 2);
    Ask(3U, 1); // One answer alone begins the count anew.
    Ask(4U, 2);
    Ask(5U, 2);
    EXPECT_FALSE(IsSuspected());
    Ask(6U, 3);
    EXPECT_TRUE(IsSuspected());
    EXPECT_EQ(duplicates, (std::vector<std::uint8_t>{5U}));
    // The count ends at three, and begins anew behind a reset of one that is suspected
    Ask(7U, 2);
    watch.OnReset(NodeId{5U});
    Ask(8U, 2);
    Ask(9U, 2);
    EXPECT_FALSE(IsSuspected());
}

TEST_F(NodeWatchTest, AQuestionThatIsAskedAgainMayBeAnsweredAgain)
{
    Verifies(req::SRS_MGR_223);
    for (std::uint8_t number = 1U; number < 10U; ++number)
    {
        Ask(number, 0);
        Ask(number, 2); // Asked twice without an answer: two are due.
    }
    EXPECT_FALSE(IsSuspected());
    // However often it was
    for (int i = 0; i < 300; ++i)
    {
        Ask(20U, 0);
    }
    Ask(20U, 255);
    EXPECT_FALSE(IsSuspected());
}

TEST_F(NodeWatchTest, WhatBelongsToNoQuestionCountsForNothing)
{
    Verifies(req::SRS_MGR_223);
    for (int i = 0; i < 10; ++i)
    {
        Hear(Eight(0x585U, {0x43U, 1U, 0x20U, 0U})); // Nobody has asked.
        Ask(2U, 1);
        Hear(Eight(0x585U, {0x43U, 1U, 0x20U, 0U})); // Another object,
        Hear(Eight(0x585U, {0x43U, 2U, 0x21U, 0U}));
        Hear(Eight(0x585U, {0x43U, 2U, 0x20U, 1U}));
        Hear(Eight(0x585U, {0x00U, 2U, 0x20U, 0U})); // a segment,
        Hear(Eight(0x585U, {0xA0U, 2U, 0x20U, 0U})); // a block,
        CanFrame shorter = Eight(0x585U, {0x43U, 2U, 0x20U, 0U});
        shorter.length_bytes = 7U; // and what is no SDO.
        Hear(shorter);
        watch.OnSent(Eight(0x605U, {0x60U, 2U, 0x20U, 0U})); // A further segment is asked for.
        CanFrame question = Eight(0x605U, {0x40U, 2U, 0x20U, 0U});
        question.length_bytes = 4U;
        watch.OnSent(question);
        watch.OnSent(CanFrame{0x605U, FrameKind::kRemote, CanPortId::kFirst, 8U, {}});
    }
    EXPECT_FALSE(IsSuspected());
    // Segments of a block look like anything
    for (const std::uint8_t command : {std::uint8_t{0xA0U}, std::uint8_t{0xC2U}})
    {
        for (std::uint8_t number = 1U; number < 10U; ++number)
        {
            Ask(number, 1);
            watch.OnSent(Eight(0x605U, {command, number, 0x20U, 0U}));
            Hear(Eight(0x585U, {0x43U, number, 0x20U, 0U}));
        }
    }
    EXPECT_FALSE(IsSuspected());
}

TEST_F(NodeWatchTest, AnAbortBehindAnAnswerIsASecondOneWhereTheTransferHadEnded)
{
    Verifies(req::SRS_MGR_223);
    const auto abort = [this](const std::uint8_t number) { Hear(Eight(0x585U, {0x80U, number, 0x20U, 0U})); };
    // Given readings in segments, and writings in segments, that are aborted behind their first answer
    for (std::uint8_t number = 1U; number < 6U; ++number)
    {
        Ask(number, 1, 0x41U);
        abort(number);
        Ask(number, 1, 0x60U, 0x21U);
        abort(number);
    }
    EXPECT_FALSE(IsSuspected());
    // Given values that were complete, or were refused
    Ask(10U, 1);
    abort(10U);
    Ask(11U, 1, 0x60U, 0x23U);
    abort(11U);
    Ask(12U, 1, 0x80U);
    EXPECT_FALSE(IsSuspected());
    abort(12U);
    EXPECT_TRUE(IsSuspected());
}

TEST_F(NodeWatchTest, ASecondBootUpMessageBehindAResetIsOfASecondDevice)
{
    Verifies(req::SRS_MGR_015);
    const auto reset = [this](const int boot_ups, const std::uint8_t node = 5U, const std::uint8_t command = 0x82U)
    {
        watch.OnSent(Command(command, node));
        for (int i = 0; i < boot_ups; ++i)
        {
            Hear(Sign(0U));
        }
    };
    reset(2);
    reset(2, 0U, 0x81U);
    EXPECT_FALSE(IsSuspected());
    reset(2);
    EXPECT_TRUE(IsSuspected());
    watch.OnReset(NodeId{5U});
    // Given resets of others, other commands and frames of another length, then a boot-up message is one of its own
    for (int i = 0; i < 5; ++i)
    {
        reset(1);
        watch.OnSent(Command(0x82U, 6U));
        watch.OnSent(Command(0x01U, 5U));
        CanFrame longer = Command(0x82U, 5U);
        longer.length_bytes = 3U;
        watch.OnSent(longer);
        CanFrame remote = Command(0x82U, 5U);
        remote.kind = FrameKind::kRemote;
        watch.OnSent(remote);
    }
    EXPECT_FALSE(IsSuspected());
    // One that is reset several times before it boots has several messages due, up to 255
    for (int i = 0; i < 300; ++i)
    {
        reset(0);
    }
    for (int i = 0; i < 255; ++i)
    {
        Hear(Sign(0U));
    }
    EXPECT_FALSE(IsSuspected());
}

TEST_F(NodeWatchTest, ThreeRemoteFramesInARowThatAreAnsweredTwiceAreAnsweredByTwo)
{
    Verifies(req::SRS_MGR_015);
    const auto guard = [this](const int answers)
    {
        watch.OnSent(Remote());
        for (int i = 0; i < answers; ++i)
        {
            Hear(Sign(((i % 2) == 0) ? 0x85U : 0x05U));
        }
    };
    guard(2);
    guard(2);
    guard(1);
    guard(2);
    guard(2);
    EXPECT_FALSE(IsSuspected());
    guard(3);
    EXPECT_TRUE(IsSuspected());
    // One that never sets the toggle bit sends heartbeats beside
    watch.OnReset(NodeId{5U});
    for (int i = 0; i < 10; ++i)
    {
        watch.OnSent(Remote());
        Hear(Sign(0x05U));
        Hear(Sign(0x05U));
    }
    EXPECT_FALSE(IsSuspected());
}

} // namespace
} // namespace counterpoint::cia302
