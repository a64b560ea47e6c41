// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/managed/report.hpp"

#include <algorithm>
#include <set>

namespace counterpoint::campaign::managed
{
namespace
{
[[nodiscard]] std::string ReasonFor(const Plan& plan, const std::string& place, std::set<std::string>& used)
{
    for (const Known& known : plan.known)
    {
        if (place.rfind(known.place, 0U) == 0U)
        {
            used.insert(known.place);
            return known.reason;
        }
    }
    return "";
}

/// Frames of one identifier are one row; of a device's objects all.
[[nodiscard]] std::string RowOf(const Campaign& campaign, const Trial& trial)
{
    const std::string subject = campaign.space.SubjectText(trial);
    const std::string part = std::string(WordOf(trial.target)) + " ";
    return part + (IsOfFrames(trial.target) ? subject.substr(0U, subject.find('#')) : subject);
}

void Mark(const Campaign& campaign, const Trial& trial, const Outcome& outcome, Summary& summary)
{
    const std::string name = RowOf(campaign, trial);
    auto row =
        std::find_if(summary.map.begin(), summary.map.end(), [&name](const MapRow& each) { return each.name == name; });
    if (row == summary.map.end())
    {
        summary.map.push_back({name, {}});
        row = std::prev(summary.map.end());
    }
    auto& cell = row->cells.at(static_cast<std::size_t>(trial.fault));
    ++cell[0U];
    cell[1U] += IsEffective(outcome.result) ? 1U : 0U;
    cell[2U] += (outcome.result == Class::kSilent) ? 1U : 0U;
}

[[nodiscard]] bool HasLike(const std::vector<Finding>& findings, const Trial& trial, const Outcome& outcome)
{
    return std::any_of(findings.begin(), findings.end(),
                       [&trial, &outcome](const Finding& each)
                       {
                           return each.outcome.detail == outcome.detail && each.trial.target == trial.target &&
                                  each.trial.fault == trial.fault;
                       });
}

void RequireTellers(const Campaign& campaign, Summary& summary)
{
    for (const Teller teller : campaign.plan.detectors)
    {
        const bool has_any = std::any_of(summary.tallies.begin(), summary.tallies.end(), [teller](const Tally& tally)
                                         { return tally.tellers.at(static_cast<std::size_t>(teller)) != 0U; });
        if (!has_any)
        {
            summary.idle.emplace_back(WordOf(teller));
        }
    }
}
} // namespace

bool Summary::Holds() const
{
    return std::all_of(silent.begin(), silent.end(), [](const Finding& each) { return !each.known.empty(); }) &&
           idle.empty() && stale.empty();
}

Summary Summarise(const Campaign& campaign)
{
    Summary summary;
    std::set<std::string> used;
    for (const Stratum& stratum : campaign.space.Strata())
    {
        summary.tallies.push_back({&stratum, {}, {}, {}});
    }
    for (std::uint64_t index = 0U; index < campaign.results.Size(); ++index)
    {
        const std::uint64_t number = campaign.results.NumberAt(index);
        const Outcome outcome = campaign.results.At(index);
        const Trial trial = campaign.space.At(number);
        Tally& tally = *std::find_if(summary.tallies.begin(), summary.tallies.end(), [number](const Tally& each)
                                     { return number < each.stratum->first + each.stratum->taken; });
        ++tally.classes.at(static_cast<std::size_t>(outcome.result));
        if (outcome.result == Class::kOpen)
        {
            ++summary.open;
            continue;
        }
        Mark(campaign, trial, outcome, summary);
        if (outcome.result == Class::kDetected)
        {
            ++tally.tellers.at(static_cast<std::size_t>(outcome.detector));
            tally.times.push_back(outcome.us);
        }
        if (outcome.result == Class::kSilent)
        {
            summary.silent.push_back(
                {number, trial, outcome, ReasonFor(campaign.plan, campaign.space.PlaceText(trial), used)});
        }
        if (outcome.result == Class::kListed && !HasLike(summary.listed, trial, outcome))
        {
            summary.listed.push_back({number, trial, outcome, ""});
        }
    }
    for (Tally& tally : summary.tallies)
    {
        std::sort(tally.times.begin(), tally.times.end());
    }
    std::sort(summary.map.begin(), summary.map.end(),
              [](const MapRow& left, const MapRow& right) { return left.name < right.name; });
    RequireTellers(campaign, summary);
    for (const Known& known : campaign.plan.known)
    {
        const bool is_needed = used.count(known.place) != 0U || campaign.plan.sample != 0U || summary.open != 0U;
        if (!is_needed)
        {
            summary.stale.push_back(known.place);
        }
    }
    return summary;
}

std::string WhyOf(const Outcome& outcome)
{
    switch (outcome.result)
    {
    case Class::kSilent:
        return TextOf(static_cast<Wrong>(outcome.detail));
    case Class::kListed:
        return TextOf(static_cast<Limit>(outcome.detail));
    case Class::kSafeOther:
        return "less runs than without the fault, and nobody tells it";
    default:
        return "";
    }
}

Strange StrangeIn(const Outcome& outcome)
{
    const auto teller = static_cast<std::size_t>(outcome.detector);
    if (teller >= kTellerCount)
    {
        return StrangeNumber("detector", teller, kTellerCount);
    }
    if (outcome.result == Class::kSilent)
    {
        return StrangeNumber("reason", outcome.detail, kWrongCount);
    }
    return (outcome.result == Class::kListed) ? StrangeNumber("reason", outcome.detail, kLimitCount) : Strange{};
}

std::string SentenceOf(const Outcome& outcome)
{
    const auto teller = static_cast<Teller>(outcome.detector);
    const std::string reason = WhyOf(outcome);
    std::string text = std::string("outcome: ") + WordOf(outcome.result);
    text += (teller == Teller::kNobody) ? "" : std::string(", told by ") + WordOf(teller);
    text += reason.empty() ? "" : ", " + reason;
    const bool has_time = outcome.result == Class::kDetected || outcome.result == Class::kSilent;
    return text + (has_time ? ", after " + MsText(outcome.us) + " ms" : "");
}
} // namespace counterpoint::campaign::managed
