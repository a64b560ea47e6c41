// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What somebody wrote into a network file and would not get: refused where the network could not work, else told.
#include "canopen/network/loaded_network.hpp"

#include "canopen/cia306/input_error.hpp"

namespace counterpoint::network
{
namespace
{
using cia306::InputError;

/// A key that only some profiles look at.
struct ProfileKey
{
    const char* key;
    bool is_given;
    bool has_effect;
};

const char* NameOf(const StartProfile profile)
{
    const char* name = "cia302";
    name = (profile == StartProfile::kEl6751) ? "el6751" : name;
    return (profile == StartProfile::kPlcDesigner) ? "plc_designer" : name;
}

/// Bits of 1F80h that the start-up follows; being the master and the negotiation are not of the start-up.
std::uint32_t StartUpBits(const StartProfile profile)
{
    constexpr std::uint32_t kOfAll = cia302::kIsMaster | cia302::kFlyingMaster;
    std::uint32_t bits = cia302::kKnownStartUpBits;
    bits = (profile == StartProfile::kEl6751) ? kOfAll : bits;
    return (profile == StartProfile::kPlcDesigner)
               ? (kOfAll | cia302::kStartAllAtOnce | cia302::kApplicationStartsSlaves)
               : bits;
}

const cia302::El6751Pdo* FirstSynchronous(const ProfileSlave& slave)
{
    const cia302::El6751Pdo* found = nullptr;
    for (const auto* const pdos : {&slave.rx_pdos, &slave.tx_pdos})
    {
        for (const cia302::El6751Pdo& pdo : *pdos)
        {
            found = (found == nullptr && cia302::IsSynchronous(pdo.type)) ? &pdo : found;
        }
    }
    return found;
}

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

void LoadedNetwork::FillSoftware(const LoadedSlave& slave, cia302::SlaveSetup& setup)
{
    if (slave.plan.software)
    {
        const SoftwarePlan& software = *slave.plan.software;
        setup.software.identification = software.identification.value_or(0U);
        setup.software.date = software.date.value_or(0U);
        setup.software.time = software.time.value_or(0U);
        setup.software.program = {slave.program.data(), static_cast<std::uint32_t>(slave.program.size())};
    }
}

void LoadedNetwork::RequireSoftware(const SlavePlan& plan) const
{
    const SoftwarePlan software = plan.software.value_or(SoftwarePlan{});
    const std::uint32_t compared =
        software.identification.value_or(0U) | software.date.value_or(0U) | software.time.value_or(0U);
    const std::string node = " of node " + std::to_string(plan.node);
    if (plan.software && compared == 0U)
    {
        throw InputError(plan_.file, plan.line,
                         {"software" + node + " with nothing to compare", "identification, date or time above 0"});
    }
    if (software.may_update == software.program.empty())
    {
        throw InputError(plan_.file, plan.line,
                         {software.may_update ? "an update of the software" + node + " without a program"
                                              : "a program" + node + " that no update may load",
                          "update: true and program: FILE, or neither"});
    }
}

/// SYNC is sent as soon as any PDO needs it; only the network file knows how often.
void LoadedNetwork::RequireSync() const
{
    for (const std::unique_ptr<LoadedSlave>& slave : loaded_)
    {
        const cia302::El6751Pdo* const pdo = FirstSynchronous(slave->profile);
        if (pdo != nullptr && setup_.sync_period_us == 0U)
        {
            throw InputError(plan_.file, slave->plan.line,
                             {"PDO " + std::to_string(pdo->number) + " of node " + std::to_string(slave->plan.node) +
                                  " is synchronous (type " + std::to_string(pdo->type) + ") and there is no SYNC",
                              "a period under manager, sync"});
        }
    }
}

void LoadedNetwork::WarnOfUnused()
{
    const StartProfile profile = plan_.manager.profile;
    const bool is_cia302 = profile == StartProfile::kCia302;
    const bool is_el6751 = profile == StartProfile::kEl6751;
    const bool is_plc = profile == StartProfile::kPlcDesigner;
    const auto warn = [&](const std::size_t line, const ProfileKey& key)
    {
        if (key.is_given && !key.has_effect)
        {
            warnings_.push_back(cia306::Printable(plan_.file) + ":" + std::to_string(line) + ": " + key.key +
                                " has no effect with the profile " + NameOf(profile));
        }
    };
    const ManagerPlan& manager = plan_.manager;
    warn(manager.line, {"sync", setup_.sync_period_us != 0U, is_el6751});
    warn(manager.line, {"el6751", manager.el6751.has_value(), is_el6751});
    warn(manager.line, {"boot_time", setup_.boot_time_ms != 0U, is_cia302});
    warn(manager.line, {"a bit of start_up", (setup_.start_up & ~StartUpBits(profile)) != 0U, is_cia302});
    for (const SlavePlan& slave : plan_.slaves)
    {
        warn(slave.line, {"el6751", slave.el6751.has_value(), is_el6751});
        warn(slave.line, {"plc_designer", slave.plc.has_value(), is_plc});
        warn(slave.line, {"keep_alive", slave.is_kept_alive.value_or(false), is_cia302});
        warn(slave.line, {"boot", !slave.is_booted.value_or(true), is_cia302});
        warn(slave.line, {"restore", slave.is_restored.value_or(false), is_cia302});
        warn(slave.line, {"software", slave.software.has_value(), is_cia302});
        warn(slave.line, {"vendor_id", slave.vendor_id.value_or(0U) != 0U, !is_plc});
        warn(slave.line, {"product_code", slave.product_code.value_or(0U) != 0U, !is_plc});
        warn(slave.line, {"revision", slave.revision.value_or(0U) != 0U, !is_plc});
        warn(slave.line, {"serial", slave.serial.value_or(0U) != 0U, !is_plc});
    }
}

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
