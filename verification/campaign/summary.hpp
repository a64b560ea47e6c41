// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_SUMMARY_HPP
#define VERIFICATION_CAMPAIGN_SUMMARY_HPP

#include "verification/campaign/device.hpp"
#include "verification/campaign/outcome.hpp"
#include "verification/campaign/plan.hpp"
#include "verification/campaign/results.hpp"
#include "verification/campaign/runner.hpp"
#include "verification/campaign/space.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::campaign
{
/// One stratum, counted.
struct Tally
{
    Stratum stratum{};
    std::array<std::uint64_t, kClassCount> classes{};
    std::array<std::uint64_t, kDetectorCount> detectors{};
    std::vector<std::uint32_t>
        times{};            ///< From fault to closed output, ascending; of what was detected or safe otherwise.
    std::uint64_t late{0U}; ///< Of those above the limit, counted from their first effect.
    std::uint32_t limit_us{0U};

    [[nodiscard]] std::uint64_t Of(const Class wanted) const
    {
        return classes.at(static_cast<std::size_t>(wanted));
    }
    /// @brief Those that changed what the device does: of these alone a share is said.
    [[nodiscard]] std::uint64_t Effective() const
    {
        return Of(Class::kDetected) + Of(Class::kSafeOther) + Of(Class::kSilent) + Of(Class::kExposed);
    }
};

/// An experiment that a person has to look at.
struct Finding
{
    std::uint64_t number{0U};
    Experiment experiment{};
    Outcome outcome{};
};

/// All results of a campaign, counted and judged. [SRS_CMG_010]
struct Summary
{
    std::vector<Tally> tallies;
    std::vector<Finding> silent;
    std::vector<Finding> late;
    std::vector<Detector> idle; ///< That the plan asks for and that found nothing.
    std::uint64_t open{0U};     ///< Not tried, or in another shard.

    /// @brief Nothing silent, nothing late, and each detector that the plan names found something.
    [[nodiscard]] bool Holds() const noexcept
    {
        return silent.empty() && late.empty() && idle.empty();
    }
};

/// What a report is written of. All outlive it.
struct Campaign
{
    const Plan& plan;
    const Space& space;
    const Device& device;
    const Limits& limits;
    const Recording& recording;
};

[[nodiscard]] Summary Summarise(const Campaign& campaign, const Results& results);

/// @brief Place of an experiment as "channel_a.records+12.3": byte 12 of the member, bit 3.
[[nodiscard]] std::string PlaceText(const Campaign& campaign, const Experiment& experiment);
/// @brief How many are of the listed limit, and how many were wrong for a time; empty: none. [SRS_CMG_021, SRS_CMG_027]
[[nodiscard]] std::string ListedText(const Summary& summary);
/// @brief The report for a terminal.
[[nodiscard]] std::string TextReport(const Campaign& campaign, const Summary& summary);
/// @brief The report as one page without any other file. [SRS_CMG_010]
[[nodiscard]] std::string HtmlReport(const Campaign& campaign, const Summary& summary);
/// @brief All experiments that have an outcome, one a line.
[[nodiscard]] std::string CsvReport(const Campaign& campaign, const Results& results);
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_SUMMARY_HPP
