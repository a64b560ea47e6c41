// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/elections/failover_record.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

namespace counterpoint::elections
{
namespace
{

using Json = nlohmann::ordered_json;

Json Bins(const Tally& tally)
{
    Json bins = Json::array();
    for (const auto& [late, count] : tally.late_us)
    {
        bins.push_back({{"from_us", late}, {"count", count}});
    }
    return bins;
}

Json Times(const Tally& tally)
{
    Json times = Json::array();
    for (const auto& [computed, lateness] : tally.failovers)
    {
        times.push_back({{"computed_us", computed},
                         {"runs", lateness.runs},
                         {"least_us", computed + lateness.least},
                         {"greatest_us", computed + lateness.greatest}});
    }
    return times;
}

} // namespace

bool WriteFailovers(const std::string& path, const std::vector<FailoverSeries>& all)
{
    constexpr int kIndent = 1;
    constexpr Time kBin = 100;
    bool holds = !all.empty();
    Json series = Json::array();
    for (const FailoverSeries& one : all)
    {
        Lateness lateness{};
        for (const auto& [computed, of_computed] : one.tally.failovers)
        {
            lateness.Add(of_computed);
        }
        holds = holds && (one.tally.failures == 0U) && (lateness.runs > 0U);
        series.push_back({{"name", one.name},
                          {"runs", one.tally.runs},
                          {"failed", one.tally.failures},
                          {"first_failure", one.tally.first_failure},
                          {"least_late_us", lateness.least},
                          {"greatest_late_us", lateness.greatest},
                          {"bins", Bins(one.tally)},
                          {"times", Times(one.tally)}});
    }
    const Json record = {{"cycle_us", WorldPlan{}.cycle},
                         {"bin_us", kBin},
                         {"series", series},
                         {"requirements", {{"SRS_FLY_026", holds}}}};
    const std::filesystem::path parent = std::filesystem::path(path).parent_path();
    std::error_code ignored{};
    if (!parent.empty())
    {
        std::filesystem::create_directories(parent, ignored);
    }
    std::ofstream file(path);
    file << record.dump(kIndent) << "\n";
    return file.good();
}

} // namespace counterpoint::elections
