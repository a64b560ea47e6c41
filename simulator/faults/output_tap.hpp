// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_FAULTS_OUTPUT_TAP_HPP
#define SIMULATOR_FAULTS_OUTPUT_TAP_HPP

#include "simulator/faults/part_faults.hpp"

#include "hal/api/safety_output.hpp"
#include "hal/api/watchdog.hpp"

namespace counterpoint::simulator
{
/// Stands before the output stage of the host: remembers the permits of the last cycle, and makes the faults of permits
/// and of the challenge. [SRS_SIM_032, SRS_SIM_034]
class OutputTap final : public hal::SafetyOutput
{
  public:
    OutputTap(hal::SafetyOutput& real, PartFaults& faults) noexcept;

    [[nodiscard]] std::uint32_t Challenge() noexcept override;
    void Drive(const hal::PermitSet& permits) noexcept override;
    [[nodiscard]] hal::ProbeAnswer Probe(const hal::PermitSet& permits,
                                         std::uint32_t challenge) const noexcept override;
    /// @brief As the kernel gave them.
    [[nodiscard]] const hal::PermitSet& Permits() const noexcept;

  private:
    [[nodiscard]] Permit Spoiled(Part part, const Permit& given, const Permit& before) noexcept;
    /// @brief What a gate that is always good makes of what it is given: right permits. [SRS_SIM_054]
    [[nodiscard]] hal::PermitSet Accepted(const hal::PermitSet& given) noexcept;

    hal::SafetyOutput& real_;
    PartFaults& faults_;
    hal::PermitSet permits_{};
    std::uint32_t challenge_{0U}; ///< As the kernel saw it.
    std::uint32_t issued_{0U};
};

/// The same before the watchdog. [SRS_SIM_032, SRS_SIM_034]
class WatchdogTap final : public hal::Watchdog
{
  public:
    WatchdogTap(hal::Watchdog& real, PartFaults& faults) noexcept;

    [[nodiscard]] hal::WatchdogQuestion Question() noexcept override;
    void Answer(const hal::WatchdogAnswer& answer) noexcept override;
    /// @brief A watchdog that never trips: it is served here, once in so long. When the next time is; kNever: it is a
    /// sound one. [SRS_SIM_054]
    [[nodiscard]] Nanoseconds Keep(Nanoseconds now, Nanoseconds every) noexcept;

  private:
    void Give(const hal::WatchdogAnswer& answer) noexcept;
    [[nodiscard]] hal::WatchdogAnswer Right() noexcept;

    hal::Watchdog& real_;
    PartFaults& faults_;
    hal::WatchdogQuestion question_{0U};
    hal::WatchdogAnswer before_{0U};
    Nanoseconds answered_{0}; ///< By the kernel.
    Nanoseconds kept_{0};
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_FAULTS_OUTPUT_TAP_HPP
