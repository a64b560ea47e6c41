// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Two CPUs on one bus and one wire. Button 2 is pressed from 300 to 400 ms; at 600 ms the wire is cut.
#include "examples/host/run.hpp"
#include "hal/host/cross_link.hpp"

#include "channel_a/channel.hpp"
#include "channel_b/channel.hpp"
#include "examples/controller/controller.hpp"
#include "examples/host/bench.hpp"
#include "names/safety_core/crosslink/link_config.hpp"
#include "safety_core/crosslink/peer.hpp"

namespace counterpoint::examples
{
namespace
{

/// One CPU: its board, its one channel, its own kernel. CPU A sends the boot-up message of the device.
class Cpu
{
  public:
    Cpu(host::VirtualBus& bus, host::HostWire& wire, const PeerRole role, const Instant start)
        : board{bus, InstantPair{start, start}}, application{role}, wire_{wire},
          end_{(role == PeerRole::kA) ? host::WireEnd::kFirst : host::WireEnd::kSecond}, a_{storage_a_.Handle()},
          b_{storage_b_.Handle()}, peer{(role == PeerRole::kA) ? static_cast<Channel&>(a_) : static_cast<Channel&>(b_),
                                        board.watchdog, application.DescribeLink()},
          kernel{KernelParts{peer.VoiceA(), peer.VoiceB(), board.can, board.output, peer.Watchdog(), application,
                             nullptr, &windows_[0]}},
          device_{kernel, (role == PeerRole::kA) ? &board.can : nullptr, application}
    {
        board.device = &device_.Whole();
        board.peer = &peer;
    }
    [[nodiscard]] bool PowerOn()
    {
        const LinkConfigFault fault = CheckLinkConfig(application.Describe(), application.DescribeLink());
        return (fault == LinkConfigFault::kNone) && board.PowerOn();
    }
    /// Why PowerOn failed; the configuration is refused alike when it is written again.
    [[nodiscard]] std::string Refusal()
    {
        const LinkConfigFault fault = CheckLinkConfig(application.Describe(), application.DescribeLink());
        if (fault != LinkConfigFault::kNone)
        {
            return std::string{"link refused: "} + NameOf(fault) + "\n";
        }
        const StartResult started = device_.Started();
        const bool has_started = started == StartResult::kStarted;
        return RefusalOf(started, has_started ? Controller::Configure(kernel) : AbortCode::kNone);
    }
    void Cycle(const host::BusTime at)
    {
        wire_.SetNow(static_cast<host::LinkInstant>(at / host::kMicrosecond));
        hal::CrossLink& link = wire_.End(end_);
        while (link.Receive(message_) == hal::LinkStatus::kDone)
        {
            const host::BusTime arrived = static_cast<host::BusTime>(wire_.ArrivedAt(end_)) * host::kMicrosecond;
            peer.OnMessage(message_, board.clocks.At(arrived).a);
        }
        const InstantPair now = board.clocks.Now();
        if (peer.Examine(now.a) != LinkFinding::kNone)
        {
            kernel.OnCrossLinkFault();
        }
        device_.Whole().Cycle(CycleCall{now, 0U, 0U});
        peer.Compose(PeerMoment{now.a, kernel.DeviceState().fault}, message_);
        static_cast<void>(link.Send(message_));
    }

    Board board;
    Controller application;

  private:
    host::HostWire& wire_;
    host::WireEnd end_;
    channel_a::StorageFor<2U> storage_a_{};
    channel_b::StorageFor<2U> storage_b_{};
    channel_a::Channel a_;
    channel_b::Channel b_;
    hal::LinkFrame message_{};
    CauseWindows windows_[2U]{};

  public:
    Peer peer;
    Kernel kernel;

  private:
    device::AppDevice<Controller, 2U> device_;
};

} // namespace

std::string RunController()
{
    host::VirtualBus bus{host::BitRate::k500k};
    host::HostWire wire{1U};
    OtherNode others{bus, 0x101U, 0x103U};
    Cpu a{bus, wire, PeerRole::kA, Instant{5000U}};
    Cpu b{bus, wire, PeerRole::kB, Instant{900000U}};
    if (!a.PowerOn())
    {
        return "CPU A: " + a.Refusal();
    }
    if (!b.PowerOn())
    {
        return "CPU B: " + b.Refusal();
    }
    TimeLine line{};
    for (unsigned ms = 1U; ms <= 1000U; ++ms)
    {
        if (ms == 49U)
        {
            others.StartAll();
        }
        if (ms == 600U)
        {
            wire.Faults(host::WireEnd::kFirst).is_cut = true;
            wire.Faults(host::WireEnd::kSecond).is_cut = true;
        }
        if ((ms % 25U) == 0U)
        {
            const bool is_pressed = (ms >= 300U) && (ms < 400U);
            others.Send(TwoBytes{1U, static_cast<std::uint8_t>(is_pressed ? 0U : 1U)});
        }
        const host::BusTime now = ms * host::kMillisecond;
        bus.Advance(now);
        a.Cycle(now);
        bus.Advance(now + (300 * host::kMicrosecond));
        b.Cycle(now + (300 * host::kMicrosecond));
        line.Note(ms, "CPU A " + NameOf(a.kernel.DeviceState()) + ", CPU B " + NameOf(b.kernel.DeviceState()) +
                          ", buttons " + NameOf(a.kernel.GetState(CommunicationIndex{kFirstCommunication}).state) +
                          ", commands " + std::to_string(others.heard.first) + " " +
                          std::to_string(others.heard.second));
    }
    return line.Text() + "pairs " + std::to_string(others.pairs) + ", wrong pairs " + std::to_string(others.wrong) +
           "\n";
}

} // namespace counterpoint::examples
