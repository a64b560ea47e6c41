// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/told_causes.hpp"
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"

#include <cstdint>

namespace counterpoint
{
namespace
{

ToldWindow At(const std::uint32_t now_us)
{
    return ToldWindow{Instant{now_us}, 50000U};
}

struct Room
{
    Room()
    {
        causes.Restart(&windows[0], 64U);
    }

    CauseWindows windows[64]{};
    ToldCauses causes{};
};

TEST(ToldCauses, WithoutRoomEverythingIsTold)
{
    Verifies(req::SRS_KRN_347);
    ToldCauses without_room{};
    without_room.Restart(nullptr, 64U);
    EXPECT_TRUE(without_room.Take(5U, SrdoCause::kLength, At(1000U)));
    EXPECT_TRUE(without_room.Take(5U, SrdoCause::kLength, At(1000U)));
    EXPECT_EQ(without_room.Slots(), 0U);
}

// t [us]   1000 (told)   51000 (window)   51001
TEST(ToldCauses, CauseIsToldAgainOneMicrosecondAfterItsWindow)
{
    Verifies(req::SRS_KRN_032);
    for (std::uint32_t number = 1U; number <= 18U; ++number)
    {
        const SrdoCause cause = static_cast<SrdoCause>(number);
        Room room{};
        ToldCauses& causes = room.causes;
        EXPECT_EQ(causes.Slots(), 0U);
        EXPECT_TRUE(causes.Take(63U, cause, At(1000U))) << number;
        EXPECT_EQ(causes.Slots(), 0x8000000000000000U);
        EXPECT_FALSE(causes.Take(63U, cause, At(1000U))) << number;
        EXPECT_FALSE(causes.Take(63U, cause, At(51000U))) << number;
        EXPECT_TRUE(causes.Take(63U, cause, At(51001U))) << number;
        EXPECT_FALSE(causes.Take(63U, cause, At(101001U))) << number;
    }
}

// Those of consumers, and those of producers: each has a window of its own, and each slot.
TEST(ToldCauses, CausesDoNotDisturbEachOther)
{
    Verifies(req::SRS_KRN_032);
    const auto together = [](const std::vector<std::uint32_t>& numbers)
    {
        Room room{};
        ToldCauses& causes = room.causes;
        std::uint32_t now_us = 1000U;
        for (std::uint32_t round = 0U; round < 2U; ++round)
        {
            for (const std::uint32_t number : numbers)
            {
                EXPECT_TRUE(causes.Take(5U, static_cast<SrdoCause>(number), At(now_us))) << number;
                EXPECT_TRUE(causes.Take(6U, static_cast<SrdoCause>(number), At(now_us))) << number;
                now_us += 100U;
            }
            for (const std::uint32_t number : numbers)
            {
                EXPECT_FALSE(causes.Take(5U, static_cast<SrdoCause>(number), At(now_us))) << number;
            }
            // Exactly one window and one microsecond behind the first of them
            now_us += 50001U - (100U * static_cast<std::uint32_t>(numbers.size()));
        }
    };
    together({1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 9U, 10U, 11U, 18U});
    together({18U, 11U, 10U, 9U, 8U, 7U, 6U, 5U, 4U, 3U, 2U, 1U});
    together({4U, 13U, 14U, 15U, 16U, 17U});
    together({17U, 16U, 15U, 14U, 13U, 4U});
}

// An SRDO that has become a producer tells what it never told, whatever it told as a consumer.
TEST(ToldCauses, CauseThatSharesItsPlaceIsTold)
{
    Verifies(req::SRS_KRN_032);
    for (std::uint32_t number = 7U; number <= 12U; ++number)
    {
        const SrdoCause first = static_cast<SrdoCause>(number);
        const SrdoCause second = static_cast<SrdoCause>(number + 6U);
        Room room{};
        ToldCauses& causes = room.causes;
        EXPECT_TRUE(causes.Take(5U, first, At(1000U)));
        EXPECT_TRUE(causes.Take(5U, second, At(2000U)));
        EXPECT_FALSE(causes.Take(5U, second, At(2000U)));
        EXPECT_TRUE(causes.Take(5U, first, At(3000U)));
        EXPECT_FALSE(causes.Take(5U, first, At(3000U)));
        EXPECT_TRUE(causes.Take(5U, second, At(4000U)));
    }
}

TEST(ToldCauses, WindowThatIsOverIsClosedBySweeping)
{
    Verifies(req::SRS_KRN_032);
    Verifies(req::SRS_KRN_346);
    Room room{};
    ToldCauses& causes = room.causes;
    EXPECT_TRUE(causes.Take(5U, SrdoCause::kLength, At(1000U)));
    EXPECT_TRUE(causes.Take(5U, SrdoCause::kWrongEcho, At(2000U)));
    causes.Sweep(5U, At(51000U));
    EXPECT_EQ(causes.Slots(), 0x20U);
    EXPECT_FALSE(causes.Take(5U, SrdoCause::kLength, At(51000U)));
    causes.Sweep(5U, At(52000U));
    EXPECT_EQ(causes.Slots(), 0x20U);
    EXPECT_FALSE(causes.Take(5U, SrdoCause::kWrongEcho, At(52000U)));
    causes.Sweep(5U, At(52001U));
    EXPECT_EQ(causes.Slots(), 0U);
    // The counter has come round: the instants look new, and are not
    EXPECT_TRUE(causes.Take(5U, SrdoCause::kLength, At(1000U)));
    EXPECT_TRUE(causes.Take(5U, SrdoCause::kWrongEcho, At(2000U)));
    causes.Restart(&room.windows[0], 64U);
    EXPECT_EQ(causes.Slots(), 0U);
    EXPECT_TRUE(causes.Take(5U, SrdoCause::kLength, At(1000U)));
}

TEST(ToldCauses, WindowOfEachCauseIsClosedBySweeping)
{
    Verifies(req::SRS_KRN_032);
    for (std::uint32_t number = 1U; number <= 18U; ++number)
    {
        Room room{};
        EXPECT_TRUE(room.causes.Take(5U, static_cast<SrdoCause>(number), At(1000U)));
        room.causes.Sweep(5U, At(51001U));
        EXPECT_EQ(room.causes.Slots(), 0U) << number;
    }
}

TEST(ToldCauses, EverySlotHasItsTurn)
{
    Verifies(req::SRS_KRN_032);
    Room room{};
    ToldCauses& causes = room.causes;
    for (std::uint32_t turn = 1U; turn <= 129U; ++turn)
    {
        EXPECT_EQ(causes.NextSlot(), turn % 64U);
    }
    causes.Restart(&room.windows[0], 64U);
    EXPECT_EQ(causes.NextSlot(), 1U);
}

/// SRDO 1 is a consumer with an SCT of 50 ms, SRDO 3 a producer with a refresh time of 25 ms.
class Telling : public Rig
{
  protected:
    explicit Telling(const bool has_windows = true) : Rig(nullptr, nullptr, nullptr, has_windows)
    {
    }
    /// One channel signals these causes of a slot in this cycle.
    void CycleWith(Tap& tap, const SlotIndex slot, const std::uint32_t signals)
    {
        tap.on_outcome = [slot](CycleOutcome& outcome) { outcome.signalled = SrdoMask{1U} << slot; };
        tap.more_signals = signals;
        tap.signals_slot = slot;
        Cycle();
        tap.on_outcome = nullptr;
        tap.more_signals = 0U;
    }
};

constexpr std::uint32_t kLengthBit = 2U;
constexpr std::uint32_t kSrvtBit = 0x20U;

// t [ms]   0 Length   30 SRVT   50 Length (not told)   51 Length   80 SRVT (not told)   81 SRVT
TEST_F(Telling, EachCauseHasTheWindowOfItsOwnLastTelling)
{
    Verifies(req::SRS_KRN_032);
    Verifies(req::SRS_KRN_226);
    Verifies(req::SRS_KRN_345);
    using Causes = std::vector<SrdoCause>;
    Operate();
    // The wait for a first pair has been told
    Cycles(52U);
    application.errors.clear();
    CycleWith(a, 0U, kLengthBit);
    EXPECT_EQ(CausesOf(0x1301U), Causes{SrdoCause::kLength});
    ASSERT_EQ(kernel.SetStatus(CommunicationIndex{0x1301U}, StatusByte{0xB0U}), Result::kSuccessful);
    // The other channel says it a cycle later: that is no news
    CycleWith(b, 0U, kLengthBit);
    Cycles(28U);
    CycleWith(b, 0U, kSrvtBit);
    EXPECT_EQ(kernel.GetStatus(CommunicationIndex{0x1301U}).status.value, 0x50U);
    ASSERT_EQ(kernel.SetStatus(CommunicationIndex{0x1301U}, StatusByte{0xB0U}), Result::kSuccessful);
    Cycles(19U);
    application.flow.clear();
    CycleWith(a, 0U, kLengthBit);
    EXPECT_EQ(CausesOf(0x1301U), (Causes{SrdoCause::kLength, SrdoCause::kSrvt}));
    EXPECT_EQ(kernel.GetStatus(CommunicationIndex{0x1301U}).status.value, 0xB0U);
    EXPECT_NE(application.flow.back().first, FlowEvent::kSrdoError);
    CycleWith(a, 0U, kLengthBit);
    EXPECT_EQ(CausesOf(0x1301U), (Causes{SrdoCause::kLength, SrdoCause::kSrvt, SrdoCause::kLength}));
    EXPECT_EQ(application.flow.back(), std::make_pair(FlowEvent::kSrdoError, std::uint16_t{1U}));
    Cycles(28U);
    CycleWith(a, 0U, kSrvtBit);
    EXPECT_EQ(CausesOf(0x1301U).size(), 3U);
    CycleWith(a, 0U, kSrvtBit);
    EXPECT_EQ(CausesOf(0x1301U).size(), 4U);
}

/// A kernel that is given no windows.
class TellingWithoutRoom : public Telling
{
  protected:
    TellingWithoutRoom() : Telling(false)
    {
    }
};

// Where there is room, each is told once within its window.
TEST_F(TellingWithoutRoom, EachCauseIsToldWheneverAChannelSignalsIt)
{
    Verifies(req::SRS_KRN_347);
    Operate();
    Cycles(52U);
    application.errors.clear();
    for (std::size_t cycle = 1U; cycle <= 5U; ++cycle)
    {
        CycleWith(((cycle % 2U) == 0U) ? b : a, 0U, kLengthBit);
        EXPECT_EQ(CausesOf(0x1301U), std::vector<SrdoCause>(cycle, SrdoCause::kLength));
        ASSERT_EQ(kernel.SetStatus(CommunicationIndex{0x1301U}, StatusByte{0xB0U}), Result::kSuccessful);
    }
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

TEST_F(Telling, ProducersWindowIsItsRefreshTime)
{
    Verifies(req::SRS_KRN_032);
    constexpr std::uint32_t kBusOffBit = 0x4000U;
    Operate();
    application.refresh = RefreshAnswer::kSkip;
    CycleWith(a, 1U, kBusOffBit);
    Cycles(24U);
    CycleWith(a, 1U, kBusOffBit);
    const auto told = [this]
    {
        std::uint32_t count = 0U;
        for (const SrdoCause cause : CausesOf(0x1303U))
        {
            count += (cause == SrdoCause::kBusOff) ? 1U : 0U;
        }
        return count;
    };
    EXPECT_EQ(told(), 1U);
    CycleWith(a, 1U, kBusOffBit);
    EXPECT_EQ(told(), 2U);
}

// SRDO 1 by channel A alone, SRDO 3 by channel B alone.
TEST_F(Telling, EachSlotIsToldForItself)
{
    Verifies(req::SRS_KRN_032);
    Verifies(req::SRS_KRN_006);
    Verifies(req::SRS_KRN_226);
    Operate();
    application.refresh = RefreshAnswer::kSkip;
    CycleWith(a, 0U, kLengthBit);
    CycleWith(b, 1U, kLengthBit);
    EXPECT_EQ(CausesOf(0x1301U), std::vector<SrdoCause>{SrdoCause::kLength});
    EXPECT_EQ(CausesOf(0x1303U), std::vector<SrdoCause>{SrdoCause::kLength});
    EXPECT_EQ(kernel.GetStatus(CommunicationIndex{0x1303U}).status.value, 0x50U);
    // A round of all slots behind the window nothing of it is kept
    EXPECT_NE(windows[1].open, 0U);
    Cycles(25U + 64U + 1U);
    EXPECT_EQ(windows[1].open & kLengthBit, 0U);
}

// t [ms]   0 told   64 and 128 its turn to be swept   131 within its refresh time of 200 ms, beyond the SCT of SRDO 1
TEST_F(Telling, SweepingGoesByTheSlotsOwnWindow)
{
    Verifies(req::SRS_KRN_032);
    ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    ASSERT_EQ(Write(0x1303U, 2U, 200U, 2U), AbortCode::kNone);
    CycleWith(a, 1U, kLengthBit);
    Cycles(130U);
    CycleWith(a, 1U, kLengthBit);
    EXPECT_EQ(CausesOf(0x1303U), std::vector<SrdoCause>{SrdoCause::kLength});
}

TEST_F(Telling, EveryCauseThereIsAndNoOther)
{
    Verifies(req::SRS_KRN_006);
    Operate();
    CycleWith(a, 0U, 0xFFF80001U);
    EXPECT_TRUE(application.errors.empty());
    CycleWith(a, 0U, 0x00040000U);
    EXPECT_EQ(CausesOf(0x1301U), std::vector<SrdoCause>{SrdoCause::kWaitingPastSct});
}

// 71 minutes later, when the instant of the last telling looks new, and after a second Start.
TEST_F(Telling, WindowDoesNotComeRoundNorSurviveAStart)
{
    Verifies(req::SRS_KRN_032);
    Verifies(req::SRS_KRN_346);
    config.cycle_us = 1000000U;
    config.diagnostic_interval_us = 10000000U;
    config.test_interval_us = 20000000U;
    config.clock_interval_us = 100000000U;
    ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    const auto cycle = [this](const std::uint32_t at_us, const std::uint32_t signals)
    {
        a.on_outcome = [](CycleOutcome& outcome) { outcome.signalled = 1U; };
        a.more_signals = signals;
        kernel.Cycle(CycleCall{InstantPair{{at_us}, {at_us}}, 0U, 0U});
    };
    std::uint32_t at_us = 500000U;
    cycle(at_us, kLengthBit);
    ASSERT_EQ(application.errors.size(), 1U);
    for (std::uint32_t second = 0U; second < 4294U; ++second)
    {
        at_us += 1000000U;
        cycle(at_us, 0U);
    }
    // 4294.5 s: 4294967296 us is 0 again
    at_us += 980000U;
    EXPECT_EQ(at_us, 512704U);
    cycle(at_us, kLengthBit);
    EXPECT_EQ(application.errors.size(), 2U);
    ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    cycle(at_us + 1000U, kLengthBit);
    EXPECT_EQ(application.errors.size(), 3U);
}

TEST_F(Telling, WhatIsNotToldWantsNoAnswer)
{
    Verifies(req::SRS_KRN_032);
    Verifies(req::SRS_KRN_022);
    Verifies(req::SRS_KRN_345);
    handshake = StatusHandshake::kRequired;
    Operate();
    CycleWith(a, 0U, kLengthBit);
    ASSERT_EQ(kernel.SetStatus(CommunicationIndex{0x1301U}, StatusByte{0xB0U}), Result::kSuccessful);
    CycleWith(b, 0U, kLengthBit);
    Cycles(3U);
    EXPECT_EQ(CausesOf(0x1301U).size(), 1U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

} // namespace
} // namespace counterpoint
