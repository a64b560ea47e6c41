// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/network_plan/row_times.hpp"

#include <algorithm>

namespace counterpoint::network_plan
{
namespace
{
/// Whether the rows have guard time and life time factor as they are told, and not those of the heartbeat.
bool IsGuarded(const SlavePlan& slave, const cia302::SlaveSetup& setup)
{
    return slave.guard_ms.has_value() || setup.GuardTimeMs() > 0U;
}

std::string LostText(const cia302::SlaveSetup& setup)
{
    return " is lost after " + std::to_string(RowTimesOf(setup).watched_ms) + " ms without a heartbeat (" +
           std::to_string(setup.el6751->guard_time_ms) + " ms x life time factor " +
           std::to_string(setup.el6751->life_time_factor) + ", 65535 ms at most)";
}
} // namespace

bool HasRows(const cia302::SlaveSetup& setup)
{
    return setup.el6751 != nullptr && setup.el6751->IsWatched();
}

RowTimes RowTimesOf(const cia302::SlaveSetup& setup)
{
    constexpr std::uint32_t kLongestMs = 0xFFFFU;
    const std::uint32_t life_ms = std::uint32_t{setup.el6751->guard_time_ms} * setup.el6751->life_time_factor;
    return {life_ms, std::min(life_ms, kLongestMs)};
}

/// The life time factor has 8 bits and 1016h has 16: a slave may be lost before the time that was asked for. The factor
/// counts heartbeats: a time between two of them becomes a longer one.
std::string OtherTimeText(const SlavePlan& slave, const cia302::SlaveSetup& setup)
{
    if (!HasRows(setup))
    {
        return "";
    }
    const RowTimes times = RowTimesOf(setup);
    const bool is_guarded = IsGuarded(slave, setup);
    const std::uint32_t asked_ms = is_guarded ? times.life_ms : setup.heartbeat.consumer_ms;
    const bool is_longer = !is_guarded && asked_ms > 0U && times.watched_ms > asked_ms;
    std::string expected = (times.watched_ms < asked_ms) ? "no longer time than that, or a longer heartbeat" : "";
    expected = is_longer ? "a multiple of its heartbeat" : expected;
    return expected.empty()
               ? ""
               : LostText(setup) + ", and not after " + std::to_string(asked_ms) + " ms, expected " + expected;
}

/// 1017h is written with the guard time, and both sides wait for its multiple.
std::vector<std::string> UnusedBesideRows(const SlavePlan& slave, const cia302::SlaveSetup& setup)
{
    std::vector<std::string> texts;
    if (HasRows(setup))
    {
        const std::uint16_t guard_ms = setup.el6751->guard_time_ms;
        const std::uint32_t watched_ms = RowTimesOf(setup).watched_ms;
        const std::uint32_t consumer_ms = slave.consumer_ms.value_or(watched_ms);
        const bool is_instead = IsGuarded(slave, setup) || consumer_ms == 0U; // Else OtherTimeText tells.
        const std::string node = "node " + std::to_string(slave.node);
        if (slave.heartbeat_ms.value_or(guard_ms) != guard_ms)
        {
            texts.push_back("heartbeat has no effect beside guard_time with the profile el6751: " + node +
                            " is told to send one each " + std::to_string(guard_ms) +
                            " ms, expected that, or no such key");
        }
        if (is_instead && consumer_ms != watched_ms)
        {
            texts.push_back("consumer has no effect with the profile el6751: " + node + LostText(setup) +
                            ", expected that time, or no such key");
        }
    }
    return texts;
}
} // namespace counterpoint::network_plan
