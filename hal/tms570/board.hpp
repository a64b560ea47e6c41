// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_BOARD_HPP
#define HAL_TMS570_BOARD_HPP

#include "hal/tms570/can/can_ports.hpp"
#include "hal/tms570/chip/shared.hpp"
#include "hal/tms570/chip/variant.hpp"
#include "hal/tms570/diagnosis/built_in_tests.hpp"
#include "hal/tms570/diagnosis/ecc.hpp"
#include "hal/tms570/diagnosis/esm.hpp"
#include "hal/tms570/diagnosis/mpu.hpp"
#include "hal/tms570/interrupts.hpp"
#include "hal/tms570/output/safety_pins.hpp"
#include "hal/tms570/start_report.hpp"
#include "hal/tms570/time/rti.hpp"
#include "hal/tms570/time/watchdog.hpp"

#include <cstdint>

namespace counterpoint::tms570
{

/// How a board is set up; the objects that it names outlive the board.
struct BoardSetup
{
    const Variant& variant;
    CanPortsSetup can; ///< Base and room of the controllers are those of the variant.
    SafetyPinsSetup pins;
    MpuSetup protection;
    hal::WatchdogWindow watchdog;
    std::uint32_t latest_open_us; ///< The window of the watchdog is open by then: a cycle less its tolerance.
    EccTestPlace ecc_place;
};

/// All drivers of a controller and the order in which they start. Use: Start with interrupts locked; unlock; then, for
/// ever: BeginCycle, frames by NextFrame to the kernel, the kernel's cycle. [SRS_TMS_060, SRS_TMS_061, SRS_TMS_062]
class Board
{
  public:
    /// @brief Nothing is started.
    Board() noexcept;

    /// @brief Does every step in order, until one fails. Answer kResetComes: the processor is about to be reset by its
    /// own test; call nothing more. Without kStarted all pins are low, nERROR is low, and the controllers are off the
    /// bus.
    [[nodiscard]] StartReport Start(const BoardSetup& setup) noexcept;
    /// @brief Starts the watchdog, after which it cannot be stopped any more: last, when the kernel is ready for its
    /// first cycle. kFailed as if a step had failed.
    [[nodiscard]] Outcome StartWatchdog() noexcept;

    /// @brief Looks at the drivers; the first fault stays, cuts off and is told: then call the kernel no more,
    /// and the watchdog resets the controller.
    [[nodiscard]] BoardFault BeginCycle() noexcept;
    /// @brief The next frame or loss, oldest first; kind kNothing when there is none.
    [[nodiscard]] QueuedFrame NextFrame() noexcept
    {
        return can_.Next();
    }
    /// @brief Handler of the interrupt (IRQ).
    void OnInterrupt() noexcept;
    /// @brief Handler of the fast interrupt (FIQ).
    void OnFastInterrupt() noexcept;

    /// @brief The drivers, for the kernel and its executive: CAN controllers.
    [[nodiscard]] CanPorts& Can() noexcept
    {
        return can_;
    }
    /// @brief Safety outputs.
    [[nodiscard]] SafetyPins& Output() noexcept
    {
        return pins_;
    }
    /// @brief Watchdog.
    [[nodiscard]] WindowedWatchdog& Watchdog() noexcept
    {
        return watchdog_;
    }
    /// @brief The two counters of time.
    [[nodiscard]] Rti& Clocks() noexcept
    {
        return rti_;
    }
    /// @brief Memory protection.
    [[nodiscard]] Mpu& Protection() noexcept
    {
        return mpu_;
    }
    /// @brief Error signalling module.
    [[nodiscard]] const Esm& Errors() const noexcept
    {
        return esm_;
    }
    /// @brief The first fault of a driver; kNone while there is none.
    [[nodiscard]] BoardFault Fault() const noexcept
    {
        return fault_.Load();
    }

  private:
    [[nodiscard]] StepResult Do(StartStep step, const BoardSetup& setup) noexcept;
    [[nodiscard]] static StepResult TestRam(const BoardSetup& setup) noexcept;
    [[nodiscard]] StepResult DoLogicTest() noexcept;
    [[nodiscard]] StepResult PlanTheWatchdog(const BoardSetup& setup) noexcept;
    [[nodiscard]] StepResult StartCan(const BoardSetup& setup) noexcept;
    void ExamineInTurn() noexcept;
    void Note(Outcome outcome, BoardFault fault) noexcept;
    void EnterSafeState(BoardFault fault) noexcept;

    Rti rti_{};
    CanPorts can_;
    SafetyPins pins_;
    WindowedWatchdog watchdog_{};
    Mpu mpu_{};
    Esm esm_{};
    WatchdogPlan watchdog_plan_{};
    LogicTest logic_test_{LogicTest::kInvalid};
    Presence has_comparator_{Presence::kInvalid};
    TableCheck table_check_{TableCheck::kInvalid};
    std::uint8_t comparators_{0U};
    std::uint32_t rti_source_{0U};
    bool is_watched_{false};
    std::uint32_t turn_{0U};
    Shared<BoardFault> fault_{BoardFault::kInvalid};
};

} // namespace counterpoint::tms570

#endif
