// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_ZYNQMP_BOARD_HPP
#define HAL_ZYNQMP_BOARD_HPP

#include "hal/tms570/diagnosis/mpu.hpp"
#include "hal/zynqmp/can/can_ports.hpp"
#include "hal/zynqmp/output/output_driver.hpp"
#include "hal/zynqmp/time/counters.hpp"
#include "hal/zynqmp/time/watchdog_driver.hpp"

#include <cstdint>

namespace counterpoint::zynqmp
{

/// How a board is set up. Clocks, pins of the controller and resets of the peripherals are those of its boot loader.
struct BoardSetup
{
    CanPortsSetup can;
    CountersSetup counters;
    tms570::MpuSetup protection;
};

/// Pins and watchdog of a board, which outlive it: those of the controller, or others.
struct BoardParts
{
    Counters& counters;
    OutputDriver& output;
    WatchdogDriver& watchdog;
};

/// Steps of the start in their order. [SRS_ZYN_066]
enum class StartStep : std::uint8_t
{
    kCounters = 0U,
    kPins = 1U,
    kProtection = 2U,
    kCan = 3U, ///< Last: from here on frames are acknowledged and received.
};
constexpr std::uint8_t kStartSteps = 4U;

/// What the start came to.
struct StartReport
{
    Outcome outcome;
    StartStep last; ///< The last step that was done.
};

/// First fault of the drivers.
enum class BoardFault : std::uint8_t
{
    kInvalid = 0U, ///< Not started.
    kStart = 1U,   ///< A step of the start failed.
    kCan = 2U,
    kPins = 3U,
    kCounters = 4U,
    kWatchdog = 5U,
    kProtection = 6U,
    kNone = 0x5AU,
};

/// All drivers of a controller and the order in which they start. Use: Start; then, for ever: Look until the moment of
/// the cycle, BeginCycle, Look, frames by NextFrame to the kernel, the kernel's cycle. No interrupt is used.
/// [SRS_ZYN_066, SRS_ZYN_067]
class Board
{
  public:
    /// @brief Nothing is started.
    explicit Board(const BoardParts& parts) noexcept;

    /// @brief Does every step in order, until one fails; then all pins are low and the controllers off the bus.
    [[nodiscard]] StartReport Start(const BoardSetup& setup) noexcept;
    /// @brief Starts the watchdog: last, when the kernel is ready for its first cycle. kFailed as if a step had failed.
    [[nodiscard]] Outcome StartWatchdog() noexcept;

    /// @brief Looks at the drivers; the first fault stays, cuts off and is told: then call the kernel no more, and the
    /// watchdog resets the controller.
    [[nodiscard]] BoardFault BeginCycle() noexcept;
    /// @brief Takes what the CAN controllers have; the moment up to which NextFrame tells everything.
    InstantPair Look() noexcept
    {
        return can_.Look();
    }
    /// @brief The next frame or loss, oldest first; kind kNothing when there is none.
    [[nodiscard]] QueuedFrame NextFrame() noexcept
    {
        return can_.Next();
    }

    /// @brief The drivers, for the kernel and its executive: CAN controllers.
    [[nodiscard]] CanPorts& Can() noexcept
    {
        return can_;
    }
    /// @brief Safety outputs and other pins.
    [[nodiscard]] OutputDriver& Output() noexcept
    {
        return parts_.output;
    }
    /// @brief Watchdog.
    [[nodiscard]] WatchdogDriver& Watchdog() noexcept
    {
        return parts_.watchdog;
    }
    /// @brief The two counters of time.
    [[nodiscard]] Counters& Clocks() noexcept
    {
        return parts_.counters;
    }
    /// @brief Memory protection.
    [[nodiscard]] tms570::Mpu& Protection() noexcept
    {
        return mpu_;
    }
    /// @brief The first fault of a driver; kNone while there is none.
    [[nodiscard]] BoardFault Fault() const noexcept
    {
        return fault_;
    }

  private:
    [[nodiscard]] Outcome Do(StartStep step, const BoardSetup& setup) noexcept;
    void Note(Outcome outcome, BoardFault fault) noexcept;
    void EnterSafeState(BoardFault fault) noexcept;

    BoardParts parts_;
    CanPorts can_;
    tms570::Mpu mpu_{};
    BoardFault fault_{BoardFault::kInvalid};
    bool is_watched_{false};
};

} // namespace counterpoint::zynqmp

#endif
