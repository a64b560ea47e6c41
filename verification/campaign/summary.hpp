// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_SUMMARY_HPP
#define VERIFICATION_CAMPAIGN_SUMMARY_HPP

#include "canopen/cia306/text/text_file.hpp"
#include "verification/campaign/device.hpp"
#include "verification/campaign/outcome.hpp"
#include "verification/campaign/plan.hpp"
#include "verification/campaign/results.hpp"
#include "verification/campaign/runner.hpp"
#include "verification/campaign/space.hpp"

#include <array>
#include <cstdint>
#include <deque>
#include <numeric>
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
        times{};                ///< From fault to closed output, ascending; of what was detected or safe otherwise.
    std::uint64_t late{0U};     ///< Of those above the limit, counted from their first effect.
    std::uint32_t limit_us{0U}; ///< The longest by which one of them was judged,
    std::uint32_t least_limit_us{0U}; ///< and the shortest. [SRS_CMG_818]

    [[nodiscard]] std::uint64_t Of(const Class wanted) const
    {
        return classes.at(static_cast<std::size_t>(wanted));
    }
    /// @brief Those of the plan that were tried.
    [[nodiscard]] std::uint64_t Injected() const
    {
        return std::accumulate(classes.begin(), classes.end(), std::uint64_t{0U}) - Of(Class::kOpen);
    }
    /// @brief Those that changed what the device does: of these alone a share is said.
    [[nodiscard]] std::uint64_t Effective() const
    {
        std::uint64_t count = 0U;
        for (std::size_t each = 0U; each < kClassCount; ++each)
        {
            count += IsEffective(static_cast<Class>(each)) ? classes.at(each) : 0U;
        }
        return count;
    }
};

/// An experiment that a person has to look at.
struct Finding
{
    std::uint64_t number{0U};
    Outcome outcome{};
    const Known* known{nullptr}; ///< Of the plan; null: nobody answers for it.
};

/// They may be all experiments: in pieces, so that no longer list is made of a shorter one. [SRS_CMG_804]
using Findings = std::deque<Finding>;

/// Faults of one member at one phase.
struct MapCell
{
    std::uint64_t injected{0U};
    std::uint64_t effective{0U};
    std::uint64_t silent{0U};
    std::uint64_t exposed{0U};
};

/// A member of the device, or what is no memory.
struct MapRow
{
    std::string name;
    std::vector<MapCell> cells; ///< By phase, or by kind.
};

/// So many were found within `up_to_us`, and not within the half of it.
struct Bin
{
    std::uint32_t up_to_us{0U};
    std::uint64_t count{0U};
};

/// What one mechanism found first.
struct Mechanism
{
    Detector detector{Detector::kNobody};
    std::vector<std::uint32_t> times{}; ///< Ascending.
};

/// All results of a campaign, counted and judged. [SRS_CMG_010]
struct Summary
{
    std::vector<Tally> tallies;
    Findings silent;
    Findings exposed; ///< Silent until the self test found them. [SRS_CMG_151, SRS_CMG_152]
    Findings late;
    std::uint64_t latent{
        0U}; ///< Found later than the limit behind the first byte that differed, in time behind what it did.
    std::vector<std::string> idle;     ///< Detectors and voices that the plan asks for and that found nothing.
    std::vector<std::string> stale;    ///< Known places of the plan at which nothing was found.
    std::vector<Mechanism> mechanisms; ///< Those that found something.
    std::vector<MapRow> map;           ///< The places of the device, in their order, by phase.
    std::vector<MapRow> subjects;      ///< What was hit and is no memory, by kind.
    std::uint64_t open{0U};            ///< Not tried, or in another shard.

    /// @brief Nothing silent, exposed or late that nobody answers for, and each detector, voice and known place of the
    /// plan found something.
    [[nodiscard]] bool Holds() const noexcept
    {
        return IsKnown(silent) && IsKnown(exposed) && IsKnown(late) && idle.empty() && stale.empty();
    }

  private:
    [[nodiscard]] static bool IsKnown(const Findings& findings) noexcept;
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
/// @brief The member that was hit, or what is no memory.
[[nodiscard]] std::string MemberText(const Campaign& campaign, const Experiment& experiment);
/// @brief Median, 99.9 % and greatest of sorted times, in ms; a dash each where nothing was found.
[[nodiscard]] std::vector<std::string> TimeTexts(const std::vector<std::uint32_t>& sorted);
/// @brief By which limits the faults of a row were judged: one, or from the shortest to the longest. [SRS_CMG_818]
[[nodiscard]] std::string LimitText(const Tally& tally);
/// @brief How many are of the listed limit; empty: none. [SRS_CMG_021]
[[nodiscard]] std::string ListedText(const Summary& summary);
/// @brief How many lay longer than their limit and did nothing; empty: none. [SRS_CMG_155]
[[nodiscard]] std::string LatentText(const Summary& summary);
/// @brief How long it took until what was detected or safe otherwise was so, by powers of two from 1 ms on.
[[nodiscard]] std::vector<Bin> HistogramOf(const Summary& summary);
/// @brief Where a member is declared, as channel_b/storage.hpp:82; empty where nobody knows. [SRS_CMG_045]
[[nodiscard]] std::string DeclarationOf(const std::string& member);
/// @brief The report for a terminal.
[[nodiscard]] std::string TextReport(const Campaign& campaign, const Summary& summary);
/// @brief The report as one page without any other file. [SRS_CMG_010]
[[nodiscard]] std::string HtmlReport(const Campaign& campaign, const Summary& summary);
/// @brief The report for programs: docs/json.md. [SRS_CMG_045, SRS_CMG_804]
void JsonReport(const Campaign& campaign, const Summary& summary, const cia306::TextPiece& write);
/// @brief All experiments that have an outcome, one a line; each line as soon as it is made. [SRS_CMG_804]
void CsvReport(const Campaign& campaign, const Results& results, const cia306::TextPiece& write);
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_SUMMARY_HPP
