// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/start_up/el6751/rows.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint16_t kDeviceTypeIndex = 0x1000U;
constexpr std::uint16_t kSyncPeriodIndex = 0x1006U;
constexpr std::uint16_t kGuardTimeIndex = 0x100CU;
constexpr std::uint16_t kLifeTimeFactorIndex = 0x100DU;
constexpr std::uint16_t kConsumerIndex = 0x1016U;
constexpr std::uint16_t kProducerIndex = 0x1017U;
constexpr std::uint16_t kIdentityIndex = 0x1018U;
constexpr std::uint16_t kFirstRxPdo = 0x1400U;
constexpr std::uint16_t kFirstTxPdo = 0x1800U;
constexpr std::uint16_t kConciseIndex = 0x1F22U;
constexpr std::uint16_t kCouplerPdosIndex = 0x5500U;
constexpr std::uint16_t kLastCouplerType = 2U; ///< Digital and analogue terminals.
constexpr std::uint32_t kLongestTime = 0xFFFFU;

const El6751Slave& SlaveOf(const El6751Context& context) noexcept
{
    return El6751SlaveOf(context.setup, context.node);
}

bool IsCoupler(const El6751Context& context) noexcept
{
    return SlaveOf(context).kind == El6751Kind::kBusCoupler;
}

/// The object that a row accesses, and the value that it compares or writes. All zero for rows without one, or of a
/// PDO.
struct RowForm
{
    El6751Row row;
    std::uint16_t index;
    std::uint8_t sub;
    std::uint8_t size_bytes;
    bool is_upload;
    StartUpStep step;
    std::uint32_t value;
};

RowForm FormOf(const El6751Context& context, const El6751Row row) noexcept
{
    const SlaveSetup& setup = context.setup.Slave(context.node);
    const El6751Slave& slave = SlaveOf(context);
    const std::uint32_t life_ms = std::uint32_t{slave.guard_time_ms} * slave.life_time_factor;
    const std::uint32_t manager = slave.is_consumer_literal ? 0U : (std::uint32_t{context.setup.own.value} << 16U);
    const std::uint32_t consumer = manager | ((life_ms > kLongestTime) ? kLongestTime : life_ms);
    const std::uint32_t period_us = context.setup.sync_period_us;
    const RowForm forms[]{
        {El6751Row::kDeviceType, kDeviceTypeIndex, 0U, 4U, true, StartUpStep::kDeviceType, setup.device_type},
        {El6751Row::kVendorId, kIdentityIndex, 1U, 4U, true, StartUpStep::kVendorId, setup.vendor_id},
        {El6751Row::kProductCode, kIdentityIndex, 2U, 4U, true, StartUpStep::kProductCode, setup.product_code},
        {El6751Row::kRevisionNumber, kIdentityIndex, 3U, 4U, true, StartUpStep::kRevisionNumber, setup.revision_number},
        {El6751Row::kSerialNumber, kIdentityIndex, 4U, 4U, true, StartUpStep::kSerialNumber, setup.serial_number},
        {El6751Row::kSyncPeriod, kSyncPeriodIndex, 0U, 4U, false, StartUpStep::kSyncPeriod, period_us},
        {El6751Row::kCouplerPdos, kCouplerPdosIndex, 0U, 4U, false, StartUpStep::kPdo, slave.coupler_pdos},
        {El6751Row::kProducerHeartbeat, kProducerIndex, 0U, 2U, false, StartUpStep::kHeartbeat, slave.guard_time_ms},
        {El6751Row::kConsumerHeartbeat, kConsumerIndex, 1U, 4U, false, StartUpStep::kHeartbeat, consumer},
        {El6751Row::kGuardTime, kGuardTimeIndex, 0U, 2U, false, StartUpStep::kGuarding, slave.guard_time_ms},
        {El6751Row::kLifeTimeFactor, kLifeTimeFactorIndex, 0U, 1U, false, StartUpStep::kGuarding,
         slave.life_time_factor},
    };
    RowForm found{row, 0U, 0U, 0U, false, StartUpStep::kNone, 0U};
    for (const RowForm& form : forms)
    {
        found = (form.row == row) ? form : found;
    }
    return found;
}

/// Whether the conditions of a row that is none of a PDO hold.
bool IsSlaveRowActive(const El6751Context& context, const El6751Place& place) noexcept
{
    const El6751Slave& slave = SlaveOf(context);
    const El6751Row row = place.row;
    const bool is_coupler = IsCoupler(context);
    const bool is_number = (row >= El6751Row::kVendorId) && (row <= El6751Row::kSerialNumber);
    const bool is_of_all = (row == El6751Row::kVendorId) || (row == El6751Row::kProductCode);
    const bool is_configured = !is_coupler && (FormOf(context, row).value != 0U);
    const bool is_synchronous = context.is_sync_sent && slave.is_sync_period_written;
    const bool is_guarding = (row == El6751Row::kGuardTime) || (row == El6751Row::kLifeTimeFactor);
    const bool is_heartbeat = (row == El6751Row::kConsumerHeartbeat);
    const bool is_watching = (row == El6751Row::kProducerHeartbeat) || (is_guarding && place.is_heartbeat_aborted) ||
                             (is_heartbeat && !place.is_heartbeat_aborted);
    const ConciseReading user = ReadConcise(context.setup.Slave(context.node).concise_dcf, place.user);
    return (row == El6751Row::kEnd) || ((row == El6751Row::kDeviceType) && slave.is_device_type_checked) ||
           (is_number && (is_configured || (is_coupler && is_of_all))) ||
           ((row == El6751Row::kSyncPeriod) && is_synchronous) || ((row == El6751Row::kCouplerPdos) && is_coupler) ||
           (is_watching && slave.IsWatched()) ||
           ((row == El6751Row::kUserObject) && (user.state != ConciseState::kEnd));
}

bool IsPdoRow(const El6751Row row) noexcept
{
    return (row >= El6751Row::kCobId) && (row <= El6751Row::kEventReadBack);
}

bool IsReadBack(const El6751Row row) noexcept
{
    return (row == El6751Row::kCobIdReadBack) || (row == El6751Row::kTypeReadBack) ||
           (row == El6751Row::kInhibitReadBack) || (row == El6751Row::kEventReadBack);
}

bool IsActive(const El6751Context& context, const El6751Place& place) noexcept
{
    bool is_active = false;
    if (IsReadBack(place.row))
    {
        is_active = place.is_aborted;
    }
    else if (IsPdoRow(place.row))
    {
        const El6751Slave& slave = SlaveOf(context);
        const El6751Pdo& pdo = El6751PdoOf(slave, place.pdo);
        const bool is_coupler = IsCoupler(context);
        const bool has_type = !is_coupler || (pdo.number <= kLastCouplerType);
        const bool is_cob_id = (place.row == El6751Row::kCobId) && slave.is_cob_id_written && !is_coupler;
        const bool is_type = (place.row == El6751Row::kType) && slave.is_type_written && has_type;
        const bool is_inhibit = (place.row == El6751Row::kInhibit) && (El6751InhibitOf(slave, pdo) > 0U);
        const bool is_event = (place.row == El6751Row::kEvent) && (El6751EventOf(slave, pdo) > 0U);
        is_active = is_cob_id || is_type || is_inhibit || is_event;
    }
    else
    {
        is_active = IsSlaveRowActive(context, place);
    }
    return is_active;
}

/// The row behind this one, active or not.
El6751Place Successor(const El6751Context& context, const El6751Place& place) noexcept
{
    const std::uint8_t pdos = SlaveOf(context).PdoCount();
    El6751Place next = place;
    next.row = static_cast<El6751Row>(static_cast<std::uint8_t>(place.row) + 1U);
    if (place.row == El6751Row::kCouplerPdos)
    {
        next.pdo = 0U;
        next.row = (pdos > 0U) ? El6751Row::kCobId : El6751Row::kProducerHeartbeat;
    }
    else if ((place.row == El6751Row::kEventReadBack) && ((place.pdo + 1U) < pdos))
    {
        next.pdo = static_cast<std::uint8_t>(place.pdo + 1U);
        next.row = El6751Row::kCobId;
    }
    else if (place.row == El6751Row::kLifeTimeFactor)
    {
        next.user = ConcisePosition{0U, 0U};
    }
    else if (place.row == El6751Row::kUserObject)
    {
        const Bytes& list = context.setup.Slave(context.node).concise_dcf;
        next.user = ReadConcise(list, place.user).next;
        next.row = (ReadConcise(list, next.user).state == ConciseState::kEnd) ? El6751Row::kEnd : place.row;
    }
    else
    {
        // The next one of the list.
    }
    return next;
}

El6751Access PdoAccess(const El6751Slave& slave, const El6751Place& place) noexcept
{
    const El6751Pdo& pdo = El6751PdoOf(slave, place.pdo);
    const std::uint16_t first = (place.pdo < slave.rx_count) ? kFirstRxPdo : kFirstTxPdo;
    const auto index = static_cast<std::uint16_t>(first + pdo.number - 1U);
    const bool is_read = IsReadBack(place.row);
    El6751Access access{{index, 1U}, StartUpStep::kPdo, is_read, is_read, 4U, pdo.cob_id, Bytes{nullptr, 0U}};
    access.step = is_read ? StartUpStep::kPdoReadBack : StartUpStep::kPdo;
    if ((place.row == El6751Row::kType) || (place.row == El6751Row::kTypeReadBack))
    {
        access.object.sub = 2U;
        access.size_bytes = 1U;
        access.value = pdo.type;
    }
    else if ((place.row == El6751Row::kInhibit) || (place.row == El6751Row::kInhibitReadBack))
    {
        access.object.sub = 3U;
        access.size_bytes = 2U;
        access.value = El6751InhibitOf(slave, pdo);
    }
    else if ((place.row == El6751Row::kEvent) || (place.row == El6751Row::kEventReadBack))
    {
        access.object.sub = 5U;
        access.size_bytes = 2U;
        access.value = El6751EventOf(slave, pdo);
    }
    else
    {
        // The COB-ID.
    }
    return access;
}

} // namespace

El6751Place NextRow(const El6751Context& context, const El6751Place& place) noexcept
{
    El6751Place next = Successor(context, place);
    while (!IsActive(context, next))
    {
        next = Successor(context, next);
    }
    return next;
}

El6751Access AccessOf(const El6751Context& context, const El6751Place& place) noexcept
{
    El6751Access access{{0U, 0U}, StartUpStep::kNone, false, false, 0U, 0U, Bytes{nullptr, 0U}};
    if (IsPdoRow(place.row))
    {
        access = PdoAccess(SlaveOf(context), place);
    }
    else if (place.row == El6751Row::kUserObject)
    {
        const ConciseReading entry = ReadConcise(context.setup.Slave(context.node).concise_dcf, place.user);
        const ObjectAddress itself{kConciseIndex, context.node.value};
        access.step = StartUpStep::kUserObjects;
        access.object = (entry.state == ConciseState::kEntry) ? entry.object : itself;
        access.user = entry.value;
    }
    else
    {
        const RowForm form = FormOf(context, place.row);
        const bool is_compared = form.is_upload && ((form.value != 0U) || (form.index == kDeviceTypeIndex));
        access = El6751Access{{form.index, form.sub}, form.step,  form.is_upload,    is_compared,
                              form.size_bytes,        form.value, Bytes{nullptr, 0U}};
    }
    return access;
}

El6751Verdict JudgeAnswer(const El6751Access& access, const El6751Row row, const El6751Answer& answer) noexcept
{
    const bool is_silence = (answer.outcome.abort == SdoAbort::kTimeOut) && !answer.outcome.by_server;
    const bool has_other_way = (IsPdoRow(row) && !IsReadBack(row)) || (row == El6751Row::kProducerHeartbeat);
    El6751Verdict verdict = El6751Verdict::kNext;
    if (is_silence)
    {
        verdict = answer.is_first ? El6751Verdict::kNotFound : El6751Verdict::kSyntax;
    }
    else if (answer.outcome.abort != SdoAbort::kNone)
    {
        verdict = (has_other_way && answer.outcome.by_server) ? El6751Verdict::kNext : El6751Verdict::kSyntax;
    }
    else if (access.is_upload && (answer.outcome.size_bytes != access.size_bytes))
    {
        verdict = El6751Verdict::kSyntax;
    }
    else if (access.is_compared && (answer.read != access.value))
    {
        verdict = El6751Verdict::kMismatch;
    }
    else
    {
        // As configured.
    }
    return verdict;
}

El6751Place Remember(const El6751Place& place, const SdoOutcome& outcome) noexcept
{
    const bool is_aborted = (outcome.abort != SdoAbort::kNone);
    const bool is_heartbeat = (place.row == El6751Row::kProducerHeartbeat);
    El6751Place next = place;
    next.is_aborted = is_aborted && !is_heartbeat;
    next.is_heartbeat_aborted = place.is_heartbeat_aborted || (is_aborted && is_heartbeat);
    next.is_heartbeat_answered = place.is_heartbeat_answered || (!is_aborted && is_heartbeat);
    return next;
}

} // namespace counterpoint::cia302
