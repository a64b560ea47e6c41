// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/network_plan/profile_maker.hpp"

#include "canopen/cia301/base/cob_id.hpp"
#include "canopen/cia302/network/concise_dcf.hpp"
#include "canopen/network_plan/concise_maker.hpp"

#include "canopen/cia306/text/input_error.hpp"

#include <algorithm>
#include <optional>
#include <set>

namespace counterpoint::network_plan
{
namespace
{
using cia302::El6751Pdo;
using cia302::El6751Slave;
using cia302::NetworkSetup;
using cia302::SlaveSetup;
using cia306::Device;
using cia306::Entry;

constexpr std::uint16_t kFirstRxPdo = 0x1400U;
constexpr std::uint16_t kFirstTxPdo = 0x1800U;
constexpr std::uint16_t kPdoNumbers = 0x200U; ///< Also from communication to mapping parameters.
constexpr std::uint32_t kOff = 0x80000000U;
constexpr std::uint32_t kBitsOfByte = 8U;
constexpr std::uint32_t kLengthMask = 0xFFU; ///< Of a mapping entry.
constexpr std::uint32_t kMostPdos = 255U;    ///< Both directions together.
constexpr std::uint8_t kEventDriven = 255U;
constexpr std::uint16_t kCouplerPdos = 0x5500U;

std::uint32_t MappedBits(const Device& device, const std::uint8_t node_id, const std::uint16_t mapping)
{
    const std::uint32_t count = NumberOf(device, node_id, mapping, 0U, 0U);
    std::uint32_t bits = 0U;
    for (std::uint32_t sub = 1U; sub <= std::min(count, 64U); ++sub)
    {
        bits += NumberOf(device, node_id, mapping, static_cast<std::uint8_t>(sub), 0U) & kLengthMask;
    }
    return bits;
}

/// Guard time and life time factor: as the file says, else as the heartbeat has them. A device that is known to have no
/// 1016h would abort that row: it is supervised by its heartbeat all the same, as the setup says. What the rows write
/// is the slave's heartbeat.
void FillGuard(const SlavePlan& plan, const Device& device, SlaveSetup& setup, El6751Slave& slave)
{
    const bool has_consumer = device.objects.empty() || device.Find(0x1016U, 1U) != nullptr;
    const std::uint32_t producer_ms = setup.heartbeat.producer_ms;
    const std::uint32_t consumer_ms = std::max<std::uint32_t>(setup.heartbeat.consumer_ms, producer_ms);
    if (plan.guard_ms || setup.GuardTimeMs() > 0U)
    {
        slave.guard_time_ms = setup.GuardTimeMs();
        slave.life_time_factor = setup.RetryFactor();
    }
    else if (producer_ms > 0U && has_consumer)
    {
        const std::uint32_t factor = (consumer_ms + producer_ms - 1U) / producer_ms;
        slave.guard_time_ms = static_cast<std::uint16_t>(producer_ms);
        slave.life_time_factor = static_cast<std::uint8_t>(std::min(factor, 255U));
    }
    setup.heartbeat.producer_ms = slave.IsWatched() ? slave.guard_time_ms : setup.heartbeat.producer_ms;
}

/// A time that the DCF switches off though the device has one by itself: no row does it, and it can change only while
/// the PDO is off.
bool IsSwitchedOff(const Device& device, const std::uint8_t node_id, const std::uint16_t index, const std::uint8_t sub)
{
    const Entry* const entry = device.Find(index, sub);
    bool is_off =
        entry != nullptr && !entry->IsFixed() && entry->parameter_value.IsSet() && entry->default_value.IsSet();
    if (is_off)
    {
        Entry usual = *entry;
        usual.parameter_value = {};
        const std::optional<cia306::Value> by_itself = cia306::UsableValue(device.file, usual, node_id);
        const std::optional<cia306::Value> value = cia306::UsableValue(device.file, *entry, node_id);
        const bool has_one = by_itself && by_itself->bits > 0U;
        is_off = has_one && value && value->bits == 0U;
    }
    return is_off;
}

/// Communication parameters of the PDO at this place of the dictionary that the rows write, and its mapping.
bool IsRowOfPdo(const std::vector<El6751Pdo>& pdos, const std::uint16_t first, const cia302::ConciseReading& entry)
{
    constexpr std::uint8_t kEvent = 5U;
    constexpr std::uint8_t kReserved = 4U;
    const bool is_parameter = entry.object.sub >= 1U && entry.object.sub <= kEvent && entry.object.sub != kReserved;
    bool is_row = false;
    for (const El6751Pdo& pdo : pdos)
    {
        const std::uint32_t index = first + pdo.number - 1U;
        is_row = is_row || (is_parameter && entry.object.index == index) || entry.object.index == index + kPdoNumbers;
    }
    return is_row;
}

/// Communication parameters of any PDO.
bool IsPdoParameter(const std::uint16_t index)
{
    return (index >= kFirstRxPdo && index < kFirstRxPdo + kPdoNumbers) ||
           (index >= kFirstTxPdo && index < kFirstTxPdo + kPdoNumbers);
}

bool IsCoupler(const El6751Slave& slave)
{
    return slave.kind == cia302::El6751Kind::kBusCoupler;
}

/// 5500h as its DCF says, unless the network file does. Of another device it is any object. [SRS_ELM_585]
std::uint32_t CouplerPdosOf(const SlavePlan& plan, const Device& device, const El6751Slave& slave)
{
    const std::uint32_t usual = IsCoupler(slave) ? NumberOf(device, plan.node, kCouplerPdos, 0U, 0U) : 0U;
    return plan.coupler_pdos.value_or(usual);
}

/// Of 1016h the row writes the first consumer, which is the manager; the manager a second time would be refused.
bool IsRowOfSlave(const El6751Slave& slave, const cia302::ConciseReading& entry, const NetworkSetup& network)
{
    const std::uint16_t index = entry.object.index;
    const bool has_node = entry.value.size_bytes == sizeof(std::uint32_t);
    const bool is_manager =
        index == 0x1016U && (entry.object.sub <= 1U || (has_node && entry.value.data[2] == network.own.value));
    const bool is_guarding = is_manager || index == 0x1017U || index == 0x100CU || index == 0x100DU;
    const bool is_sync = index == 0x1006U && slave.is_sync_period_written;
    const bool is_coupler_row = index == kCouplerPdos && entry.object.sub == 0U && IsCoupler(slave);
    return is_coupler_row || (is_guarding && slave.IsWatched()) || (is_sync && cia302::NeedsSync(network));
}

/// Whether the DCF gives the object, which has a value of the concise DCF, another one than the device has by itself,
/// as far as the DCF knows that.
bool IsChanged(const Device& device, const std::uint8_t node_id, const Entry& entry)
{
    bool is_changed = entry.parameter_value.IsSet();
    if (is_changed && entry.default_value.IsSet())
    {
        Entry usual = entry;
        usual.parameter_value = {};
        const bool is_known = cia306::UsableValue(device.file, usual, node_id).has_value();
        is_changed = !is_known || BytesOf(device, usual, node_id) != BytesOf(device, entry, node_id);
    }
    return is_changed;
}

/// PDOs whose whole sequence is kept: those whose mapping changes, and those with a time that is switched off.
/// [SRS_NET_480]
std::set<std::uint16_t> WholePdos(const Device& device, const std::uint8_t node_id, const cia302::Bytes& concise)
{
    constexpr std::uint8_t kInhibit = 3U;
    constexpr std::uint8_t kEvent = 5U;
    std::set<std::uint16_t> whole;
    cia302::ConciseReading entry = cia302::ReadConcise(concise, {0U, 0U});
    for (; entry.state == cia302::ConciseState::kEntry; entry = cia302::ReadConcise(concise, entry.next))
    {
        const std::uint16_t index = entry.object.index;
        const auto pdo = static_cast<std::uint16_t>(index - kPdoNumbers);
        const bool is_mapped = IsPdoParameter(pdo) && IsChanged(device, node_id, *device.Find(index, entry.object.sub));
        whole.insert(is_mapped ? pdo : std::uint16_t{0U});
        const bool is_off = IsPdoParameter(index) && (IsSwitchedOff(device, node_id, index, kInhibit) ||
                                                      IsSwitchedOff(device, node_id, index, kEvent));
        whole.insert(is_off ? index : std::uint16_t{0U});
    }
    return whole;
}

/// What the rows write, and mappings that stay as they are, is left out, but for the PDOs of WholePdos. A bus coupler
/// makes its PDOs by 5500h.
std::vector<std::uint8_t> FurtherObjects(const ProfileSlave& slave, const cia302::Bytes& concise,
                                         const std::set<std::uint16_t>& whole, const NetworkSetup& network)
{
    std::vector<ConciseEntry> kept;
    cia302::ConciseReading entry{};
    const bool is_coupler = IsCoupler(slave.el6751);
    entry = cia302::ReadConcise(concise, {0U, 0U});
    for (; entry.state == cia302::ConciseState::kEntry; entry = cia302::ReadConcise(concise, entry.next))
    {
        const std::uint16_t index = entry.object.index;
        const auto mapped = static_cast<std::uint16_t>(index - kPdoNumbers);
        const std::uint16_t pdo = IsPdoParameter(mapped) ? mapped : index;
        const bool is_made = is_coupler && IsPdoParameter(pdo);
        const bool is_pdo_row = whole.count(pdo) == 0U && (is_made || IsRowOfPdo(slave.rx_pdos, kFirstRxPdo, entry) ||
                                                           IsRowOfPdo(slave.tx_pdos, kFirstTxPdo, entry));
        if (!is_pdo_row && !IsRowOfSlave(slave.el6751, entry, network))
        {
            kept.push_back({entry.object.index, entry.object.sub,
                            std::vector<std::uint8_t>(entry.value.data, entry.value.data + entry.value.size_bytes)});
        }
    }
    return ConciseBytes(kept);
}

/// Zeros, or what the network file says. [SRS_MGR_022]
void FillOutputs(const std::string& file, const SlavePlan& plan, ProfileSlave& slave)
{
    slave.outputs.assign(slave.rx_pdos.size(), {});
    std::set<std::uint16_t> seen;
    for (const OutputPlan& output : plan.outputs)
    {
        const std::string name = "RxPDO " + std::to_string(output.number) + " of node " + std::to_string(plan.node);
        const auto found = std::find_if(slave.rx_pdos.begin(), slave.rx_pdos.end(),
                                        [&output](const El6751Pdo& pdo) { return pdo.number == output.number; });
        if (found == slave.rx_pdos.end())
        {
            throw cia306::InputError(file, output.place, {"no " + name, "one that its DCF switches on and maps"});
        }
        if (!seen.insert(output.number).second)
        {
            throw cia306::InputError(file, output.place, {name + " a second time", "each RxPDO once"});
        }
        if (output.bytes.size() != found->length_bytes)
        {
            throw cia306::InputError(file, output.place,
                                     {name + " with " + std::to_string(output.bytes.size()) + " bytes",
                                      std::to_string(found->length_bytes) + " as its mapping has"});
        }
        auto& bytes = slave.outputs.at(static_cast<std::size_t>(found - slave.rx_pdos.begin()));
        std::copy(output.bytes.begin(), output.bytes.end(), bytes.begin());
    }
    for (std::size_t place = 0U; place < slave.rx_pdos.size(); ++place)
    {
        slave.rx_pdos[place].data_bytes = slave.outputs[place].data();
    }
}

void FillEl6751(const std::string& file, const SlavePlan& plan, const Device& device, ProfileSlave& slave,
                SlaveSetup& setup)
{
    slave.el6751 = plan.el6751.value_or(El6751Slave{});
    slave.el6751.coupler_pdos = CouplerPdosOf(plan, device, slave.el6751);
    slave.rx_pdos = MakePdos(device, plan.node, kFirstRxPdo);
    slave.tx_pdos = MakePdos(device, plan.node, kFirstTxPdo);
    if (slave.rx_pdos.size() + slave.tx_pdos.size() > kMostPdos)
    {
        throw cia306::InputError(device.file, device.device_info_place.OrBeginning(),
                                 {std::to_string(slave.rx_pdos.size() + slave.tx_pdos.size()) + " PDOs that are on",
                                  "at most " + std::to_string(kMostPdos) + " with the EL6751 start-up"});
    }
    FillOutputs(file, plan, slave);
    FillGuard(plan, device, setup, slave.el6751);
    slave.el6751.rx_pdos = slave.rx_pdos.data();
    slave.el6751.rx_count = static_cast<std::uint8_t>(slave.rx_pdos.size());
    slave.el6751.tx_pdos = slave.tx_pdos.data();
    slave.el6751.tx_count = static_cast<std::uint8_t>(slave.tx_pdos.size());
    setup.el6751 = &slave.el6751;
}
} // namespace

std::vector<El6751Pdo> MakePdos(const Device& device, const std::uint8_t node_id, const std::uint16_t first)
{
    std::vector<El6751Pdo> pdos;
    for (auto found = device.objects.lower_bound(first);
         found != device.objects.end() && found->first < first + kPdoNumbers; ++found)
    {
        const std::uint16_t index = found->first;
        const std::uint32_t cob_id = NumberOf(device, node_id, index, 1U, kOff);
        const std::uint32_t bits = MappedBits(device, node_id, static_cast<std::uint16_t>(index + kPdoNumbers));
        if ((cob_id & (kOff | cia301::kCobExtended)) == cia301::kCobExtended)
        {
            throw cia306::InputError(device.file, device.Find(index, 1U)->ValuePlace(),
                                     {cia306::ObjectName(index, 1U) + " is " + cia306::Hex(cob_id, 8) +
                                          ", a PDO with an identifier of 29 bits",
                                      "one of 11 bits (bit 29 is 0)"});
        }
        if ((cob_id & kOff) == 0U && bits > 0U)
        {
            El6751Pdo pdo{};
            pdo.number = static_cast<std::uint16_t>(index - first + 1U);
            pdo.cob_id = cob_id;
            pdo.type = static_cast<std::uint8_t>(NumberOf(device, node_id, index, 2U, kEventDriven));
            pdo.inhibit_100us = static_cast<std::uint16_t>(NumberOf(device, node_id, index, 3U, 0U));
            pdo.event_ms = static_cast<std::uint16_t>(NumberOf(device, node_id, index, 5U, 0U));
            pdo.length_bytes = static_cast<std::uint8_t>(std::min((bits + kBitsOfByte - 1U) / kBitsOfByte, 8U));
            pdos.push_back(pdo);
        }
    }
    return pdos;
}

void LeaveOutRows(const Device& device, const std::uint8_t node_id, const NetworkSetup& network, ProfileSlave& slave,
                  SlaveSetup& setup)
{
    const std::set<std::uint16_t> whole = WholePdos(device, node_id, setup.concise_dcf);
    slave.concise = FurtherObjects(slave, setup.concise_dcf, whole, network);
    setup.concise_dcf = cia302::Bytes{slave.concise.data(), static_cast<std::uint32_t>(slave.concise.size())};
}

std::string WarningOfCoupler(const SlavePlan& plan, const Device& device)
{
    const Entry* const entry = device.Find(kCouplerPdos, 0U);
    const bool is_coupler = plan.el6751.has_value() && IsCoupler(*plan.el6751);
    const bool is_twice = is_coupler && plan.coupler_pdos && entry != nullptr && entry->parameter_value.IsSet();
    const std::uint32_t other = is_twice ? NumberOf(device, plan.node, kCouplerPdos, 0U, 0U) : 0U;
    const bool is_other = is_twice && other != *plan.coupler_pdos;
    return is_other ? cia306::ObjectName(kCouplerPdos, 0U) + " of node " + std::to_string(plan.node) + " is " +
                          cia306::Hex(other, 1) + " in its DCF: " + cia306::Hex(*plan.coupler_pdos, 1) +
                          " of coupler_pdos is written, expected one of the two"
                    : "";
}

void FillProfile(const std::string& file, const StartProfile profile, const SlavePlan& plan, const Device& device,
                 ProfileSlave& slave, SlaveSetup& setup)
{
    if (profile != StartProfile::kEl6751 && !plan.outputs.empty())
    {
        throw cia306::InputError(file, plan.outputs.front().place,
                                 {"outputs of node " + std::to_string(plan.node) + " with another profile",
                                  "the profile el6751, which sends RxPDOs"});
    }
    if (profile == StartProfile::kEl6751)
    {
        FillEl6751(file, plan, device, slave, setup);
    }
    else if (profile == StartProfile::kPlcDesigner)
    {
        slave.plc = plan.plc.value_or(cia302::PlcSlave{!plan.is_mandatory.value_or(true), false});
        setup.plc = &slave.plc;
    }
}
} // namespace counterpoint::network_plan
