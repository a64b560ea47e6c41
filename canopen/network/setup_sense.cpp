// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What somebody wrote into a network file and would not get: refused where the network could not work, else told.
#include "canopen/network/loaded_network.hpp"

#include "canopen/cia306/input_error.hpp"
#include "canopen/network/start_up_bits.hpp"

namespace counterpoint::network
{
namespace
{
using cia306::InputError;

constexpr std::uint32_t kReservedAssignment = 0x02U;

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

/// One supervision a slave, and that by heartbeat goes first; who sends heartbeats answers no remote frames.
void LoadedNetwork::WarnOfGuarding(const SlavePlan& slave, const bool is_el6751)
{
    const cia302::HeartbeatSetup& heartbeat = slaves_.at(slave.node).heartbeat;
    const std::string place = cia306::Printable(plan_.file) + ":" + std::to_string(slave.line) + ": ";
    const std::string node = "node " + std::to_string(slave.node);
    const bool is_asked = slave.guard_ms.value_or(0U) > 0U && !is_el6751;
    if (is_asked && heartbeat.consumer_ms > 0U)
    {
        warnings_.push_back(place + "guard_time has no effect: " + node + " is supervised by heartbeat within " +
                            std::to_string(heartbeat.consumer_ms) +
                            " ms, expected heartbeat: 0 ms and no consumer time for one that is guarded");
    }
    else if (is_asked && heartbeat.producer_ms > 0U)
    {
        warnings_.push_back(place + node + " sends a heartbeat each " + std::to_string(heartbeat.producer_ms) +
                            " ms and will not answer when it is guarded, expected heartbeat: 0 ms");
    }
    else
    {
        // Guarded, or not asked for.
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
        warn(slave.line, {"bit 1 of assignment, which is reserved,",
                          (slave.assignment.value_or(0U) & kReservedAssignment) != 0U, false});
        WarnOfGuarding(slave, is_el6751);
    }
}
} // namespace counterpoint::network
