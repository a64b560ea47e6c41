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
    /// What the runner reads of a processor that no longer tells anything: when its watchdog was served last, or later.
    volatile std::uint32_t two_cpu_served;
}

namespace counterpoint::two_cpu
{
namespace
{
using target::Write;
using target::WriteNumber;

constexpr std::uint32_t kOrderCycle = 40U;
constexpr std::uint32_t kLastCycle = 72U;
constexpr std::uint32_t kFirstPairUs = 100000U;
/// What the queue of the port has room for, and a loss.
constexpr std::uint32_t kMostFrames = 129U;

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
    InstantPair TakeFrames() noexcept;
    void Deliver(const zynqmp::QueuedFrame& queued) noexcept;
    void Sense() noexcept;
    void OneCycle() noexcept;
    void Watch() noexcept;
    void ObeyOrder() noexcept;
    void NoteOrder() noexcept;
    void TellEnd() const noexcept;
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
    std::uint32_t losses_{0U};
};

Instant Executive::Look() noexcept
{
    const Instant now = OwnClock(OwnBoard().Clocks().Now()).a;
    looked_ = now;
    return now;
}

void Executive::Deliver(const zynqmp::QueuedFrame& queued) noexcept
{
    const bool is_confirmed = queued.kind == zynqmp::QueuedKind::kConfirmed;
    const StampedFrame frame{queued.frame.frame, OwnClock(queued.frame.stamp)};
    const std::uint32_t identifier = frame.frame.identifier;
    if ((!is_confirmed) && (queued.kind != zynqmp::QueuedKind::kReceived))
    {
        ++losses_;
        Self().OnLoss();
        return;
    }
    if ((identifier == 0x103U) || (identifier == 0x104U))
    {
        std::uint32_t& count = is_confirmed ? own_frames_[identifier - 0x103U] : peer_frames_[identifier - 0x103U];
        ++count;
    }
    // On a bus an answer ends at least this much later than the frame; on the emulator both end at once.
    for (std::uint32_t turn = 0U; (!is_confirmed) && (turn < kFrameUs) && ((Look().us - frame.stamp.a.us) < kFrameUs);
         ++turn)
    {
        LetOthersRun();
    }
    // The sensor's frames leave by the controller of processor 0; to the device they are another node's.
    const bool is_own = is_confirmed && (identifier >= 0x103U);
    Self().OnBus(frame, is_own, Look());
}

/// The moment up to which everything has been delivered: no frame was, or had to be served, after it.
InstantPair Executive::TakeFrames() noexcept
{
    InstantPair now = OwnBoard().Look();
    zynqmp::QueuedFrame queued = OwnBoard().NextFrame();
    for (std::uint32_t taken = 0U; (taken < kMostFrames) && (queued.kind != zynqmp::QueuedKind::kNothing); ++taken)
    {
        Deliver(queued);
        now = OwnBoard().Look();
        queued = OwnBoard().NextFrame();
    }
    return now;
}

void Executive::Listen() noexcept
{
    if (Link().Receive(message_) == hal::LinkStatus::kDone)
    {
        Self().peer.OnMessage(message_, Look());
    }
    static_cast<void>(TakeFrames());
}

/// A pair of the sensor, to the bus.
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
        static_cast<void>(OwnBoard().Can().Transmit(frame));
    }
}

void Executive::OneCycle() noexcept
{
    if (OwnBoard().BeginCycle() != zynqmp::BoardFault::kNone)
    {
        return; // All is closed, and the watchdog is served no more.
    }
    const InstantPair now = OwnClock(TakeFrames());
    // In contact, as a start command of the network would reach both.
    if ((!is_operational_) && Self().peer.Link().IsAlive())
    {
        is_operational_ = true;
        Self().OnBus(StampedFrame{kStartCommand, now}, false, now.a);
    }
    Self().Cycle(now, message_);
    two_cpu_served = Look().us;
    static_cast<void>(Link().Send(message_));
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
        StopTimer();
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
    const bool is_open = IsPinHigh();
    const Instant now = Look();
    if (is_open != is_open_)
    {
        Write(is_open ? "open" : "closed");
        Tell("at", now.us);
        Write("\n");
    }
    is_open_ = is_open;
}

void Executive::TellEnd() const noexcept
{
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
    Tell("losses", losses_);
    Tell("board", static_cast<std::uint32_t>(OwnBoard().Fault()));
    Write("\n");
}

std::uint32_t Executive::Run() noexcept
{
    const bool is_up = StartBoard() && Self().PowerOn(Look());
    if (!is_up || (OwnBoard().StartWatchdog() != zynqmp::Outcome::kDone))
    {
        Write("FAILURE: it does not start, board fault");
        Tell("board", static_cast<std::uint32_t>(OwnBoard().Fault()));
        Write("\n");
        return 1U;
    }
    Write("limits");
    Tell("link", Self().LimitOfLink());
    Tell("channel", Self().LimitOf(FaultClass::kChannel));
    Tell("configuration", Self().LimitOf(FaultClass::kConfiguration));
    Tell("watchdog", WatchdogPeriodUs());
    Write("\n");
    // The first answer comes a cycle after the start of the watchdog.
    next_cycle_ = Instant{Look().us + kCycleUs};
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
            ++cycles_;
            if (cycles_ == kOrderCycle)
            {
                ObeyOrder();
            }
        }
        Watch();
        // What was sent is confirmed before the other processor can answer.
        static_cast<void>(OwnBoard().Look());
        LetOthersRun();
    }
    StopTimer();
    TellEnd();
    return 0U;
}

} // namespace
} // namespace counterpoint::two_cpu

extern "C" std::uint32_t TargetMain() noexcept
{
    static counterpoint::two_cpu::Executive executive;
    return executive.Run();
}
