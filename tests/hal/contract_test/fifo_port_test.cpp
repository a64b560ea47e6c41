// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The port to the made-up controller of examples/port_fifo, on a model of its registers.
#include "can.hpp"
#include "hal/contract_test/contract_test.hpp"
#include "pins.hpp"
#include "tests/hal/contract_test/fifo_model.hpp"
#include "tests/hal/contract_test/report.hpp"
#include "verification/trace/ids/hal.hpp"
#include "verification/trace/verifies.hpp"
#include "watchdog.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace port_fifo
{
namespace
{

namespace contract = counterpoint::hal::contract;
using counterpoint::CanFrame;
using counterpoint::CanPortId;
using counterpoint::FrameKind;
using counterpoint::SrdoMask;
using counterpoint::Verifies;
namespace req = counterpoint::req;

constexpr std::uint16_t kAccepted[]{0x121U, 0x122U};

/// What the image of a board would have, with the model in the place of the silicon.
struct Board
{
    Board()
    {
        model.interrupt = [this] { can.OnInterrupt(); };
        pins.Start();
        is_started = can.Start(FilterList{kAccepted, 2U});
    }

    FifoModel model{};
    Clocks clocks{};
    Can can{clocks};
    Pins pins{clocks, counterpoint::hal::GateLimit{1500U}};
    Watchdog watchdog{};
    bool is_started{false};
    std::string text{};
};

Board& Of(void* const bench)
{
    return *static_cast<Board*>(bench);
}

void Hold(bool& what, const contract::Hold hold)
{
    what = hold == contract::Hold::kHeld;
}

contract::PortBench BenchOf(Board& board)
{
    contract::PortBench bench{};
    bench.bench = &board;
    bench.write = [](void* self, const char* text) { Of(self).text += text; };
    bench.next = [](void* self)
    {
        const CanEvent event = Of(self).can.Next();
        return contract::PortEvent{static_cast<contract::EventKind>(event.kind), event.frame};
    };
    bench.pass = [](void* self, std::uint32_t us)
    {
        Of(self).model.Advance(us);
        Of(self).pins.Examine();
    };
    bench.restart = [](void* self)
    {
        Of(self).model.Restart();
        Of(self).pins.Start();
    };
    bench.peer_send = [](void* self, const CanFrame& frame)
    {
        Of(self).model.Send(frame);
        return true;
    };
    bench.pins = [](void* self) { return SrdoMask{Of(self).model.Pins()}; };
    bench.hold_bus = [](void* self, contract::Hold hold) { Hold(Of(self).model.bus_held, hold); };
    bench.hold_interrupt = [](void* self, contract::Hold hold)
    {
        Hold(Of(self).model.interrupt_masked, hold);
        if (hold == contract::Hold::kReleased)
        {
            Of(self).can.OnInterrupt();
        }
    };
    bench.hold_counter = [](void* self, contract::Counter counter, contract::Hold hold)
    { Hold((counter == contract::Counter::kB) ? Of(self).model.b_held : Of(self).model.a_held, hold); };
    bench.hold_pin = [](void* self, contract::Hold hold) { Hold(Of(self).model.pin_held, hold); };
    bench.read_back = [](void* /*self*/) { return SrdoMask{Pins::ReadBack()}; };
    bench.is_alive = [](void* self) { return Of(self).model.IsAlive(); };
    bench.peer_take = [](void* self, CanFrame& frame)
    {
        std::deque<CanFrame>& seen = Of(self).model.seen_by_peer;
        if (seen.empty())
        {
            return false;
        }
        frame = seen.front();
        seen.pop_front();
        return true;
    };
    bench.work = [](void* self) { return Of(self).model.accesses; };
    return bench;
}

contract::PortUnderTest TableOf(Board& board)
{
    contract::PortUnderTest port{};
    port.parts =
        contract::PortParts{&board.can, &board.clocks, &board.pins, &board.pins, &board.watchdog, nullptr, nullptr};
    port.bench = BenchOf(board);
    port.numbers = contract::PortNumbers{{{0x121U, CanPortId::kFirst}, {0x122U, CanPortId::kFirst}},
                                         {{0x101U, CanPortId::kFirst}, {0x102U, CanPortId::kFirst}},
                                         0x123U,
                                         1U,
                                         32U,
                                         4U,
                                         280U,
                                         10U,
                                         1000U,
                                         1500U,
                                         counterpoint::hal::WatchdogWindow{500U, 1600U},
                                         12U,
                                         90'000'000U};
    return port;
}

TEST(FifoPort, KeepsTheContract)
{
    Verifies(req::SRS_HAL_035);
    Board board;
    ASSERT_TRUE(board.is_started);
    const contract::ContractCount count = contract::RunContractTest(TableOf(board));
    EXPECT_EQ(contract::LinesWith(board.text, ": broken: "), std::vector<std::string>{});
    // It has neither memory protection nor parameter memory, and says so. The model has no bus-off.
    EXPECT_EQ(contract::LinesWith(board.text, ": not shown: "),
              (std::vector<std::string>{
                  "transmission: nothing old leaves after bus-off: not shown: the bench cannot bring about a bus-off",
                  "protection: impossible region is refused: not shown: the port has no memory protection",
                  "parameters: programmed bytes are read: not shown: the port has no parameter memory",
                  "parameters: erase touches one bank: not shown: the port has no parameter memory"}));
    EXPECT_EQ(count.held, 40U);
}

TEST(FifoPort, OrderOfBothFifosIsThatOfTheirStamps)
{
    Verifies(req::SRS_HAL_035);
    // Given an interrupt that comes late: a frame of another node, an own one, and again one of the other node wait
    Board board;
    board.model.interrupt_masked = true;
    board.model.Send(CanFrame{0x121U, FrameKind::kData, CanPortId::kFirst, 1U, {1U}});
    board.model.Advance(300U);
    ASSERT_EQ(board.can.Transmit(CanFrame{0x101U, FrameKind::kData, CanPortId::kFirst, 1U, {2U}}),
              counterpoint::hal::TransmitStatus::kAccepted);
    board.model.Advance(300U);
    board.model.Send(CanFrame{0x122U, FrameKind::kData, CanPortId::kFirst, 1U, {3U}});
    board.model.Advance(300U);
    board.can.OnInterrupt();
    // Then they come in the order of the bus, with stamps 300 us apart: 140 us after each began
    std::vector<unsigned> order;
    std::vector<std::uint32_t> stamps;
    for (CanEvent event = board.can.Next(); event.kind != EventKind::kNothing; event = board.can.Next())
    {
        order.push_back(event.frame.frame.data[0]);
        stamps.push_back(event.frame.stamp.b.us);
    }
    EXPECT_EQ(order, (std::vector<unsigned>{1U, 2U, 3U}));
    EXPECT_EQ(stamps, (std::vector<std::uint32_t>{1140U, 1440U, 1740U}));
}

TEST(FifoPort, BufferIsTakenUntilItsEventWasRead)
{
    Verifies(req::SRS_HAL_035);
    // Given four frames that have left, whose events nobody has taken yet
    Board board;
    board.model.interrupt_masked = true;
    for (std::uint8_t number = 0U; number < 4U; ++number)
    {
        ASSERT_EQ(board.can.Transmit(CanFrame{0x101U, FrameKind::kData, CanPortId::kFirst, 1U, {number}}),
                  counterpoint::hal::TransmitStatus::kAccepted);
    }
    board.model.Advance(2000U);
    // Then no buffer is overwritten, and afterwards there is room again
    const CanFrame next{0x101U, FrameKind::kData, CanPortId::kFirst, 1U, {9U}};
    EXPECT_EQ(board.can.Transmit(next), counterpoint::hal::TransmitStatus::kQueueFull);
    board.can.OnInterrupt();
    EXPECT_EQ(board.can.Transmit(next), counterpoint::hal::TransmitStatus::kAccepted);
}

} // namespace
} // namespace port_fifo
