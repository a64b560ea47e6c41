// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The device of the user guide on the skeleton: it tells what is missing and does not start. `contract` as the first
// word runs the contract test instead.
#include "board.hpp"
#include "device.hpp"

#include "channel_a/channel.hpp"
#include "channel_a/storage.hpp"
#include "channel_b/channel.hpp"
#include "channel_b/storage.hpp"
#include "hal/contract_test/contract_test.hpp"
#include "names/safety_core/kernel/start_check.hpp"

#include <cstdio>
#include <cstring>

namespace
{
using namespace counterpoint;
namespace contract = hal::contract;

/// One line for each missing part; how many.
unsigned TellMissing(const port_skeleton::Board& board)
{
    unsigned missing = 0U;
    for (std::uint8_t number = 1U; number <= port_skeleton::kLastPart; ++number)
    {
        const port_skeleton::Part part = static_cast<port_skeleton::Part>(number);
        if (board.StateOf(part) == port_skeleton::PartState::kMissing)
        {
            std::printf("missing: %s%s\n", NameOf(part),
                        port_skeleton::Board::IsOptional(part) ? " (or say that the device does without)" : "");
            ++missing;
        }
    }
    return missing;
}

/// What the kernel says of this board if somebody starts it in spite of all.
const char* KernelsAnswer(port_skeleton::Board& board)
{
    channel_a::StorageFor<2U> storage_a{};
    channel_b::StorageFor<2U> storage_b{};
    channel_a::Channel a{storage_a.Handle()};
    channel_b::Channel b{storage_b.Handle()};
    first_device::Device application{};
    CauseWindows windows[2]{};
    Kernel kernel{KernelParts{a, b, board.can, board.output, board.watchdog, application, nullptr, &windows[0]}};
    return NameOf(kernel.Start(application.Describe(), FlowCallback::kOff));
}

contract::PortEvent Next(void* const bench)
{
    const port_skeleton::CanEvent event = static_cast<port_skeleton::Board*>(bench)->can.Next();
    return contract::PortEvent{static_cast<contract::EventKind>(event.kind), event.frame};
}

/// The bench of a port of which nothing is there yet. Yours lets time go by on a clock of its own and reads pins.
contract::PortUnderTest Describe(port_skeleton::Board& board)
{
    contract::PortUnderTest port{};
    port.parts = contract::PortParts{&board.can,      &board.clocks,     &board.output,    &board.output,
                                     &board.watchdog, &board.protection, &board.parameters};
    port.bench.bench = &board;
    port.bench.write = [](void* /*bench*/, const char* const text) { std::fputs(text, stdout); };
    port.bench.next = Next;
    port.bench.pass = [](void* /*bench*/, std::uint32_t /*us*/) {};
    port.bench.restart = [](void* /*bench*/) {};
    port.bench.peer_send = [](void* /*bench*/, const CanFrame& /*frame*/) { return true; };
    port.bench.pins = [](void* /*bench*/) { return SrdoMask{0U}; };
    port.bench.is_alive = [](void* /*bench*/) { return false; };
    port.numbers.received[0] = contract::FrameName{0x101U, CanPortId::kFirst};
    port.numbers.received[1] = contract::FrameName{0x102U, CanPortId::kFirst};
    port.numbers.sent[0] = contract::FrameName{0x103U, CanPortId::kFirst};
    port.numbers.sent[1] = contract::FrameName{0x104U, CanPortId::kFirst};
    port.numbers.foreign = 0x111U; // One bit from the first that is received.
    port.numbers.controllers = 1U;
    port.numbers.receive_room = 8U;
    port.numbers.transmit_room = 8U;
    port.numbers.frame_us = 280U;
    port.numbers.tolerance_us = 10U;
    port.numbers.cycle_us = 1000U;
    port.numbers.gate_limit_us = 1500U;
    port.numbers.window = hal::WatchdogWindow{500U, 1600U};
    return port;
}

} // namespace

int main(const int count, char** const words)
{
    port_skeleton::Board board{};
    if ((count > 1) && (std::strcmp(words[1], "contract") == 0))
    {
        const contract::ContractCount result = contract::RunContractTest(Describe(board));
        return ((result.broken + result.not_shown) == 0U) ? 0 : 1;
    }
    if (board.FirstMissing() != port_skeleton::Part::kNone)
    {
        std::printf("not started: %u parts are missing\n", TellMissing(board));
        std::printf("the kernel alone would answer: %s\n", KernelsAnswer(board));
        return 1;
    }
    std::puts("all parts are there: start the device here as examples/first_device does");
    return 0;
}
