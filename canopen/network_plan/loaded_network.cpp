// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/network_plan/loaded_network.hpp"

#include "canopen/cia302/network/concise_dcf.hpp"
#include "canopen/cia306/file/device_reader.hpp"
#include "canopen/cia306/text/input_error.hpp"
#include "canopen/cia306/text/text_file.hpp"

#include <algorithm>
#include <set>

namespace counterpoint::network_plan
{
namespace
{
using cia302::SlaveSetup;
using cia306::Device;
using cia306::Entry;
using cia306::InputError;

constexpr std::uint32_t kUsualAssignment = cia302::kInNetwork | cia302::kBootSlave | cia302::kMandatory;
constexpr std::uint32_t kConsumerFactor = 2U; ///< Consumer time of a producer time, where nobody says more.
constexpr std::uint32_t kLeastSyncUs = 1000U; ///< A manager works each ms.
constexpr std::uint32_t kLongestMs = 65535U;

/// The number that a DCF configures, 0 where it has none.
std::uint32_t Configured(const LoadedSlave& slave, const std::uint16_t index, const std::uint8_t sub)
{
    return NumberOf(slave.device, slave.plan.node, index, sub, 0U);
}

std::uint32_t WithBit(const std::uint32_t bits, const std::uint32_t bit, const std::optional<bool>& is_set)
{
    return is_set ? ((bits & ~bit) | (*is_set ? bit : 0U)) : bits;
}

/// 1F81h as the keys of a slave have it, given bits kept. [SRS_NET_154]
std::uint32_t AssignmentOf(const SlavePlan& plan)
{
    constexpr std::uint32_t kFactorShift = 8U;
    constexpr std::uint32_t kTimeShift = 16U;
    const std::uint32_t given = plan.assignment.value_or(0U);
    std::uint32_t bits = (given == 0U) ? kUsualAssignment : (given | cia302::kInNetwork);
    bits = WithBit(bits, cia302::kMandatory, plan.is_mandatory);
    bits = WithBit(bits, cia302::kKeepAlive, plan.is_kept_alive);
    bits = WithBit(bits, cia302::kBootSlave, plan.is_booted);
    bits = WithBit(bits, cia302::kRestoreDefaults, plan.is_restored);
    bits = plan.software
               ? WithBit(bits | cia302::kVerifySoftware, cia302::kMayUpdateSoftware, plan.software->may_update)
               : bits;
    bits = plan.retry_factor ? ((bits & 0xFFFF00FFU) | (std::uint32_t{*plan.retry_factor} << kFactorShift)) : bits;
    return plan.guard_ms ? ((bits & 0x0000FFFFU) | (std::uint32_t{*plan.guard_ms} << kTimeShift)) : bits;
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

LoadedNetwork::LoadedNetwork(const NetworkPlan& plan) : plan_(plan), warnings_(plan.warnings)
{
    RequireManager();
    if (!plan_.manager.dcf.empty())
    {
        device_ = cia306::ReadDeviceFile(plan_.manager.dcf);
        RequireNode(device_, *plan_.manager.node, plan_.manager.place, "the manager, ");
        TakeManagerObjects(device_, plan_);
    }
    if (!plan_.manager.flying && (plan_.manager.start_up.value_or(0U) & cia302::kFlyingMaster) != 0U)
    {
        plan_.manager.flying = FlyingPlan{}; // Where no DCF said more.
    }
    RequireNodes();
    for (const SlavePlan& slave : plan_.slaves)
    {
        Load(slave);
    }
    for (const std::unique_ptr<LoadedSlave>& slave : loaded_)
    {
        Fill(*slave, slaves_.at(slave->plan.node));
    }
    FillManager();
    const std::vector<std::string> warnings = WarningsOf(*this);
    warnings_.insert(warnings_.end(), warnings.begin(), warnings.end());
}

const LoadedSlave* LoadedNetwork::Find(const std::uint8_t node) const noexcept
{
    const LoadedSlave* found = nullptr;
    for (const std::unique_ptr<LoadedSlave>& slave : loaded_)
    {
        found = (slave->plan.node == node) ? slave.get() : found;
    }
    return found;
}

LoadedSlave* LoadedNetwork::Find(const std::uint8_t node) noexcept
{
    LoadedSlave* found = nullptr;
    for (const std::unique_ptr<LoadedSlave>& slave : loaded_)
    {
        found = (slave->plan.node == node) ? slave.get() : found;
    }
    return found;
}

bool LoadedNetwork::ReplaceConcise(const std::uint8_t node, const cia302::Bytes& bytes)
{
    LoadedSlave* const slave = Find(node);
    cia302::ConciseReading entry = cia302::ReadConcise(bytes, {0U, 0U});
    bool is_plain = cia302::IsConcise(bytes);
    for (; entry.state == cia302::ConciseState::kEntry; entry = cia302::ReadConcise(bytes, entry.next))
    {
        const bool is_safety =
            entry.object.index >= cia301::kFirstKernelIndex && entry.object.index <= cia301::kLastKernelIndex;
        is_plain = is_plain && !is_safety;
    }
    const bool is_taken = slave != nullptr && is_plain;
    if (is_taken)
    {
        slave->downloaded.assign(bytes.data, bytes.data + bytes.size_bytes);
        slaves_.at(node).concise_dcf = {slave->downloaded.data(), bytes.size_bytes};
    }
    return is_taken;
}

void LoadedNetwork::RequireNode(const cia306::Device& device, const std::uint8_t node, const Place place,
                                const std::string& who) const
{
    if (device.node_id.value_or(node) != node)
    {
        throw InputError(plan_.file, place,
                         {cia306::Quoted(device.file) + " is for node-ID " + std::to_string(*device.node_id),
                          "the DCF of " + who + "node " + std::to_string(node)});
    }
}

void LoadedNetwork::RequireManager() const
{
    const std::uint32_t node = plan_.manager.node.value_or(0U);
    if (node == 0U || node > cia302::kLastNode)
    {
        throw InputError(plan_.file, plan_.manager.place, {"no node-ID of the manager", "one from 1 to 127"});
    }
}

void LoadedNetwork::RequireNodes() const
{
    std::set<std::uint8_t> seen;
    for (const SlavePlan& slave : plan_.slaves)
    {
        if (slave.node == *plan_.manager.node)
        {
            throw InputError(
                plan_.file, slave.place,
                {"node " + std::to_string(slave.node) + " is the manager and a slave", "different node-IDs"});
        }
        if (!seen.insert(slave.node).second)
        {
            throw InputError(plan_.file, slave.place,
                             {"node " + std::to_string(slave.node) + " a second time", "each node once"});
        }
    }
    if (seen.empty())
    {
        throw InputError(plan_.file, plan_.manager.place, {"a network without slaves", "at least one"});
    }
}

void LoadedNetwork::Load(const SlavePlan& plan)
{
    auto slave = std::make_unique<LoadedSlave>();
    slave->plan = plan;
    if (!plan.dcf.empty())
    {
        slave->device = cia306::ReadDeviceFile(plan.dcf);
        slave->dcf_text = cia306::ReadTextFile(plan.dcf);
        RequireNode(slave->device, plan.node, plan.place, "");
        if (plan.is_configured)
        {
            slave->entries = MakeConcise(slave->device, plan.node);
        }
        slave->objects = MakeExpectation(slave->device, plan.node);
    }
    if (plan.software && !plan.software->program.empty())
    {
        const std::string program = cia306::ReadTextFile(plan.software->program);
        slave->program.assign(program.begin(), program.end());
    }
    slave->safety = {slave->objects.data(), static_cast<std::uint16_t>(slave->objects.size())};
    loaded_.push_back(std::move(slave));
}

void LoadedNetwork::Fill(LoadedSlave& slave, SlaveSetup& setup) const
{
    setup.assignment = AssignmentOf(slave.plan);
    setup.restore_sub = slave.plan.restore_sub.value_or(0U);
    FillIdentity(slave, setup);
    FillHeartbeat(slave, setup);
    FillSoftware(slave, setup);
    setup.safety = slave.objects.empty() ? nullptr : &slave.safety;
    RequireSense(slave, setup);
    FillProfile(plan_.file, plan_.manager.profile, slave.plan, slave.device, slave.profile, setup);
}

/// What somebody wrote and would not get: supervision that cannot work, and a configuration that is not there.
void LoadedNetwork::RequireSense(const LoadedSlave& slave, const SlaveSetup& setup) const
{
    const SlavePlan& plan = slave.plan;
    const auto ms = [](const std::uint32_t time) { return std::to_string(time) + " ms"; };
    const bool has_half = (setup.GuardTimeMs() == 0U) != (setup.RetryFactor() == 0U);
    const bool asks_half = plan.guard_ms.value_or(0U) > 0U || plan.retry_factor.value_or(0U) > 0U;
    const std::uint16_t consumer_ms = setup.heartbeat.consumer_ms; // The usual one may be cut by 1016h.
    if (has_half && asks_half)
    {
        throw InputError(
            plan_.file, plan.place,
            {"guard time " + ms(setup.GuardTimeMs()) + " with retry factor " + std::to_string(setup.RetryFactor()),
             "both above 0, or none"});
    }
    if (consumer_ms > 0U && consumer_ms <= setup.heartbeat.producer_ms)
    {
        throw InputError(
            plan_.file, plan.place,
            {"consumer time " + ms(consumer_ms) + " of a heartbeat each " + ms(setup.heartbeat.producer_ms),
             "a longer one"});
    }
    RequireSoftware(plan);
    if (plan.writes_safety && slave.objects.empty())
    {
        throw InputError(plan_.file, plan.place,
                         {"write_safety of node " + std::to_string(plan.node) + ", which has no safety configuration",
                          "a DCF with an SRDO"});
    }
}

/// Something to compare, and a program and its update only together. [SRS_NET_152]
void LoadedNetwork::RequireSoftware(const SlavePlan& plan) const
{
    const SoftwarePlan software = plan.software.value_or(SoftwarePlan{});
    const std::uint32_t compared =
        software.identification.value_or(0U) | software.date.value_or(0U) | software.time.value_or(0U);
    const std::string node = " of node " + std::to_string(plan.node);
    if (plan.software && compared == 0U)
    {
        throw InputError(plan_.file, plan.place,
                         {"software" + node + " with nothing to compare", "identification, date or time above 0"});
    }
    if (software.may_update == software.program.empty())
    {
        throw InputError(plan_.file, plan.place,
                         {software.may_update ? "an update of the software" + node + " without a program"
                                              : "a program" + node + " that no update may load",
                          "update: true and program: FILE, or neither"});
    }
}

/// SYNC is sent as soon as any PDO needs it; only the network file knows how often. [SRS_NET_152]
void LoadedNetwork::RequireSync() const
{
    for (const std::unique_ptr<LoadedSlave>& slave : loaded_)
    {
        const cia302::El6751Pdo* const pdo = FirstSynchronous(slave->profile);
        if (pdo != nullptr && setup_.sync_period_us == 0U)
        {
            throw InputError(plan_.file, slave->plan.place,
                             {"PDO " + std::to_string(pdo->number) + " of node " + std::to_string(slave->plan.node) +
                                  " is synchronous (type " + std::to_string(pdo->type) + ") and there is no SYNC",
                              "a period under manager, sync"});
        }
    }
}

void LoadedNetwork::FillIdentity(const LoadedSlave& slave, SlaveSetup& setup) const
{
    constexpr std::uint16_t kDeviceType = 0x1000U;
    constexpr std::uint16_t kIdentity = 0x1018U;
    constexpr std::uint16_t kDate = 0x1020U;
    constexpr std::uint16_t kEmergency = 0x1014U;
    const SlavePlan& plan = slave.plan;
    setup.device_type = plan.device_type.value_or(Configured(slave, kDeviceType, 0U));
    setup.vendor_id = plan.vendor_id.value_or(Configured(slave, kIdentity, 1U));
    setup.product_code = plan.product_code.value_or(Configured(slave, kIdentity, 2U));
    setup.revision_number = plan.revision.value_or(Configured(slave, kIdentity, 3U));
    setup.serial_number = plan.serial.value_or(Configured(slave, kIdentity, 4U));
    setup.emergency_id = Configured(slave, kEmergency, 0U);
    setup.configuration_date = plan.date.value_or(Configured(slave, kDate, 1U));
    setup.configuration_time = plan.time.value_or(Configured(slave, kDate, 2U));
}

/// The producer time goes into the concise DCF, where the network file asks for another one than the DCF.
void LoadedNetwork::FillHeartbeat(LoadedSlave& slave, SlaveSetup& setup) const
{
    constexpr std::uint16_t kProducer = 0x1017U;
    std::vector<ConciseEntry> entries = slave.entries;
    std::uint32_t producer_ms = Configured(slave, kProducer, 0U);
    if (slave.plan.heartbeat_ms)
    {
        producer_ms = *slave.plan.heartbeat_ms;
        const std::vector<std::uint8_t> value{static_cast<std::uint8_t>(producer_ms & 0xFFU),
                                              static_cast<std::uint8_t>(producer_ms >> 8U)};
        bool is_there = false;
        for (ConciseEntry& entry : entries)
        {
            is_there = is_there || entry.index == kProducer;
            entry.value = (entry.index == kProducer) ? value : entry.value;
        }
        if (!is_there)
        {
            entries.insert(entries.begin(), {kProducer, 0U, value});
        }
    }
    const std::uint32_t usual_ms = std::min(producer_ms * kConsumerFactor, kLongestMs);
    setup.heartbeat.producer_ms = static_cast<std::uint16_t>(producer_ms);
    setup.heartbeat.consumer_ms = slave.plan.consumer_ms.value_or(static_cast<std::uint16_t>(usual_ms));
    setup.heartbeat.arming = slave.plan.arming.value_or(cia302::Arming::kFirstHeartbeat);
    slave.concise = ConciseBytes(entries);
    const std::vector<std::uint8_t>& concise = slave.concise;
    setup.concise_dcf = concise.empty() ? cia302::Bytes{nullptr, 0U}
                                        : cia302::Bytes{concise.data(), static_cast<std::uint32_t>(concise.size())};
}

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

void LoadedNetwork::FillManager()
{
    const ManagerPlan& manager = plan_.manager;
    setup_.own = cia302::NodeId{*manager.node};
    setup_.start_up = manager.start_up.value_or(cia302::kIsMaster) | (manager.flying ? cia302::kFlyingMaster : 0U);
    setup_.boot_time_ms = manager.boot_time_ms.value_or(0U);
    setup_.inhibit_100us = manager.inhibit_100us.value_or(0U);
    setup_.sync_period_us = manager.sync_us.value_or(0U);
    setup_.slaves = slaves_.data();
    RequireSync();
    for (const std::unique_ptr<LoadedSlave>& slave : loaded_)
    {
        const std::uint8_t node = slave->plan.node;
        if (manager.profile == StartProfile::kEl6751)
        {
            LeaveOutRows(slave->device, node, setup_, slave->profile, slaves_.at(node));
        }
    }
    if (setup_.sync_period_us != 0U && setup_.sync_period_us < kLeastSyncUs)
    {
        // The network file goes before the manager's DCF. [SRS_NET_231]
        constexpr std::uint16_t kSyncPeriod = 0x1006U;
        const cia306::Entry* const entry = device_.Find(kSyncPeriod, 0U);
        const bool is_of_dcf = entry != nullptr && manager.places.count("sync") == 0U;
        throw InputError(is_of_dcf ? device_.file : plan_.file, is_of_dcf ? entry->ValuePlace() : manager.place,
                         {"SYNC period (1006h) of " + std::to_string(setup_.sync_period_us) + " us",
                          "none, or at least " + std::to_string(kLeastSyncUs) + " us"});
    }
}
} // namespace counterpoint::network_plan
