// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_MANAGED_REPORT_HPP
#define VERIFICATION_CAMPAIGN_MANAGED_REPORT_HPP

#include "canopen/cia306/text/text_file.hpp"
#include "verification/campaign/managed/space.hpp"
#include "verification/campaign/results.hpp"

#include <array>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

namespace counterpoint::campaign::managed
{
/// One stratum, counted.
struct Tally
{
    const Stratum* stratum{nullptr};
    std::array<std::uint64_t, kClassCount> classes{};
    std::array<std::uint64_t, kTellerCount> tellers{};
    std::vector<std::uint32_t> times{}; ///< Until it was told, ascending.

    [[nodiscard]] std::uint64_t Of(const Class wanted) const
    {
        return classes.at(static_cast<std::size_t>(wanted));
    }
    [[nodiscard]] std::uint64_t Injected() const
    {
        return std::accumulate(classes.begin(), classes.end(), std::uint64_t{0U}) - Of(Class::kOpen);
    }
    [[nodiscard]] std::uint64_t Effective() const
    {
        return Of(Class::kDetected) + Of(Class::kSafeOther) + Of(Class::kSilent);
    }
};

/// An experiment that a person has to look at.
struct Finding
{
    std::uint64_t number{0U};
    Trial trial{};
    Outcome outcome{};
    std::string known; ///< The plan's reason; empty: nobody answers for it.
};

/// Faults of one kind in frames of one identifier, a device or a manager.
struct MapRow
{
    std::string name;
    std::array<std::array<std::uint64_t, 3U>, kFaultCount> cells{}; ///< Injected, effective, silent.
};

/// All results of a campaign, counted and judged. [SRS_CMG_074]
struct Summary
{
    std::vector<Tally> tallies;
    std::vector<Finding> silent;
    std::vector<Finding> listed; ///< One of each kind of limit and part.
    std::vector<std::string> idle;
    std::vector<std::string> stale;
    std::vector<MapRow> map;
    std::uint64_t open{0U};

    [[nodiscard]] bool Holds() const;
};

/// What a report is written of. All outlive it.
struct Campaign
{
    const Plan& plan;
    const Space& space;
    const Results& results;
};

[[nodiscard]] Summary Summarise(const Campaign& campaign);
/// @brief Why an outcome is what it is; empty: its class says it.
[[nodiscard]] std::string WhyOf(const Outcome& outcome);
/// @brief As campaign::StrangeIn, of a fault of a network. [SRS_CMG_802]
[[nodiscard]] Strange StrangeIn(const Outcome& outcome);
/// @brief An outcome as a sentence.
[[nodiscard]] std::string SentenceOf(const Outcome& outcome);
[[nodiscard]] std::string TextReport(const Campaign& campaign, const Summary& summary);
/// @brief Each survivor, and each line, as soon as it is made. [SRS_CMG_804]
void JsonReport(const Campaign& campaign, const Summary& summary, const cia306::TextPiece& write);
void CsvReport(const Campaign& campaign, const cia306::TextPiece& write);
/// @brief One page without any other file.
[[nodiscard]] std::string HtmlReport(const Campaign& campaign, const Summary& summary);
} // namespace counterpoint::campaign::managed

#endif // VERIFICATION_CAMPAIGN_MANAGED_REPORT_HPP
