// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Windows and times of PDOs to the microsecond.
#include "canopen/start_up/el6751/pdos.hpp"
#include "tests/canopen/cia301/keeping_sink.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace counterpoint::cia302
{
namespace
{

constexpr NodeId kNode{5U};
constexpr std::uint32_t kStartUs = 0xFFFF'F000U; // 4 ms before the counter wraps.

/// One slave, SYNC every 10 ms from 0 on, its TxPDO 185h with 4 bytes.
class El6751PdosTest : public ::testing::Test
{
  public:
    void Tx(const std::uint8_t type, const std::uint16_t event_ms)
    {
        tx[0] = El6751Pdo{1U, 0x185U, type, 4U, 0U, event_ms, nullptr};
        slave.tx_pdos = tx.data();
        slave.tx_count = 1U;
    }
    void Rx(const std::uint8_t type, const std::uint16_t inhibit_100us, const std::uint16_t event_ms)
    {
        rx[0] = El6751Pdo{1U, 0x205U, type, 2U, inhibit_100us, event_ms, data.data()};
        slave.rx_pdos = rx.data();
        slave.rx_count = 1U;
    }
    El6751Pdos& Make(const El6751Times& times)
    {
        setups[5].assignment = kInNetwork;
        setups[5].el6751 = &slave;
        pdos.emplace_back(El6751PdoParts{setup, sink, El6751PdoRoom{records.data(), 2U}, times});
        EXPECT_TRUE(pdos.back().Begin());
        pdos.back().Await(kNode);
        return pdos.back();
    }
    static Instant At(const std::uint32_t us)
    {
        return Instant{kStartUs + us};
    }
    static CanFrame Frame(const std::uint32_t identifier, const std::uint8_t length)
    {
        return CanFrame{identifier, FrameKind::kData, CanPortId::kFirst, length, {}};
    }
    /// The TxPDO at this time; the fault afterwards.
    int Receive(El6751Pdos& some, const std::uint32_t us)
    {
        some.OnFrame(Frame(0x185U, 4U), At(us));
        return some.Fault(kNode);
    }
    int Cycle(El6751Pdos& some, const std::uint32_t us)
    {
        some.OnCycle(At(us));
        return some.Fault(kNode);
    }
    /// SYNC of cycle n at n x 10 ms with the TxPDO 0.2 ms behind it, or without; the fault at the end of the cycle.
    int SyncCycle(El6751Pdos& some, const std::uint32_t n, const bool is_received)
    {
        static_cast<void>(Cycle(some, 10000U * n));
        if (is_received)
        {
            static_cast<void>(Receive(some, (10000U * n) + 200U));
        }
        return Cycle(some, (10000U * n) + 9000U);
    }
    /// Sent frames as identifiers.
    std::vector<std::uint32_t> Sent()
    {
        std::vector<std::uint32_t> list{};
        for (const CanFrame& frame : sink.frames)
        {
            list.push_back(frame.identifier);
        }
        sink.frames.clear();
        return list;
    }

    std::array<std::uint8_t, 2> data{{0x11U, 0x22U}};
    std::array<El6751Pdo, 1> tx{};
    std::array<El6751Pdo, 1> rx{};
    El6751Slave slave{};
    std::array<SlaveSetup, kNodeRoom> setups{};
    NetworkSetup setup{NodeId{127U}, kIsMaster, 0U, 0U, 10000U, setups.data()};
    std::array<El6751PdoRecord, 2> records{};
    cia301::KeepingSink sink{};
    std::vector<El6751Pdos> pdos{};
};

TEST_F(El6751PdosTest, TheWindowIsTheInputShiftTimeTheEndIncluded)
{
    Verifies(req::SRS_ELM_033);
    Verifies(req::SRS_ELM_034);
    Tx(1U, 0U);
    Rx(1U, 0U, 0U);
    El6751Pdos& some = Make(El6751Times{});
    some.Feed(kNode);
    EXPECT_EQ(Cycle(some, 0U), 0);
    EXPECT_EQ(Receive(some, 500U), 0);
    EXPECT_EQ(Cycle(some, 10000U), 0);
    some.OnSent(Frame(0x205U, 2U)); // The last RxPDO ends the other window alone.
    EXPECT_EQ(some.Fault(kNode), 0);
    EXPECT_EQ(Receive(some, 10500U), 0);
    EXPECT_EQ(Cycle(some, 20000U), 0);
    EXPECT_EQ(Cycle(some, 20500U), 0);
    // When it comes 1 us late, it was missing, though it came
    some.OnFrame(Frame(0x185U, 3U), At(20501U)); // (too short: it does not hide the fault)
    EXPECT_EQ(some.Fault(kNode), 40);
    some.Await(kNode);
    EXPECT_EQ(Cycle(some, 30000U), 0);
    EXPECT_EQ(Receive(some, 30100U), 0);
    EXPECT_EQ(Cycle(some, 40000U), 0);
    EXPECT_EQ(Cycle(some, 40501U), 40);
}

TEST_F(El6751PdosTest, WhatFoundNoRoomIsSentAgainBetweenTwoCycles)
{
    Verifies(req::SRS_ELM_230);
    Tx(1U, 0U);
    Rx(1U, 0U, 0U);
    El6751Pdos& some = Make(El6751Times{});
    some.Feed(kNode);
    static_cast<void>(Cycle(some, 0U));
    EXPECT_EQ(Sent(), (std::vector<std::uint32_t>{0x080U, 0x205U}));
    // What has left does not leave again
    some.SendAgain(At(10000U));
    EXPECT_EQ(Sent(), (std::vector<std::uint32_t>{}));
    // When SYNC finds no room, and then its RxPDO
    sink.room = 0;
    static_cast<void>(Cycle(some, 10000U));
    some.SendAgain(At(10100U));
    EXPECT_EQ(Sent(), (std::vector<std::uint32_t>{}));
    sink.room = 1;
    some.SendAgain(At(10200U));
    EXPECT_EQ(Sent(), (std::vector<std::uint32_t>{0x080U}));
    sink.room = 1;
    some.SendAgain(At(10300U));
    EXPECT_EQ(Sent(), (std::vector<std::uint32_t>{0x205U}));
    sink.room = 10;
    some.SendAgain(At(10400U));
    EXPECT_EQ(Sent(), (std::vector<std::uint32_t>{}));
    // The window began with the SYNC that left; the next one keeps its phase
    EXPECT_EQ(Receive(some, 10700U), 0);
    static_cast<void>(Cycle(some, 20000U));
    EXPECT_EQ(Sent(), (std::vector<std::uint32_t>{0x080U, 0x205U}));
    // When all ends, nothing waits any more
    sink.room = 0;
    static_cast<void>(Cycle(some, 30000U));
    some.End();
    sink.room = 10;
    some.SendAgain(At(30100U));
    EXPECT_EQ(Sent(), (std::vector<std::uint32_t>{}));
}

TEST_F(El6751PdosTest, WhatFoundNoRoomBesideSyncIsSentBehindIt)
{
    Verifies(req::SRS_ELM_230);
    // Given an RxPDO that does not follow SYNC, and that is due as SYNC is
    Tx(1U, 0U);
    Rx(255U, 0U, 0U);
    El6751Pdos& some = Make(El6751Times{});
    some.Feed(kNode);
    sink.room = 0;
    static_cast<void>(Cycle(some, 0U));
    sink.room = 2;
    some.SendAgain(At(100U));
    EXPECT_EQ(Sent(), (std::vector<std::uint32_t>{0x080U, 0x205U}));
}

TEST_F(El6751PdosTest, WhatComesBehindTheWindowDoesNotCountForTheNextCycle)
{
    Verifies(req::SRS_ELM_033);
    Tx(1U, 0U);
    El6751Pdos& some = Make(El6751Times{});
    EXPECT_EQ(SyncCycle(some, 0U, true), 0);
    EXPECT_EQ(Receive(some, 9500U), 0);
    EXPECT_EQ(SyncCycle(some, 1U, false), 40);
}

TEST_F(El6751PdosTest, OneThatAlwaysComesTooLateStaysMissingUntilItComesInTime)
{
    Verifies(req::SRS_ELM_033);
    Tx(1U, 0U);
    El6751Pdos& some = Make(El6751Times{});
    EXPECT_EQ(SyncCycle(some, 0U, true), 0);
    EXPECT_EQ(SyncCycle(some, 1U, false), 40);
    EXPECT_EQ(Receive(some, 19500U), 40);
    EXPECT_EQ(SyncCycle(some, 2U, true), 0);
}

TEST_F(El6751PdosTest, WithASyncMultiplierTheShiftCountsInTheLastPart)
{
    Verifies(req::SRS_ELM_033);
    Tx(1U, 0U);
    El6751Times times{};
    times.sync_multiplier = 4U; // 7.5 ms + 0.5 ms
    El6751Pdos& some = Make(times);
    EXPECT_EQ(Cycle(some, 0U), 0);
    EXPECT_EQ(Receive(some, 8000U), 0);
    EXPECT_EQ(Cycle(some, 10000U), 0);
    EXPECT_EQ(Receive(some, 18000U), 0);
    EXPECT_EQ(Cycle(some, 20000U), 0);
    EXPECT_EQ(Cycle(some, 28000U), 0);
    EXPECT_EQ(Cycle(some, 28001U), 40);
}

TEST_F(El6751PdosTest, SupervisionBeginsWithTheFirstReception)
{
    Verifies(req::SRS_ELM_033);
    Tx(1U, 0U);
    El6751Pdos& some = Make(El6751Times{});
    for (std::uint32_t n = 0U; n < 20U; ++n)
    {
        EXPECT_EQ(SyncCycle(some, n, false), 0);
    }
    EXPECT_FALSE(some.HasAll(kNode));
    EXPECT_EQ(SyncCycle(some, 20U, true), 0);
    EXPECT_TRUE(some.HasAll(kNode));
    EXPECT_EQ(SyncCycle(some, 21U, false), 40);
}

TEST_F(El6751PdosTest, TheLastSynchronousRxPdoOnTheBusEndsTheWindow)
{
    Verifies(req::SRS_ELM_033);
    Tx(1U, 0U);
    Rx(1U, 0U, 0U);
    El6751Times times{};
    times.window = El6751Window::kLastRxPdo;
    El6751Pdos& some = Make(times);
    some.Feed(kNode);
    EXPECT_EQ(Cycle(some, 0U), 0);
    EXPECT_EQ(Sent(), (std::vector<std::uint32_t>{0x80U, 0x205U}));
    EXPECT_EQ(Receive(some, 700U), 0);
    some.OnSent(Frame(0x205U, 2U));
    EXPECT_EQ(some.Fault(kNode), 0);
    // In the next cycle it does not come before
    EXPECT_EQ(Cycle(some, 10000U), 0);
    some.OnSent(Frame(0x80U, 0U));
    EXPECT_EQ(some.Fault(kNode), 0);
    some.OnSent(Frame(0x205U, 2U));
    EXPECT_EQ(some.Fault(kNode), 40);
}

TEST_F(El6751PdosTest, WithoutASynchronousRxPdoTheNextSyncEndsTheWindow)
{
    Verifies(req::SRS_ELM_033);
    Tx(1U, 0U);
    El6751Times times{};
    times.window = El6751Window::kLastRxPdo;
    El6751Pdos& some = Make(times);
    EXPECT_EQ(Cycle(some, 0U), 0);
    EXPECT_EQ(Receive(some, 9999U), 0);
    EXPECT_EQ(Cycle(some, 10000U), 0);
    EXPECT_EQ(Cycle(some, 19999U), 0);
    EXPECT_EQ(Cycle(some, 20000U), 40);
}

TEST_F(El6751PdosTest, TypeOneWithAnEventTimeMayMissOneCycle)
{
    Verifies(req::SRS_ELM_035);
    Tx(1U, 100U);
    El6751Pdos& some = Make(El6751Times{});
    const std::string received = "X.X.XX..";
    const std::vector<int> faults{0, 0, 0, 0, 0, 0, 0, 22};
    for (std::uint32_t n = 0U; n < 8U; ++n)
    {
        EXPECT_EQ(SyncCycle(some, n, received[n] == 'X'), faults[n]) << n;
    }
    EXPECT_EQ(SyncCycle(some, 8U, true), 0);
}

TEST_F(El6751PdosTest, TypeTwoToTwoHundredFortyMayMissOneOfTheirOwnCycles)
{
    Verifies(req::SRS_ELM_036);
    Tx(3U, 0U);
    El6751Pdos& some = Make(El6751Times{});
    // Expected in cycles 0, 3, 6, 9, 12, 15; received in 0, 6, 9
    for (std::uint32_t n = 0U; n < 15U; ++n)
    {
        const bool is_received = (n == 0U) || (n == 6U) || (n == 9U);
        EXPECT_EQ(SyncCycle(some, n, is_received), 0) << n;
    }
    EXPECT_EQ(SyncCycle(some, 15U, false), 22);
    // 240: 480 cycles in all
    Tx(240U, 0U);
    some.Await(kNode);
    EXPECT_EQ(SyncCycle(some, 16U, true), 0);
    for (std::uint32_t n = 17U; n < 496U; ++n)
    {
        EXPECT_EQ(SyncCycle(some, n, false), 0) << n;
    }
    EXPECT_EQ(SyncCycle(some, 496U, false), 22);
}

TEST_F(El6751PdosTest, AsynchronousOnesAreMissingAfterTwiceTheEventTime)
{
    Verifies(req::SRS_ELM_037);
    for (const std::uint8_t type : {std::uint8_t{254U}, std::uint8_t{255U}})
    {
        Tx(type, 50U);
        El6751Pdos& some = Make(El6751Times{});
        EXPECT_EQ(Cycle(some, 300000U), 0); // never received: not supervised
        EXPECT_EQ(Receive(some, 300000U), 0);
        EXPECT_EQ(Cycle(some, 400000U), 0);
        EXPECT_EQ(Receive(some, 400000U), 0);
        EXPECT_EQ(Cycle(some, 500000U), 0);
        EXPECT_EQ(Cycle(some, 500001U), 22);
        EXPECT_EQ(Receive(some, 500002U), 0);
    }
}

TEST_F(El6751PdosTest, WithoutEventTimeOrWithAnotherTypeThereIsNoSuchTime)
{
    Verifies(req::SRS_ELM_037);
    const std::vector<std::vector<std::uint16_t>> cases{{255U, 0U}, {254U, 0U}, {253U, 50U}, {252U, 50U}, {0U, 50U}};
    for (const std::vector<std::uint16_t>& one : cases)
    {
        Tx(static_cast<std::uint8_t>(one[0]), one[1]);
        El6751Pdos& some = Make(El6751Times{});
        EXPECT_EQ(Receive(some, 100U), 0);
        for (std::uint32_t n = 1U; n < 1000U; ++n)
        {
            EXPECT_EQ(Cycle(some, 10000U * n), 0) << one[0];
        }
    }
}

TEST_F(El6751PdosTest, TooShortIsAnErrorAndLongerIsNone)
{
    Verifies(req::SRS_ELM_038);
    Tx(255U, 0U);
    El6751Pdos& some = Make(El6751Times{});
    some.OnFrame(Frame(0x185U, 3U), At(0U));
    EXPECT_EQ(some.Fault(kNode), 20);
    EXPECT_FALSE(some.HasAny(kNode));
    some.OnFrame(Frame(0x185U, 5U), At(1U));
    EXPECT_EQ(some.Fault(kNode), 0);
    EXPECT_TRUE(some.HasAll(kNode));
    // Remote frames and other identifiers are not it
    CanFrame remote = Frame(0x185U, 0U);
    remote.kind = FrameKind::kRemote;
    some.OnFrame(remote, At(2U));
    some.OnFrame(Frame(0x186U, 1U), At(3U));
    EXPECT_EQ(some.Fault(kNode), 0);
}

TEST_F(El6751PdosTest, TooShortEachTimeStaysTooShortUntilARightOneOrNoneComes)
{
    Verifies(req::SRS_ELM_480);
    for (const bool was_right : {true, false})
    {
        // Given a TxPDO with an event time of 100 ms that comes each 200 ms, at first right or never so
        Tx(255U, 100U);
        El6751Pdos& some = Make(El6751Times{});
        some.OnFrame(Frame(0x185U, was_right ? 4U : 3U), At(0U));
        // When it is too short from then on
        for (std::uint32_t ms = 1U; ms <= 2000U; ++ms)
        {
            if ((ms % 200U) == 0U)
            {
                some.OnFrame(Frame(0x185U, 3U), At(1000U * ms));
            }
            const bool is_right = was_right && (ms < 200U);
            EXPECT_EQ(Cycle(some, 1000U * ms), is_right ? 0 : 20) << ms;
        }
        // Then it is missing once none came for longer than 200 ms, and too short when the next one is
        EXPECT_EQ(Cycle(some, 2200000U), 20);
        EXPECT_EQ(Cycle(some, 2200001U), 22);
        some.OnFrame(Frame(0x185U, 3U), At(2300000U));
        EXPECT_EQ(some.Fault(kNode), 20);
        EXPECT_EQ(some.HasAll(kNode), was_right);
        EXPECT_EQ(Receive(some, 2400000U), 0);
        EXPECT_TRUE(some.HasAll(kNode));
    }
}

TEST_F(El6751PdosTest, TooShortInEachSyncCycleIsThereUnlessItComesBehindTheWindow)
{
    Verifies(req::SRS_ELM_480);
    Tx(1U, 0U);
    El6751Pdos& some = Make(El6751Times{});
    EXPECT_EQ(SyncCycle(some, 0U, true), 0);
    // When it comes too short within the window of each cycle, then that is what it is
    for (std::uint32_t n = 1U; n <= 5U; ++n)
    {
        EXPECT_EQ(Cycle(some, 10000U * n), (n == 1U) ? 0 : 20);
        some.OnFrame(Frame(0x185U, 3U), At((10000U * n) + 500U));
        EXPECT_EQ(Cycle(some, (10000U * n) + 9000U), 20);
    }
    // When it comes behind it, it is missing in its cycle
    EXPECT_EQ(Cycle(some, 60000U), 20);
    EXPECT_EQ(Cycle(some, 60501U), 40);
    for (std::uint32_t n = 6U; n <= 9U; ++n)
    {
        some.OnFrame(Frame(0x185U, 3U), At((10000U * n) + 600U));
        EXPECT_EQ(some.Fault(kNode), 40);
        EXPECT_EQ(Cycle(some, (10000U * n) + 10000U), 40);
        EXPECT_EQ(Cycle(some, (10000U * n) + 10501U), 40);
    }
    // And in time again: too short, then right
    EXPECT_EQ(Cycle(some, 110000U), 40);
    some.OnFrame(Frame(0x185U, 3U), At(110200U));
    EXPECT_EQ(Cycle(some, 119000U), 20);
    EXPECT_EQ(SyncCycle(some, 12U, true), 0);
}

TEST_F(El6751PdosTest, RxPdosOfTypeNFollowEveryNthSync)
{
    Verifies(req::SRS_ELM_031);
    Rx(3U, 0U, 0U);
    El6751Pdos& some = Make(El6751Times{});
    some.Feed(kNode);
    std::string course{};
    for (std::uint32_t n = 0U; n < 10U; ++n)
    {
        static_cast<void>(Cycle(some, 10000U * n));
        course += (Sent().size() == 2U) ? 'X' : '.';
    }
    EXPECT_EQ(course, "X.X..X..X."); // at once, then with the third SYNC, the sixth, the ninth
}

// At once, then with the 240th SYNC and the 480th; the first one is number 0 here.
TEST_F(El6751PdosTest, TheHighestTypeThatCountsSyncsIs240)
{
    Verifies(req::SRS_ELM_031);
    for (const std::uint8_t type : {std::uint8_t{240U}, std::uint8_t{241U}})
    {
        Rx(type, 0U, 0U);
        El6751Pdos& some = Make(El6751Times{});
        some.Feed(kNode);
        std::vector<std::uint32_t> with_pdo{};
        for (std::uint32_t n = 0U; n <= 480U; ++n)
        {
            // A change that those of 1 to 240 do not mind
            data[0] = static_cast<std::uint8_t>(data[0] + ((n == 7U) ? 1U : 0U));
            static_cast<void>(Cycle(some, 10000U * n));
            const std::vector<std::uint32_t> frames = Sent();
            if (std::count(frames.begin(), frames.end(), 0x205U) == 1)
            {
                with_pdo.push_back(n);
            }
        }
        EXPECT_EQ(with_pdo,
                  (type == 240U) ? (std::vector<std::uint32_t>{0U, 239U, 479U}) : (std::vector<std::uint32_t>{0U, 7U}));
    }
}

TEST_F(El6751PdosTest, RxPdosOfTypeZeroFollowASyncAfterAChange)
{
    Verifies(req::SRS_ELM_031);
    Rx(0U, 0U, 0U);
    El6751Pdos& some = Make(El6751Times{});
    static_cast<void>(Cycle(some, 0U));
    some.Feed(kNode);
    static_cast<void>(Cycle(some, 1000U));
    EXPECT_EQ(Sent(), (std::vector<std::uint32_t>{0x80U, 0x205U}));
    static_cast<void>(Cycle(some, 10000U));
    data[1] = 0x23U;
    static_cast<void>(Cycle(some, 15000U));
    EXPECT_EQ(Sent(), (std::vector<std::uint32_t>{0x80U}));
    static_cast<void>(Cycle(some, 20000U));
    EXPECT_EQ(Sent(), (std::vector<std::uint32_t>{0x80U, 0x205U}));
    static_cast<void>(Cycle(some, 30000U));
    EXPECT_EQ(Sent(), (std::vector<std::uint32_t>{0x80U}));
}

TEST_F(El6751PdosTest, OtherRxPdosFollowChangesWithinInhibitAndEventTime)
{
    Verifies(req::SRS_ELM_031);
    Rx(255U, 30U, 10U); // 3 ms, 10 ms
    El6751Pdos& some = Make(El6751Times{});
    some.Feed(kNode);
    std::vector<std::uint32_t> times{};
    for (std::uint32_t ms = 0U; ms < 40U; ++ms)
    {
        data[0] = static_cast<std::uint8_t>(data[0] + ((ms == 1U) || (ms == 7U) ? 1U : 0U));
        static_cast<void>(Cycle(some, 1000U * ms));
        if (!Sent().empty())
        {
            times.push_back(ms);
        }
    }
    EXPECT_EQ(times, (std::vector<std::uint32_t>{0U, 3U, 7U, 17U, 27U, 37U}));
}

TEST_F(El6751PdosTest, ASinkWithoutRoomDelaysSyncAndRxPdos)
{
    Verifies(req::SRS_ELM_031);
    Verifies(req::SRS_ELM_032);
    Tx(1U, 0U);
    Rx(1U, 0U, 0U);
    El6751Pdos& some = Make(El6751Times{});
    some.Feed(kNode);
    sink.room = 1;
    static_cast<void>(Cycle(some, 0U));
    EXPECT_EQ(Sent(), (std::vector<std::uint32_t>{0x80U}));
    sink.room = 1;
    static_cast<void>(Cycle(some, 100U));
    EXPECT_EQ(Sent(), (std::vector<std::uint32_t>{0x205U}));
    sink.room = 0;
    static_cast<void>(Cycle(some, 10000U));
    sink.room = 2;
    static_cast<void>(Cycle(some, 10100U));
    EXPECT_EQ(Sent(), (std::vector<std::uint32_t>{0x80U, 0x205U}));
    sink.room = 2;
    static_cast<void>(Cycle(some, 20000U));
    EXPECT_EQ(Sent(), (std::vector<std::uint32_t>{0x80U, 0x205U}));
}

TEST_F(El6751PdosTest, ASlaveAtRestIsNeitherFedNorSupervised)
{
    Verifies(req::SRS_ELM_031);
    Tx(1U, 0U);
    Rx(1U, 0U, 0U);
    El6751Pdos& some = Make(El6751Times{});
    some.Feed(kNode);
    EXPECT_EQ(SyncCycle(some, 0U, true), 0);
    some.Rest(kNode);
    static_cast<void>(Sent());
    for (std::uint32_t n = 1U; n < 5U; ++n)
    {
        EXPECT_EQ(SyncCycle(some, n, false), 0);
    }
    EXPECT_EQ(Sent(), (std::vector<std::uint32_t>(4U, 0x80U)));
}

} // namespace
} // namespace counterpoint::cia302
