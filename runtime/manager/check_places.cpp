// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Where in the files of flying masters something stands, and what of it does not go together.
#include "runtime/manager/check_places.hpp"

#include "canopen/cia306/text/input_error.hpp"
#include "runtime/manager/check.hpp"

#include <algorithm>
#include <array>

namespace counterpoint::runtime
{
namespace
{
using cia302::FlyingFinding;
using cia302::FlyingFindingKind;
using cia302::MasterWatch;
using network_plan::LoadedNetwork;
using network_plan::LoadedSlave;

constexpr std::uint8_t kAnySub = 0xFFU;

struct ObjectKey
{
    std::uint16_t index;
    std::uint8_t sub;
    const char* key;
};

constexpr std::array<ObjectKey, 9> kOfManager{{{0x1F90U, 1U, "timeout"},
                                               {0x1F90U, 2U, "delay"},
                                               {0x1F90U, 3U, "priority"},
                                               {0x1F90U, 4U, "level_slot"},
                                               {0x1F90U, 5U, "node_slot"},
                                               {0x1F80U, kAnySub, "start_up"},
                                               {0x1F89U, kAnySub, "boot_time"},
                                               {0x102AU, kAnySub, "inhibit"},
                                               {0x1006U, kAnySub, "sync"}}};
constexpr std::array<ObjectKey, 15> kOfSlave{{{0x1F81U, kAnySub, "assignment"},
                                              {0x1F84U, kAnySub, "device_type"},
                                              {0x1F85U, kAnySub, "vendor_id"},
                                              {0x1F86U, kAnySub, "product_code"},
                                              {0x1F87U, kAnySub, "revision"},
                                              {0x1F88U, kAnySub, "serial"},
                                              {0x1F8AU, kAnySub, "restore"},
                                              {0x1F26U, kAnySub, "date"},
                                              {0x1F27U, kAnySub, "time"},
                                              {0x1F53U, kAnySub, "software"},
                                              {0x1F54U, kAnySub, "software"},
                                              {0x1F55U, kAnySub, "software"},
                                              {0x1F58U, kAnySub, "software"},
                                              {0x1016U, kAnySub, "consumer"},
                                              {0x1017U, kAnySub, "heartbeat"}}};

constexpr std::array<const char*, 9> kOfFlying{"timeout",    "delay",   "priority", "level_slot", "node_slot",
                                               "watch_time", "standby", "cyclic",   "claim_heard"};

/// 0: nobody watches.
std::uint32_t WatchMsOf(const LoadedNetwork& net, const cia302::NodeId other)
{
    const network_plan::ManagerPlan& plan = net.Plan().manager;
    const cia302::FlyingMasterOptions options = plan.flying.value_or(network_plan::FlyingPlan{}).options;
    const std::uint32_t own_ms = plan.heartbeat_ms.value_or(0U);
    const bool is_twice = options.watch == MasterWatch::kTwiceProducer && own_ms > 0U;
    const std::uint32_t consumer_ms = net.Setup().Slave(other).heartbeat.consumer_ms;
    const std::uint32_t installed_ms = is_twice ? (2U * own_ms) : options.watch_ms;
    const std::uint32_t otherwise_ms = (options.watch == MasterWatch::kApplication) ? 0U : installed_ms;
    return (consumer_ms > 0U) ? consumer_ms : otherwise_ms;
}

/// How `one` stands to `other`.
void TellTogether(const LoadedNetwork& one, const LoadedNetwork& other, std::vector<std::string>& lines)
{
    const cia302::NodeId node = other.Setup().own;
    const std::uint32_t watch_ms = WatchMsOf(one, node);
    const std::uint32_t heartbeat_ms = other.Plan().manager.heartbeat_ms.value_or(0U);
    if (one.Setup().IsListed(node) && watch_ms > 0U && watch_ms <= heartbeat_ms)
    {
        const bool is_consumer = one.Setup().Slave(node).heartbeat.consumer_ms > 0U;
        const CheckedKey key = is_consumer ? CheckedKey{node.value, "consumer"} : CheckedKey{0U, "watch_time"};
        lines.push_back(PlaceOf(one, key) + ": master " + std::to_string(node.value) + " is watched by " +
                        std::to_string(watch_ms) + " ms, expected more than the " + std::to_string(heartbeat_ms) +
                        " ms of its heartbeat in " + PlaceOf(other, {0U, "heartbeat"}));
    }
    const network_plan::FlyingPlan flying = one.Plan().manager.flying.value_or(network_plan::FlyingPlan{});
    const network_plan::FlyingPlan others = other.Plan().manager.flying.value_or(network_plan::FlyingPlan{});
    const bool is_race_cyclic = others.options.cyclic == cia302::CyclicMessage::kNegotiation;
    if (flying.options.ignores_claims && is_race_cyclic && flying.options.cyclic == others.options.cyclic)
    {
        lines.push_back(PlaceOf(one, {0U, "claim_heard"}) +
                        ": claim_heard is ignores, expected compares beside cyclic " + "negotiation of " +
                        PlaceOf(other, {0U, "cyclic"}) + ": two such masters never end");
    }
    if (flying.options.standby == cia302::StandbyReaction::kRaces && is_race_cyclic)
    {
        lines.push_back(PlaceOf(one, {0U, "standby"}) + ": standby is races, expected ignores or asks beside cyclic " +
                        "negotiation of " + PlaceOf(other, {0U, "cyclic"}) + ": such masters elect without end");
    }
}
} // namespace

CheckedKey KeyOf(const FlyingFinding& finding)
{
    const std::uint8_t node = finding.slave.value;
    CheckedKey key{node, (node == 0U) ? "" : "dcf"};
    const auto take = [&](const ObjectKey& row)
    {
        const bool is_it = row.index == finding.index && (row.sub == finding.sub || row.sub == kAnySub);
        key.key = is_it ? row.key : key.key;
    };
    const bool is_object =
        finding.kind == FlyingFindingKind::kValue || finding.kind == FlyingFindingKind::kContent || node == 0U;
    for (const ObjectKey& row : kOfManager)
    {
        if (node == 0U)
        {
            take(row);
        }
    }
    for (const ObjectKey& row : kOfSlave)
    {
        if (node != 0U && is_object)
        {
            take(row);
        }
    }
    const bool is_plc = finding.kind == FlyingFindingKind::kPlcOptional || finding.kind == FlyingFindingKind::kPlcReset;
    key.key = (finding.kind == FlyingFindingKind::kArming) ? "arming" : key.key;
    key.key = (finding.kind == FlyingFindingKind::kProfile) ? "el6751" : key.key;
    key.key = is_plc ? "plc_designer" : key.key;
    return key;
}

std::string PlaceOf(const LoadedNetwork& net, const CheckedKey& key)
{
    const network_plan::ManagerPlan& manager = net.Plan().manager;
    const LoadedSlave* const slave = net.Find(key.node);
    const bool is_slave = key.node != 0U && slave != nullptr;
    const network_plan::KeyLines& lines = is_slave ? slave->plan.lines : manager.lines;
    std::size_t line = is_slave ? slave->plan.line : manager.line;
    const bool has_key = !key.key.empty();
    line = has_key ? network_plan::LineOf(lines, "dcf", line) : line;
    line = has_key ? network_plan::LineOf(lines, key.key, line) : line;
    const bool is_of_flying = std::find(kOfFlying.begin(), kOfFlying.end(), key.key) != kOfFlying.end();
    if (!is_slave && is_of_flying && manager.flying)
    {
        line = network_plan::LineOf(lines, "flying", line);
        line = network_plan::LineOf(manager.flying->lines, key.key, line);
    }
    const std::string file = cia306::Printable(net.Plan().file);
    return (line > 0U) ? (file + ":" + std::to_string(line)) : file;
}

std::vector<std::string> ProblemsTogether(const std::vector<const LoadedNetwork*>& masters)
{
    std::vector<std::string> lines;
    for (const LoadedNetwork* const one : masters)
    {
        for (const LoadedNetwork* const other : masters)
        {
            if (one->Setup().own.value != other->Setup().own.value)
            {
                TellTogether(*one, *other, lines);
            }
        }
    }
    return lines;
}

std::vector<std::string> WarningsOf(const std::vector<const LoadedNetwork*>& masters)
{
    std::vector<std::string> lines;
    for (const LoadedNetwork* const one : masters)
    {
        for (const std::string& warning : one->Warnings())
        {
            const bool is_told =
                std::find(lines.begin(), lines.end(), warning) != lines.end(); // All know the same slaves.
            lines.insert(lines.end(), is_told ? 0U : 1U, warning);
        }
        for (const LoadedNetwork* const other : masters)
        {
            const cia302::NodeId node = other->Setup().own;
            const bool is_other = node.value != one->Setup().own.value && one->Setup().IsListed(node);
            const std::string name = std::to_string(node.value);
            if (is_other && one->Setup().Slave(node).Has(cia302::kMandatory))
            {
                lines.push_back(
                    PlaceOf(*one, {node.value, "mandatory"}) + ": master " + name +
                    " is a mandatory slave: when it fails, the start-up of this one does not end before it is back");
            }
            if (is_other && WatchMsOf(*one, node) == 0U)
            {
                lines.push_back(PlaceOf(*one, {node.value, ""}) + ": nobody watches master " + name +
                                ": when it fails, this one stays slave");
            }
        }
    }
    return lines;
}
} // namespace counterpoint::runtime
