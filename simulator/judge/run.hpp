// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_JUDGE_RUN_HPP
#define SIMULATOR_JUDGE_RUN_HPP

#include "simulator/journal/journal.hpp"
#include "simulator/judge/managed.hpp"
#include "simulator/judge/verdicts.hpp"
#include "simulator/scenario/scenario.hpp"
#include "simulator/world/network.hpp"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::simulator
{
/// One run of a scenario: simulated and judged. Its parts refer to each other, so it cannot be moved or copied.
class Run
{
  public:
    /// @brief Builds bus and devices; no time has passed yet. Without `make` a scenario with managers is refused.
    /// Throws YamlError and cia306::InputError.
    Run(Scenario scenario, std::optional<Nanoseconds> until, bool keeps_all, const MakeManaged& make = nullptr);
    /// @brief The same for a file; `profile` is a start-up profile instead of the scenario's first one.
    Run(const std::string& file, std::optional<std::uint64_t> seed, std::optional<Nanoseconds> until, bool keeps_all,
        const MakeManaged& make = nullptr, const std::string& profile = {});

    Run(const Run&) = delete;
    Run& operator=(const Run&) = delete;

    /// @brief Lets the time of the scenario pass, then judges. `progress` is told now and then how much time has
    /// passed.
    void Simulate(const std::function<void(Nanoseconds)>& progress);

    /// @brief The scenario.
    [[nodiscard]] const Scenario& Setting() const noexcept
    {
        return scenario_;
    }
    /// @brief What happened.
    [[nodiscard]] const Journal& Record() const noexcept
    {
        return journal_;
    }
    /// @brief Bus and devices.
    [[nodiscard]] Network& Devices() noexcept
    {
        return *network_;
    }
    /// @brief What the DCF of a node says.
    [[nodiscard]] const runtime::DeviceModel& ModelOf(NodeIndex node) const;
    /// @brief The verdict of each expectation.
    [[nodiscard]] const std::vector<ExpectationVerdict>& Verdicts() const noexcept
    {
        return verdicts_;
    }
    /// @brief A line for each fault that never changed anything. [SRS_SIM_015]
    [[nodiscard]] std::vector<std::string> FaultsWithoutEffect() const;
    /// @brief A line for each thing of the scenario that --until cut off, and for copies of frames that were dropped.
    /// [SRS_SIM_016, SRS_SIM_017]
    [[nodiscard]] std::vector<std::string> Findings() const;
    /// @brief Whether all expectations hold.
    [[nodiscard]] bool Holds() const noexcept;
    /// @brief The measurement of the first expectation with a limit; null: there is none.
    [[nodiscard]] const Measurement* FirstMeasurement() const noexcept;
    /// @brief Name of a node, of a manager (they come behind the nodes), or of somebody else on the bus.
    [[nodiscard]] std::string NodeName(NodeIndex node) const;
    /// @brief The managers; null: the scenario has none.
    [[nodiscard]] const ManagedWorld* Managed() const noexcept
    {
        return managed_.get();
    }

  private:
    void RunTo(Nanoseconds now);
    void LookAt(Nanoseconds now);
    [[nodiscard]] std::string FoundAtDevice(const Expectation& expectation);
    void FindOtherClosers();
    void FindOtherFinders();
    void FindOtherFinder(ExpectationVerdict& verdict);
    [[nodiscard]] std::string OthersBefore(std::size_t fault, Nanoseconds at) const;
    [[nodiscard]] std::vector<std::size_t> AllBut(std::size_t fault) const;
    [[nodiscard]] const Journal& RecordWithout(const std::vector<std::size_t>& faults);

    Scenario scenario_;
    std::optional<Nanoseconds> until_;
    Nanoseconds whole_{0}; ///< Duration of the scenario that `until_` may cut.
    MakeManaged make_;
    Journal journal_;
    std::unique_ptr<Network> network_;
    std::unique_ptr<ManagedWorld> managed_; ///< The managers; null: there are none.
    std::vector<std::string> found_;        ///< By expectation: what a manager or device said at its time.
    std::vector<ExpectationVerdict> verdicts_;
    std::map<std::vector<std::size_t>, std::unique_ptr<Run>> without_; ///< Runs that are the same but for these faults.
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_JUDGE_RUN_HPP
