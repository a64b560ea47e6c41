// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_FAULTS_OUTPUT_TAP_HPP
#define SIMULATOR_FAULTS_OUTPUT_TAP_HPP

#include "simulator/faults/part_faults.hpp"

#include "hal/api/safety_output.hpp"
#include "hal/api/watchdog.hpp"

namespace counterpoint::simulator
{
/// Stands in front of the output stage of the host. It remembers the permits of the last cycle, and makes the faults of
/// permits and challenge. [SRS_SIM_032, SRS_SIM_034]
class OutputTap final : public hal::SafetyOutput
{
  public:
    /// @brief Both outlive the tap.
    OutputTap(hal::SafetyOutput& real, PartFaults& faults) noexcept;

    [[nodiscard]] std::uint32_t Challenge() noexcept override;
    void Drive(const hal::PermitSet& permits) noexcept override;
    [[nodiscard]] hal::ProbeAnswer Probe(const hal::PermitSet& permits,
                                         std::uint32_t challenge) const noexcept override;
    /// @brief The permits of the last cycle, as the kernel gave them.
    [[nodiscard]] const hal::PermitSet& Permits() const noexcept
    {
        return permits_;
    }

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

/// Stands in front of the watchdog likewise, and makes the faults of question and answer. [SRS_SIM_032, SRS_SIM_034]
class WatchdogTap final : public hal::Watchdog
{
  public:
    /// @brief Both outlive the tap.
    WatchdogTap(hal::Watchdog& real, PartFaults& faults) noexcept;

    [[nodiscard]] hal::WatchdogQuestion Question() noexcept override;
    void Answer(const hal::WatchdogAnswer& answer) noexcept override;
    /// @brief Serves a watchdog that never trips, once every `every`. Answers when it is to be served next; kNever: it
    /// is a sound watchdog. [SRS_SIM_054]
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
