// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_FAULTS_SUPERVISOR_TAP_HPP
#define SIMULATOR_FAULTS_SUPERVISOR_TAP_HPP

#include "simulator/faults/part_faults.hpp"

#include "safety_core/comparator/comparator.hpp"
#include "safety_core/kernel/configuration_guard.hpp"

#include <cstdint>

namespace counterpoint::simulator
{
/// Stands between the kernel and comparator and configuration guard. These have no interface, so the linker puts the
/// tap there (--wrap, see CMakeLists.txt), and the shipped objects stay as they are. Without an active tap every call
/// goes straight through. [SRS_SIM_022]
class SupervisorTap
{
  public:
    /// @brief `faults` outlives the tap.
    explicit SupervisorTap(PartFaults& faults) noexcept;

    /// @brief While it lives, the calls of this thread go through `tap`.
    class Scope
    {
      public:
        explicit Scope(SupervisorTap* tap) noexcept;
        ~Scope();
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;
    };

    // The linker leads the calls of counterpoint::Comparator::Compare and so on to these.
    [[nodiscard]] Verdict Compare(Comparator& self, const Comparison& comparison) noexcept;
    [[nodiscard]] std::uint32_t GuardCycle(ConfigurationGuard& self, std::uint32_t challenge, Instant now) noexcept;

  private:
    PartFaults& faults_;
    Verdict verdict_{};
    std::uint32_t token_{0U};
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_FAULTS_SUPERVISOR_TAP_HPP
