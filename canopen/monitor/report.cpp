// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/monitor/report.hpp"

#include "canopen/monitor/contradictions.hpp"
#include "canopen/monitor/texts.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <numeric>
#include <ostream>

namespace counterpoint::monitor
{
namespace
{
using Json = nlohmann::ordered_json;

std::string IdentifierName(const std::uint32_t identifier)
{
    return cia306::Hex(identifier, 3).substr(2U) + "h";
}

void WriteTimes(const char* const name, const TimeStatistics& times, std::ostream& out)
{
    if (times.count == 0U)
    {
        out << "  " << name << "  none measured, limit " << MillisecondsText(times.limit) << "\n";
        return;
    }
    out << "  " << name << "  least " << MillisecondsText(times.least) << ", mean " << MillisecondsText(times.Mean())
        << ", greatest " << MillisecondsText(times.greatest) << ", limit " << MillisecondsText(times.limit)
        << ", margin " << MillisecondsText(times.limit - times.greatest) << "\n";
}

std::size_t Total(const std::array<std::size_t, kCauseCount>& counts)
{
    return std::accumulate(counts.begin(), counts.end(), std::size_t{0U});
}

double Milliseconds(const Time time)
{
    return static_cast<double>(time) / static_cast<double>(kMillisecond);
}

Json TimesJson(const TimeStatistics& times)
{
    Json answer{{"count", times.count}, {"limit_ms", Milliseconds(times.limit)}};
    if (times.count != 0U)
    {
        answer["min_ms"] = Milliseconds(times.least);
        answer["mean_ms"] = Milliseconds(times.Mean());
        answer["max_ms"] = Milliseconds(times.greatest);
        answer["margin_ms"] = Milliseconds(times.limit - times.greatest);
    }
    return answer;
}

Json EndJson(const Network& network, const std::optional<SrdoEnd>& end)
{
    return end ? Json{{"node", network.Nodes()[end->node].name}, {"srdo", end->number}} : Json(nullptr);
}

Json SrdoJson(const Report& report, const std::size_t number)
{
    const WatchModel& model = report.network.Watches()[number];
    const SrdoWatch& watch = report.analysis.Watches()[number];
    const auto& counts = report.analysis.CountsOf(number);
    Json answer{{"producer", EndJson(report.network, model.producer)},
                {"consumer", EndJson(report.network, model.consumer)},
                {"normal_id", model.setup.normal_id},
                {"inverse_id", model.setup.inverse_id},
                {"detection", model.setup.is_late ? "late" : "early"},
                {"pairs", watch.PairCount()},
                {"violations", Total(counts)},
                {"causes", Json::object()},
                {"cycle", TimesJson(watch.Cycle())},
                {"srvt", TimesJson(watch.Srvt())}};
    for (std::size_t cause = 0U; cause < kCauseCount; ++cause)
    {
        if (counts.at(cause) != 0U)
        {
            answer["causes"][CauseName(static_cast<Cause>(cause))] = counts.at(cause);
        }
    }
    return answer;
}

Json ViolationJson(const Violation& violation)
{
    Json watchers = Json::array();
    for (const std::size_t watch : violation.watches)
    {
        watchers.push_back(watch);
    }
    return {{"time_s", static_cast<double>(violation.breach.time) / static_cast<double>(kSecond)},
            {"cause", CauseName(violation.breach.cause)},
            {"srdos", watchers},
            {"details", violation.breach.details}};
}

Json FramesJson(const std::vector<FrameText>& frames)
{
    Json answer = Json::array();
    for (const FrameText& frame : frames)
    {
        answer.push_back(
            {{"time_s", static_cast<double>(frame.time) / static_cast<double>(kSecond)}, {"text", frame.text}});
    }
    return answer;
}
} // namespace

std::vector<std::size_t> Silent(const Report& report)
{
    const auto& watches = report.analysis.Watches();
    const bool is_any =
        std::any_of(watches.begin(), watches.end(), [](const SrdoWatch& watch) { return watch.PairCount() != 0U; });
    std::vector<std::size_t> silent;
    for (std::size_t number = 0U; number < watches.size(); ++number)
    {
        const WatchModel& model = report.network.Watches()[number];
        const bool has_both = model.producer && model.consumer;
        if (watches[number].PairCount() == 0U && (has_both || !is_any))
        {
            silent.push_back(number);
        }
    }
    return silent;
}

bool HasMissed(const Report& report)
{
    return report.missed.malformed != 0U || report.missed.lost_frames != 0U;
}

bool Holds(const Report& report)
{
    return report.analysis.ViolationCount() == 0U && Silent(report).empty() && !HasMissed(report);
}

std::string Watchers(const Network& network, const Violation& violation)
{
    std::string names;
    for (const std::size_t watch : violation.watches)
    {
        names += (names.empty() ? "" : "; ") + network.NameOf(network.Watches()[watch]);
    }
    return names;
}

std::string ViolationText(const Network& network, const Violation& violation)
{
    if (violation.watches.empty())
    {
        return SecondsText(violation.breach.time) + " " + CauseName(violation.breach.cause) + ": " +
               violation.breach.details;
    }
    const WatchSetup& setup = network.Watches()[violation.watches.front()].setup;
    return SecondsText(violation.breach.time) + " " + CauseName(violation.breach.cause) + ": " +
           Watchers(network, violation) + " (" + IdentifierName(setup.normal_id) + ", " +
           IdentifierName(setup.inverse_id) + "): " + violation.breach.details;
}

std::string OthersText(const Report& report)
{
    return std::to_string(report.origin.other_frames) + " frames of other interfaces were not judged, the last at " +
           SecondsText(report.origin.other_last) + "; judged: " + cia306::Quoted(report.origin.interface) + ", until " +
           SecondsText(report.analysis.Last());
}

std::string MissedText(const Report& report)
{
    return std::to_string(report.missed.malformed) + " malformed elements and " +
           std::to_string(report.missed.lost_frames) + " lost frames: what was in them was not judged";
}

void WriteSummary(const Report& report, std::ostream& out)
{
    out << report.analysis.FrameCount() << " frames";
    for (std::size_t service = 0U; service < kServiceCount; ++service)
    {
        const std::size_t count = report.analysis.Frames().at(service);
        if (count != 0U)
        {
            out << ", " << count << " " << ServiceName(static_cast<Service>(service));
        }
    }
    const bool is_watched = !report.network.Watches().empty();
    out << "; " << SecondsText(report.analysis.Last() - report.analysis.First()) << " s; "
        << (is_watched ? std::to_string(report.analysis.ViolationCount()) + " violations" : "no SRDO was watched")
        << "\n";
    if (report.origin.other_frames != 0U)
    {
        out << OthersText(report) << "\n";
    }
    if (HasMissed(report))
    {
        out << MissedText(report) << "\n";
    }
    const std::vector<std::size_t> silent = Silent(report);
    for (std::size_t number = 0U; number < report.network.Watches().size(); ++number)
    {
        const WatchModel& model = report.network.Watches()[number];
        const SrdoWatch& watch = report.analysis.Watches()[number];
        const auto& counts = report.analysis.CountsOf(number);
        out << report.network.NameOf(model) << " (" << IdentifierName(model.setup.normal_id) << ", "
            << IdentifierName(model.setup.inverse_id) << (model.setup.is_late ? ", late" : "")
            << "): " << watch.PairCount() << " pairs, " << Total(counts) << " violations";
        for (std::size_t cause = 0U; cause < kCauseCount; ++cause)
        {
            if (counts.at(cause) != 0U)
            {
                out << ", " << counts.at(cause) << " " << CauseName(static_cast<Cause>(cause));
            }
        }
        out << "\n";
        WriteTimes("cycle", watch.Cycle(), out);
        WriteTimes("SRVT ", watch.Srvt(), out);
        out << (std::count(silent.begin(), silent.end(), number) == 0
                    ? ""
                    : "  no valid pair came, expected at least one\n");
    }
}

std::string JsonReport(const Report& report)
{
    const Analysis& analysis = report.analysis;
    const auto [first, last] = analysis.FrameTimes();
    const auto time = [&analysis](const Time at)
    { return (analysis.FrameCount() == 0U) ? Json() : Json(static_cast<double>(at) / static_cast<double>(kSecond)); };
    Json answer{{"format", "counterpoint-monitor-1"},
                {"source", report.source},
                {"holds", Holds(report)},
                {"interface", report.origin.interface.empty() ? Json() : Json(report.origin.interface)},
                {"frames", analysis.FrameCount()},
                {"other_frames", report.origin.other_frames},
                {"other_last_s", report.origin.other_frames == 0U ? Json()
                                                                  : Json(static_cast<double>(report.origin.other_last) /
                                                                         static_cast<double>(kSecond))},
                {"first_s", time(first)},
                {"last_s", time(last)},
                {"services", Json::object()},
                {"malformed", report.missed.malformed},
                {"lost_frames", report.missed.lost_frames},
                {"absences", report.missed.absences},
                {"violation_count", analysis.ViolationCount()},
                {"violations", Json::array()},
                {"warnings", Json::array()},
                {"silent", Silent(report)},
                {"srdos", Json::array()}};
    for (std::size_t service = 0U; service < kServiceCount; ++service)
    {
        answer["services"][ServiceName(static_cast<Service>(service))] = analysis.Frames().at(service);
    }
    for (const Contradiction& contradiction : ContradictionsOf(report.network))
    {
        answer["warnings"].push_back({{"file", contradiction.file},
                                      {"line", contradiction.finding.place.line},
                                      {"column", contradiction.finding.place.column},
                                      {"object", contradiction.finding.object},
                                      {"message", contradiction.finding.text}});
    }
    if (!report.origin.doubt.empty())
    {
        answer["warnings"].push_back(
            {{"file", report.source}, {"line", 0}, {"column", 0}, {"object", ""}, {"message", report.origin.doubt}});
    }
    for (const Violation& violation : report.violations)
    {
        answer["violations"].push_back(ViolationJson(violation));
    }
    for (std::size_t number = 0U; number < report.network.Watches().size(); ++number)
    {
        answer["srdos"].push_back(SrdoJson(report, number));
    }
    if (report.frames != nullptr)
    {
        answer["frame_texts"] = FramesJson(*report.frames);
    }
    return answer.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}
} // namespace counterpoint::monitor
