// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What a person should know of a network whose manager is a flying master.
#include "canopen/cia306/text/input_error.hpp"
#include "canopen/network/loaded_network.hpp"

namespace counterpoint::network
{
namespace
{

constexpr std::uint32_t kUsualNodeSlotMs = 10U;
/// 1F90h:05 below which a 072h of the same race can be taken for one of a later race: half of it has to be longer than
/// two cycles of 1 ms, the longest frame and 072h, at 125 kbit/s.
constexpr std::uint32_t LeastNodeSlotMs()
{
    constexpr std::uint32_t kCyclesUs = 2U * 1000U;
    constexpr std::uint32_t kBits = 135U + 55U; // With the stuff bits at worst and the pause behind.
    constexpr std::uint32_t kBitUs = 8U;
    return ((2U * (kCyclesUs + (kBits * kBitUs))) / 1000U) + 1U;
}
static_assert(LeastNodeSlotMs() == 8U);

} // namespace

/// A node of which no file tells more may be another master.
bool LoadedNetwork::HasUnwatchedNode() const
{
    bool has_one = false;
    for (const std::unique_ptr<LoadedSlave>& slave : loaded_)
    {
        const cia302::SlaveSetup& setup = slaves_.at(slave->plan.node);
        has_one = has_one || (slave->plan.dcf.empty() && setup.heartbeat.consumer_ms == 0U);
    }
    return has_one;
}

/// What a flying master would do, and nobody wants.
void LoadedNetwork::WarnOfFlying()
{
    const ManagerPlan& manager = plan_.manager;
    if (!manager.flying)
    {
        return;
    }
    const FlyingPlan& flying = *manager.flying;
    const cia302::FlyingMasterOptions& options = flying.options;
    const std::size_t of_flying = LineOf(manager.lines, "flying", manager.line);
    const auto warn = [&](const std::size_t line, const std::string& text)
    { warnings_.push_back(cia306::Printable(plan_.file) + ":" + std::to_string(line) + ": " + text); };
    const auto ms = [](const std::uint32_t time) { return std::to_string(time) + " ms"; };
    const std::uint32_t heartbeat_ms = manager.heartbeat_ms.value_or(0U);
    if (heartbeat_ms == 0U)
    {
        warn(LineOf(manager.lines, "heartbeat", of_flying),
             "a flying master without heartbeat, which its standbys lose again and again: expected a heartbeat above "
             "0 ms");
    }
    const bool is_asked = flying.lines.count("watch_time") > 0U;
    const bool watches = options.watch == cia302::MasterWatch::kInstalled && (is_asked || HasUnwatchedNode());
    if (watches && options.watch_ms <= heartbeat_ms)
    {
        warn(LineOf(flying.lines, "watch_time", of_flying),
             "watch_time " + ms(options.watch_ms) + " for masters with a heartbeat each " + ms(heartbeat_ms) +
                 " as this one: their standbys lose them again and again, expected a longer one");
    }
    const std::uint32_t slot_ms = flying.node_slot_ms.value_or(kUsualNodeSlotMs);
    if (slot_ms > 0U && slot_ms < LeastNodeSlotMs())
    {
        warn(LineOf(flying.lines, "node_slot", of_flying),
             "node_slot " + ms(slot_ms) +
                 ": with a cycle of 1 ms and 125 kbit/s a failover may take longer than "
                 "computed, expected at least " +
                 ms(LeastNodeSlotMs()));
    }
    const bool is_race_cyclic = options.cyclic == cia302::CyclicMessage::kNegotiation;
    if (is_race_cyclic && options.standby == cia302::StandbyReaction::kRaces)
    {
        warn(LineOf(flying.lines, "standby", of_flying),
             "standby races with cyclic negotiation: masters like this one elect without end, expected another word "
             "for one of them");
    }
    if (is_race_cyclic && options.ignores_claims)
    {
        warn(LineOf(flying.lines, "claim_heard", of_flying),
             "claim_heard ignores with cyclic negotiation: two masters like this one never end, expected another word "
             "for one of them");
    }
}

} // namespace counterpoint::network
