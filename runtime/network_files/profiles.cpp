// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/network_files/profiles.hpp"

#include "runtime/manager/pdos.hpp"
#include "runtime/yaml/map.hpp"
#include "runtime/yaml/optional_values.hpp"

#include <limits>

namespace counterpoint::runtime
{
namespace
{
using cia302::El6751Slave;

constexpr Word<cia302::El6751Kind> kKindWords[] = {{"general", cia302::El6751Kind::kGeneral},
                                                   {"bk51x0", cia302::El6751Kind::kBusCoupler}};
constexpr Word<cia302::El6751NodeReaction> kReactionWords[] = {{"stop", cia302::El6751NodeReaction::kStop},
                                                               {"none", cia302::El6751NodeReaction::kNone}};
constexpr Word<cia302::El6751Restart> kRestartWords[] = {{"automatic", cia302::El6751Restart::kAutomatic},
                                                         {"by_hand", cia302::El6751Restart::kByHand}};
constexpr Word<cia302::El6751NetworkReaction> kNetworkWords[] = {{"none", cia302::El6751NetworkReaction::kNone},
                                                                 {"stop_all", cia302::El6751NetworkReaction::kStopAll}};
constexpr Word<cia302::El6751Window> kWindowWords[] = {{"input_shift", cia302::El6751Window::kInputShift},
                                                       {"last_rx_pdo", cia302::El6751Window::kLastRxPdo}};
} // namespace

void ReadEl6751Slave(const std::string& file, const YamlValue& value, network_plan::SlavePlan& plan)
{
    const YamlMap map(file, value.Node(),
                      {"kind", "check_device_type", "write_sync_period", "write_cob_ids", "write_types", "start",
                       "restart_without_pdos", "literal_consumer", "reaction", "restart", "network_reaction",
                       "coupler_pdos", "coupler_inhibit", "coupler_event"});
    constexpr const char* kWrong = "a time that does not fit";
    constexpr Nanoseconds kHundredUs = 100 * kNanosecondsPerMicrosecond;
    El6751Slave slave{};
    TakeWord(map, "kind", slave.kind, kKindWords);
    TakeWord(map, "check_device_type", slave.is_device_type_checked, kTruthWords);
    TakeWord(map, "write_sync_period", slave.is_sync_period_written, kTruthWords);
    TakeWord(map, "write_cob_ids", slave.is_cob_id_written, kTruthWords);
    TakeWord(map, "write_types", slave.is_type_written, kTruthWords);
    TakeWord(map, "start", slave.is_started, kTruthWords);
    TakeWord(map, "restart_without_pdos", slave.is_restarted_without_pdos, kTruthWords);
    TakeWord(map, "literal_consumer", slave.is_consumer_literal, kTruthWords);
    TakeWord(map, "reaction", slave.node_reaction, kReactionWords);
    TakeWord(map, "restart", slave.restart, kRestartWords);
    TakeWord(map, "network_reaction", slave.network_reaction, kNetworkWords);
    TakeNumber(map, "coupler_pdos", plan.coupler_pdos, 0U);
    TakeTime(map, "coupler_inhibit", slave.coupler_inhibit_100us, kHundredUs, "tenths of a millisecond", kWrong);
    TakeTime(map, "coupler_event", slave.coupler_event_ms, kNanosecondsPerMillisecond, "milliseconds", kWrong);
    plan.el6751 = slave;
}

cia302::El6751Times ReadEl6751Times(const std::string& file, const YamlValue& value)
{
    const YamlMap map(file, value.Node(), {"window", "sync_multiplier", "input_shift"});
    cia302::El6751Times times{};
    TakeWord(map, "window", times.window, kWindowWords);
    TakeNumber(map, "sync_multiplier", times.sync_multiplier, 1U);
    TakeTime(map, "input_shift", times.input_shift_us, kNanosecondsPerMicrosecond, "microseconds",
             "a time that does not fit");
    return times;
}

std::vector<network_plan::OutputPlan> ReadOutputs(const std::string& file, const YamlValue& value)
{
    constexpr std::uint64_t kHighestPdo = 512U;
    const std::string expected = "1 to 8 bytes as hexadecimal digits, such as 01 FF";
    std::vector<network_plan::OutputPlan> outputs;
    for (const YamlValue& item : value.Items("a list of RxPDOs, such as [{pdo: 1, data: 01 FF}]"))
    {
        const YamlMap map(file, item.Node(), {"pdo", "data"});
        network_plan::OutputPlan output;
        output.place = item.Where().place;
        output.number = static_cast<std::uint16_t>(map.Require("pdo").Number({1U, kHighestPdo}));
        const YamlValue data = map.Require("data");
        const auto bytes = BytesFrom(data.Text(expected));
        if (!bytes)
        {
            data.Refuse(Shown(data.Text(expected)), expected);
        }
        output.bytes = *bytes;
        outputs.push_back(output);
    }
    return outputs;
}

cia302::PlcSlave ReadPlcSlave(const std::string& file, const YamlValue& value, const bool is_mandatory)
{
    const YamlMap map(file, value.Node(), {"optional", "reset_node"});
    cia302::PlcSlave slave{!is_mandatory, false};
    TakeWord(map, "optional", slave.is_optional, kTruthWords);
    TakeWord(map, "reset_node", slave.is_reset, kTruthWords);
    return slave;
}
} // namespace counterpoint::runtime
