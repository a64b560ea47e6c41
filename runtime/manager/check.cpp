// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The findings of CompareFlyingMasters in words, with their places in the files; what network files say beyond the
// setup of a manager; and what of them does not go together.
#include "runtime/manager/check.hpp"

#include "canopen/cia302/flying_master/compare.hpp"
#include "canopen/cia306/text/input_error.hpp"
#include "runtime/manager/assembly.hpp"
#include "runtime/manager/pdos.hpp"
#include "runtime/manager/report/texts.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace counterpoint::runtime
{
namespace
{
using cia302::FlyingFinding;
using cia302::FlyingFindingKind;
using cia302::MasterWatch;
using network_plan::LoadedNetwork;
using network_plan::LoadedSlave;

/// El6751Part as network files call it.
constexpr std::uint16_t kProgram = 0x1F58U;
constexpr std::array<const char*, cia302::kEl6751Parts> kParts{"profile data",
                                                               "kind",
                                                               "check_device_type",
                                                               "write_sync_period",
                                                               "write_cob_ids",
                                                               "write_types",
                                                               "start",
                                                               "restart_without_pdos",
                                                               "literal_consumer",
                                                               "reaction",
                                                               "restart",
                                                               "network_reaction",
                                                               "life time factor",
                                                               "guard time",
                                                               "coupler_pdos",
                                                               "coupler_inhibit",
                                                               "coupler_event",
                                                               "number of RxPDOs",
                                                               "number of TxPDOs"};

constexpr std::array<std::pair<FlyingFindingKind, const char*>, 3> kNames{
    {{FlyingFindingKind::kArming, "arming"},
     {FlyingFindingKind::kPlcOptional, "optional"},
     {FlyingFindingKind::kPlcReset, "reset_node"}}};

std::string Number(const std::uint64_t value)
{
    return cia306::Hex(value, 1);
}

constexpr std::uint32_t kLastPdo = 512U;
using Outputs = std::map<std::uint32_t, std::vector<std::uint8_t>>;

Outputs OutputsOf(const network_plan::SlavePlan& plan)
{
    Outputs outputs;
    for (const network_plan::OutputPlan& output : plan.outputs)
    {
        outputs[output.number] = output.bytes;
    }
    return outputs;
}

/// What is not said is sent as zeros.
std::string OutputText(const Outputs& outputs, const std::uint32_t number)
{
    const auto found = outputs.find(number);
    const std::vector<std::uint8_t> bytes = (found == outputs.end()) ? std::vector<std::uint8_t>{} : found->second;
    const bool is_zero = std::all_of(bytes.begin(), bytes.end(), [](const std::uint8_t byte) { return byte == 0U; });
    return is_zero ? "zeros" : BytesText(bytes);
}

/// The key of a network file that decides a compared value: of a slave, or of the manager (node 0), the keys of
/// `flying` included.
struct CheckedKey
{
    std::uint8_t node{0U};
    std::string key; ///< Empty: the slave or manager as such.
};

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

/// The key for the object of a finding.
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

/// FILE:LINE of a key. Where the file does not have the key: of `dcf`, from which the value came then, or of the
/// slave or manager.
std::string PlaceOf(const LoadedNetwork& net, const CheckedKey& key)
{
    const network_plan::ManagerPlan& manager = net.Plan().manager;
    const LoadedSlave* const slave = net.Find(key.node);
    const bool is_slave = slave != nullptr; // What is told of a slave stands in a file that has it.
    const network_plan::KeyPlaces& places = is_slave ? slave->plan.places : manager.places;
    cia306::Place place = is_slave ? slave->plan.place : manager.place;
    const bool has_key = !key.key.empty();
    place = has_key ? network_plan::PlaceOf(places, "dcf", place) : place;
    place = has_key ? network_plan::PlaceOf(places, key.key, place) : place;
    const bool is_of_flying = std::find(kOfFlying.begin(), kOfFlying.end(), key.key) != kOfFlying.end();
    if (is_of_flying && manager.flying)
    {
        place = network_plan::PlaceOf(places, "flying", place);
        place = network_plan::PlaceOf(manager.flying->places, key.key, place);
    }
    return cia306::PlaceText(net.Plan().file, {place.line, 0U});
}

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

/// What does not work between these masters although their configurations agree, a line each: a consumer time
/// that is not longer than the heartbeat of the watched master; standbys that race, or masters that ignore 071h, beside
/// one that sends 072h each cycle. O(masters^2) [SRS_MGR_153]
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

class Differences final : public cia302::FlyingFindingListener
{
  public:
    explicit Differences(const std::vector<const LoadedNetwork*>& masters) : masters_(masters)
    {
    }

    void OnFinding(const FlyingFinding& finding) noexcept override
    {
        first_ = masters_[finding.first];
        second_ = masters_[finding.second];
        const bool is_profile = finding.kind == FlyingFindingKind::kProfile &&
                                finding.sub == static_cast<std::uint8_t>(cia302::El6751Part::kProfiles);
        if (finding.first == finding.second)
        {
            TellOfOne(finding);
        }
        else if (!is_profile) // Which data there are follows from the profile, which is compared by its name.
        {
            TellOfTwo(finding);
        }
    }
    /// What is in the network file only.
    void ComparePlans(const LoadedNetwork& first, const LoadedNetwork& second)
    {
        first_ = &first;
        second_ = &second;
        const network_plan::ManagerPlan& one = first.Plan().manager;
        const network_plan::ManagerPlan& other = second.Plan().manager;
        if (one.profile != other.profile)
        {
            Tell({0U, "profile"}, "profile", WordOf(one.profile), WordOf(other.profile));
        }
        const cia302::El6751Times times = one.el6751.value_or(cia302::El6751Times{});
        const cia302::El6751Times others = other.el6751.value_or(cia302::El6751Times{});
        Compare({0U, "el6751"}, "el6751 window", static_cast<std::uint64_t>(times.window),
                static_cast<std::uint64_t>(others.window));
        Compare({0U, "el6751"}, "el6751 sync_multiplier", times.sync_multiplier, others.sync_multiplier);
        Compare({0U, "el6751"}, "el6751 input_shift", times.input_shift_us, others.input_shift_us);
        Compare({0U, "sdo_timeout"}, "sdo_timeout", one.sdo_time_out_ms.value_or(0U),
                other.sdo_time_out_ms.value_or(0U));
        Compare({0U, "sdo_tries"}, "sdo_tries", one.sdo_tries.value_or(0U), other.sdo_tries.value_or(0U));
        for (const auto& slave : first.Slaves())
        {
            const LoadedSlave* const same = second.Find(slave->plan.node);
            if (same != nullptr)
            {
                Compare({slave->plan.node, "write_safety"}, "write_safety of node " + std::to_string(slave->plan.node),
                        slave->plan.writes_safety ? 1U : 0U, same->plan.writes_safety ? 1U : 0U);
                CompareOutputs(*slave, *same);
            }
        }
    }
    [[nodiscard]] const std::vector<std::string>& Lines() const noexcept
    {
        return lines_;
    }

  private:
    /// `key` tells where in the files it stands.
    void Tell(const CheckedKey& key, const std::string& object, const std::string& one, const std::string& other)
    {
        lines_.push_back(PlaceOf(*second_, key) + ": " + object + " is " + other + ", expected " + one + " as in " +
                         PlaceOf(*first_, key));
    }
    void Compare(const CheckedKey& key, const std::string& object, const std::uint64_t one, const std::uint64_t other)
    {
        if (one != other)
        {
            Tell(key, object, Number(one), Number(other));
        }
    }
    void CompareOutputs(const LoadedSlave& one, const LoadedSlave& other)
    {
        const auto firsts = OutputsOf(one.plan);
        const auto seconds = OutputsOf(other.plan);
        for (std::uint32_t number = 1U; number <= kLastPdo; ++number)
        {
            const std::string first = OutputText(firsts, number);
            const std::string second = OutputText(seconds, number);
            if (first != second)
            {
                Tell({one.plan.node, "outputs"},
                     "output of RxPDO " + std::to_string(number) + " of node " + std::to_string(one.plan.node), first,
                     second);
            }
        }
    }

    void TellOfOne(const FlyingFinding& finding)
    {
        const bool is_node = finding.kind == FlyingFindingKind::kSameNode;
        const std::string file = PlaceOf(*second_, is_node ? CheckedKey{0U, "node"} : KeyOf(finding)) + ": ";
        const std::string object = cia306::ObjectName(finding.index, finding.sub);
        if (finding.kind == FlyingFindingKind::kNotFlying)
        {
            lines_.push_back(file + object + " is " + Number(finding.first_value) +
                             ", expected bit 5: a flying master");
        }
        else if (finding.kind == FlyingFindingKind::kSlots)
        {
            lines_.push_back(file + object + " is " + Number(finding.first_value) + " with 0x1F90:05 " +
                             Number(finding.second_value) +
                             ", expected more than 127 times the latter, which is above 0");
        }
        else if (finding.kind == FlyingFindingKind::kSameNode)
        {
            lines_.push_back(file + "node-ID of the manager is " + std::to_string(finding.first_value) +
                             ", expected another one than in the files before");
        }
        else
        {
            lines_.push_back(file + object + " is " + Number(finding.first_value) + ", expected at most " +
                             Number(cia302::kLowestPriority));
        }
    }
    void TellOfTwo(const FlyingFinding& finding)
    {
        const std::string node = std::to_string(finding.slave.value);
        const bool is_in_first = finding.kind != FlyingFindingKind::kOnlySecond;
        const bool is_in_second = finding.kind != FlyingFindingKind::kOnlyFirst;
        if (finding.kind == FlyingFindingKind::kMissing)
        {
            TellMissing(finding, node);
        }
        else if (finding.kind == FlyingFindingKind::kUnknown)
        {
            lines_.push_back(PlaceOf(*first_, {0U, ""}) + ": no node " + node +
                             ", expected the other master in the network list");
        }
        else if (finding.kind == FlyingFindingKind::kContent)
        {
            TellContent(finding);
        }
        else
        {
            Tell(KeyOf(finding), NameOf(finding), is_in_first ? Number(finding.first_value) : "absent",
                 is_in_second ? Number(finding.second_value) : "absent");
        }
    }
    void TellMissing(const FlyingFinding& finding, const std::string& node)
    {
        const bool is_first = finding.first_value == 0U;
        lines_.push_back(PlaceOf(is_first ? *first_ : *second_, {0U, ""}) + ": no node " + node +
                         ", expected it as in " + PlaceOf(is_first ? *second_ : *first_, {finding.slave.value, ""}));
    }
    void TellContent(const FlyingFinding& finding)
    {
        const auto size = [&finding](const LoadedNetwork* const net)
        {
            const cia302::SlaveSetup& slave = net->Setup().Slave(finding.slave);
            const cia302::Bytes& bytes = (finding.index == kProgram) ? slave.software.program : slave.concise_dcf;
            return std::to_string(bytes.size_bytes) + " bytes";
        };
        Tell(KeyOf(finding), cia306::ObjectName(finding.index, finding.sub), size(first_),
             size(second_) + " with other contents");
    }
    [[nodiscard]] static std::string NameOf(const FlyingFinding& finding)
    {
        const std::string of_node = " of node " + std::to_string(finding.slave.value);
        const std::string object = cia306::ObjectName(finding.index, finding.sub);
        std::string name = object;
        for (const auto& [kind, words] : kNames)
        {
            name = (kind == finding.kind) ? (words + of_node) : name;
        }
        const bool is_safety =
            finding.kind == FlyingFindingKind::kOnlyFirst || finding.kind == FlyingFindingKind::kOnlySecond;
        name = (is_safety || finding.kind == FlyingFindingKind::kSafety) ? (object + of_node + " (safety)") : name;
        name = (finding.kind == FlyingFindingKind::kPdo) ? (object + of_node) : name;
        name = (finding.kind == FlyingFindingKind::kProfile) ? (kParts.at(finding.sub) + of_node) : name;
        return (finding.kind == FlyingFindingKind::kValue) ? NameOfValue(finding, object) : name;
    }
    /// Values of the master, of which two stand for what is told of the slave by name.
    [[nodiscard]] static std::string NameOfValue(const FlyingFinding& finding, const std::string& object)
    {
        const std::string of_node = " of node " + std::to_string(finding.slave.value);
        const bool is_consumer = finding.index == 0x1016U;
        const bool is_producer = finding.index == 0x1017U;
        const std::string heartbeat = is_consumer ? "heartbeat consumer (0x1016)" : "heartbeat (0x1017)";
        return (is_consumer || is_producer) ? (heartbeat + of_node) : object;
    }

    const std::vector<const LoadedNetwork*>& masters_;
    const LoadedNetwork* first_{nullptr};
    const LoadedNetwork* second_{nullptr};
    std::vector<std::string> lines_;
};
} // namespace

std::vector<std::string> DifferencesOf(const std::vector<const LoadedNetwork*>& masters)
{
    std::vector<cia302::FlyingMasterTimes> times;
    for (const LoadedNetwork* const master : masters)
    {
        times.push_back(FlyingTimesOf(master->Plan()));
    }
    std::vector<cia302::FlyingMasterView> views;
    for (std::size_t i = 0U; i < masters.size(); ++i)
    {
        views.push_back({&masters[i]->Setup(), &times[i]});
    }
    Differences differences(masters);
    static_cast<void>(cia302::CompareFlyingMasters(views.data(), static_cast<std::uint8_t>(views.size()), differences));
    for (std::size_t i = 1U; i < masters.size(); ++i)
    {
        differences.ComparePlans(*masters.front(), *masters[i]);
    }
    std::vector<std::string> lines = differences.Lines();
    const std::vector<std::string> together = ProblemsTogether(masters);
    lines.insert(lines.end(), together.begin(), together.end());
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
