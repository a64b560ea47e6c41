// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/report/page_parts.hpp"
#include "simulator/report/reports.hpp"
#include "simulator/scenario/names.hpp"

#include <filesystem>
#include <string>

namespace counterpoint::simulator
{
namespace
{
using Json = nlohmann::ordered_json;

constexpr Word<EventKind> kEventWords[] = {
    {"nmt", EventKind::kNmt},
    {"input", EventKind::kInput},
    {"acknowledge", EventKind::kAcknowledge},
    {"gfc", EventKind::kGfc},
    {"power_on", EventKind::kPowerOn},
    {"fault", EventKind::kFault},
    {"frame_changed", EventKind::kFrameChanged},
    {"view_a", EventKind::kViewA},
    {"view_b", EventKind::kViewB},
    {"cause_a", EventKind::kCauseA},
    {"cause_b", EventKind::kCauseB},
    {"verdict", EventKind::kVerdict},
    {"demotion", EventKind::kDemotion},
    {"permits", EventKind::kPermits},
    {"output", EventKind::kOutput},
    {"value", EventKind::kValue},
    {"signal", EventKind::kSignal},
    {"device_fault", EventKind::kDeviceFault},
    {"watchdog", EventKind::kWatchdog},
    {"hung", EventKind::kHung},
    {"configuration_invalid", EventKind::kConfigurationInvalid},
    {"reception", EventKind::kReception},
    {"power_off", EventKind::kPowerOff},
    {"no_start", EventKind::kNoStart},
    {"self_test", EventKind::kSelfTest},
    {"link", EventKind::kLink},
    {"link_message", EventKind::kLinkMessage},
    {"time", EventKind::kTime},
    {"emergency", EventKind::kEmergency},
    {"new_node_id", EventKind::kNewNodeId},
    {"store", EventKind::kStore},
};

constexpr Word<host::FrameFate> kFateWords[] = {
    {"complete", host::FrameFate::kComplete},      {"hit", host::FrameFate::kHit},
    {"collision", host::FrameFate::kCollision},    {"not_acknowledged", host::FrameFate::kNotAcknowledged},
    {"sender_gone", host::FrameFate::kSenderGone},
};

constexpr Word<std::uint8_t> kDirectionWords[] = {
    {"off", kDirectionOff}, {"producer", kDirectionProducer}, {"consumer", kDirectionConsumer}};

Json NodesToJson(const Run& run)
{
    Json nodes = Json::array();
    for (NodeIndex node = 0U; node < run.Setting().nodes.size(); ++node)
    {
        const runtime::DeviceModel& model = run.ModelOf(node);
        Json srdos = Json::array();
        for (const runtime::SrdoModel& srdo : model.Srdos())
        {
            srdos.push_back({{"number", srdo.number},
                             {"slot", model.SlotOf(srdo.number).value_or(0U)},
                             {"direction", NameOf(kDirectionWords, srdo.direction)},
                             {"sct_ms", srdo.times.sct_ms},
                             {"srvt_ms", srdo.times.srvt_ms},
                             {"cob_id_1", srdo.cob_id_1},
                             {"cob_id_2", srdo.cob_id_2}});
        }
        const NodeSetup& setup = run.Setting().nodes[node];
        nodes.push_back(
            {{"name", run.NodeName(node)},
             {"device", setup.device},
             {"cpu", (setup.role == runtime::CpuRole::kWhole) ? Json()
                                                              : Json((setup.role == runtime::CpuRole::kA) ? "a" : "b")},
             {"node_id", model.Config().node_id},
             {"dcf", std::filesystem::path(model.File()).filename().string()},
             {"cycle_us", model.Config().cycle_us},
             {"discrepancy_us", model.Config().discrepancy_us},
             {"self_tests", setup.self_tests},
             {"srdos", srdos}});
    }
    return nodes;
}

Json FramesToJson(const Run& run)
{
    Json frames = Json::array();
    for (const FrameEntry& entry : run.Record().Frames())
    {
        frames.push_back({{"start_ns", entry.start},
                          {"end_ns", entry.end},
                          {"identifier", entry.frame.identifier},
                          {"data", DataText(entry.frame, " ")},
                          {"sender", (entry.sender == kNoNode) ? Json() : Json(run.NodeName(entry.sender))},
                          {"fate", NameOf(kFateWords, entry.fate)}});
    }
    return frames;
}

/// What a program wants as a word or number instead of a sentence.
void AddDetails(const Run& run, const Event& event, Json& json)
{
    switch (event.kind)
    {
    case EventKind::kViewA:
    case EventKind::kViewB:
        json["state"] = NameOf(runtime::kStateWords, static_cast<SrdoState>(event.value));
        return;
    case EventKind::kNmt:
        json["state"] = Name(static_cast<NmtState>(event.value));
        return;
    case EventKind::kSignal:
    case EventKind::kCauseA:
    case EventKind::kCauseB:
        json["cause"] = Name(static_cast<SrdoCause>(event.value));
        return;
    case EventKind::kDeviceFault:
        json["fault"] = Name(static_cast<DeviceFault>(event.value));
        return;
    case EventKind::kFault:
        json["fault"] = run.Setting().faults[event.value].name;
        json["place"] = event.value;
        return;
    case EventKind::kLink:
        json["state"] = NameOf(kLinkStateWords, static_cast<LinkState>(event.value));
        json["finding"] = NameOf(kLinkFindingWords, static_cast<LinkFinding>(event.other));
        return;
    case EventKind::kFrameChanged:
        json["identifier"] = event.value;
        return;
    case EventKind::kOutput:
    case EventKind::kPermits:
    case EventKind::kDemotion:
    case EventKind::kAcknowledge:
        json["value"] = event.value;
        return;
    case EventKind::kVerdict:
        json["agreed"] = event.value;
        json["matched"] = event.other;
        return;
    case EventKind::kValue:
    case EventKind::kInput:
        json["object"] =
            ObjectText({static_cast<std::uint16_t>(event.other >> 8U), static_cast<std::uint8_t>(event.other & 0xFFU)});
        json["value"] = event.value;
        return;
    case EventKind::kStore:
        json["object"] =
            ObjectText({static_cast<std::uint16_t>(event.other >> 8U), static_cast<std::uint8_t>(event.other)});
        json["value"] = event.value;
        json["abort"] = event.other >> 32U;
        return;
    case EventKind::kReception:
        json["identifier"] = event.value;
        json["good"] = event.other != 0U;
        return;
    default:
        return;
    }
}

Json EventsToJson(const Run& run)
{
    Json events = Json::array();
    for (const Event& event : run.Record().Events())
    {
        Json json{{"at_ns", event.at}, {"kind", NameOf(kEventWords, event.kind)}};
        json["node"] = (event.node == kNoNode) ? Json() : Json(run.NodeName(event.node));
        if (event.srdo != 0U)
        {
            json["srdo"] = event.srdo;
        }
        AddDetails(run, event, json);
        if (event.kind != EventKind::kReception)
        {
            json["text"] = EventText(run, event);
        }
        events.push_back(std::move(json));
    }
    return events;
}

/// What each manager told, as in its log.
Json ManagersToJson(const Run& run)
{
    Json managers = Json::array();
    if (run.Managed() == nullptr)
    {
        return managers;
    }
    NodeIndex place = run.Setting().nodes.size();
    for (const std::uint8_t node : run.Managed()->Managers())
    {
        Json events = Json::array();
        for (const ManagerEntry& entry : run.Record().Managers())
        {
            if (entry.manager == place)
            {
                events.push_back(Json::parse(entry.line));
            }
        }
        managers.push_back({{"node", node}, {"name", run.NodeName(place)}, {"events", events}});
        ++place;
    }
    return managers;
}

Json MeasurementToJson(const Run& run, const Measurement& measurement)
{
    const auto time = [](const Nanoseconds at) { return (at < 0) ? Json() : Json(at); };
    return {{"fault", run.Setting().faults[measurement.fault].name},
            {"node", measurement.place},
            {"srdo", measurement.srdo},
            {"limit_class", Name(measurement.fault_class)},
            {"limit_ns", time(measurement.limit)},
            {"effect_ns", time(measurement.effect)},
            {"reference_ns", time(measurement.reference)},
            {"closed_ns", time(measurement.closed)},
            {"elapsed_ns", time(measurement.elapsed)},
            {"closed_by_another_fault", measurement.is_of_another},
            {"detected_by", Name(measurement.detection.party)},
            {"detection_cause", measurement.detection.cause},
            {"detected_ns", time(measurement.detection.at)},
            {"holds", measurement.Holds()}};
}

Json ExpectationsToJson(const Run& run)
{
    Json expectations = Json::array();
    for (const ExpectationVerdict& verdict : run.Verdicts())
    {
        Json json{{"holds", verdict.holds}, {"wanted", verdict.wanted}, {"seen", verdict.seen}};
        if (verdict.measurement)
        {
            json["measurement"] = MeasurementToJson(run, *verdict.measurement);
        }
        expectations.push_back(std::move(json));
    }
    return expectations;
}
} // namespace

nlohmann::ordered_json RunToJson(const Run& run)
{
    const Scenario& scenario = run.Setting();
    Json faults = Json::array();
    for (const FaultSetup& fault : scenario.faults)
    {
        faults.push_back({{"name", fault.name}, {"kind", Name(fault.kind)}});
    }
    return {{"format", "counterpoint-simulation-1"},
            {"scenario", std::filesystem::path(scenario.file).filename().string()},
            {"title", scenario.title},
            {"description", scenario.description},
            {"seed", scenario.seed},
            {"profile", scenario.profile.empty() ? Json() : Json(scenario.profile)},
            {"bitrate", scenario.bitrate},
            {"duration_ns", scenario.duration},
            {"holds", run.Holds()},
            {"nodes", NodesToJson(run)},
            {"managers", ManagersToJson(run)},
            {"faults", faults},
            {"expectations", ExpectationsToJson(run)},
            {"frames", FramesToJson(run)},
            {"events", EventsToJson(run)}};
}

std::string JsonReport(const Run& run)
{
    return RunToJson(run).dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}
} // namespace counterpoint::simulator
