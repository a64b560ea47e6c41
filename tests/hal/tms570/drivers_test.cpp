// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/tms570/output/cut_off.hpp"
#include "hal/tms570/probe.hpp"
#include "tests/hal/tms570/rig.hpp"
#include "verification/trace/ids/tms570.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace counterpoint::tms570
{
namespace
{

[[nodiscard]] hal::WatchdogAnswer RightAnswer(const hal::WatchdogQuestion& question)
{
    return hal::WatchdogAnswer{(0x5EC0'DE27U + question.value) * 0x0100'0193U};
}

// 1500 us at 80 MHz: 14 steps of 8192 cycles are 1433 us; the half of it is 716 us.
TEST(WatchdogTest, PlanLiesWithinTheWindowThatWasAskedFor)
{
    Verifies(req::SRS_TMS_022);
    // Given a cycle of 1 ms, when the window is planned
    const WatchdogPlan plan = PlanWatchdog(hal::WatchdogWindow{500U, 1500U}, RtiClock{80U}, 900U);
    // Then it is the hardware's nearest inside of what was asked for
    EXPECT_EQ(plan.outcome, Outcome::kDone);
    EXPECT_EQ(plan.preload, 13U);
    EXPECT_EQ(plan.window, 0x50U);
    EXPECT_EQ(plan.real.opens_us, 716U);
    EXPECT_EQ(plan.real.ends_us, 1433U);
    // and what the hardware cannot have is refused
    EXPECT_EQ(PlanWatchdog(hal::WatchdogWindow{800U, 1000U}, RtiClock{80U}, 805U).outcome, Outcome::kFailed);
    EXPECT_EQ(PlanWatchdog(hal::WatchdogWindow{10U, 90U}, RtiClock{80U}, 50U).outcome, Outcome::kFailed);
    EXPECT_EQ(PlanWatchdog(hal::WatchdogWindow{0U, 300001U}, RtiClock{80U}, 900U).outcome, Outcome::kFailed);
    EXPECT_EQ(PlanWatchdog(hal::WatchdogWindow{0U, 1500U}, RtiClock{0U}, 900U).outcome, Outcome::kFailed);
}

class WatchdogRuns : public ::testing::Test
{
  protected:
    void SetUp() override
    {
        ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
        ASSERT_EQ(rig.board.StartWatchdog(), Outcome::kDone);
    }

    Rig rig;
};

TEST_F(WatchdogRuns, RightAnswersInTheWindowKeepItQuiet)
{
    Verifies(req::SRS_TMS_023);
    // Given answers every millisecond, when each is right
    for (int cycle = 0; cycle < 20; ++cycle)
    {
        rig.machine.Advance(1000U);
        rig.board.Watchdog().Answer(RightAnswer(rig.board.Watchdog().Question()));
    }
    // Then it never bites, and the questions differ
    EXPECT_FALSE(rig.machine.rti.HasBitten());
    const std::uint32_t before = rig.board.Watchdog().Question().value;
    rig.machine.Advance(1000U);
    rig.board.Watchdog().Answer(RightAnswer(rig.board.Watchdog().Question()));
    EXPECT_NE(rig.board.Watchdog().Question().value, before);
}

TEST_F(WatchdogRuns, EarlyAndLateAnswersReset)
{
    Verifies(req::SRS_TMS_022);
    // Given an answer after 700 us, which is before the window opens at 716 us
    rig.machine.Advance(700U);
    rig.board.Watchdog().Answer(RightAnswer(rig.board.Watchdog().Question()));
    EXPECT_TRUE(rig.machine.rti.HasBitten());
}

TEST_F(WatchdogRuns, SilenceResets)
{
    Verifies(req::SRS_TMS_022);
    // Given no answer, when the period of 1433 us is not over, then it waits
    rig.machine.Advance(1420U);
    EXPECT_FALSE(rig.machine.rti.HasBitten());
    // and then it bites
    rig.machine.Advance(20U);
    EXPECT_TRUE(rig.machine.rti.HasBitten());
}

class WrongAnswer : public WatchdogRuns, public ::testing::WithParamInterface<std::uint32_t>
{
};

TEST_P(WrongAnswer, ResetsForEveryBit)
{
    Verifies(req::SRS_TMS_023);
    // Given a right answer in which these bits are wrong
    rig.machine.Advance(1000U);
    hal::WatchdogAnswer answer = RightAnswer(rig.board.Watchdog().Question());
    answer.value ^= GetParam();
    // When it is given in the window, then a key is wrong and the controller is reset
    rig.board.Watchdog().Answer(answer);
    EXPECT_TRUE(rig.machine.rti.HasBitten());
}

INSTANTIATE_TEST_SUITE_P(Bits, WrongAnswer,
                         ::testing::Values(1U, 0x8000U, 0x00010000U, 0x80000000U, 0x00010001U, 0xFFFFFFFFU));

TEST(WatchdogTest, EachSingleBitOfAnAnswerIsAWrongKey)
{
    Verifies(req::SRS_TMS_023);
    for (std::uint32_t bit = 0U; bit < 32U; ++bit)
    {
        // Given an answer in its window that is right but for one bit, then the controller is reset
        Rig rig;
        ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
        ASSERT_EQ(rig.board.StartWatchdog(), Outcome::kDone);
        rig.machine.Advance(1000U);
        hal::WatchdogAnswer answer = RightAnswer(rig.board.Watchdog().Question());
        answer.value ^= std::uint32_t{1U} << bit;
        rig.board.Watchdog().Answer(answer);
        EXPECT_TRUE(rig.machine.rti.HasBitten()) << "bit " << bit;
    }
}

// The keys are E51Ah and A35Ch. By how much an answer is above the right one is in both, half by half.
TEST_F(WatchdogRuns, KeysAreComputedFromTheAnswerWhateverItIs)
{
    Verifies(req::SRS_TMS_023);
    struct Keys
    {
        std::uint32_t above;
        std::uint32_t first;
        std::uint32_t second;
    };
    for (const Keys& keys : {Keys{0U, 0xE51AU, 0xA35CU}, Keys{1U, 0xE51BU, 0xA35CU}, Keys{0x10000U, 0xE51AU, 0xA35DU},
                             Keys{0xFFFFFFFFU, 0xE519U, 0xA35BU}})
    {
        // Given an answer that is so much above the right one
        rig.machine.Advance(1000U);
        hal::WatchdogAnswer answer = RightAnswer(rig.board.Watchdog().Question());
        answer.value += keys.above;
        std::vector<std::uint32_t> written;
        rig.machine.SetSurroundings([&] { written.push_back(rig.machine.rti.LastKey()); });
        rig.board.Watchdog().Answer(answer);
        rig.machine.SetSurroundings({});
        // Then two keys are written, whether it is right or wrong
        EXPECT_EQ(written, (std::vector<std::uint32_t>{keys.first, keys.second})) << keys.above;
    }
}

TEST_F(WatchdogRuns, IsSetUpToResetAndStaysOn)
{
    Verifies(req::SRS_TMS_022);
    // Given a watchdog that was started for 500 us to 1500 us: preload 13, the upper half of 1433 us, reaction reset
    EXPECT_EQ(rig.machine.Read(0xFFFFFC94U), 13U);
    EXPECT_EQ(rig.machine.Read(0xFFFFFCA4U), 0x5U);
    EXPECT_EQ(rig.machine.Read(0xFFFFFCA8U), 0x50U);
    EXPECT_EQ(rig.machine.Read(0xFFFFFC90U), 0xA98559DAU);
    // When somebody turns it off by the key that is for that, then it is on all the same, and bites
    rig.machine.Write(0xFFFFFC90U, 0x5312ACEDU);
    EXPECT_EQ(rig.machine.Read(0xFFFFFC90U), 0xA98559DAU);
    rig.machine.Advance(1440U);
    EXPECT_TRUE(rig.machine.rti.HasBitten());
}

TEST(WatchdogTest, LostWriteRefusesTheStart)
{
    Verifies(req::SRS_TMS_022);
    for (const model::Fault fault : {model::Fault::kWatchdogNotEnabled, model::Fault::kWatchdogPeriodLost,
                                     model::Fault::kWatchdogReactionLost, model::Fault::kWatchdogWindowLost})
    {
        // Given a watchdog that does not keep what is written
        Rig rig;
        ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
        rig.machine.faults.Set(fault);
        // When it is started, then that fails and the device is safe before its first cycle
        EXPECT_EQ(rig.board.StartWatchdog(), Outcome::kFailed);
        EXPECT_EQ(rig.board.BeginCycle(), BoardFault::kWatchdog);
        EXPECT_TRUE(rig.IsSafe());
    }
}

TEST(WatchdogTest, VariantWithoutAWindowFindsLateAndWrongAnswers)
{
    Verifies(req::SRS_TMS_022);
    // Given the variant whose watchdog has no window
    Rig rig{kLs20x};
    ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    ASSERT_EQ(rig.board.StartWatchdog(), Outcome::kDone);
    EXPECT_EQ(rig.machine.Read(0xFFFFFCA8U), 0U);
    // When an answer is early, then nothing happens, and the driver finds all as it was set up
    rig.machine.Advance(100U);
    rig.board.Watchdog().Answer(RightAnswer(rig.board.Watchdog().Question()));
    EXPECT_FALSE(rig.machine.rti.HasBitten());
    EXPECT_EQ(rig.board.Watchdog().Examine(), Outcome::kDone);
    // and when none comes, then it resets
    rig.machine.Advance(1600U);
    EXPECT_TRUE(rig.machine.rti.HasBitten());
}

TEST(SafetyPinsTest, ThreeRightPermitsOpenAndEachWrongOneCloses)
{
    Verifies(req::SRS_TMS_024);
    // Given a started board whose pin is low
    Rig rig;
    ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    EXPECT_EQ(rig.machine.gio.PinsA(), 0U);
    for (int wrong = 0; wrong < 4; ++wrong)
    {
        // When three right permits come, then it is high
        SafetyPins& output = rig.board.Output();
        output.Drive(Rig::RightPermits(output.Challenge(), 1U));
        EXPECT_EQ(rig.machine.gio.PinsA(), 1U);
        // and when one is wrong, or the challenge is an old one, it is low
        hal::PermitSet permits = Rig::RightPermits(output.Challenge(), 1U);
        permits.a.response ^= (wrong == 0) ? 1U : 0U;
        permits.b.response ^= (wrong == 1) ? 1U : 0U;
        permits.kernel.response ^= (wrong == 2) ? 1U : 0U;
        static_cast<void>((wrong == 3) ? output.Challenge() : 0U);
        output.Drive(permits);
        EXPECT_EQ(rig.machine.gio.PinsA(), 0U);
        rig.Arm();
    }
}

TEST(SafetyPinsTest, InterruptedOutputStaysLowUntilItIsArmed)
{
    Verifies(req::SRS_TMS_300);
    for (const bool is_late : {false, true})
    {
        Rig rig;
        ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
        SafetyPins& output = rig.board.Output();
        output.Drive(Rig::RightPermits(output.Challenge(), 1U));
        ASSERT_EQ(rig.machine.gio.PinsA(), 1U);
        // Given a wrong permit, or a look at the pins 1201 us later
        hal::PermitSet permits = Rig::RightPermits(output.Challenge(), 1U);
        permits.b.response ^= 1U;
        rig.machine.Advance(is_late ? 1230U : 0U);
        if (is_late)
        {
            EXPECT_EQ(output.Examine(), Outcome::kDone);
        }
        else
        {
            output.Drive(permits);
        }
        EXPECT_EQ(rig.machine.gio.PinsA(), 0U);
        // When right permits come, then the challenge is 0 and the pin low
        for (int cycle = 0; cycle < 5; ++cycle)
        {
            const std::uint32_t challenge = output.Challenge();
            EXPECT_EQ(challenge, 0U);
            output.Drive(Rig::RightPermits(challenge, 1U));
            EXPECT_EQ(output.Examine(), Outcome::kDone);
            EXPECT_EQ(rig.machine.gio.PinsA(), 0U);
        }
        rig.Arm();
        output.Drive(Rig::RightPermits(output.Challenge(), 1U));
        EXPECT_EQ(rig.machine.gio.PinsA(), 1U);
    }
}

TEST(SafetyPinsTest, SilenceClosesAfterTheLimit)
{
    Verifies(req::SRS_TMS_024);
    // Given an open output
    Rig rig;
    ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    SafetyPins& output = rig.board.Output();
    output.Drive(Rig::RightPermits(output.Challenge(), 1U));
    // When nothing is driven for 1200 us and the pins are looked at, then it is open still
    rig.machine.Advance(1190U);
    EXPECT_EQ(output.Examine(), Outcome::kDone);
    EXPECT_EQ(rig.machine.gio.PinsA(), 1U);
    // and closed after that
    rig.machine.Advance(20U);
    EXPECT_EQ(output.Examine(), Outcome::kDone);
    EXPECT_EQ(rig.machine.gio.PinsA(), 0U);
}

TEST(SafetyPinsTest, CutOffLastsUntilTheNextStart)
{
    Verifies(req::SRS_TMS_025);
    // Given an output that was cut off
    Rig rig;
    ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    SafetyPins& output = rig.board.Output();
    output.CutOff();
    // When right permits come, then it stays low and is no output any more
    output.Drive(Rig::RightPermits(output.Challenge(), 1U));
    EXPECT_EQ(rig.machine.gio.PinsA(), 0U);
    EXPECT_EQ(output.Open(), 0U);
    EXPECT_EQ(output.Examine(), Outcome::kFailed);
    // and when it is started again, it works
    EXPECT_EQ(output.Start(rig.setup.pins), Outcome::kDone);
    output.Drive(Rig::RightPermits(output.Challenge(), 1U));
    EXPECT_EQ(rig.machine.gio.PinsA(), 1U);
}

TEST(SafetyPinsTest, PulseBetweenTwoCyclesIsSeen)
{
    Verifies(req::SRS_TMS_025);
    Verifies(req::SRS_TMS_026);
    // Given closed outputs
    Rig rig;
    ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    SafetyPins& output = rig.board.Output();
    output.Drive(Rig::RightPermits(output.Challenge(), 0U));
    // When the pin is made high behind the driver's back, which a write of the right level would mend
    Write(At(gio::kPortA, gio::kSet), 1U);
    ASSERT_EQ(rig.machine.gio.PinsA(), 1U);
    // Then the look of the next cycle sees it and cuts off
    EXPECT_EQ(output.Examine(), Outcome::kFailed);
    EXPECT_EQ(rig.machine.gio.PinsA(), 0U);
    EXPECT_EQ(Read(At(gio::kPortA, gio::kDirection)), 0U);
}

TEST(SafetyPinsTest, CutOffThatIsNotReadBackIsToldByTheErrorPin)
{
    Verifies(req::SRS_TMS_026);
    // Given an open output whose direction cannot be changed any more
    Rig rig;
    ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    SafetyPins& output = rig.board.Output();
    output.Drive(Rig::RightPermits(output.Challenge(), 1U));
    ASSERT_TRUE(rig.machine.esm.IsPinHigh());
    rig.machine.faults.Set(model::Fault::kPinStaysOutput);
    // When it is cut off, then the pin is low, and nERROR says that it is an output still
    output.CutOff();
    EXPECT_EQ(rig.machine.gio.PinsA(), 0U);
    EXPECT_FALSE(rig.machine.esm.IsPinHigh());
}

/// Pins on their own, one of which needs slots 0 and 1. What is flipped lies behind two tables of functions and the
/// reference to the clocks.
class FlippedPins
{
  public:
    static constexpr std::size_t kFirstBit = 3U * sizeof(void*) * 8U;
    static constexpr std::size_t kBits = sizeof(SafetyPins) * 8U;

    explicit FlippedPins(Rig& started) : rig{started}
    {
        SafetyPinsSetup setup = rig.setup.pins;
        setup.pins[0U].slots = 3U;
        EXPECT_EQ(pins.Start(setup), Outcome::kDone);
        pins.Drive(hal::PermitSet{});
    }
    void Drive(const SrdoMask mask)
    {
        pins.Drive(Rig::RightPermits(pins.Challenge(), mask));
    }
    void Flip(const std::size_t bit)
    {
        reinterpret_cast<unsigned char*>(&pins)[bit / 8U] ^= static_cast<unsigned char>(1U << (bit % 8U));
    }

    Rig& rig;
    SafetyPins pins{rig.board.Clocks()};
};

TEST(SafetyPinsTest, NoBitOfItsMemoryOpensAPin)
{
    Verifies(req::SRS_TMS_026);
    Rig rig;
    ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    for (std::size_t bit = FlippedPins::kFirstBit; bit < FlippedPins::kBits; ++bit)
    {
        // Given one bit flipped, when only one of the two slots of the pin is permitted, then the pin stays low
        FlippedPins flipped{rig};
        flipped.Flip(bit);
        flipped.Drive(1U);
        EXPECT_EQ(flipped.rig.machine.gio.PinsA(), 0U) << bit;
        EXPECT_EQ(flipped.rig.machine.gio.PinsB(), 0U) << bit;
    }
}

TEST(SafetyPinsTest, NoBitOfItsMemoryHoldsAPinOpen)
{
    Verifies(req::SRS_TMS_026);
    Rig rig;
    ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    for (std::size_t bit = FlippedPins::kFirstBit; bit < FlippedPins::kBits; ++bit)
    {
        for (const bool is_cut_off : {false, true})
        {
            // Given an open pin and one bit flipped
            FlippedPins flipped{rig};
            flipped.Drive(3U);
            ASSERT_EQ(flipped.rig.machine.gio.PinsA(), 1U);
            flipped.Flip(bit);
            // When it is cut off, or when nothing is driven for longer than the limit of 1200 us, then it is low
            if (is_cut_off)
            {
                flipped.pins.CutOff();
            }
            else
            {
                flipped.rig.machine.Advance(1201U);
                static_cast<void>(flipped.pins.Examine());
            }
            EXPECT_EQ(flipped.rig.machine.gio.PinsA(), 0U) << bit;
            // and the next cycle, in which one slot is permitted, leaves it so
            flipped.Drive(1U);
            EXPECT_EQ(flipped.rig.machine.gio.PinsA(), 0U) << bit;
        }
    }
}

TEST(ProbeTest, OnlyTheArmedAccessIsProvoked)
{
    Verifies(req::SRS_TMS_046);
    // Given a machine that reports an uncorrectable error of the even bank
    model::Machine machine{kLs12x};
    machine.esm.Raise(3U, 3U);
    constexpr Register kPlace{0x08000100U};
    const AbortFacts right{hal::ExceptionCause::kDataAccess, 0x08000104U, ProbeInstruction()};
    const AbortFacts elsewhere{hal::ExceptionCause::kDataAccess, 0x08000108U, ProbeInstruction()};
    const AbortFacts other_code{hal::ExceptionCause::kDataAccess, 0x08000104U, ProbeInstruction() + 4U};
    const AbortFacts other_cause{hal::ExceptionCause::kInstruction, 0x08000104U, ProbeInstruction()};
    // When nothing is armed, then no abort is provoked
    EXPECT_FALSE(IsProvoked(right));
    // and when it is, then exactly this one, once
    ArmProbe(ProbeKind::kEvenRam, kPlace);
    EXPECT_TRUE(IsProvoked(right));
    EXPECT_FALSE(IsProvoked(right));
    for (const AbortFacts& wrong : {elsewhere, other_code, other_cause})
    {
        ArmProbe(ProbeKind::kEvenRam, kPlace);
        EXPECT_FALSE(IsProvoked(wrong));
        // A wrong one uses it up as well.
        EXPECT_FALSE(IsProvoked(right));
    }
    // and not while another module reports
    ArmProbe(ProbeKind::kOddRam, kPlace);
    EXPECT_FALSE(IsProvoked(right));
    ArmProbe(ProbeKind::kFlash, kPlace);
    EXPECT_FALSE(IsProvoked(right));
}

TEST(CutOffTest, ClosesEverythingWithoutAnyObject)
{
    Verifies(req::SRS_TMS_052);
    // Given a device in operation
    Rig rig{kLs12x, BusLayout::kTwoBuses};
    ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    ASSERT_EQ(rig.Cycle(), BoardFault::kNone);
    ASSERT_EQ(rig.machine.gio.PinsA(), 1U);
    // When an exception comes
    CutOffEverything();
    // Then pins and nERROR are low and both controllers off the bus
    EXPECT_TRUE(rig.IsSafe());
    EXPECT_FALSE(rig.machine.dcan2.IsOnBus());
    EXPECT_EQ(Read(At(gio::kPortA, gio::kDirection)), 0U);
}

TEST(RtiTest, CountersAreMicrosecondsOfTheirOwn)
{
    Verifies(req::SRS_TMS_020);
    for (const Variant* variant : {&kLs20x, &kLs12x, &kLs31x, &kLc43x})
    {
        // Given a started board of each variant
        Rig rig{*variant};
        ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
        // When a millisecond passes
        const InstantPair before = rig.board.Clocks().Now();
        rig.machine.Advance(1000U);
        const InstantPair after = rig.board.Clocks().Now();
        // Then both say so
        EXPECT_NEAR(after.a.us - before.a.us, 1000.0, 1.0);
        EXPECT_NEAR(after.b.us - before.b.us, 1000.0, 1.0);
    }
}

} // namespace
} // namespace counterpoint::tms570
