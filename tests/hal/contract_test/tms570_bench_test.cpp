// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The contract test on the drivers of the TMS570, as they are in the image, on their register models.
#include "hal/contract_test/contract_test.hpp"
#include "tests/hal/contract_test/report.hpp"
#include "tests/hal/tms570/rig.hpp"
#include "verification/trace/ids/hal.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::tms570
{
namespace
{

namespace contract = hal::contract;

/// A board on its models, and what happens around it.
class Bench
{
  public:
    Bench()
    {
        Restart();
    }

    void Restart()
    {
        rig.reset();
        rig.emplace();
        peer_.clear();
        is_held = false;
        is_shorted = false;
        interrupts_held = false;
        is_started = rig->Start().answer == StartAnswer::kStarted;
        is_started = is_started && (rig->board.StartWatchdog() == Outcome::kDone);
        left_us_ = 0U;
    }
    /// Time in steps, so that a frame ends and is served as on a bus; the port's own duty comes once a cycle.
    void Pass(const std::uint32_t us)
    {
        for (std::uint32_t passed = 0U; passed < us; passed += kStepUs)
        {
            rig->machine.Advance(kStepUs);
            EndOneFrame();
            if (!is_shorted)
            {
                rig->machine.dcan1.Recover();
            }
            TakeInterrupts();
        }
        left_us_ += us;
        if (left_us_ >= 900U)
        {
            left_us_ = 0U;
            static_cast<void>(rig->board.BeginCycle());
        }
    }
    void TakeInterrupts()
    {
        if (!interrupts_held)
        {
            rig->TakeInterrupts();
        }
    }
    void Send(const CanFrame& frame)
    {
        peer_.push_back(frame);
    }

    std::optional<Rig> rig{}; ///< In one place, whatever restarts.
    bool is_started{false};
    bool is_held{false};
    bool is_shorted{false};
    bool interrupts_held{false};
    std::string text{};

  private:
    static constexpr std::uint32_t kStepUs = 100U;

    void EndOneFrame()
    {
        if (!peer_.empty())
        {
            static_cast<void>(rig->machine.dcan1.Receive(peer_.front()));
            peer_.pop_front();
        }
        else if (!is_held)
        {
            static_cast<void>(rig->machine.dcan1.Transmit());
        }
    }

    std::deque<CanFrame> peer_{};
    std::uint32_t left_us_{0U};
};

Bench& Of(void* const bench)
{
    return *static_cast<Bench*>(bench);
}

contract::PortEvent Next(void* const bench)
{
    const QueuedFrame queued = Of(bench).rig->board.NextFrame();
    switch (queued.kind)
    {
    case QueuedKind::kReceived:
        return contract::PortEvent{contract::EventKind::kReceived, queued.frame};
    case QueuedKind::kConfirmed:
        return contract::PortEvent{contract::EventKind::kConfirmed, queued.frame};
    case QueuedKind::kNothing:
        return contract::PortEvent{contract::EventKind::kNothing, queued.frame};
    case QueuedKind::kInvalid:
    case QueuedKind::kLoss:
    default:
        return contract::PortEvent{contract::EventKind::kLoss, queued.frame};
    }
}

/// Frames end 100 us apart here.
contract::PortUnderTest TableOf(Bench& bench)
{
    contract::PortUnderTest port{};
    port.parts.can = &bench.rig->board.Can();
    port.parts.clocks = &bench.rig->board.Clocks();
    port.parts.output = &bench.rig->board.Output();
    port.parts.cut_off = &bench.rig->board.Output();
    port.parts.watchdog = &bench.rig->board.Watchdog();
    port.parts.protection = &bench.rig->board.Protection();
    port.bench.bench = &bench;
    port.bench.write = [](void* self, const char* text) { Of(self).text += text; };
    port.bench.next = Next;
    port.bench.pass = [](void* self, std::uint32_t us) { Of(self).Pass(us); };
    port.bench.restart = [](void* self) { Of(self).Restart(); };
    port.bench.peer_send = [](void* self, const CanFrame& frame)
    {
        Of(self).Send(frame);
        return frame.kind == FrameKind::kData;
    };
    // The watchdog's reset makes the pins inputs and ends the program; the bench goes on as if nothing could follow.
    port.bench.pins = [](void* self)
    {
        model::Machine& machine = Of(self).rig->machine;
        return SrdoMask{machine.rti.HasBitten() ? 0U : machine.gio.PinsA()};
    };
    port.bench.is_alive = [](void* self) { return !Of(self).rig->machine.rti.HasBitten(); };
    port.bench.hold_bus = [](void* self, contract::Hold hold) { Of(self).is_held = hold == contract::Hold::kHeld; };
    port.bench.bus_off = [](void* self, contract::Hold hold)
    {
        Of(self).is_shorted = hold == contract::Hold::kHeld;
        if (Of(self).is_shorted)
        {
            Of(self).rig->machine.dcan1.GoBusOff();
        }
    };
    port.bench.hold_interrupt = [](void* self, contract::Hold hold)
    {
        Of(self).interrupts_held = hold == contract::Hold::kHeld;
        Of(self).TakeInterrupts();
    };
    port.numbers = contract::PortNumbers{{{kNormal, CanPortId::kFirst}, {kInverse, CanPortId::kFirst}},
                                         {{kSentNormal, CanPortId::kFirst}, {kSentInverse, CanPortId::kFirst}},
                                         0x133U,
                                         1U,
                                         64U,
                                         2U,
                                         280U,
                                         20U,
                                         1000U,
                                         1200U,
                                         hal::WatchdogWindow{500U, 1500U},
                                         0U,
                                         0U};
    return port;
}

TEST(Tms570Contract, DriversKeepIt)
{
    Verifies(req::SRS_HAL_030);
    Verifies(req::SRS_HAL_340);
    Bench bench;
    ASSERT_TRUE(bench.is_started);
    static_cast<void>(contract::RunContractTest(TableOf(bench)));
    EXPECT_EQ(contract::LinesWith(bench.text, ": broken: "), std::vector<std::string>{}) << bench.text;
    // What these models cannot bring about is not shown.
    EXPECT_EQ(contract::LinesWith(bench.text, " held, "), std::vector<std::string>{"35 held, 0 broken, 9 not shown"});
}

} // namespace
} // namespace counterpoint::tms570
