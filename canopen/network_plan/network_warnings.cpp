// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/network_plan/loaded_network.hpp"

#include "canopen/cia301/base/cob_id.hpp"
#include "canopen/cia302/network/concise_dcf.hpp"
#include "canopen/cia306/safety/contradictions.hpp"
#include "canopen/cia306/text/finding.hpp"
#include "canopen/cia306/text/input_error.hpp"
#include "canopen/network_plan/concise_maker.hpp"
#include "canopen/network_plan/profile_maker.hpp"
#include "canopen/network_plan/row_times.hpp"
#include "canopen/network_plan/start_up_bits.hpp"

#include <algorithm>
#include <memory>

namespace counterpoint::network_plan
{
namespace
{
using cia306::InputError;

constexpr std::uint16_t kEmergency = 0x1014U;
constexpr std::uint32_t kReservedAssignment = 0x02U;
constexpr std::uint32_t kLastIdentifier = 0x7FFU; ///< Frames with 29 bits are not looked at.

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

/// Who is watched, in bits 16 to 23, and how long, if this is an entry of 1016h; else 0.
std::uint32_t ConsumerIn(const cia302::ConciseReading& entry)
{
    const bool is_one = entry.object.index == 0x1016U && entry.value.size_bytes == 4U;
    const std::uint8_t* const bytes = entry.value.data;
    return is_one ? (std::uint32_t{bytes[2]} << 16U) | (std::uint32_t{bytes[1]} << 8U) | bytes[0] : 0U;
}

/// Whom 1016h:01 of the DCF watches; 0: nobody.
std::uint32_t FirstWatched(const LoadedSlave& slave)
{
    const cia302::Bytes all{slave.concise.data(), static_cast<std::uint32_t>(slave.concise.size())};
    std::uint32_t node = 0U;
    cia302::ConciseReading entry = cia302::ReadConcise(all, {0U, 0U});
    for (; entry.state == cia302::ConciseState::kEntry; entry = cia302::ReadConcise(all, entry.next))
    {
        node = (entry.object.sub == 1U && ConsumerIn(entry) != 0U) ? (ConsumerIn(entry) >> 16U) : node;
    }
    return node;
}

/// How long the slave is told to wait for the manager's heartbeat: by the rows of the EL6751 profile, unless its DCF
/// says that it is guarded instead, else by its 1016h. 0: it does not watch the manager.
std::uint32_t WatchesManagerMs(const LoadedSlave& slave, const cia302::SlaveSetup& setup, const std::uint32_t own)
{
    constexpr std::uint32_t kLongestMs = 0xFFFFU;
    constexpr std::uint32_t kNodeShift = 16U;
    const bool has_producer = slave.device.objects.empty() || slave.device.Find(0x1017U, 0U) != nullptr;
    std::uint32_t time_ms = 0U;
    if (HasRows(setup))
    {
        time_ms = has_producer ? RowTimesOf(setup).watched_ms : 0U;
    }
    else
    {
        cia302::ConciseReading entry = cia302::ReadConcise(setup.concise_dcf, {0U, 0U});
        for (; entry.state == cia302::ConciseState::kEntry; entry = cia302::ReadConcise(setup.concise_dcf, entry.next))
        {
            const std::uint32_t value = ConsumerIn(entry);
            time_ms = ((value >> kNodeShift) == own) ? (value & kLongestMs) : time_ms;
        }
    }
    return time_ms;
}

/// Each bit of 1F80h that the profile does not follow, and the one that a safety slave takes from it.
/// [SRS_NET_150] [SRS_NET_006]
std::vector<std::string> WarningsOfStartUp(const ManagerPlan& manager, const cia302::NetworkSetup& setup)
{
    constexpr std::uint32_t kBits = 32U;
    const std::uint32_t followed = StartUpBits(manager.profile);
    std::vector<std::string> warnings;
    for (std::uint32_t bit = 0U; bit < kBits; ++bit)
    {
        if ((((setup.start_up & ~followed) >> bit) & 1U) != 0U)
        {
            warnings.push_back("bit " + std::to_string(bit) + " of start_up has no effect with the profile " +
                               NameOf(manager.profile));
        }
    }
    if ((setup.start_up & followed & cia302::kStartAllAtOnce) != 0U && setup.HasSafetySlave())
    {
        warnings.push_back("one start for all is asked for (1F80h bit 1), and there is a safety slave: each slave is "
                           "started by itself after its verification");
    }
    return warnings;
}

/// Told to send no heartbeat, by the network file or its DCF, and awaited all the same. Who is not booted is told
/// nothing. [SRS_NET_006]
bool IsAwaitedInVain(const LoadedSlave& slave, const cia302::SlaveSetup& setup, const StartProfile profile)
{
    constexpr std::uint16_t kProducer = 0x1017U;
    const auto is_producer = [](const ConciseEntry& entry) { return entry.index == kProducer; };
    const bool is_told =
        slave.plan.heartbeat_ms.has_value() || std::any_of(slave.entries.begin(), slave.entries.end(), is_producer);
    const bool is_booted = profile != StartProfile::kCia302 || setup.Has(cia302::kBootSlave);
    return is_told && is_booted && setup.heartbeat.producer_ms == 0U && setup.heartbeat.consumer_ms > 0U;
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

class NetworkWarnings
{
  public:
    explicit NetworkWarnings(const LoadedNetwork& network);
    [[nodiscard]] std::vector<std::string> All();

  private:
    void WarnOfUnused();
    void WarnOfGuarding(const SlavePlan& slave, bool is_el6751);
    void WarnOfSafety(const LoadedSlave& slave);
    void WarnOfCoupler(const LoadedSlave& slave);
    void WarnOfEmergencies();
    void WarnOfSyncs();
    void WarnOfDownloads();
    void WarnOfSrdos();
    [[nodiscard]] std::string EmergencyPlace(const LoadedSlave& slave) const;
    [[nodiscard]] std::uint32_t EmergencyOf(const LoadedSlave& slave) const;
    void WarnOfFiles();
    void WarnOfHeartbeat();
    void WarnOfFlying();
    [[nodiscard]] bool HasUnwatchedNode() const;

    const NetworkPlan& plan_;
    const cia306::Device& own_;
    const cia302::NetworkSetup& setup_;
    const std::vector<std::unique_ptr<LoadedSlave>>& loaded_;
    std::vector<std::string> warnings_;
};

NetworkWarnings::NetworkWarnings(const LoadedNetwork& network)
    : plan_(network.Plan()), own_(network.Device()), setup_(network.Setup()), loaded_(network.Slaves())
{
}

std::vector<std::string> NetworkWarnings::All()
{
    WarnOfFiles();
    for (const std::unique_ptr<LoadedSlave>& slave : loaded_)
    {
        WarnOfSafety(*slave);
        WarnOfCoupler(*slave);
    }
    WarnOfEmergencies();
    WarnOfSyncs();
    WarnOfDownloads();
    WarnOfSrdos();
    WarnOfUnused();
    WarnOfHeartbeat();
    WarnOfFlying();
    return warnings_;
}

/// What the reader of the DCFs found strange, each file once. [SRS_EDS_038]
void NetworkWarnings::WarnOfFiles()
{
    std::vector<const cia306::Device*> told{&own_};
    for (const std::unique_ptr<LoadedSlave>& slave : loaded_)
    {
        const bool is_told = std::any_of(told.begin(), told.end(), [&slave](const cia306::Device* const other)
                                         { return other->file == slave->device.file; });
        if (!is_told)
        {
            told.push_back(&slave->device);
        }
    }
    for (const cia306::Device* const device : told)
    {
        for (const cia306::Finding& warning : device->warnings)
        {
            warnings_.push_back(cia306::FormatFinding(device->file, warning));
        }
    }
}

/// A slave that waits hardly longer than the period loses the manager on a loaded bus. [SRS_NET_153]
void NetworkWarnings::WarnOfHeartbeat()
{
    const std::uint32_t period_ms = plan_.manager.heartbeat_ms.value_or(0U);
    const std::uint32_t least_ms = period_ms + (period_ms + 1U) / 2U;
    for (const std::unique_ptr<LoadedSlave>& slave : loaded_)
    {
        const std::uint8_t node = slave->plan.node;
        const std::uint32_t time_ms = WatchesManagerMs(*slave, setup_.slaves[node], setup_.own.value);
        const bool has_rows = slave->profile.el6751.IsWatched();
        const std::uint32_t first = has_rows ? FirstWatched(*slave) : 0U;
        const std::string name =
            cia306::PlaceText(plan_.file, slave->plan.place) + ": warning: node " + std::to_string(node);
        if (IsAwaitedInVain(*slave, setup_.slaves[node], plan_.manager.profile))
        {
            const cia302::HeartbeatSetup& heartbeat = setup_.slaves[node].heartbeat;
            const bool is_cia302 = plan_.manager.profile == StartProfile::kCia302;
            const bool is_patient = heartbeat.arming == cia302::Arming::kFirstHeartbeat;
            const std::string otherwise = is_patient ? "it is not supervised" : "it is taken for lost";
            warnings_.push_back(name + " is told to send no heartbeat and awaited within " +
                                std::to_string(heartbeat.consumer_ms) +
                                " ms: " + (is_cia302 ? "its start-up ends with letter K" : otherwise) +
                                ", expected a heartbeat, or consumer: 0 ms");
        }
        const std::string other = OtherTimeText(slave->plan, setup_.slaves[node]);
        if (!other.empty())
        {
            warnings_.push_back(name + other);
        }
        const std::string place = name + " watches the manager for " + std::to_string(time_ms) + " ms";
        if (first != 0U && first != setup_.own.value)
        {
            warnings_.push_back(name + " watches node " + std::to_string(first) +
                                " by 1016h:01, where the profile writes the manager, expected it at another "
                                "sub-index");
        }
        if (time_ms > 0U && period_ms == 0U)
        {
            warnings_.push_back(place + ", and the manager sends no heartbeat, expected one under manager");
        }
        else if (time_ms > 0U && time_ms < least_ms)
        {
            warnings_.push_back(place + ", whose heartbeat comes every " + std::to_string(period_ms) +
                                " ms, expected at least " + std::to_string(least_ms) +
                                " ms, or a shorter heartbeat under manager");
        }
    }
}

/// One supervision a slave, and that by heartbeat goes first; who sends heartbeats answers no remote frames.
void NetworkWarnings::WarnOfGuarding(const SlavePlan& slave, const bool is_el6751)
{
    const cia302::HeartbeatSetup& heartbeat = setup_.slaves[slave.node].heartbeat;
    const std::string place = cia306::PlaceText(plan_.file, slave.place) + ": warning: ";
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

void NetworkWarnings::WarnOfCoupler(const LoadedSlave& slave)
{
    const bool is_el6751 = plan_.manager.profile == StartProfile::kEl6751;
    const std::string text = is_el6751 ? WarningOfCoupler(slave.plan, slave.device) : "";
    if (!text.empty())
    {
        warnings_.push_back(cia306::PlaceText(plan_.file, slave.plan.place) + ": warning: " + text);
    }
    const cia302::El6751Slave options = slave.plan.el6751.value_or(cia302::El6751Slave{});
    const bool is_general = is_el6751 && options.kind == cia302::El6751Kind::kGeneral;
    const bool has_key = slave.plan.coupler_pdos.value_or(0U) > 0U || options.coupler_inhibit_100us > 0U ||
                         options.coupler_event_ms > 0U;
    if (is_general && has_key)
    {
        warnings_.push_back(cia306::PlaceText(plan_.file, slave.plan.place) + ": warning: node " +
                            std::to_string(slave.plan.node) +
                            " is no bus coupler: coupler_pdos, coupler_inhibit and coupler_event have no effect, "
                            "expected kind: bk51x0, or none of them");
    }
}

/// What the gate expects and the device does not have by itself, or has and the gate does not read. [SRS_NET_151]
void NetworkWarnings::WarnOfSafety(const LoadedSlave& slave)
{
    constexpr std::uint32_t kIsOff = 0x80000000U;
    constexpr std::uint16_t kValidFlag = 0x13FEU;
    constexpr std::uint16_t kSignatures = 0x13FFU;
    std::uint32_t count = 0U;
    std::uint32_t highest = 0U;
    for (const cia302::ExpectedObject& object : slave.objects)
    {
        const bool is_signature = object.address.index == kSignatures;
        count = (is_signature && object.address.sub == 0U) ? static_cast<std::uint32_t>(object.value) : count;
        highest = is_signature ? object.address.sub : highest; // Ascending.
    }
    const std::string node = "node " + std::to_string(slave.plan.node);
    const auto warn = [&](const std::uint16_t index, const std::string& text)
    {
        const cia306::Entry* const entry = slave.device.Find(index, 0U);
        const Place place = (entry == nullptr) ? Place{} : entry->ValuePlace();
        warnings_.push_back(cia306::PlaceText(slave.device.file, place) +
                            ": warning: " + cia306::ObjectName(index, 0U) + ": " + text);
    };
    const cia306::Entry* const flag = slave.device.Find(kValidFlag, 0U);
    const cia306::ValueResult valid =
        (flag == nullptr) ? cia306::ValueResult{} : cia306::ConfiguredValue(*flag, slave.plan.node);
    const std::uint64_t value = valid.value ? valid.value->bits : 0U;
    if (!slave.objects.empty() && value != kConfigurationValidValue && !slave.plan.writes_safety)
    {
        warn(kValidFlag, cia306::Hex(value, 2) + " keeps " + node +
                             " from being started until somebody declares its configuration valid, expected 0xA5, or "
                             "write_safety: true in the network file");
    }
    if (!slave.objects.empty() && (setup_.slaves[slave.plan.node].emergency_id & kIsOff) != 0U)
    {
        warn(kEmergency, cia306::Hex(setup_.slaves[slave.plan.node].emergency_id, 8) +
                             " switches off the emergencies of " + node +
                             ", which counts as good in its safe state, expected an identifier without bit 31");
    }
    else if (!slave.objects.empty() && setup_.slaves[slave.plan.node].emergency_id > kLastIdentifier)
    {
        warn(kEmergency, cia306::Hex(setup_.slaves[slave.plan.node].emergency_id, 8) + ": the emergencies of " + node +
                             " are not heard, and it counts as good in its safe state, expected 0x001 to 0x7FF");
    }
    else
    {
        // Heard, or nobody asks.
    }
    if (count > highest)
    {
        warn(kSignatures, "room for " + std::to_string(count) + " signatures, and the highest SRDO of the file is " +
                              std::to_string(highest) + ": what " + node +
                              " has in the others is not read, expected them in the file");
    }
}

/// As cia302::NodeWatch hears them.
std::uint32_t NetworkWarnings::EmergencyOf(const LoadedSlave& slave) const
{
    constexpr std::uint32_t kUsual = 0x80U;
    const std::uint32_t named = setup_.slaves[slave.plan.node].emergency_id;
    return (named == 0U) ? kUsual + slave.plan.node : named;
}

std::string NetworkWarnings::EmergencyPlace(const LoadedSlave& slave) const
{
    const cia306::Entry* const entry = slave.device.Find(kEmergency, 0U);
    return (entry == nullptr) ? cia306::PlaceText(plan_.file, slave.plan.place)
                              : cia306::PlaceText(slave.device.file, entry->ValuePlace());
}

/// Of two slaves with one identifier the first that names it is charged with all of its emergencies. [SRS_NET_151]
void NetworkWarnings::WarnOfEmergencies()
{
    for (std::size_t place = 0U; place < loaded_.size(); ++place)
    {
        for (std::size_t behind = place + 1U; behind < loaded_.size(); ++behind)
        {
            const LoadedSlave& first = *loaded_[place];
            const LoadedSlave& second = *loaded_[behind];
            const std::uint32_t identifier = EmergencyOf(first);
            if (identifier == EmergencyOf(second) && identifier <= kLastIdentifier)
            {
                warnings_.push_back(EmergencyPlace(first) + ": warning: " + cia306::ObjectName(kEmergency, 0U) + ": " +
                                    cia306::Hex(identifier, 3) + " of node " + std::to_string(first.plan.node) +
                                    " is that of node " + std::to_string(second.plan.node) + ", too (" +
                                    EmergencyPlace(second) +
                                    "): whose emergencies come with it is not known, expected one for each");
            }
        }
    }
}

/// Whoever produces SYNC sends it as often as it can where the period asks for that: its identifier goes before those
/// of SRDOs. [SRS_NET_232]
void NetworkWarnings::WarnOfSyncs()
{
    constexpr std::uint16_t kSyncId = 0x1005U;
    constexpr std::uint16_t kSyncPeriod = 0x1006U;
    constexpr std::uint64_t kFrameUs = 47U; // Without data and stuff bits, at 1 Mbit/s.
    for (const std::unique_ptr<LoadedSlave>& slave : loaded_)
    {
        const std::uint8_t node = slave->plan.node;
        const std::uint64_t identifier = NumberOf(slave->device, node, kSyncId, 0U, 0U);
        const std::uint64_t period_us = NumberOf(slave->device, node, kSyncPeriod, 0U, 0U);
        const bool is_producer = (identifier & cia301::kCobBit30) != 0U;
        if (is_producer && period_us > 0U && period_us < 2U * kFrameUs)
        {
            warnings_.push_back(
                cia306::PlaceText(slave->device.file, slave->device.Find(kSyncPeriod, 0U)->ValuePlace()) +
                ": warning: " + cia306::ObjectName(kSyncPeriod, 0U) + ": SYNC of node " + std::to_string(node) +
                " each " + std::to_string(period_us) +
                " us takes the bus (47 us a frame at 1 Mbit/s), expected 0, or a period that leaves room for others");
        }
    }
}

/// The value of such an object is in a file of its own, which is not read. [SRS_MGR_323]
void NetworkWarnings::WarnOfDownloads()
{
    for (const std::unique_ptr<LoadedSlave>& slave : loaded_)
    {
        for (const auto& [index, object] : slave->device.objects)
        {
            for (const auto& [sub, entry] : object.entries)
            {
                if (entry.download_file.IsSet() && !entry.IsFixed() && !entry.is_download_refused)
                {
                    warnings_.push_back(cia306::PlaceText(slave->device.file, entry.download_file.place) +
                                        ": warning: " + cia306::ObjectName(index, sub) + ": " +
                                        cia306::Quoted(entry.download_file.text) + " is not written to node " +
                                        std::to_string(slave->plan.node) +
                                        ", expected ParameterValue, or a tool that downloads files");
                }
            }
        }
    }
}

/// A copied DCF sends what another slave sends: each consumer takes both, and no signature of either is wrong. SRDOs
/// count as on where 13FEh is not A5h, too: anybody may declare them valid. [SRS_NET_060]
void NetworkWarnings::WarnOfSrdos()
{
    std::vector<cia306::SafetyConfiguration> configurations;
    for (const std::unique_ptr<LoadedSlave>& slave : loaded_)
    {
        configurations.push_back(cia306::ExtractSafety(slave->device, slave->plan.node));
    }
    std::vector<cia306::SrdoEnd> ends;
    for (std::size_t place = 0U; place < loaded_.size(); ++place)
    {
        const LoadedSlave& slave = *loaded_[place];
        for (const cia306::SrdoConfiguration& srdo : configurations[place].srdos)
        {
            if (srdo.IsOn())
            {
                ends.push_back({place, "node " + std::to_string(slave.plan.node), slave.device.file, &srdo});
            }
        }
    }
    for (const cia306::Contradiction& contradiction : cia306::ContradictionsOf(ends))
    {
        warnings_.push_back(cia306::FormatFinding(contradiction.file, contradiction.finding));
    }
}

void NetworkWarnings::WarnOfUnused()
{
    const StartProfile profile = plan_.manager.profile;
    const bool is_cia302 = profile == StartProfile::kCia302;
    const bool is_el6751 = profile == StartProfile::kEl6751;
    const bool is_plc = profile == StartProfile::kPlcDesigner;
    const ManagerPlan& manager = plan_.manager;
    const auto tell = [&](const Place place, const std::string& key)
    {
        warnings_.push_back(cia306::PlaceText(plan_.file, place) + ": warning: " + key +
                            " has no effect with the profile " + NameOf(profile));
    };
    const auto warn = [&](const Place place, const ProfileKey& key)
    {
        if (key.is_given && !key.has_effect && !manager.is_profile_chosen)
        {
            tell(place, key.key);
        }
    };
    warn(manager.place, {"sync", setup_.sync_period_us != 0U, is_el6751});
    warn(manager.place, {"el6751", manager.el6751.has_value(), is_el6751});
    warn(manager.place, {"boot_time", setup_.boot_time_ms != 0U, is_cia302});
    for (const std::string& warning : WarningsOfStartUp(manager, setup_))
    {
        warnings_.push_back(cia306::PlaceText(plan_.file, manager.place) + ": warning: " + warning);
    }
    for (const SlavePlan& slave : plan_.slaves)
    {
        warn(slave.place, {"el6751", slave.el6751.has_value(), is_el6751});
        warn(slave.place, {"plc_designer", slave.plc.has_value(), is_plc});
        warn(slave.place, {"keep_alive", slave.is_kept_alive.value_or(false), is_cia302});
        warn(slave.place, {"boot", !slave.is_booted.value_or(true), is_cia302});
        warn(slave.place, {"restore", slave.is_restored.value_or(false), is_cia302});
        warn(slave.place, {"software", slave.software.has_value(), is_cia302});
        warn(slave.place, {"date", slave.date.value_or(0U) != 0U, is_cia302});
        warn(slave.place, {"time", slave.time.value_or(0U) != 0U, is_cia302});
        // Of another flying master it says when its silence counts.
        const bool is_armed = !HasRows(setup_.slaves[slave.node]) || manager.flying.has_value();
        warn(slave.place, {"arming", slave.arming.has_value(), is_armed});
        warn(slave.place, {"vendor_id", slave.vendor_id.value_or(0U) != 0U, !is_plc});
        warn(slave.place, {"product_code", slave.product_code.value_or(0U) != 0U, !is_plc});
        warn(slave.place, {"revision", slave.revision.value_or(0U) != 0U, !is_plc});
        warn(slave.place, {"serial", slave.serial.value_or(0U) != 0U, !is_plc});
        if ((slave.assignment.value_or(0U) & kReservedAssignment) != 0U)
        {
            tell(slave.place, "bit 1 of assignment, which is reserved,");
        }
        WarnOfGuarding(slave, is_el6751);
        for (const std::string& text : UnusedBesideRows(slave, setup_.slaves[slave.node]))
        {
            warnings_.push_back(cia306::PlaceText(plan_.file, slave.place) + ": warning: " + text);
        }
    }
}

/// A node of which no file tells more may be another master.
bool NetworkWarnings::HasUnwatchedNode() const
{
    bool has_one = false;
    for (const std::unique_ptr<LoadedSlave>& slave : loaded_)
    {
        const cia302::SlaveSetup& setup = setup_.slaves[slave->plan.node];
        has_one = has_one || (slave->plan.dcf.empty() && setup.heartbeat.consumer_ms == 0U);
    }
    return has_one;
}

/// What a flying master would do, and nobody wants.
void NetworkWarnings::WarnOfFlying()
{
    const ManagerPlan& manager = plan_.manager;
    if (!manager.flying)
    {
        return;
    }
    const FlyingPlan& flying = *manager.flying;
    const cia302::FlyingMasterOptions& options = flying.options;
    const Place of_flying = PlaceOf(manager.places, "flying", manager.place);
    const auto warn = [&](const Place place, const std::string& text)
    { warnings_.push_back(cia306::PlaceText(plan_.file, place) + ": warning: " + text); };
    const auto ms = [](const std::uint32_t time) { return std::to_string(time) + " ms"; };
    const std::uint32_t heartbeat_ms = manager.heartbeat_ms.value_or(0U);
    if (heartbeat_ms == 0U)
    {
        warn(PlaceOf(manager.places, "heartbeat", of_flying),
             "a flying master without heartbeat, which its standbys lose again and again: expected a heartbeat above "
             "0 ms");
    }
    const bool is_asked = flying.places.count("watch_time") > 0U;
    const bool watches = options.watch == cia302::MasterWatch::kInstalled && (is_asked || HasUnwatchedNode());
    if (watches && options.watch_ms <= heartbeat_ms)
    {
        warn(PlaceOf(flying.places, "watch_time", of_flying),
             "watch_time " + ms(options.watch_ms) + " for masters with a heartbeat each " + ms(heartbeat_ms) +
                 " as this one: their standbys lose them again and again, expected a longer one");
    }
    const std::uint32_t slot_ms = flying.node_slot_ms.value_or(kUsualNodeSlotMs);
    if (slot_ms > 0U && slot_ms < LeastNodeSlotMs())
    {
        warn(PlaceOf(flying.places, "node_slot", of_flying),
             "node_slot " + ms(slot_ms) +
                 ": with a cycle of 1 ms and 125 kbit/s a failover may take longer than "
                 "computed, expected at least " +
                 ms(LeastNodeSlotMs()));
    }
    const bool is_race_cyclic = options.cyclic == cia302::CyclicMessage::kNegotiation;
    if (is_race_cyclic && options.standby == cia302::StandbyReaction::kRaces)
    {
        warn(PlaceOf(flying.places, "standby", of_flying),
             "standby races with cyclic negotiation: masters like this one elect without end, expected another word "
             "for one of them");
    }
    if (is_race_cyclic && options.ignores_claims)
    {
        warn(PlaceOf(flying.places, "claim_heard", of_flying),
             "claim_heard ignores with cyclic negotiation: two masters like this one never end, expected another word "
             "for one of them");
    }
}
} // namespace

std::vector<std::string> WarningsOf(const LoadedNetwork& network)
{
    return NetworkWarnings(network).All();
}

} // namespace counterpoint::network_plan
