// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What the tests of the hardware leave behind, and limits of the drivers that no fault shows.
#include "hal/tms570/chip/system_registers.hpp"
#include "hal/tms570/diagnosis/lockstep.hpp"
#include "hal/tms570/time/clock_comparator.hpp"
#include "tests/hal/tms570/rig.hpp"
#include "verification/trace/ids/tms570.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace counterpoint::tms570
{
namespace
{

using model::Fault;

[[nodiscard]] bool IsEsmClean()
{
    const EsmStatus status = ReadEsm();
    return (status.group_1_low | status.group_1_high | status.group_2 | status.group_3) == 0U;
}

[[nodiscard]] std::string TextOf(const std::string& path)
{
    std::ifstream file{path};
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

/// A wait whose bit never comes. One look takes 50 ns of the model; what is done before and after takes 10 us at most.
struct EndlessWait
{
    model::Fault fault;
    Outcome (*wait)();
    std::uint64_t looks;
};

using EndlessWaits = ::testing::TestWithParam<EndlessWait>;

TEST_P(EndlessWaits, EndAfterTheLooksThatTheTableOfFaultsTells)
{
    Verifies(req::SRS_TMS_003);
    // Given a peripheral that never says that it is ready
    model::Machine machine{kLs12x};
    machine.faults.Set(GetParam().fault);
    // When its driver waits, then that fails after the looks that docs/tms570_faults.md tells, and after no more
    EXPECT_EQ(GetParam().wait(), Outcome::kFailed);
    EXPECT_GE(machine.NowUs(), GetParam().looks / 20U);
    EXPECT_LE(machine.NowUs(), (GetParam().looks / 20U) + 10U);
}

INSTANTIATE_TEST_SUITE_P(
    All, EndlessWaits,
    ::testing::Values(
        EndlessWait{model::Fault::kCcmSelfTestEndless, [] { return Lockstep::Test(1U); }, 20'000U},
        EndlessWait{model::Fault::kPllNeverLocks, [] { return StartClocks(kLs12x.clocks, kLs12x.system); }, 70'000U},
        EndlessWait{model::Fault::kDccEndless, [] { return ClockComparator::Start(kLs12x.clocks); }, 200'000U},
        EndlessWait{model::Fault::kMemoryInitEndless, [] { return InitialiseMemories(kLs12x.memories); }, 70'000U},
        EndlessWait{model::Fault::kPbistEndless, [] { return TestMemories(kLs12x.memories); }, 1'000'000U}));

TEST(DiagnosisTest, BusyInterfaceOfACanControllerIsLookedAt64Times)
{
    Verifies(req::SRS_TMS_019);
    Verifies(req::SRS_TMS_015);
    Verifies(req::SRS_TMS_003);
    // Given a controller whose interface to the objects stays busy
    Rig rig;
    ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    rig.machine.faults.Set(model::Fault::kDcanBusyForEver);
    // When a frame is sent, then it is refused after 64 looks of 50 ns and the few writes around them
    const std::uint64_t before = rig.machine.NowUs();
    EXPECT_EQ(rig.board.Can().Transmit(Frame(kSentNormal, 1U)), hal::TransmitStatus::kRefused);
    EXPECT_GE(rig.machine.NowUs() - before, 3U);
    EXPECT_LE(rig.machine.NowUs() - before, 4U);
    // and every later one at once
    EXPECT_EQ(rig.board.Can().Transmit(Frame(kSentInverse, 1U)), hal::TransmitStatus::kRefused);
    EXPECT_FALSE(rig.machine.dcan1.IsOnBus());
}

TEST(DiagnosisTest, LockstepTestForcesEveryErrorAndEndsInLockstep)
{
    Verifies(req::SRS_TMS_040);
    // Given a sound comparator
    model::Machine machine{kLs12x};
    // When it is tested, then it passes, in lockstep mode, without an error left, and nERROR goes high again
    EXPECT_EQ(Lockstep::Test(1U), Outcome::kDone);
    EXPECT_EQ(machine.Read(0xFFFFF604U), 0U);
    EXPECT_TRUE(IsEsmClean());
    EXPECT_FALSE(machine.esm.IsPinHigh());
    machine.Advance(300U);
    EXPECT_TRUE(machine.esm.IsPinHigh());
}

TEST(DiagnosisTest, TableOfVectorsIsAsItWasAfterItsTest)
{
    Verifies(req::SRS_TMS_041);
    // Given a sound table, when its parity is tested, then it passes with parity on and nothing left
    model::Machine machine{kLs12x};
    EXPECT_EQ(Interrupts::TestTable(TableCheck::kParity), Outcome::kDone);
    EXPECT_EQ(machine.Read(0xFFFFFDF0U), 0xAU);
    EXPECT_EQ(machine.Read(0xFFFFFDECU), 0U);
    EXPECT_EQ(machine.Read(0xFFF82400U), 0U);
    EXPECT_TRUE(IsEsmClean());
    // and the set-up fills all of it
    EXPECT_EQ(Interrupts::Start(TableCheck::kParity), Outcome::kDone);
    EXPECT_EQ(machine.Read(0xFFF82000U), 0xFFFFFFFCU);
    EXPECT_EQ(machine.Read(0xFFF821FCU), 0xFFFFFFFCU);
    // with DCAN 1, DCAN 2 and the ESM enabled: channels 16, 20, 35, and 0 and 1 that are always
    EXPECT_EQ(machine.Read(0xFFFFFE30U), 0x00110003U);
    EXPECT_EQ(machine.Read(0xFFFFFE34U), 0x00000008U);
}

TEST(DiagnosisTest, OneInterruptServesABoundedNumberOfRequests)
{
    Verifies(req::SRS_TMS_042);
    // Given a board and a bus on which frames never end: each read of a frame brings the next
    Rig rig;
    ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    rig.machine.dcan1.Receive(Frame(kNormal, 1U));
    rig.machine.SetSurroundings([&rig] { rig.machine.dcan1.Receive(Frame(kNormal, 1U)); });
    // When the interrupt is taken, then it comes back
    rig.board.OnInterrupt();
    rig.machine.SetSurroundings({});
    int frames = 0;
    for (QueuedFrame frame = rig.board.NextFrame(); frame.kind != QueuedKind::kNothing; frame = rig.board.NextFrame())
    {
        frames += (frame.kind == QueuedKind::kReceived) ? 1 : 0;
    }
    EXPECT_EQ(frames, 32);
}

TEST(DiagnosisTest, RequestThatNobodyAskedForDoesNotComeForEver)
{
    Verifies(req::SRS_TMS_042);
    // Given a board and a request of a channel that no driver enabled
    Rig rig;
    ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    rig.machine.faults.Set(model::Fault::kVimUnknownRequest);
    EXPECT_TRUE(rig.machine.vim.Line());
    // When it is taken, then the device is safe and the line is down, so that the program runs
    rig.board.OnInterrupt();
    EXPECT_EQ(rig.board.Fault(), BoardFault::kInterrupts);
    EXPECT_FALSE(rig.machine.vim.Line());
}

TEST(DiagnosisTest, ClockComparatorCountsBothClocksForTheSameTime)
{
    Verifies(req::SRS_TMS_043);
    // Given 160 MHz of a 16 MHz oscillator
    model::Machine machine{kLs12x};
    // When the comparator is started, then 39 600 cycles of the oscillator, 1 percent to either side, are ten times as
    // many of the processor
    EXPECT_EQ(ClockComparator::Start(kLs12x.clocks), Outcome::kDone);
    EXPECT_EQ(machine.Read(0xFFFFEC08U), 39'204U);
    EXPECT_EQ(machine.Read(0xFFFFEC0CU), 792U);
    EXPECT_EQ(machine.Read(0xFFFFEC10U), 396'000U);
    EXPECT_EQ(machine.Read(0xFFFFEC00U), 0x55AAU);
    // and it goes on without an error
    machine.Advance(10'000U);
    EXPECT_EQ(ClockComparator::Examine(), Outcome::kDone);
    EXPECT_EQ(ClockComparator::Start(ClockTree{0U, 0U, 0U, 160U, 80U}), Outcome::kFailed);
}

TEST(DiagnosisTest, RamIsAsItWasAfterTheTestOfItsEcc)
{
    Verifies(req::SRS_TMS_044);
    // Given sound RAM
    model::Machine machine{kLs12x};
    // When its ECC is tested, then it passes, the provoked aborts were the only ones, and nothing is left
    EXPECT_EQ(TestRamEcc(EccTestPlace{0x08000100U}), Outcome::kDone);
    EXPECT_EQ(machine.real_aborts, 0U);
    EXPECT_TRUE(IsEsmClean());
    for (const std::uint32_t bank : {0xFFFFF800U, 0xFFFFF900U})
    {
        EXPECT_EQ(machine.Read(bank), 0x0005000AU);
        EXPECT_EQ(machine.Read(bank + 0x10U), 0U);
    }
    EXPECT_EQ(machine.Read(0x08400100U), machine.Read(0x08400200U));
    EXPECT_TRUE(machine.processor.ChecksRam());
    // and a place that does not hold a word of both banks is refused
    EXPECT_EQ(TestRamEcc(EccTestPlace{0x08000108U}), Outcome::kFailed);
}

TEST(DiagnosisTest, FlashDiagnosisIsOffAfterTheTest)
{
    Verifies(req::SRS_TMS_045);
    // Given a sound flash, when its ECC is tested, then it passes, and the diagnosis is off
    model::Machine machine{kLs12x};
    EXPECT_EQ(TestFlashEcc(), Outcome::kDone);
    EXPECT_EQ(machine.real_aborts, 0U);
    EXPECT_EQ(machine.Read(0xFFF8706CU), 0x000A0007U);
    EXPECT_EQ(machine.Read(0xFFF8701CU), 0U);
    EXPECT_TRUE(IsEsmClean());
}

TEST(DiagnosisTest, MemoryTestEndsSwitchedOff)
{
    Verifies(req::SRS_TMS_048);
    Verifies(req::SRS_TMS_049);
    // Given sound memories, when they are tested and initialised
    model::Machine machine{kLs12x};
    EXPECT_EQ(TestMemories(kLs12x.memories), Outcome::kDone);
    // Then the last run was over VIM, DCAN 1 and 2, and the controller is off
    EXPECT_EQ(machine.Read(0xFFFFE5C8U), 0x20CU);
    EXPECT_EQ(machine.Read(0xFFFFE580U), 0U);
    EXPECT_EQ(machine.Read(0xFFFFFF58U), 0x105U);
    EXPECT_EQ(InitialiseMemories(kLs12x.memories), Outcome::kDone);
    EXPECT_EQ(machine.Read(0xFFFFFF60U), 0x64U);
    EXPECT_EQ(machine.Read(0xFFFFFF5CU), 0x5U);
}

TEST(DiagnosisTest, ClocksAreThoseOfTheVariant)
{
    Verifies(req::SRS_TMS_050);
    // Given a controller of 16 MHz, when its clocks are started
    model::Machine machine{kLs12x};
    EXPECT_EQ(StartClocks(kLs12x.clocks, kLs12x.system), Outcome::kDone);
    // Then the PLL makes 16 / 6 * 120 / 2 MHz, drives the processor, half of it the peripherals and the RTI
    EXPECT_EQ(machine.Read(0xFFFFFF70U), 0x20057700U);
    EXPECT_EQ(machine.Read(0xFFFFFF48U), 1U);
    EXPECT_EQ(machine.Read(0xFFFFFF50U), 0x01090109U);
    EXPECT_EQ(machine.Read(0xFFFFFFD0U), 0x01010100U);
    EXPECT_EQ(ExamineClocks(kLs12x.system.rti_source), Outcome::kDone);
}

TEST(DiagnosisTest, ColdErrorIsKeptWithItsChannel)
{
    Verifies(req::SRS_TMS_031);
    // Given an error of group 2 that only the shadow kept over the reset
    Rig rig;
    rig.machine.esm.Raise(2U, 24U);
    rig.machine.Write(0xFFFFF51CU, 1U << 24U);
    // When the board starts, then it is refused and tells the channel
    EXPECT_EQ(rig.Start().last, StartStep::kColdErrors);
    EXPECT_EQ(rig.board.Errors().First().group, 2U);
    EXPECT_EQ(rig.board.Errors().First().channel, 24U);
}

TEST(DiagnosisTest, ObjectWithAParityErrorHandsNothingOn)
{
    Verifies(req::SRS_TMS_019);
    Verifies(req::SRS_TMS_017);
    // Given a board and a frame in an object whose parity does not fit
    Rig rig;
    ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    rig.machine.faults.Set(model::Fault::kDcanParityError);
    rig.machine.dcan1.Receive(Frame(kNormal, 1U));
    // When the interrupt of the controller is taken
    rig.board.OnInterrupt();
    // Then there is no frame, and the controller is off the bus and refuses
    EXPECT_EQ(rig.board.NextFrame().kind, QueuedKind::kNothing);
    EXPECT_EQ(rig.board.Can().Controller(CanPortId::kFirst).Fault(), CanFault::kParity);
    EXPECT_FALSE(rig.machine.dcan1.IsOnBus());
    EXPECT_EQ(rig.board.Can().Transmit(Frame(kSentNormal, 1U)), hal::TransmitStatus::kRefused);
    EXPECT_EQ(rig.board.Can().Guarantees().bus_order, hal::Guarantee::kAbsent);
}

TEST(DiagnosisTest, TestedSourcesAreThoseOfTheImage)
{
    Verifies(req::SRS_TMS_001);
    // Given the drivers, the list that both builds compile, and what this build has compiled
    const std::string list = TextOf(TMS570_DRIVERS "/CMakeLists.txt");
    const std::string compiled = TextOf(TMS570_COMPILE_COMMANDS);
    // Then the list has no condition, so that it is the same for the target
    EXPECT_EQ(list.find("if("), std::string::npos);
    const std::filesystem::path drivers{TMS570_DRIVERS};
    std::size_t count = 0U;
    for (const auto& entry : std::filesystem::recursive_directory_iterator{drivers})
    {
        // The other side of the pairs of functions, and what runs before and behind the drivers, is the image's own.
        const std::string name = entry.path().lexically_relative(drivers).generic_string();
        const bool is_of_image = (name.rfind("silicon/", 0U) == 0U) || (name.rfind("start/", 0U) == 0U);
        if (is_of_image || (entry.path().extension() != ".cpp"))
        {
            continue;
        }
        ++count;
        // and each driver is on it, and was compiled once, from the place where it is
        EXPECT_NE(list.find(name), std::string::npos) << name;
        const std::string line = "\"file\": \"" + entry.path().string() + "\"";
        const std::size_t first = compiled.find(line);
        EXPECT_NE(first, std::string::npos) << name;
        EXPECT_EQ(compiled.find(line, first + 1U), std::string::npos) << name;
    }
    EXPECT_GE(count, 20U);
}

TEST(DiagnosisTest, NoDriverHasAConditionalOfThePreprocessor)
{
    Verifies(req::SRS_TMS_002);
    const std::filesystem::path drivers{TMS570_DRIVERS};
    std::size_t count = 0U;
    for (const auto& entry : std::filesystem::recursive_directory_iterator{drivers})
    {
        const std::string extension = entry.path().extension().string();
        if ((extension != ".cpp") && (extension != ".hpp"))
        {
            continue;
        }
        // Given a source, then it has none, and a header the one of its guard
        ++count;
        const std::string text = TextOf(entry.path().string());
        std::size_t conditionals = 0U;
        for (std::size_t at = text.find("\n#if"); at != std::string::npos; at = text.find("\n#if", at + 1U))
        {
            ++conditionals;
        }
        EXPECT_EQ(conditionals, (extension == ".hpp") ? 1U : 0U) << entry.path();
        EXPECT_EQ(text.find("\n#el"), std::string::npos) << entry.path();
    }
    EXPECT_GE(count, 40U);
}

struct Comparator
{
    const char* name;
    std::uint32_t number;
    std::uint8_t channel; ///< Of ESM group 2.
};

using EveryComparator = ::testing::TestWithParam<Comparator>;

TEST_P(EveryComparator, WithAFaultRefusesTheStart)
{
    Verifies(req::SRS_TMS_040);
    Verifies(req::SRS_TMS_070);
    // Given an LC43x with one comparator that fails, never ends, or does not tell what is forced
    for (const Fault fault : {Fault::kCcmSelfTestFails, Fault::kCcmSelfTestEndless, Fault::kCcmForcedErrorUnseen,
                              Fault::kCcmSelfTestErrorUnseen})
    {
        Rig rig{kLc43x};
        rig.machine.ccm.faulty = GetParam().number;
        rig.machine.faults.Set(fault);
        // When the board starts, then it is refused at the test of lockstep
        const StartReport report = rig.Start();
        EXPECT_EQ(report.answer, StartAnswer::kRefused);
        EXPECT_EQ(report.last, StartStep::kLockstep);
        EXPECT_TRUE(rig.IsSafe());
    }
}

TEST_P(EveryComparator, ThatFindsADifferenceIsASafeStateInTheInterrupt)
{
    Verifies(req::SRS_TMS_040);
    // Given an LC43x in operation
    Rig rig{kLc43x};
    ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    ASSERT_EQ(rig.Cycle(), BoardFault::kNone);
    // When what one comparator compares differs
    rig.machine.ccm.Differ(GetParam().number);
    rig.TakeInterrupts();
    // Then the output is closed and the channel told
    EXPECT_EQ(rig.board.Fault(), BoardFault::kEsm);
    EXPECT_EQ(rig.board.Errors().First().group, 2U);
    EXPECT_EQ(rig.board.Errors().First().channel, GetParam().channel);
    EXPECT_EQ(rig.Cycle(), BoardFault::kEsm);
    EXPECT_TRUE(rig.IsSafe());
}

TEST_P(EveryComparator, ThatIsInAnotherModeIsFoundWithinEightCycles)
{
    Verifies(req::SRS_TMS_040);
    Verifies(req::SRS_TMS_062);
    // Given an LC43x in operation, when one comparator no longer compares
    Rig rig{kLc43x};
    ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    rig.machine.ccm.faulty = GetParam().number;
    rig.machine.faults.Set(Fault::kCcmNotLockstep);
    // Then that is found
    EXPECT_EQ(rig.CyclesUntilFault(8), BoardFault::kLockstep);
    EXPECT_TRUE(rig.IsSafe());
}

INSTANTIATE_TEST_SUITE_P(Lc43x, EveryComparator,
                         ::testing::Values(Comparator{"processors", 0U, 2U}, Comparator{"vims", 1U, 25U},
                                           Comparator{"idle_bus", 2U, 26U}, Comparator{"power_domains", 3U, 28U}),
                         [](const auto& row) { return std::string{row.param.name}; });

TEST(Lockstep, NoComparatorOrTooManyFailTheTest)
{
    Verifies(req::SRS_TMS_040);
    // Given a sound controller, when a table of constants says no comparator, or five, then neither test nor look
    // passes
    model::Machine machine{kLc43x};
    EXPECT_EQ(Lockstep::Test(0U), Outcome::kFailed);
    EXPECT_EQ(Lockstep::Test(5U), Outcome::kFailed);
    EXPECT_EQ(Lockstep::Examine(0U), Outcome::kFailed);
    EXPECT_EQ(Lockstep::Examine(5U), Outcome::kFailed);
    // and with the right number both do, and no flag is left
    EXPECT_EQ(Lockstep::Test(4U), Outcome::kDone);
    EXPECT_EQ(Lockstep::Examine(4U), Outcome::kDone);
    EXPECT_EQ(ReadEsm().group_1_low, 0U);
    EXPECT_EQ(ReadEsm().group_2, 0U);
}

} // namespace
} // namespace counterpoint::tms570
