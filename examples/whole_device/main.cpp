// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The device on the host: a simulated bus with one other node, which is SDO client, NMT master and safety controller in
// one, and one second of simulated time.
#include "device.hpp"

#include "hal/host/can_ports.hpp"
#include "hal/host/clocks.hpp"
#include "hal/host/file_parameter_memory.hpp"
#include "hal/host/output.hpp"
#include "hal/host/virtual/bus.hpp"
#include "hal/host/watchdog.hpp"

#include <cstdio>
#include <exception>

namespace
{
using namespace counterpoint;

constexpr const char* kStore = "whole_device.store";
constexpr std::uint32_t kBankBytes = 4096U;
constexpr std::uint32_t kEmergency = 0x80U + dictionary::kNodeId;
constexpr std::uint32_t kSpeed = 0x180U + dictionary::kNodeId;
constexpr std::uint32_t kSetpoint = 0x200U + dictionary::kNodeId;
constexpr std::uint32_t kAnswer = 0x580U + dictionary::kNodeId;
constexpr std::uint32_t kRequest = 0x600U + dictionary::kNodeId;
constexpr std::uint32_t kHeartbeat = 0x700U + dictionary::kNodeId;
constexpr std::uint32_t kSave = 0x65766173U; ///< "save"

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

std::uint32_t NumberIn(const CanFrame& frame, const unsigned first, const unsigned bytes)
{
    std::uint32_t number = 0U;
    for (unsigned byte = 0U; byte < bytes; ++byte)
    {
        number |= static_cast<std::uint32_t>(frame.data[first + byte]) << (8U * byte);
    }
    return number;
}

/// Everything else on the bus.
class OtherNode final : public host::BusListener
{
  public:
    explicit OtherNode(host::VirtualBus& bus)
        : bus_{bus}, node_{bus.Attach(*this, host::NodeSetup{CanPortId::kFirst, 8U})}
    {
    }
    void OnReceived(const CanFrame& frame, const host::BusTime at) override
    {
        const unsigned ms = static_cast<unsigned>(at / host::kMillisecond);
        if (frame.identifier == kAnswer)
        {
            TellAnswer(ms, frame);
        }
        else if (frame.identifier == kEmergency)
        {
            std::printf("%4u ms: emergency %04lXh\n", ms, static_cast<unsigned long>(NumberIn(frame, 0U, 2U)));
        }
        else if (frame.identifier == kSpeed)
        {
            speed = NumberIn(frame, 0U, 2U);
        }
        else if ((frame.identifier == kHeartbeat) && (frame.data[0] != state))
        {
            state = frame.data[0];
            std::printf("%4u ms: NMT state %u\n", ms, state);
        }
    }
    void OnConfirmed(const CanFrame& /*frame*/, host::BusTime /*at*/) override
    {
    }
    void StartAll()
    {
        Submit(CanFrame{0U, FrameKind::kData, CanPortId::kFirst, 2U, {1U, 0U}});
    }
    void Read(const std::uint16_t index, const std::uint8_t sub)
    {
        Ask(0x40U, index, sub, 0U);
    }
    /// Of `bytes` bytes, 1 to 4.
    void Write(const std::uint16_t index, const std::uint8_t sub, const std::uint8_t bytes, const std::uint32_t value)
    {
        Ask(static_cast<std::uint8_t>(0x23U | ((4U - bytes) << 2U)), index, sub, value);
    }
    void Pair(const std::uint8_t command)
    {
        Submit(CanFrame{0x101U, FrameKind::kData, CanPortId::kFirst, 1U, {command}});
        Submit(CanFrame{0x102U, FrameKind::kData, CanPortId::kFirst, 1U, {static_cast<std::uint8_t>(~command)}});
    }
    void SetSpeed(const std::uint8_t value)
    {
        Submit(CanFrame{kSetpoint, FrameKind::kData, CanPortId::kFirst, 2U, {value, 0U}});
    }

    std::uint32_t speed{0U};
    std::uint8_t state{0xFFU};

  private:
    static void TellAnswer(const unsigned ms, const CanFrame& frame)
    {
        std::printf("%4u ms: SDO %02X%02Xh:%02X ", ms, frame.data[2], frame.data[1], frame.data[3]);
        const auto number = static_cast<unsigned long>(NumberIn(frame, 4U, 4U));
        if (frame.data[0] == 0x60U)
        {
            std::puts("written");
        }
        else if (frame.data[0] == 0x80U)
        {
            std::printf("refused, abort code %08lXh\n", number);
        }
        else
        {
            std::printf("is %lu\n", number);
        }
    }
    void Ask(const std::uint8_t command, const std::uint16_t index, const std::uint8_t sub, const std::uint32_t value)
    {
        CanFrame frame{kRequest, FrameKind::kData, CanPortId::kFirst, 8U, {command}};
        frame.data[1] = static_cast<std::uint8_t>(index);
        frame.data[2] = static_cast<std::uint8_t>(index >> 8U);
        frame.data[3] = sub;
        for (unsigned byte = 0U; byte < 4U; ++byte)
        {
            frame.data[4U + byte] = static_cast<std::uint8_t>(value >> (8U * byte));
        }
        Submit(frame);
    }
    void Submit(const CanFrame& frame)
    {
        static_cast<void>(bus_.Submit(node_, frame));
    }

    host::VirtualBus& bus_;
    host::NodeIndex node_;
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
    host::FileParameterMemory memory{kStore, kBankBytes};
    OtherNode other{bus};
    whole_device::Device device{whole_device::Hardware{can, output, watchdog, memory}};
};

bool PowerOn(Bench& bench)
{
    bench.watchdog.Start(hal::WatchdogWindow{500U, 1600U});
    return bench.device.Whole().PowerOn(bench.clocks.Now().a) == device::LoadResult::kLoaded;
}

/// What the other node does in this millisecond.
void Act(OtherNode& other, const unsigned ms)
{
    const bool sends_pairs = (ms >= 200U) && (ms <= 500U);
    switch (ms)
    {
    case 10U:
        other.Read(0x1018U, 2U);
        break;
    case 20U:
        other.Read(0x2012U, 0U);
        break;
    case 30U:
        other.Write(0x2012U, 0U, 2U, 20U);
        break;
    case 40U:
        other.Write(0x1010U, 1U, 4U, kSave);
        break;
    case 180U:
        other.StartAll();
        break;
    case 190U:
        other.Write(0x1301U, 2U, 2U, 100U); // SCT: not in OPERATIONAL.
        break;
    case 300U:
        other.SetSpeed(200U);
        break;
    case 700U:
        other.Read(0x2012U, 0U);
        break;
    default:
        break;
    }
    if (sends_pairs && ((ms % 25U) == 0U))
    {
        other.Pair(1U);
    }
}

void Run(Bench& bench, const unsigned ms)
{
    Act(bench.other, ms);
    bench.bus.Advance(ms * host::kMillisecond); // Frames and confirmations go to the device from in here.
    // A button of two contacts, one for each channel: one closes when it is pressed, one opens.
    const bool is_pressed = (ms >= 250U) && (ms < 280U);
    const bool make_contact = is_pressed;
    const bool break_contact = !is_pressed;
    constexpr SrdoMask kSlot = SrdoMask{1U} << dictionary::kSrdo1Slot;
    bench.device.Cycle(CycleCall{bench.clocks.Now(), make_contact ? kSlot : 0U, break_contact ? 0U : kSlot});
    whole_device::Drive::Cycle(bench.output.Open());
}

int RunBench()
{
    static_cast<void>(std::remove(kStore));
    Bench bench{};
    bench.reception.device = &bench.device.Whole();
    static_cast<void>(bench.can.ConnectPort(CanPortId::kFirst, bench.bus, 8U));
    bool is_up = PowerOn(bench);
    std::uint32_t told = 0U;
    for (unsigned ms = 1U; (ms <= 800U) && is_up; ++ms)
    {
        Run(bench, ms);
        if (ms == 600U)
        {
            bench.device.Whole().PowerOff();
            std::printf("%4u ms: power off and on\n", ms);
            is_up = PowerOn(bench);
        }
        const std::uint32_t speed = bench.other.speed;
        if ((speed != told) && ((speed == 200U) || (speed == 0U) || (told == 0U)))
        {
            std::printf("%4u ms: speed %lu by PDO\n", ms, static_cast<unsigned long>(speed));
        }
        told = speed;
    }
    std::puts(is_up ? "device running" : "device not started");
    return is_up ? 0 : 1;
}

} // namespace

int main()
{
    try
    {
        return RunBench();
    }
    catch (const std::exception& problem)
    {
        std::fprintf(stderr, "whole_device: %s\n", problem.what()); // The store cannot be made here.
        return 2;
    }
}
