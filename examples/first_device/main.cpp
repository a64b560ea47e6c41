// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The device on the host: a simulated bus with a sender of commands, and half a second of simulated time.
#include "device.hpp"

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
#include "names/safety_core/kernel/start_check.hpp"

#include <cstdio>

namespace
{
using namespace counterpoint;

/// What the controllers report goes to the device in the order of the bus.
class Reception final : public host::FrameSink
{
  public:
    void OnFrame(const StampedFrame& frame) override
    {
        device->OnFrame(frame);
    }
    void OnConfirm(const StampedFrame& frame) override
    {
        device->OnConfirm(frame);
    }
    void OnOverflow() override
    {
        device->OnLoss();
    }
    device::Device* device{nullptr};
};

/// The other node: sends the start command, sends pairs as a sensor would, and counts the pairs of the device.
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
    static void StartAll(host::VirtualBus& bus, const host::NodeIndex node)
    {
        static_cast<void>(bus.Submit(node, CanFrame{0U, FrameKind::kData, CanPortId::kFirst, 2U, {1U, 0U}}));
    }
    void Send(host::VirtualBus& bus, const host::NodeIndex node, const std::uint8_t command)
    {
        CanFrame frame{0x101U, FrameKind::kData, CanPortId::kFirst, 1U, {command}};
        static_cast<void>(bus.Submit(node, frame));
        frame.identifier = 0x102U;
        frame.data[0] = static_cast<std::uint8_t>(~command);
        static_cast<void>(bus.Submit(node, frame));
    }
    unsigned reports{0U};
};

/// The hardware on the bench, and the device on it.
struct Bench
{
    host::VirtualBus bus{host::BitRate::k500k};
    host::HostClocks clocks{bus, InstantPair{{1000U}, {70000U}}};
    host::HostWatchdog watchdog{bus};
    host::HostOutput output{bus, watchdog, hal::GateLimit{1500U}};
    Reception reception{};
    host::HostCanPorts can{clocks, reception};
    Sender sender{};
    host::NodeIndex sender_node{bus.Attach(sender, host::NodeSetup{CanPortId::kFirst, 8U})};

    channel_a::StorageFor<2U> storage_a{}; // Two SRDOs.
    channel_b::StorageFor<2U> storage_b{};
    channel_a::Channel a{storage_a.Handle()};
    channel_b::Channel b{storage_b.Handle()};
    first_device::Device application{};
    CauseWindows windows[2]{}; // Since when each cause of each SRDO has been told.
    Kernel kernel{KernelParts{a, b, can, output, watchdog, application, nullptr, &windows[0]}};
    device::AppDevice<first_device::Device, 2U> device{kernel, &can, application}; // Follows NMT.
};

bool PowerOn(Bench& bench)
{
    bench.reception.device = &bench.device.Whole();
    static_cast<void>(bench.can.ConnectPort(CanPortId::kFirst, bench.bus, 8U));
    bench.watchdog.Start(hal::WatchdogWindow{500U, 1600U});
    // Starts the kernel, writes the configuration and sends the boot-up message.
    return bench.device.Whole().PowerOn(bench.clocks.Now().a) == device::LoadResult::kLoaded;
}

/// Why there is no device: its description, or its configuration, which is refused alike when it is written again.
void TellRefusal(Bench& bench)
{
    const StartResult started = bench.device.Started();
    if (started != StartResult::kStarted)
    {
        std::printf("refused: %s %s\n", NameOf(started), MeaningOf(started));
        return;
    }
    const AbortCode abort = first_device::Device::Configure(bench.kernel);
    std::printf("configuration refused, abort code %08X\n", static_cast<unsigned>(abort));
}

/// What happens around the device until the millisecond `ms`, then its cycle.
void Run(Bench& bench, const unsigned ms)
{
    if (((ms % 25U) == 0U) && ((ms < 300U) || (ms > 400U))) // No commands from 300 to 400 ms.
    {
        bench.sender.Send(bench.bus, bench.sender_node, 1U);
    }
    if (ms == 9U)
    {
        Sender::StartAll(bench.bus, bench.sender_node);
    }
    bench.bus.Advance(ms * host::kMillisecond); // Frames and confirmations go to the device from in here.
    const bool is_pressed = ((ms >= 100U) && (ms < 150U)) || (ms >= 450U);
    // A button of two contacts, one for each channel: one closes when it is pressed, one opens.
    const bool make_contact = is_pressed;
    const bool break_contact = !is_pressed;
    const SrdoMask acknowledge_a = make_contact ? 1U : 0U; // Bit 0: slot 0, which is SRDO 1.
    const SrdoMask acknowledge_b = break_contact ? 0U : 1U;
    bench.device.Whole().Cycle(CycleCall{bench.clocks.Now(), acknowledge_a, acknowledge_b});
}

} // namespace

int main()
{
    Bench bench{};
    if (!PowerOn(bench))
    {
        TellRefusal(bench);
        return 1;
    }
    bool was_on = false;
    SrdoState was_state = SrdoState::kOff;
    for (unsigned ms = 1U; ms <= 500U; ++ms)
    {
        Run(bench, ms);
        // The output: the gate must be open, and the command must be to move.
        const bool is_on = ((bench.output.Open() & 1U) != 0U) && (bench.application.Command() == 1U);
        const SrdoState state = bench.kernel.GetState(CommunicationIndex{0x1301U}).state;
        const SrdoCause error = bench.application.TakeError();
        if ((is_on != was_on) || (state != was_state) || (error != SrdoCause::kNone))
        {
            std::printf("%3u ms: SRDO 1 %s, output %s", ms, NameOf(state), is_on ? "on" : "off");
            if (error != SrdoCause::kNone)
            {
                std::printf(", cause %s", NameOf(error));
            }
            std::puts("");
        }
        was_on = is_on;
        was_state = state;
    }
    const bool is_running = bench.kernel.DeviceState().fault == DeviceFault::kNone;
    std::printf("device %s, pairs received by the other node: %u\n", is_running ? "running" : "in its safe state",
                bench.sender.reports);
    return is_running ? 0 : 1;
}
