// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_RTOS_TASK_SAFETY_TASK_HPP
#define EXAMPLES_RTOS_TASK_SAFETY_TASK_HPP

#include "canopen/device/device.hpp"
#include "hal/api/clocks.hpp"
#include "safety_core/contract/can_frame.hpp"
#include "safety_core/contract/srdo.hpp"

#include <atomic>
#include <cstdint>

namespace rtos_task
{

/// What the interrupt saw on the bus.
struct BusEvent
{
    counterpoint::StampedFrame frame;
    bool is_confirmation;
};

/// From the interrupt to the safety task: one writer, one reader, no lock and no waiting.
class InterruptQueue
{
  public:
    /// @brief For the interrupt. What finds no room is a loss.
    void PutFromInterrupt(const BusEvent& event) noexcept;
    /// @brief For the task. False: there is none.
    [[nodiscard]] bool Take(BusEvent& event) noexcept;
    /// @brief For the task, before Take: whether something was lost since the last call.
    [[nodiscard]] bool TakeLoss() noexcept;

  private:
    static constexpr std::uint32_t kRoom = 16U; ///< More than the bus can bring in one cycle, with both directions.

    BusEvent ring_[kRoom]{};
    std::atomic<std::uint32_t> put_{0U};
    std::atomic<std::uint32_t> taken_{0U};
    std::atomic<bool> has_lost_{false};
};

/// What stands around the task: the port of the board.
struct Surroundings
{
    counterpoint::device::Device& device;
    counterpoint::hal::Clocks& clocks;
    InterruptQueue& queue;
    /// @brief Acknowledge levels by a reading of each channel's own.
    counterpoint::SrdoMask (*acknowledge_a)();
    counterpoint::SrdoMask (*acknowledge_b)();
    /// @brief Starts the watchdog: after this a task that does not run is a task that cuts off.
    void (*start_watchdog)();
    /// @brief Called at the end of each cycle, on the host to let time go by. On a controller empty.
    void (*cycle_done)();
};

/// What the task can tell afterwards.
struct TaskRecord
{
    bool is_started;
    std::uint32_t cycles;
    std::uint32_t late; ///< Cycles that began after their tick.
};

/// Argument of the task.
struct SafetyTaskParts
{
    Surroundings surroundings;
    TaskRecord record;
};

/// @brief Entry of the safety task: power-on, then one cycle each millisecond, for ever. Everything that calls the
/// kernel runs in here. [SRS_HAL_036]
void SafetyTask(void* parts);

} // namespace rtos_task

#endif
