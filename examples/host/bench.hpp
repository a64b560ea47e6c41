// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_HOST_BENCH_HPP
#define EXAMPLES_HOST_BENCH_HPP

#include "canopen/device/app_device.hpp"
#include "channel_a/channel.hpp"
#include "channel_b/channel.hpp"
#include "hal/host/can_ports.hpp"
#include "hal/host/clocks.hpp"
#include "hal/host/output.hpp"
#include "hal/host/virtual/bus.hpp"
#include "hal/host/watchdog.hpp"
#include "names/safety_core/contract/device_fault.hpp"
#include "names/safety_core/contract/srdo.hpp"
#include "safety_core/crosslink/peer.hpp"
#include "safety_core/kernel/kernel.hpp"
#include "safety_core/kernel/start_check.hpp"

#include <cstdint>
#include <string>

namespace counterpoint::examples
{

/// The hardware of one device on a simulated bus. Two-CPU devices have two.
class Board final : public host::FrameSink
{
  public:
    Board(host::VirtualBus& bus, const InstantPair& start)
        : clocks{bus, start}, watchdog{bus}, output{bus, watchdog, hal::GateLimit{1500U}}, can{clocks, *this}
    {
        static_cast<void>(can.ConnectPort(CanPortId::kFirst, bus, 8U));
    }
    /// The other CPU's half of a pair of this device is a confirmation.
    void OnFrame(const StampedFrame& frame) override
    {
        if ((peer != nullptr) && peer->IsEcho(frame.frame))
        {
            device->OnConfirm(frame);
        }
        else
        {
            device->OnFrame(frame);
        }
    }
    void OnConfirm(const StampedFrame& frame) override
    {
        device->OnConfirm(frame);
    }
    void OnOverflow() override
    {
        device->OnLoss();
    }
    /// @brief Starts the watchdog and the device, which sends its boot-up message. False: something was refused.
    [[nodiscard]] bool PowerOn()
    {
        watchdog.Start(hal::WatchdogWindow{500U, 1600U});
        return device->PowerOn(clocks.Now().a) == device::LoadResult::kLoaded;
    }

    host::HostClocks clocks;
    host::HostWatchdog watchdog;
    host::HostOutput output;
    host::HostCanPorts can;
    device::Device* device{nullptr};
    const Peer* peer{nullptr}; ///< With two CPUs.
};

/// @brief What a run prints of a device that did not start: what its description has wrong, or, of a kernel that
/// started, with which abort code it refuses the configuration. [SRS_EASE_007]
[[nodiscard]] std::string RefusalOf(StartResult started, AbortCode configured);

/// A device of one CPU on its board.
template <class App, std::uint8_t kSrdos> struct BenchDevice
{
    BenchDevice(host::VirtualBus& bus, const InstantPair& start) : board{bus, start}
    {
        board.device = &device.Whole();
    }
    /// @brief The acknowledge levels of channel A and of channel B, each from a reading of its own.
    void Cycle(const SrdoMask acknowledge_a, const SrdoMask acknowledge_b)
    {
        device.Whole().Cycle(CycleCall{board.clocks.Now(), acknowledge_a, acknowledge_b});
    }

    /// @brief Why PowerOn of the board failed; the configuration is refused alike when it is written again.
    [[nodiscard]] std::string Refusal()
    {
        const StartResult started = device.Started();
        const bool has_started = started == StartResult::kStarted;
        return RefusalOf(started, has_started ? App::Configure(kernel) : AbortCode::kNone);
    }

    Board board;
    App application{};
    channel_a::StorageFor<kSrdos> storage_a{};
    channel_b::StorageFor<kSrdos> storage_b{};
    channel_a::Channel a{storage_a.Handle()};
    channel_b::Channel b{storage_b.Handle()};
    CauseWindows windows[kSrdos]{};
    Kernel kernel{KernelParts{a, b, board.can, board.output, board.watchdog, application, nullptr, &windows[0]}};
    device::AppDevice<App, kSrdos> device{kernel, &board.can, application};
};

/// Data of two mapped bytes.
struct TwoBytes
{
    std::uint8_t first;
    std::uint8_t second;
};

/// Everything else on the bus: sends the start command, sends pairs with its first identifier, keeps the last complete
/// pair with its second one.
class OtherNode final : public host::BusListener
{
  public:
    OtherNode(host::VirtualBus& bus, std::uint32_t sends, std::uint32_t hears)
        : bus_{bus}, sends_{sends}, hears_{hears}, node_{bus.Attach(*this, host::NodeSetup{CanPortId::kFirst, 8U})}
    {
    }
    void OnReceived(const CanFrame& frame, host::BusTime at) override;
    void OnConfirmed(const CanFrame& /*frame*/, host::BusTime /*at*/) override
    {
    }
    /// @brief NMT: all nodes to OPERATIONAL.
    void StartAll();
    void Send(const TwoBytes& data);

    TwoBytes heard{0U, 0U};
    unsigned pairs{0U};
    unsigned wrong{0U}; ///< Inverse frames that do not fit the frame before.

  private:
    host::VirtualBus& bus_;
    std::uint32_t sends_;
    std::uint32_t hears_;
    host::NodeIndex node_;
    CanFrame normal_{};
};

/// Prints a line of the time line only where it differs from the one before.
class TimeLine
{
  public:
    void Note(unsigned ms, const std::string& line);
    [[nodiscard]] const std::string& Text() const
    {
        return text_;
    }

  private:
    std::string last_{};
    std::string text_{};
};

/// @brief "running", or the DeviceFault.
[[nodiscard]] std::string NameOf(const DeviceFaultReport& report);

} // namespace counterpoint::examples

#endif
