// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The device of the user guide in a task, on a host: a simulated bus, a sender of commands, an RTOS that is not there,
// and half a second of simulated time. A second task of lower priority takes all the time that is left; with the word
// `above` it stands above the safety task, and the watchdog cuts off.
#include "device.hpp"
#include "rtos_host.hpp"
#include "safety_task.hpp"

#include "canopen/device/app_device.hpp"
#include "channel_a/channel.hpp"
#include "channel_a/storage.hpp"
#include "channel_b/channel.hpp"
#include "channel_b/storage.hpp"
#include "hal/host/can_ports.hpp"
#include "hal/host/clocks.hpp"
#include "hal/host/output.hpp"
#include "hal/host/virtual/bus.hpp"
#include "hal/host/watchdog.hpp"
#include "names/safety_core/contract/srdo.hpp"

#include <cstdio>
#include <cstring>

namespace
{
using namespace counterpoint;

constexpr std::uint64_t kEndUs = 500'000U;
constexpr std::uint32_t kCycleWorkUs = 300U; ///< What a cycle of the kernel takes on this imagined controller.

/// What the interrupt of the CAN controller does: stamp, put, return.
class Interrupt final : public host::FrameSink
{
  public:
    void OnFrame(const StampedFrame& frame) override
    {
        rtos::host::NoteInterrupt();
        queue.PutFromInterrupt(rtos_task::BusEvent{frame, false});
    }
    void OnConfirm(const StampedFrame& frame) override
    {
        rtos::host::NoteInterrupt();
        queue.PutFromInterrupt(rtos_task::BusEvent{frame, true});
    }
    void OnOverflow() override
    {
    }
    rtos_task::InterruptQueue queue{};
};

/// The other node: the start command, commands as a sensor sends them, and a count of the pairs of the device.
class Sender final : public host::BusListener
{
  public:
    void OnReceived(const CanFrame& frame, host::BusTime /*at*/) override
    {
        reports += (frame.identifier == 0x104U) ? 1U : 0U;
    }
    void OnConfirmed(const CanFrame& /*frame*/, host::BusTime /*at*/) override
    {
    }
    unsigned reports{0U};
};

/// The board and the device on it, at one place for interrupt and tasks.
struct Board
{
    host::VirtualBus bus{host::BitRate::k500k};
    host::HostClocks clocks{bus, InstantPair{{1000U}, {70000U}}};
    host::HostWatchdog watchdog{bus};
    host::HostOutput output{bus, watchdog, hal::GateLimit{1500U}};
    Interrupt interrupt{};
    host::HostCanPorts can{clocks, interrupt};
    Sender sender{};
    host::NodeIndex sender_node{bus.Attach(sender, host::NodeSetup{CanPortId::kFirst, 8U})};

    channel_a::StorageFor<2U> storage_a{};
    channel_b::StorageFor<2U> storage_b{};
    channel_a::Channel a{storage_a.Handle()};
    channel_b::Channel b{storage_b.Handle()};
    first_device::Device application{};
    CauseWindows windows[2]{};
    Kernel kernel{KernelParts{a, b, can, output, watchdog, application, nullptr, &windows[0]}};
    device::AppDevice<first_device::Device, 2U> device{kernel, &can, application};

    unsigned told_ms{0U};
    bool was_on{false};
    SrdoState was_state{SrdoState::kOff};
};

Board& The()
{
    static Board board;
    return board;
}

void Send(const std::uint32_t identifier, const std::uint8_t length, const std::uint8_t first)
{
    const CanFrame frame{identifier, FrameKind::kData, CanPortId::kFirst, length, {first}};
    static_cast<void>(The().bus.Submit(The().sender_node, frame));
}

/// What the other node does in this millisecond: the start command at 9, a pair each 25 ms but not from 300 to 400.
void SendAt(const unsigned ms)
{
    if (ms == 9U)
    {
        Send(0x000U, 2U, 1U);
    }
    if (((ms % 25U) == 0U) && ((ms < 300U) || (ms > 400U)))
    {
        Send(0x101U, 1U, 1U);
        Send(0x102U, 1U, 0xFEU);
    }
}

/// A button of two contacts, one for each channel, pressed from 100 to 150 ms and from 450 ms on: one closes, one
/// opens.
bool IsPressed()
{
    const unsigned ms = static_cast<unsigned>(The().bus.Now() / host::kMillisecond);
    return ((ms >= 100U) && (ms < 150U)) || (ms >= 450U);
}

SrdoMask ReadMakeContact()
{
    const bool is_closed = IsPressed();
    return is_closed ? 1U : 0U;
}

SrdoMask ReadBreakContact()
{
    const bool is_closed = !IsPressed();
    return is_closed ? 0U : 1U;
}

void StartWatchdog()
{
    The().watchdog.Start(hal::WatchdogWindow{500U, 1600U});
}

/// Simulated time: frames that end in it come to the interrupt, whatever task runs.
void OnTime(const std::uint64_t now_us)
{
    for (; The().told_ms < (now_us / 1000U); ++The().told_ms)
    {
        SendAt(The().told_ms + 1U);
    }
    The().bus.Advance(static_cast<host::BusTime>(now_us) * host::kMicrosecond);
}

/// The time that the cycle took, and a line when something changed.
void CycleDone()
{
    Board& board = The();
    rtos::host::Work(kCycleWorkUs);
    const bool is_on = ((board.output.Open() & 1U) != 0U) && (board.application.Command() == 1U);
    const SrdoState state = board.kernel.GetState(CommunicationIndex{0x1301U}).state;
    if ((is_on != board.was_on) || (state != board.was_state))
    {
        std::printf("%3u ms: SRDO 1 %s, output %s\n", static_cast<unsigned>(rtos::TickCount()), NameOf(state),
                    is_on ? "on" : "off");
    }
    board.was_on = is_on;
    board.was_state = state;
}

/// Takes all the time that it can get; the safety task takes it away again each millisecond.
void OtherTask(void* const rounds)
{
    for (;;)
    {
        rtos::host::Work(5000U);
        ++*static_cast<unsigned*>(rounds);
    }
}

/// Works for 3 ms in each 20, above the safety task: what must not be.
void TaskAbove(void* const rounds)
{
    rtos::Tick last = rtos::TickCount();
    for (;;)
    {
        static_cast<void>(rtos::DelayUntil(last, 20U));
        rtos::host::Work(3000U);
        ++*static_cast<unsigned*>(rounds);
    }
}

} // namespace

int main(const int count, char** const words)
{
    const bool is_above = (count > 1) && (std::strcmp(words[1], "above") == 0);
    Board& board = The();
    static_cast<void>(board.can.ConnectPort(CanPortId::kFirst, board.bus, 8U));
    rtos_task::SafetyTaskParts safety{{board.device.Whole(), board.clocks, board.interrupt.queue, ReadMakeContact,
                                       ReadBreakContact, StartWatchdog, CycleDone},
                                      {}};
    unsigned rounds = 0U;
    rtos::CreateTask(rtos::TaskSetup{"safety", rtos::Priority::kSafety, rtos_task::SafetyTask, &safety});
    rtos::CreateTask(is_above ? rtos::TaskSetup{"above", rtos::Priority::kAbove, TaskAbove, &rounds}
                              : rtos::TaskSetup{"other", rtos::Priority::kOther, OtherTask, &rounds});
    rtos::host::SetInterrupt(OnTime);
    rtos::host::Run(kEndUs);

    std::printf("safety task: %u cycles, %u late, %u interrupts in it\n", static_cast<unsigned>(safety.record.cycles),
                static_cast<unsigned>(safety.record.late),
                static_cast<unsigned>(rtos::host::InterruptsIn(rtos::Priority::kSafety)));
    std::printf("safety task preempted by another task: %u times\n",
                static_cast<unsigned>(rtos::host::PreemptionsOf(rtos::Priority::kSafety)));
    const rtos::Priority other = is_above ? rtos::Priority::kAbove : rtos::Priority::kOther;
    std::printf("%s task: %u rounds, preempted %u times, %u interrupts in it\n", is_above ? "higher" : "other", rounds,
                static_cast<unsigned>(rtos::host::PreemptionsOf(other)),
                static_cast<unsigned>(rtos::host::InterruptsIn(other)));
    std::printf("watchdog %s\n", board.watchdog.IsAlive() ? "alive" : "tripped");
    const bool is_running = safety.record.is_started && (board.kernel.DeviceState().fault == DeviceFault::kNone);
    std::printf("device %s, pairs received by the other node: %u\n", is_running ? "running" : "in its safe state",
                board.sender.reports);
    return is_running ? 0 : 1;
}
