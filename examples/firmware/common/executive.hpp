// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_FIRMWARE_COMMON_EXECUTIVE_HPP
#define EXAMPLES_FIRMWARE_COMMON_EXECUTIVE_HPP

#include "examples/firmware/common/board_needs.hpp"
#include "examples/firmware/common/device.hpp"
#include "hal/tms570/board.hpp"

namespace counterpoint::firmware
{

/// Calls a device every millisecond on its board: frames in bus order, inputs, the cycle, outputs, code
/// without safety requirements.
class Executive
{
  public:
    Executive(tms570::Board& board, const DrivenDevice& driven, const BoardNeeds& needs) noexcept;

    /// @brief Once, before the first cycle: pins of port B, first moment.
    void Start() noexcept;
    /// @brief Waits for the next cycle and does it. After a wait that does not end, and after every fault of the board,
    /// everything is cut off and neither kernel nor watchdog is served any more: the watchdog resets the controller.
    /// [SRS_TMS_062]
    void Cycle() noexcept;

  private:
    [[nodiscard]] bool WaitForCycle() const noexcept;
    [[nodiscard]] InstantPair TakeFrames() noexcept;
    void Deliver(const tms570::QueuedFrame& queued) noexcept;

    tms570::Board& board_;
    DrivenDevice driven_;
    const BoardNeeds& needs_;
    Instant cycle_{0U};
};

} // namespace counterpoint::firmware

#endif
