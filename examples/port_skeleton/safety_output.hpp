// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_PORT_SKELETON_SAFETY_OUTPUT_HPP
#define EXAMPLES_PORT_SKELETON_SAFETY_OUTPUT_HPP

#include "hal/api/output_cutoff.hpp"
#include "hal/api/output_gate.hpp"
#include "hal/api/safety_output.hpp"
#include "parts.hpp"

namespace port_skeleton
{

/// The pins that are the last element before the actuators.
class SafetyOutput final : public counterpoint::hal::SafetyOutput, public counterpoint::hal::OutputCutoff
{
  public:
    /// @brief CONTRACT. The gate's own: hand it on.
    [[nodiscard]] std::uint32_t Challenge() noexcept override;
    /// @brief CONTRACT. Hand permits and the time of one counter to the gate, then set each pin by OutputGate::Open and
    /// nothing else: the gate remembers what closed without a decision, and keeps it closed. A pin falls without the
    /// program when no right Drive comes within the gate's limit: a watchdog that makes it an input, a monostable, a
    /// timer output. Read each pin back once a cycle; one that does not follow is a fault that cuts off.
    void Drive(const counterpoint::hal::PermitSet& permits) noexcept override;
    /// @brief CONTRACT. All pins low by the shortest way, from any exception and any state: no lock, no stack of its
    /// own, no object that the exception may have destroyed; registers are written directly. Nothing opens them again
    /// but a restart. Read back; if a pin stays high, by a second way (supply, error pin).
    void CutOff() noexcept override;

    /// @brief Change it to kThere with the body, and not before.
    [[nodiscard]] PartState State() const noexcept;
    [[nodiscard]] PartState StateOfCutOff() const noexcept;

  private:
    counterpoint::hal::OutputGate gate_{};
};

} // namespace port_skeleton

#endif
