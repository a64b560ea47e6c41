// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_SESSION_HPP
#define VERIFICATION_CAMPAIGN_SESSION_HPP

#include "verification/campaign/device.hpp"
#include "verification/campaign/judge.hpp"
#include "verification/campaign/plan.hpp"
#include "verification/campaign/recording.hpp"
#include "verification/campaign/region.hpp"
#include "verification/campaign/results.hpp"
#include "verification/campaign/runner.hpp"
#include "verification/campaign/space.hpp"
#include "verification/campaign/summary.hpp"

#include <memory>
#include <string>

namespace counterpoint::campaign
{
/// Everything that a plan needs, from its file on. One at a time in a process: the device has one address.
class Session
{
  public:
    /// @brief Reads plan and scenario, records, and runs the device once without a fault. Throws YamlError,
    /// cia306::InputError and std::runtime_error.
    explicit Session(const std::string& plan_file);

    /// @brief What a file of results of this plan says of itself.
    [[nodiscard]] ResultsOf Identity(const Shard& shard) const;
    [[nodiscard]] Campaign Parts() const
    {
        return {plan_, space_, *device_, limits_, scenario_.Record()};
    }
    [[nodiscard]] const Space& Faults() const noexcept
    {
        return space_;
    }
    [[nodiscard]] Runner& Runs() noexcept
    {
        return runner_;
    }
    [[nodiscard]] const RecordedScenario& Scenario() const noexcept
    {
        return scenario_;
    }

  private:
    [[nodiscard]] std::uint64_t SettingDigest() const;

    Plan plan_;
    RecordedScenario scenario_;
    Region region_;
    std::unique_ptr<Device> device_;
    Judge judge_;
    Limits limits_;
    Space space_;
    Runner runner_;
};
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_SESSION_HPP
