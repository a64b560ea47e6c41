// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_CONTRACT_TEST_PORT_UNDER_TEST_HPP
#define HAL_CONTRACT_TEST_PORT_UNDER_TEST_HPP

#include "hal/api/can_ports.hpp"
#include "hal/api/clocks.hpp"
#include "hal/api/memory_protection.hpp"
#include "hal/api/output_cutoff.hpp"
#include "hal/api/parameter_memory.hpp"
#include "hal/api/safety_output.hpp"
#include "hal/api/watchdog.hpp"
#include "hal/api/watchdog_timer.hpp"
#include "safety_core/contract/can_frame.hpp"
#include "safety_core/contract/srdo.hpp"

#include <cstdint>

namespace counterpoint::hal::contract
{

/// What the reception of a port hands to the kernel.
enum class EventKind : std::uint8_t
{
    kInvalid = 0U,
    kNothing = 1U,
    kLoss = 2U, ///< To Kernel::OnOverflow; `frame` has no meaning.
    kReceived = 0x3CU,
    kConfirmed = 0x5AU,
};

/// The oldest thing that happened on the bus.
struct PortEvent
{
    EventKind kind;
    StampedFrame frame;
};

/// A position that the bench brings something into, and takes it out of again.
enum class Hold : std::uint8_t
{
    kInvalid = 0U,
    kReleased = 1U,
    kHeld = 2U,
};

/// One of the two counters.
enum class Counter : std::uint8_t
{
    kInvalid = 0U,
    kA = 1U,
    kB = 2U,
};

/// A data frame that the port is set up for.
struct FrameName
{
    std::uint32_t identifier;
    CanPortId port;
};

/// The classes of hal/api as the port implements them. A null pointer: what is said of this part is not shown.
struct PortParts
{
    CanPorts* can;
    Clocks* clocks;
    SafetyOutput* output;
    OutputCutoff* cut_off;
    Watchdog* watchdog;
    MemoryProtection* protection;
    ParameterMemory* parameters;
};

/// What is around the port: a second node on the bus, wires, time. `bench` is handed back with every call. The first
/// six are needed; a null pointer among the others: what needs it is not shown.
struct PortBench
{
    void* bench;
    /// @brief Writes a piece of a line, to a terminal or wherever the result is read.
    void (*write)(void* bench, const char* text);
    /// @brief Takes the oldest event out of the port's reception, as the loop of a device does before a cycle.
    PortEvent (*next)(void* bench);
    /// @brief Returns when so much time has gone by on a clock that is none of the two counters (a third timer, a
    /// count of instructions), with interrupts served, and with what the port does in each cycle.
    void (*pass)(void* bench, std::uint32_t us);
    /// @brief Outputs, cut-off and watchdog as after power-on; the watchdog counts from here on.
    void (*restart)(void* bench);
    /// @brief The other node sends a frame on the bus of `frame.port`. False: it cannot send one of this kind.
    bool (*peer_send)(void* bench, const CanFrame& frame);
    /// @brief Slots whose outputs are high, measured at the pins and not by the port.
    SrdoMask (*pins)(void* bench);
    /// @brief Held: frames of the port stay in its controllers (nobody acknowledges). Released: they leave.
    void (*hold_bus)(void* bench, Hold hold);
    /// @brief Held: the interrupts of the port's controllers wait.
    void (*hold_interrupt)(void* bench, Hold hold);
    /// @brief Held: the source of this counter stands still.
    void (*hold_counter)(void* bench, Counter counter, Hold hold);
    /// @brief Held: the pin of slot 0 is pulled high from outside.
    void (*hold_pin)(void* bench, Hold hold);
    /// @brief Slots whose outputs the port itself takes for high: its own reading of the pins.
    SrdoMask (*read_back)(void* bench);
    /// @brief Whether the watchdog has not cut off.
    bool (*is_alive)(void* bench);
    /// @brief A count that goes on while a call of the port runs: cycles of the processor, accesses to registers.
    std::uint32_t (*work)(void* bench);
    /// @brief Takes out the oldest frame that the other node received, as it was on the bus. False: there is none.
    bool (*peer_take)(void* bench, CanFrame& frame);
    /// @brief Held: the port's controllers are in bus-off (the bus is shorted). Released: the bus is good again.
    void (*bus_off)(void* bench, Hold hold);
};

/// How the port is set up, and how exact it claims to be.
struct PortNumbers
{
    FrameName received[2]; ///< Two that reach the kernel, the lower identifier first. // MISRA D-001
    FrameName sent[2];     ///< Normal and inverse data of a producer. // MISRA D-001
    std::uint32_t foreign; ///< Does not reach the kernel; one bit from a received one shows a mask that is too wide.
    std::uint8_t controllers;
    std::uint32_t receive_room;  ///< Events that wait for `next`; fewer than 1000.
    std::uint32_t transmit_room; ///< Frames that wait for the bus at most; fewer than 250.
    std::uint32_t frame_us;      ///< The longest frame on this bus and the pause behind it.
    std::uint32_t tolerance_us;  ///< Latency of a stamp, and error of both counters in 10 cycles.
    std::uint32_t cycle_us;      ///< Within the window of the watchdog.
    std::uint32_t gate_limit_us; ///< How long a right Drive keeps an output open.
    WatchdogWindow window;
    std::uint32_t most_work;    ///< Of one call of Transmit or `next`.
    std::uint32_t long_time_us; ///< For early wraps of the counters, 60 s and more; 0: not shown.
};

/// The function table that a port fills in to be examined. [SRS_HAL_031]
struct PortUnderTest
{
    PortParts parts;
    PortBench bench;
    PortNumbers numbers;
};

} // namespace counterpoint::hal::contract

#endif
