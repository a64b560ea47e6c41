// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_PORT_SKELETON_BOARD_HPP
#define EXAMPLES_PORT_SKELETON_BOARD_HPP

#include "can_ports.hpp"
#include "clocks.hpp"
#include "cross_link.hpp"
#include "interrupt_lock.hpp"
#include "memory_protection.hpp"
#include "parameter_memory.hpp"
#include "parts.hpp"
#include "safety_output.hpp"
#include "watchdog.hpp"

namespace port_skeleton
{

/// All parts of the port, and which of them are there.
class Board
{
  public:
    /// @brief How far one part is.
    [[nodiscard]] PartState StateOf(Part part) const noexcept;
    /// @brief The first part without which no device may start; kNone: all are there. Ask before the kernel is started,
    /// and start nothing otherwise.
    [[nodiscard]] Part FirstMissing() const noexcept;
    /// @brief Whether a device may do without this part.
    [[nodiscard]] static bool IsOptional(Part part) noexcept;

    Clocks clocks{};
    CanPorts can{};
    SafetyOutput output{};
    Watchdog watchdog{};
    MemoryProtection protection{};
    InterruptLock lock{};
    ParameterMemory parameters{};
    CrossLink link{};
};

} // namespace port_skeleton

#endif
