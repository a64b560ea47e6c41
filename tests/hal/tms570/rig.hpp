// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_HAL_TMS570_RIG_HPP
#define TESTS_HAL_TMS570_RIG_HPP

#include "hal/tms570/board.hpp"
#include "verification/models/tms570/machine.hpp"

#include <cstdint>
#include <vector>

namespace counterpoint::tms570
{

constexpr std::uint16_t kNormal = 0x121U;
constexpr std::uint16_t kInverse = 0x122U;
constexpr std::uint16_t kSentNormal = 0x101U;
constexpr std::uint16_t kSentInverse = 0x102U;

/// A consumer and a producer, both on the first controller.
inline constexpr CanObject kObjects[] = {{kNormal, ObjectUse::kReceive},
                                         {kInverse, ObjectUse::kReceive},
                                         {kSentNormal, ObjectUse::kTransmit},
                                         {kSentInverse, ObjectUse::kTransmit}};
inline constexpr CanObject kSecondObjects[] = {{0x131U, ObjectUse::kReceive}, {0x132U, ObjectUse::kTransmit}};

/// What a device would give its board. 500 kbit/s of 80 MHz, cycle 1 ms, pin 0 for slot 0.
inline BoardSetup SetupFor(const Variant& variant, const BusLayout layout)
{
    constexpr std::uint32_t kTiming = dcan::BitTiming(20U, 5U, 2U, 2U);
    const DcanSetup first{RegisterBase{0U}, kTiming, kObjects, 4U, 0U, 3U, 2U};
    const DcanSetup second{RegisterBase{0U}, kTiming, kSecondObjects, 2U, 0U, 3U, 2U};
    SafetyPinsSetup pins{gio::kPortA, {}, hal::GateLimit{1200U}};
    pins.pins[0U].slots = 1U;
    const MpuSetup protection{ProtectedSpan{0U, 0x00400000U}, ProtectedSpan{kRamOrigin, 0x00040000U},
                              ProtectedSpan{kRamOrigin + 0x2000U, 0x400U}};
    return BoardSetup{variant, CanPortsSetup{first, second, layout}, pins, protection, hal::WatchdogWindow{500U, 1500U},
                      900U,    EccTestPlace{kRamOrigin + 0x100U}};
}

[[nodiscard]] inline CanFrame Frame(const std::uint32_t identifier, const std::uint8_t first_byte)
{
    return CanFrame{identifier, FrameKind::kData, CanPortId::kFirst, 2U, {first_byte, 0x34U}};
}

/// A board on its models with a program that calls it as a device does.
class Rig
{
  public:
    explicit Rig(const Variant& variant = kLs12x, const BusLayout layout = BusLayout::kOneController)
        : machine{variant}, setup{SetupFor(variant, layout)}
    {
    }

    /// @brief Start, and again after each reset by the test of the logic.
    StartReport Start()
    {
        StartReport report = board.Start(setup);
        for (int reset = 0; (reset < 3) && machine.TakeProcessorReset(); ++reset)
        {
            report = board.Start(setup);
        }
        if (report.answer == StartAnswer::kStarted)
        {
            Arm();
        }
        return report;
    }

    /// @brief What a kernel that starts does to the output.
    void Arm()
    {
        board.Output().Drive(hal::PermitSet{});
        board.Output().Drive(hal::PermitSet{});
    }

    /// @brief What the processor does when a line is up; at most as often as anything could need.
    void TakeInterrupts()
    {
        for (int i = 0; (i < 20) && (machine.vim.FastLine() || machine.vim.Line()); ++i)
        {
            if (machine.vim.FastLine())
            {
                board.OnFastInterrupt();
            }
            else
            {
                board.OnInterrupt();
            }
        }
    }

    /// @brief One cycle of a device whose kernel opens slot 0, to the end of its millisecond.
    BoardFault Cycle()
    {
        machine.Advance(900U);
        TakeInterrupts();
        const BoardFault fault = board.BeginCycle();
        for (QueuedFrame frame = board.NextFrame(); frame.kind != QueuedKind::kNothing; frame = board.NextFrame())
        {
            frames.push_back(frame);
        }
        board.Output().Drive(RightPermits(board.Output().Challenge(), opened));
        return fault;
    }

    /// @brief Cycles until the board tells a fault, at most so many. kNone: it never did.
    BoardFault CyclesUntilFault(const int most)
    {
        BoardFault fault = BoardFault::kNone;
        for (int i = 0; (i < most) && (fault == BoardFault::kNone); ++i)
        {
            fault = Cycle();
        }
        return fault;
    }

    [[nodiscard]] static hal::PermitSet RightPermits(const std::uint32_t challenge, const SrdoMask mask)
    {
        // hal/api: ((challenge + low) XOR (high rotated by 16)) * constant; these masks have no high word.
        const std::uint32_t base = challenge + static_cast<std::uint32_t>(mask);
        return hal::PermitSet{Permit{mask, base * kPermitConstantA}, Permit{mask, base * kPermitConstantB},
                              Permit{mask, base * kPermitConstantKernel}};
    }

    /// @brief The pin, nERROR and the bus as a safe device has them.
    [[nodiscard]] bool IsSafe()
    {
        return (machine.gio.PinsA() == 0U) && !machine.esm.IsPinHigh() && !machine.dcan1.IsOnBus();
    }

    model::Machine machine;
    BoardSetup setup;
    Board board{};
    SrdoMask opened{1U}; ///< What the kernel of this device would open.
    std::vector<QueuedFrame> frames{};
};

} // namespace counterpoint::tms570

#endif
