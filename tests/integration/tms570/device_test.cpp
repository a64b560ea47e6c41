// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// A whole device as it is in the image (kernel, channels, application, executive, drivers) on the register models: what
// the drivers hand to the kernel, and what the kernel finds out by itself.
#include "examples/firmware/common/device.hpp"
#include "examples/firmware/common/executive.hpp"
#include "tests/hal/tms570/rig.hpp"
#include "verification/trace/ids/tms570.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <optional>

// What the image has from its linker script and start-up.
extern "C"
{
    std::uint32_t stack_non_safety_top[1];

    void RunUnprivileged(void (*code)() noexcept, std::uint32_t* /*stack_top*/) noexcept
    {
        code();
    }
}

namespace counterpoint::tms570
{
namespace
{

using firmware::BoardNeeds;
using firmware::Executive;

constexpr std::uint64_t kPairUs = 25'000U;
constexpr std::uint64_t kInverseUs = 2'000U;
constexpr std::uint8_t kNmtStart = 1U;

/// The actuator of the examples on its board, with a sensor on the bus that says: move.
class DeviceOnModels : public ::testing::Test
{
  protected:
    void SetUp() override
    {
        rig.setup.can.first.objects = needs.objects;
        rig.setup.can.first.object_count = needs.object_count;
        rig.setup.pins.limit = hal::GateLimit{1500U};
        rig.setup.watchdog = hal::WatchdogWindow{500U, 1600U};
        ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
        Board& board = rig.board;
        const firmware::DrivenDevice driven = firmware::BuildDevice(
            firmware::Hardware{board.Can(), board.Output(), board.Watchdog(), board.Protection()});
        ASSERT_EQ(driven.device.PowerOn(board.Clocks().Now().a), device::LoadResult::kLoaded);
        kernel = &driven.kernel;
        ASSERT_EQ(board.StartWatchdog(), Outcome::kDone);
        executive.emplace(board, driven, needs);
        executive->Start();
        rig.machine.SetSurroundings([this] { Happen(); });
        Command(kNmtStart);
        next_pair_us = rig.machine.NowUs() + kPairUs;
    }
    void TearDown() override
    {
        rig.machine.SetSurroundings({});
    }

    /// Bus and interrupts, at every access of the program.
    void Happen()
    {
        const std::uint64_t now = rig.machine.NowUs();
        if (sends_pairs && (now >= next_pair_us))
        {
            rig.machine.dcan1.Receive(CanFrame{0x103U, FrameKind::kData, CanPortId::kFirst, 2U, {1U, 1U}});
            inverse_us = next_pair_us + kInverseUs;
            next_pair_us += kPairUs;
        }
        if ((inverse_us != 0U) && (now >= inverse_us))
        {
            rig.machine.dcan1.Receive(CanFrame{0x104U, FrameKind::kData, CanPortId::kFirst, 2U, {0xFEU, 0xFEU}});
            inverse_us = 0U;
        }
        if (takes_interrupts)
        {
            rig.TakeInterrupts();
        }
    }

    /// NMT, to all nodes.
    void Command(const std::uint8_t command)
    {
        rig.machine.dcan1.Receive(CanFrame{0U, FrameKind::kData, CanPortId::kFirst, 2U, {command, 0U}});
        Run(2);
    }

    void Run(const int cycles)
    {
        for (int cycle = 0; cycle < cycles; ++cycle)
        {
            executive->Cycle();
        }
    }

    /// Pairs, then a person acknowledges.
    void Release()
    {
        Run(60);
        rig.machine.gio.inputs_b = 1U;
        Run(10);
        rig.machine.gio.inputs_b = 0U;
        Run(30);
        ASSERT_EQ(rig.machine.gio.PinsA(), 1U);
        ASSERT_EQ(rig.machine.gio.PinsB() & 0x80U, 0x80U);
    }

    Rig rig{};
    BoardNeeds needs{firmware::DescribeNeeds()};
    Kernel* kernel{nullptr};
    std::optional<Executive> executive{};
    bool sends_pairs{true};
    bool takes_interrupts{true};
    std::uint64_t next_pair_us{0U};
    std::uint64_t inverse_us{0U};
};

TEST_F(DeviceOnModels, MovesOnPairsAndAcknowledgeAndStopsWithoutPairs)
{
    Verifies(req::SRS_TMS_012);
    Verifies(req::SRS_TMS_013);
    Verifies(req::SRS_TMS_024);
    // Given a device that gets pairs but no acknowledge, then its pin is low
    Run(100);
    EXPECT_EQ(rig.machine.gio.PinsA(), 0U);
    // When a person acknowledges, then it is high
    Release();
    // When pairs fail to come, then it is low within SCT 50 ms, a cycle and the rest of the present pair's 25 ms
    sends_pairs = false;
    Run(76);
    EXPECT_EQ(rig.machine.gio.PinsA(), 0U);
    // and the watchdog was served by the kernel's answers all the time, and no driver found a fault
    EXPECT_FALSE(rig.machine.rti.HasBitten());
    EXPECT_EQ(rig.board.Fault(), BoardFault::kNone);
    EXPECT_EQ(kernel->DeviceState().fault, DeviceFault::kNone);
    EXPECT_TRUE(rig.machine.Strays().empty());
}

TEST_F(DeviceOnModels, LostFrameMakesTheConsumerSafe)
{
    Verifies(req::SRS_TMS_014);
    // Given a device that moves
    Release();
    while (inverse_us != 0U)
    {
        Run(1);
    }
    Run(1);
    // When the interrupt comes so late that both frames of a pair are pending, then the output closes in that cycle
    takes_interrupts = false;
    rig.machine.dcan1.Receive(CanFrame{0x103U, FrameKind::kData, CanPortId::kFirst, 2U, {1U, 1U}});
    rig.machine.dcan1.Receive(CanFrame{0x104U, FrameKind::kData, CanPortId::kFirst, 2U, {0xFEU, 0xFEU}});
    takes_interrupts = true;
    Run(1);
    EXPECT_EQ(rig.machine.gio.PinsA(), 0U);
    EXPECT_EQ(kernel->GetState(CommunicationIndex{0x1301U}).first_cause, SrdoCause::kQueueOverflow);
}

TEST_F(DeviceOnModels, StoppedCounterIsADeviceFault)
{
    Verifies(req::SRS_TMS_021);
    // Given a device that moves
    Release();
    // When counter A stops, then the wait for the next cycle ends by its bound, and everything is cut off
    rig.machine.faults.Set(model::Fault::kCounterAStops);
    Run(1);
    EXPECT_EQ(rig.machine.gio.PinsA(), 0U);
    EXPECT_EQ(rig.machine.gio.PinsB(), 0U);
    EXPECT_FALSE(rig.machine.esm.IsPinHigh());
    // and the watchdog has bitten long before that
    EXPECT_TRUE(rig.machine.rti.HasBitten());
}

TEST_F(DeviceOnModels, FastCounterIsADeviceFault)
{
    Verifies(req::SRS_TMS_021);
    // Given a device that moves
    Release();
    // When counter B runs at twice its speed, then the kernel finds that within its clock interval of 100 ms
    rig.machine.faults.Set(model::Fault::kCounterBFast);
    Run(101);
    EXPECT_EQ(kernel->DeviceState().fault, DeviceFault::kClock);
    EXPECT_EQ(rig.machine.gio.PinsA(), 0U);
}

TEST_F(DeviceOnModels, FaultOfTheBoardIsADeviceFault)
{
    Verifies(req::SRS_TMS_062);
    // Given a device that moves
    Release();
    // When the processors differ, then everything is off in the interrupt
    rig.machine.ccm.Differ();
    static_cast<void>(Read(At(gio::kBase, gio::kGlobalControl)));
    EXPECT_EQ(rig.machine.gio.PinsA(), 0U);
    EXPECT_FALSE(rig.machine.esm.IsPinHigh());
    // and with the next cycle off the bus, and nobody serves the watchdog any more: its window of 1.6 ms runs out
    Run(1);
    EXPECT_FALSE(rig.machine.dcan1.IsOnBus());
    EXPECT_EQ(rig.machine.gio.PinsB(), 0U);
    Run(2);
    EXPECT_TRUE(rig.machine.rti.HasBitten());
}

TEST_F(DeviceOnModels, ProgramThatStandsStillIsReset)
{
    Verifies(req::SRS_TMS_022);
    // Given a device that moves, when its program stands still for longer than the window
    Release();
    rig.machine.Advance(1700U);
    // Then the watchdog resets it
    EXPECT_TRUE(rig.machine.rti.HasBitten());
}

} // namespace
} // namespace counterpoint::tms570
