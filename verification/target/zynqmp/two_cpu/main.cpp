// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// One processor of a device with two: cycles, bus and link by its own clock, and what became of its output, told over
// its UART. Channel A's processor plays the sensor as well. The runner lays an order into the OCM: which memory one of
// the processors changes behind the back of its program, in its 40th cycle. [SRS_ZYN_013, SRS_ZYN_014, SRS_ZYN_015]
#include "safety_core/kernel/limits.hpp"
#include "verification/target/target.hpp"
#include "verification/target/zynqmp/two_cpu/board.hpp"
#include "verification/target/zynqmp/two_cpu/core.hpp"
#include "verification/target/zynqmp/two_cpu/own_channel.hpp"

extern "C"
{
    std::uint32_t TargetMain() noexcept;
    /// What the runner reads of a processor that no longer tells anything: when its output was driven last.
    volatile std::uint32_t two_cpu_driven;
}

namespace counterpoint::two_cpu
{
namespace
{
using target::Write;
using target::WriteNumber;

constexpr std::uint32_t kOrderCycle = 40U;
constexpr std::uint32_t kLastCycle = 72U;
constexpr std::uint32_t kFirstPairUs = 400000U;

/// What the runner wants changed.
struct Order
{
    std::uint32_t role;    ///< PeerRole of the processor that does it. 0: nobody.
    std::uint32_t address; ///< Of a byte.
    std::uint32_t bits;    ///< Of it, which flip. 0: the processor stands still instead.
    std::uint32_t is_done;
};

volatile Order& TheOrder() noexcept
{
    return *reinterpret_cast<volatile Order*>(0xFFFDE000U);
}

Core& Self() noexcept
{
    static Core core;
    return core;
}

void Tell(const char* const name, const std::uint32_t value) noexcept
{
    Write(" ");
    Write(name);
    Write("=");
    WriteNumber(value);
}

class Executive
{
  public:
    [[nodiscard]] std::uint32_t Run() noexcept;

  private:
    void Listen() noexcept;
    void SendOut() noexcept;
    void Sense() noexcept;
    void OneCycle() noexcept;
    void Watch() noexcept;
    void ObeyOrder() noexcept;
    void NoteOrder() noexcept;
    [[nodiscard]] Instant Look() noexcept;
    [[nodiscard]] bool IsDue(const Instant at) noexcept
    {
        return (Look().us - at.us) < 0x80000000U;
    }

    bool is_a_{OwnRole() == PeerRole::kA};
    hal::LinkFrame message_{};
    Instant next_cycle_{0U};
    Instant next_pair_{0U};
    std::uint32_t cycles_{0U};
    std::uint32_t value_{0x5100U};
    std::uint32_t own_frames_[2]{};  ///< Of the own pair, 103h and 104h: sent by this processor,
    std::uint32_t peer_frames_[2]{}; ///< and by the other one.
    bool is_operational_{false};
    bool is_open_{false};
    bool is_noted_{false};
    Instant looked_{0U};
};

Instant Executive::Look() noexcept
{
    const Instant now = Now();
    looked_ = now;
    return now;
}

void Executive::SendOut() noexcept
{
    CanFrame frame{};
    while (TakeSent(frame)) // At most what Ports took.
    {
        if ((frame.identifier == 0x103U) || (frame.identifier == 0x104U))
        {
            ++own_frames_[frame.identifier - 0x103U];
        }
        Self().OnBus(frame, true, Look());
    }
}

void Executive::Listen() noexcept
{
    if (Link().Receive(message_) == hal::LinkStatus::kDone)
    {
        Self().peer.OnMessage(message_, Look());
    }
    CanFrame frame{};
    if (ReceiveFrame(frame))
    {
        if ((frame.identifier == 0x103U) || (frame.identifier == 0x104U))
        {
            ++peer_frames_[frame.identifier - 0x103U];
        }
        Self().OnBus(frame, false, Look());
    }
    SendOut();
}

/// A pair of the sensor, to the bus and, as a controller does not hear itself, to this processor.
void Executive::Sense() noexcept
{
    value_ = (value_ + 0x0101U) & 0xFFFFU;
    for (std::uint32_t half = 0U; half < 2U; ++half)
    {
        const std::uint32_t bits = (half == 0U) ? value_ : ~value_;
        CanFrame frame{};
        frame.identifier = 0x101U + half;
        frame.kind = FrameKind::kData;
        frame.port = CanPortId::kFirst;
        frame.length_bytes = 2U;
        frame.data[0] = static_cast<std::uint8_t>(bits);
        frame.data[1] = static_cast<std::uint8_t>(bits >> 8U);
        CanFrame sent{};
        if (Ports().Transmit(frame) == hal::TransmitStatus::kAccepted)
        {
            static_cast<void>(TakeSent(sent));
            Self().OnBus(frame, false, Look());
        }
    }
}

void Executive::OneCycle() noexcept
{
    // In contact, as a start command of the network would reach both.
    if ((!is_operational_) && Self().peer.Link().IsAlive())
    {
        is_operational_ = true;
        Self().OnBus(kStartCommand, false, Look());
    }
    const Instant now = Look();
    Self().Cycle(now, message_);
    two_cpu_driven = now.us;
    static_cast<void>(Link().Send(message_));
    ++cycles_;
    if (cycles_ == kOrderCycle)
    {
        ObeyOrder();
    }
    SendOut();
}

void Executive::ObeyOrder() noexcept
{
    volatile Order& order = TheOrder();
    if (order.role != static_cast<std::uint32_t>(OwnRole()))
    {
        return;
    }
    NoteOrder();
    order.is_done = 1U;
    if (order.bits == 0U)
    {
        for (;;)
        {
            asm volatile("wfi"); // A loop that never sleeps would keep the emulator from running the other processor.
        }
    }
    auto& byte = *reinterpret_cast<volatile std::uint8_t*>(order.address);
    byte = static_cast<std::uint8_t>(byte ^ order.bits);
}

/// When the order was carried out, by this processor's clock: of the last look before it was seen, so not later.
void Executive::NoteOrder() noexcept
{
    is_noted_ = true;
    Write("order");
    Tell("at", looked_.us);
    Write("\n");
}

void Executive::Watch() noexcept
{
    if ((!is_noted_) && (TheOrder().is_done != 0U))
    {
        NoteOrder();
    }
    const Instant now = Look();
    const bool is_open = Self().IsOpen(now);
    if (is_open != is_open_)
    {
        Write(is_open ? "open" : "closed");
        Tell("at", now.us);
        Write("\n");
    }
    is_open_ = is_open;
}

std::uint32_t Executive::Run() noexcept
{
    if (!StartBoard() || !Self().PowerOn(Look()))
    {
        Write("FAILURE: it does not start\n");
        return 1U;
    }
    Write("limits");
    Tell("link", Self().LimitOfLink());
    Tell("channel", Self().LimitOf(FaultClass::kChannel));
    Tell("configuration", Self().LimitOf(FaultClass::kConfiguration));
    Tell("gate", kCycleUs + kToleranceUs);
    Write("\n");
    next_cycle_ = Look();
    next_pair_ = Instant{next_cycle_.us + kFirstPairUs};
    while (cycles_ < kLastCycle)
    {
        Listen();
        if (is_a_ && IsDue(next_pair_))
        {
            Sense();
            next_pair_.us += kRefreshUs;
        }
        if (IsDue(next_cycle_))
        {
            OneCycle();
            next_cycle_.us += kCycleUs;
        }
        Watch();
        LetOthersRun();
    }
    const Core& core = Self();
    Write("cpu");
    Tell("open", is_open_ ? 1U : 0U);
    Tell("fault", static_cast<std::uint32_t>(core.kernel.DeviceState().fault));
    Tell("finding", static_cast<std::uint32_t>(core.peer.Link().Finding()));
    Tell("received", core.application.received);
    Tell("sent", core.application.sent);
    Tell("own103", own_frames_[0]);
    Tell("own104", own_frames_[1]);
    Tell("peer103", peer_frames_[0]);
    Tell("peer104", peer_frames_[1]);
    Tell("taken", core.peer.Link().Counts().taken);
    Tell("corrupt", core.peer.Link().Counts().corrupt);
    Write("\n");
    return 0U;
}

} // namespace
} // namespace counterpoint::two_cpu

extern "C" std::uint32_t TargetMain() noexcept
{
    static counterpoint::two_cpu::Executive executive;
    return executive.Run();
}
