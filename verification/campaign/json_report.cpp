// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/json_pieces.hpp"
#include "verification/campaign/statistics.hpp"
#include "verification/campaign/summary.hpp"

#include <nlohmann/json.hpp>

namespace counterpoint::campaign
{
namespace
{
using Json = nlohmann::ordered_json;

constexpr double kPercent = 100.0;
constexpr double kMedian = 0.5;
constexpr double kAlmostAll = 0.999;

/// Null where nothing was found.
void AddTimes(Json& object, const std::vector<std::uint32_t>& sorted)
{
    const auto value = [&sorted](const double part) { return sorted.empty() ? Json() : Json(Quantile(sorted, part)); };
    object["median_us"] = value(kMedian);
    object["p999_us"] = value(kAlmostAll);
    object["worst_us"] = value(1.0);
}

Json StratumOf(const Campaign& campaign, const Tally& tally)
{
    Json found = Json::object();
    for (std::size_t detector = 1U; detector < kDetectorCount; ++detector)
    {
        if (tally.detectors.at(detector) != 0U)
        {
            found[WordOf(static_cast<Detector>(detector))] = tally.detectors.at(detector);
        }
    }
    const double confidence = campaign.plan.confidence_percent / kPercent;
    const std::uint64_t effective = tally.Effective();
    Json stratum{{"part", WordOf(tally.stratum.part)},     {"kind", WordOf(tally.stratum.kind)},
                 {"faults", tally.stratum.size},           {"injected", tally.Injected()},
                 {"open", tally.Of(Class::kOpen)},         {"masked", tally.Of(Class::kMasked)},
                 {"benign", tally.Of(Class::kBenign)},     {"effective", effective},
                 {"detected", tally.Of(Class::kDetected)}, {"safe_other", tally.Of(Class::kSafeOther)},
                 {"listed", tally.Of(Class::kListed)},     {"exposed", tally.Of(Class::kExposed)},
                 {"silent", tally.Of(Class::kSilent)}};
    stratum["silent_at_most"] =
        (effective == 0U) ? Json() : Json(UpperBound(tally.Of(Class::kSilent), effective, confidence));
    stratum["found_by"] = found;
    AddTimes(stratum, tally.times);
    stratum["limit_us"] = tally.limit_us;
    stratum["least_limit_us"] = tally.least_limit_us;
    stratum["late"] = tally.late;
    return stratum;
}

Json CellOf(Json cell, const MapCell& counted)
{
    cell["injected"] = counted.injected;
    cell["effective"] = counted.effective;
    cell["silent"] = counted.silent;
    cell["exposed"] = counted.exposed;
    return cell;
}

Json MapOf(const Campaign& campaign, const Summary& summary)
{
    Json map = Json::array();
    for (const MapRow& row : summary.map)
    {
        for (const Phase phase : campaign.plan.phases)
        {
            const MapCell& cell = row.cells.at(static_cast<std::size_t>(phase));
            if (cell.injected != 0U)
            {
                map.push_back(CellOf({{"member", row.name}, {"phase", WordOf(phase)}}, cell));
            }
        }
    }
    return map;
}

Json SubjectsOf(const Summary& summary)
{
    Json subjects = Json::array();
    for (const MapRow& row : summary.subjects)
    {
        for (std::size_t kind = 0U; kind < kFaultKindCount; ++kind)
        {
            if (row.cells.at(kind).injected != 0U)
            {
                subjects.push_back(CellOf({{"subject", row.name}, {"kind", WordOf(static_cast<FaultKind>(kind))}},
                                          row.cells.at(kind)));
            }
        }
    }
    return subjects;
}

Json SurvivorOf(const Campaign& campaign, const Finding& finding)
{
    const Experiment experiment = campaign.space.At(finding.number);
    const std::string member = MemberText(campaign, experiment);
    const bool is_memory = IsMemory(experiment.part);
    const Place& place = campaign.device.Places()[experiment.place];
    Json survivor{{"experiment", finding.number},
                  {"class", IsLate(finding.outcome) ? "late" : WordOf(finding.outcome.result)},
                  {"place", PlaceText(campaign, experiment)},
                  {"member", member},
                  {"declared", DeclarationOf(member)},
                  {"byte", is_memory ? Json(experiment.offset - place.offset) : Json()},
                  {"bit", is_memory ? Json(experiment.bit) : Json()},
                  {"kind", WordOf(experiment.kind)},
                  {"cycle", experiment.cycle},
                  {"phase", WordOf(experiment.phase)},
                  {"found_by", WordOf(finding.outcome.detector)},
                  {"reason", ReasonOf(finding.outcome)},
                  {"us", finding.outcome.us}};
    survivor["known"] = (finding.known == nullptr) ? Json() : Json(finding.known->reason);
    return survivor;
}
} // namespace

void JsonReport(const Campaign& campaign, const Summary& summary, const cia306::TextPiece& write)
{
    Json report{{"format", "counterpoint-campaign-1"},
                {"plan", campaign.plan.file},
                {"title", campaign.plan.title},
                {"holds", summary.Holds() && summary.open == 0U},
                {"seed", campaign.plan.seed},
                {"confidence_percent", campaign.plan.confidence_percent},
                {"experiments", campaign.space.Size()},
                {"open", summary.open},
                {"left_out_bytes", campaign.space.LeftOut()},
                {"idle", summary.idle},
                {"stale", summary.stale}};
    Json strata = Json::array();
    for (const Tally& tally : summary.tallies)
    {
        if (tally.stratum.size != 0U)
        {
            strata.push_back(StratumOf(campaign, tally));
        }
    }
    report["strata"] = strata;
    Json mechanisms = Json::array();
    for (const Mechanism& mechanism : summary.mechanisms)
    {
        Json each{{"name", WordOf(mechanism.detector)}, {"count", mechanism.times.size()}};
        AddTimes(each, mechanism.times);
        mechanisms.push_back(each);
    }
    report["mechanisms"] = mechanisms;
    Json bins = Json::array();
    for (const Bin& bin : HistogramOf(summary))
    {
        bins.push_back({{"up_to_us", bin.up_to_us}, {"count", bin.count}});
    }
    report["histogram"] = bins;
    report["map"] = MapOf(campaign, summary);
    report["subjects"] = SubjectsOf(summary);
    report["latent"] = summary.latent;
    const std::size_t silent = summary.silent.size();
    const std::size_t dangerous = silent + summary.exposed.size();
    const auto survivor = [&campaign, &summary, silent, dangerous](const std::size_t index)
    {
        if (index < silent)
        {
            return SurvivorOf(campaign, summary.silent[index]);
        }
        return SurvivorOf(campaign,
                          (index < dangerous) ? summary.exposed[index - silent] : summary.late[index - dangerous]);
    };
    WriteWithSurvivors(report, dangerous + summary.late.size(), survivor, write);
}
} // namespace counterpoint::campaign
