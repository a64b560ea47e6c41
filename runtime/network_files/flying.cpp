// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/network_files/profiles.hpp"
#include "runtime/yaml/optional_values.hpp"

namespace counterpoint::runtime
{
namespace
{
using cia302::CyclicMessage;
using cia302::EqualLevel;
using cia302::FlyingMasterOptions;
using cia302::ForceReaction;
using cia302::LossReaction;
using cia302::MasterWatch;
using cia302::StandbyReaction;

constexpr Word<bool> kPresetWords[] = {{"default", false}, {"so1114", true}};
constexpr Word<CyclicMessage> kCyclicWords[] = {{"force", CyclicMessage::kForce},
                                                {"negotiation", CyclicMessage::kNegotiation}};
constexpr Word<ForceReaction> kForceWords[] = {
    {"reset_all", ForceReaction::kResetAll}, {"race", ForceReaction::kRace}, {"restart", ForceReaction::kRestart}};
constexpr Word<EqualLevel> kEqualWords[] = {{"stays_slave", EqualLevel::kStaysSlave},
                                            {"lower_node_forces", EqualLevel::kLowerNodeForces}};
constexpr Word<LossReaction> kLossWords[] = {
    {"restart", LossReaction::kRestart}, {"reset_all", LossReaction::kResetAll}, {"race", LossReaction::kRace}};
constexpr Word<MasterWatch> kWatchWords[] = {{"installed", MasterWatch::kInstalled},
                                             {"twice_producer", MasterWatch::kTwiceProducer},
                                             {"application", MasterWatch::kApplication}};
constexpr Word<StandbyReaction> kStandbyWords[] = {
    {"ignores", StandbyReaction::kIgnores}, {"asks", StandbyReaction::kAsks}, {"races", StandbyReaction::kRaces}};
constexpr Word<bool> kNegotiatesWords[] = {{"initialising", false}, {"pre_operational", true}};
constexpr Word<bool> kRaceWords[] = {{"joins", false}, {"keeps_slot", true}};
constexpr Word<bool> kClaimWords[] = {{"compares", false}, {"ignores", true}};
constexpr Word<bool> kStartWords[] = {{"at_once", false}, {"by_order", true}};

/// Each by itself, over what the preset says.
void TakeOptions(const YamlMap& map, FlyingMasterOptions& options)
{
    TakeWord(map, "cyclic", options.cyclic, kCyclicWords);
    TakeWord(map, "on_force", options.on_force, kForceWords);
    TakeWord(map, "equal_level", options.equal_level, kEqualWords);
    TakeWord(map, "on_loss", options.on_loss, kLossWords);
    TakeWord(map, "watch", options.watch, kWatchWords);
    TakeWord(map, "standby", options.standby, kStandbyWords);
    TakeWord(map, "negotiates", options.negotiates_pre_operational, kNegotiatesWords);
    TakeWord(map, "race_heard", options.keeps_slot, kRaceWords);
    TakeWord(map, "claim_heard", options.ignores_claims, kClaimWords);
    TakeWord(map, "answers_boot_up", options.answers_boot_up, kTruthWords);
    TakeNumber(map, "restarts", options.max_restarts, 0U);
    std::optional<std::uint16_t> watch_ms{};
    TakeMs(map, "watch_time", watch_ms);
    if (watch_ms == std::uint16_t{0U})
    {
        map.Require("watch_time").Refuse("a master that is lost at once", "a time above 0");
    }
    options.watch_ms = watch_ms.value_or(options.watch_ms);
}
} // namespace

network_plan::FlyingPlan ReadFlying(const std::string& file, const YamlValue& value)
{
    const YamlMap map(file, value.Node(), {"priority",   "timeout",     "delay",           "level_slot", "node_slot",
                                           "detect",     "preset",      "cyclic",          "on_force",   "equal_level",
                                           "on_loss",    "watch",       "watch_time",      "standby",    "negotiates",
                                           "race_heard", "claim_heard", "answers_boot_up", "restarts",   "start"});
    network_plan::FlyingPlan plan;
    plan.places = map.Places();
    TakeNumber(map, "priority", plan.priority, 0U, cia302::kLowestPriority);
    TakeMs(map, "timeout", plan.timeout_ms);
    TakeMs(map, "delay", plan.delay_ms);
    TakeMs(map, "level_slot", plan.level_slot_ms);
    TakeMs(map, "node_slot", plan.node_slot_ms);
    TakeMs(map, "detect", plan.detect_ms);
    TakeWord(map, "start", plan.is_by_order, kStartWords);
    bool is_so1114 = false;
    TakeWord(map, "preset", is_so1114, kPresetWords);
    plan.options = is_so1114 ? cia302::So1114FlyingMaster() : cia302::DefaultFlyingMaster();
    TakeOptions(map, plan.options);
    return plan;
}
} // namespace counterpoint::runtime
