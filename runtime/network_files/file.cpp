// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/network_files/file.hpp"

#include "runtime/manager/report/texts.hpp"
#include "runtime/network_files/profiles.hpp"
#include "runtime/yaml/optional_values.hpp"

#include "canopen/cia306/text/ini_document.hpp"
#include "canopen/cia306/text/input_error.hpp"
#include "canopen/network_plan/cpj_reader.hpp"

#include <filesystem>

namespace counterpoint::runtime
{
namespace
{
using network_plan::ManagerPlan;
using network_plan::NetworkPlan;
using network_plan::SlavePlan;
using network_plan::SoftwarePlan;

constexpr Word<cia302::Arming> kArmingWords[] = {{"first_heartbeat", cia302::Arming::kFirstHeartbeat},
                                                 {"boot_up", cia302::Arming::kBootUp},
                                                 {"immediately", cia302::Arming::kImmediately}};

std::string TextOf(const YamlMap& map, const char* key, const std::string& expected)
{
    const auto value = map.Find(key);
    return value ? value->Text(expected) : std::string{};
}

std::string FileIn(const std::string& file, const YamlMap& map, const char* key, const std::string& kind)
{
    const auto value = map.Find(key);
    std::string path;
    if (value)
    {
        path = network_plan::BesideFile(file, value->Text("a file name"));
        const std::string problem = network_plan::ProblemOfFile(path);
        if (!problem.empty())
        {
            value->Refuse(problem, kind);
        }
    }
    return path;
}

ManagerPlan ReadManager(const std::string& file, const YamlValue& value)
{
    const YamlMap map(file, value.Node(),
                      {"node", "dcf", "profile", "start_up", "boot_time", "inhibit", "sync", "heartbeat", "sdo_timeout",
                       "sdo_tries", "flying", "el6751"});
    constexpr std::uint64_t kStartUpBits = 0x7FU;
    constexpr std::uint32_t kLongestSdoMs = 1000000U;
    constexpr Nanoseconds kHundredUs = 100 * kNanosecondsPerMicrosecond;
    ManagerPlan plan;
    plan.place = value.Where().place;
    plan.places = map.Places();
    TakeNumber(map, "node", plan.node, 1U, cia302::kLastNode);
    plan.dcf = FileIn(file, map, "dcf", "a DCF");
    TakeWord(map, "profile", plan.profile, kProfileWords);
    TakeNumber(map, "start_up", plan.start_up, 0U, kStartUpBits);
    if (plan.start_up && (*plan.start_up & cia302::kIsMaster) == 0U)
    {
        map.Require("start_up").Refuse(cia306::Hex(*plan.start_up, 1), "bit 0: a manager is an NMT master");
    }
    TakeMs(map, "boot_time", plan.boot_time_ms);
    TakeTime(map, "inhibit", plan.inhibit_100us, kHundredUs, "tenths of a millisecond");
    TakeTime(map, "sync", plan.sync_us, kNanosecondsPerMicrosecond, "microseconds");
    TakeMs(map, "heartbeat", plan.heartbeat_ms);
    TakeMs(map, "sdo_timeout", plan.sdo_time_out_ms);
    if (plan.sdo_time_out_ms.value_or(1U) == 0U || plan.sdo_time_out_ms.value_or(1U) > kLongestSdoMs)
    {
        map.Require("sdo_timeout").Refuse(std::to_string(*plan.sdo_time_out_ms) + " ms", "1 ms to 1000 s");
    }
    TakeNumber(map, "sdo_tries", plan.sdo_tries, 1U);
    TakePart(file, map, "el6751", plan.el6751, ReadEl6751Times);
    TakePart(file, map, "flying", plan.flying, ReadFlying);
    return plan;
}

void ReadExpectations(const YamlMap& map, SlavePlan& plan)
{
    TakeNumber(map, "device_type", plan.device_type, 0U);
    TakeNumber(map, "vendor_id", plan.vendor_id, 0U);
    TakeNumber(map, "product_code", plan.product_code, 0U);
    TakeNumber(map, "revision", plan.revision, 0U);
    TakeNumber(map, "serial", plan.serial, 0U);
    TakeNumber(map, "date", plan.date, 0U);
    TakeNumber(map, "time", plan.time, 0U);
}

void ReadAssignment(const YamlMap& map, SlavePlan& plan)
{
    TakeNumber(map, "assignment", plan.assignment, 0U);
    if (plan.assignment && (*plan.assignment & cia302::kInNetwork) == 0U)
    {
        map.Require("assignment").Refuse(cia306::Hex(*plan.assignment, 1), "bit 0: a slave of the network");
    }
    TakeWord(map, "mandatory", plan.is_mandatory, kTruthWords);
    TakeWord(map, "keep_alive", plan.is_kept_alive, kTruthWords);
    TakeWord(map, "boot", plan.is_booted, kTruthWords);
    TakeNumber(map, "restore", plan.restore_sub, 0U, cia302::kLastNode);
    plan.is_restored = plan.restore_sub ? std::optional(*plan.restore_sub > 0U) : std::nullopt;
    TakeMs(map, "heartbeat", plan.heartbeat_ms);
    TakeMs(map, "consumer", plan.consumer_ms);
    TakeWord(map, "arming", plan.arming, kArmingWords);
    TakeMs(map, "guard_time", plan.guard_ms);
    TakeNumber(map, "retry_factor", plan.retry_factor, 0U);
}

SoftwarePlan ReadSoftware(const std::string& file, const YamlValue& value)
{
    const YamlMap map(file, value.Node(), {"identification", "date", "time", "program", "update"});
    SoftwarePlan plan;
    TakeNumber(map, "identification", plan.identification, 0U);
    TakeNumber(map, "date", plan.date, 0U);
    TakeNumber(map, "time", plan.time, 0U);
    plan.program = FileIn(file, map, "program", "a program");
    TakeWord(map, "update", plan.may_update, kTruthWords);
    return plan;
}

SlavePlan ReadSlave(const std::string& file, const YamlValue& value)
{
    const YamlMap map(file, value.Node(),
                      {"node",         "name",        "dcf",       "assignment",   "mandatory", "keep_alive",
                       "boot",         "restore",     "heartbeat", "consumer",     "arming",    "guard_time",
                       "retry_factor", "device_type", "vendor_id", "product_code", "revision",  "serial",
                       "date",         "time",        "configure", "write_safety", "el6751",    "plc_designer",
                       "outputs",      "software"});
    SlavePlan plan;
    plan.place = value.Where().place;
    plan.places = map.Places();
    plan.node = static_cast<std::uint8_t>(map.Require("node").Number({1U, cia302::kLastNode}));
    plan.name = TextOf(map, "name", "a name");
    plan.name = plan.name.empty() ? "node " + std::to_string(plan.node) : plan.name;
    plan.dcf = FileIn(file, map, "dcf", "a DCF");
    ReadAssignment(map, plan);
    ReadExpectations(map, plan);
    TakePart(file, map, "software", plan.software, ReadSoftware);
    if (const auto options = map.Find("el6751"))
    {
        ReadEl6751Slave(file, *options, plan);
    }
    if (const auto options = map.Find("plc_designer"))
    {
        plan.plc = ReadPlcSlave(file, *options, plan.is_mandatory.value_or(true));
    }
    TakePart(file, map, "outputs", plan.outputs, ReadOutputs);
    TakeWord(map, "configure", plan.is_configured, kTruthWords);
    TakeWord(map, "write_safety", plan.writes_safety, kTruthWords);
    return plan;
}

NetworkPlan ReadYaml(const std::string& path, const std::uint8_t manager)
{
    const YamlNode document = ParseYaml(path, ReadYamlText(path));
    const YamlMap map(path, document, {"name", "manager", "slaves"});
    NetworkPlan plan;
    plan.file = path;
    plan.name = TextOf(map, "name", "a name");
    plan.manager = ReadManager(path, map.Require("manager"));
    if (manager != 0U)
    {
        plan.manager.node = manager;
    }
    for (const YamlValue& slave : map.Require("slaves").Items("a list of slaves"))
    {
        plan.slaves.push_back(ReadSlave(path, slave));
    }
    return plan;
}

/// Before it is read as something: neither reader knows what the file was to be.
void RequireNetworkFile(const std::string& path)
{
    constexpr std::uintmax_t kMostBytes = kMaxYamlBytes;
    const std::string problem = network_plan::ProblemOfFile(path);
    if (!problem.empty())
    {
        throw cia306::InputError(path, {}, {problem, "a network file, CPJ or YAML"});
    }
    std::error_code error;
    const std::uintmax_t bytes = std::filesystem::file_size(path, error);
    if (bytes > kMostBytes)
    {
        throw cia306::InputError(
            path, {},
            {"a network file of " + std::to_string(bytes) + " bytes", "at most " + std::to_string(kMostBytes)});
    }
}
} // namespace

NetworkPlan ReadNetworkFile(const std::string& path, const std::uint8_t manager, const std::string& profile)
{
    RequireNetworkFile(path);
    const std::string extension = cia306::Lower(std::filesystem::path(path).extension().string());
    NetworkPlan plan = (extension == ".cpj") ? network_plan::ReadCpj(path, manager) : ReadYaml(path, manager);
    for (const Word<network_plan::StartProfile>& word : kProfileWords)
    {
        if (profile == word.text)
        {
            plan.manager.profile = word.meaning;
            plan.manager.is_profile_chosen = true;
        }
    }
    return plan;
}
} // namespace counterpoint::runtime
