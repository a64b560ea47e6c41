// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_FAULTS_SUPERVISOR_TAP_HPP
#define SIMULATOR_FAULTS_SUPERVISOR_TAP_HPP

#include "simulator/faults/part_faults.hpp"

#include "safety_core/comparator/comparator.hpp"
#include "safety_core/kernel/configuration_guard.hpp"
#include "safety_core/kernel/flow_monitor.hpp"

#include <cstdint>

namespace counterpoint::simulator
{
/// Stands between the kernel and comparator, flow monitor and configuration guard. These have no interface, so the
/// linker puts the tap there (--wrap, see CMakeLists.txt), and the shipped objects stay as they are. Without an active
/// tap every call goes straight through. [SRS_SIM_022]
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

    /// @brief How many calls of this thread the linker has led through a tap, by part. It shows that the wraps work.
    [[nodiscard]] static std::uint64_t Intercepted(Part part) noexcept;

    // The linker leads the calls of counterpoint::Comparator::Compare and so on to these. Those that are called
    // often are kept out of line: where no tap stands, a call costs nothing more.
    [[nodiscard]] Verdict Compare(Comparator& self, const Comparison& comparison) noexcept;
    [[gnu::noinline]] void FlowBegin(FlowMonitor& self) noexcept;
    [[gnu::noinline]] void FlowMark(FlowMonitor& self, FlowStep step, const FlowEvidence& evidence) noexcept;
    [[nodiscard]] hal::WatchdogAnswer FlowEnd(FlowMonitor& self, const hal::WatchdogQuestion& question) noexcept;
    [[nodiscard]] std::uint32_t GuardCycle(ConfigurationGuard& self, std::uint32_t challenge, Instant now) noexcept;

  private:
    [[nodiscard]] PartAnswer AnswerOf(Part part) noexcept;
    /// @brief What the part says: by itself, or by its fault.
    template <typename Said, typename Real, typename Good>
    [[nodiscard]] Said Told(Part part, Said& last, const Real& real, const Good& good) noexcept;

    PartFaults& faults_;
    Verdict verdict_{};
    hal::WatchdogAnswer answer_{};
    std::uint32_t token_{0U};
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_FAULTS_SUPERVISOR_TAP_HPP
