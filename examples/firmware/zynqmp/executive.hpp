// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_FIRMWARE_ZYNQMP_EXECUTIVE_HPP
#define EXAMPLES_FIRMWARE_ZYNQMP_EXECUTIVE_HPP

#include "examples/firmware/common/device.hpp"
#include "hal/zynqmp/board.hpp"

namespace counterpoint::firmware
{

/// Calls a device every millisecond on its board, which it looks at all the time: frames in bus order, inputs, the
/// cycle, outputs, code without safety requirements. [SRS_ZYN_068]
class PolledExecutive
{
  public:
    PolledExecutive(zynqmp::Board& board, const DrivenDevice& driven) noexcept;

    /// @brief Once, before the first cycle.
    void Start() noexcept;
    /// @brief Waits for the next cycle and does it. After a wait that does not end, and after every fault of the board,
    /// everything is cut off and neither kernel nor watchdog is served any more: the watchdog resets the controller.
    void Cycle() noexcept;

  private:
    [[nodiscard]] bool WaitForCycle() noexcept;
    [[nodiscard]] InstantPair TakeFrames() noexcept;
    void Deliver(const zynqmp::QueuedFrame& queued) noexcept;

    zynqmp::Board& board_;
    DrivenDevice driven_;
    Instant cycle_{0U};
};

} // namespace counterpoint::firmware

#endif
