// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// When a TPDO is sent, and the objects of the TPDOs: 1800h.. and 1A00h..
#include "canopen/cia301/pdo/tpdo.hpp"

#include "canopen/cia301/base/cob_id.hpp"
#include "canopen/cia301/objects/service_table.hpp"
#include "canopen/cia301/pdo/settings.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint16_t kFirstObject = 0x1800U;
constexpr std::uint32_t kUsPerMs = 1000U;
constexpr std::uint32_t kUsPerStep = 100U;
constexpr std::uint32_t kStandard = 0x7FFU;
constexpr std::uint8_t kSampledBySync = 252U;
constexpr std::uint8_t kSampledByRtr = 253U;

bool IsSendable(const Tpdo& pdo) noexcept
{
    return ((pdo.settings.cob_id & kCobOff) == 0U) && (pdo.map.count > 0U);
}

bool IsEventDriven(const Tpdo& pdo) noexcept
{
    return pdo.settings.type > kSampledByRtr;
}

/// Whether the event time is over. It begins anew in its phase, unless a whole one was missed.
bool IsTimerOver(Tpdo& pdo, const Instant now) noexcept
{
    const std::uint32_t period_us = pdo.settings.event_ms * kUsPerMs;
    const std::uint32_t since_us = now.us - pdo.run.timer_at.us;
    const bool is_over = (period_us > 0U) && pdo.run.is_timed && (since_us >= period_us);
    if (is_over)
    {
        const bool is_steady = (since_us - period_us) < period_us;
        pdo.run.timer_at.us = is_steady ? (pdo.run.timer_at.us + period_us) : now.us;
    }
    return is_over;
}

constexpr std::uint8_t kHighestSub = 6U;
constexpr std::uint8_t kStartSub = 6U;
constexpr std::uint32_t kFirstOnRtr = 252U;

bool IsType(const std::uint32_t type) noexcept
{
    return (type <= kLastSynchronous) || (type >= kFirstOnRtr);
}

} // namespace

void Tpdos::OnFrame(const CanFrame& frame, const Moment& moment) noexcept
{
    FollowState(moment);
    for (std::uint16_t i = 0U; (frame.kind == FrameKind::kRemote) && (i < parts_.table.count); ++i)
    {
        Tpdo& pdo = parts_.table.pdos[i];
        const bool is_allowed = is_operational_ && IsSendable(pdo) && ((pdo.settings.cob_id & kCobBit30) == 0U);
        const bool is_kept = IsSynchronous(pdo) || (pdo.settings.type == kSampledBySync);
        if (is_allowed && (frame.identifier == (pdo.settings.cob_id & kStandard)) && (!is_kept || pdo.run.has_sampled))
        {
            pdo.run.sampled = is_kept ? pdo.run.sampled : Pack(pdo.map);
            pdo.run.window_us = 0U;
            Transmit(pdo, moment.now);
        }
    }
}

void Tpdos::OnSync(const SyncEvent& event) noexcept
{
    FollowState(event.moment);
    for (std::uint16_t i = 0U; is_operational_ && (i < parts_.table.count); ++i)
    {
        Tpdo& pdo = parts_.table.pdos[i];
        if (IsSendable(pdo) && (IsSynchronous(pdo) || (pdo.settings.type == kSampledBySync)))
        {
            const PdoData now = Pack(pdo.map);
            const bool is_due = IsSyncDue(pdo, event, now);
            // What still waits for room keeps the values of its own SYNC.
            pdo.run.sampled = (is_due || !pdo.run.is_due) ? now : pdo.run.sampled;
            pdo.run.has_sampled = true;
            if (is_due)
            {
                pdo.run.due_at = event.moment.now;
                pdo.run.window_us = event.window_us;
                pdo.run.is_requested = false;
                Transmit(pdo, event.moment.now);
            }
        }
    }
}

bool Tpdos::IsSyncDue(Tpdo& pdo, const SyncEvent& event, const PdoData& now) const noexcept
{
    TpdoRun& run = pdo.run;
    bool is_due = false;
    if (pdo.settings.type == 0U)
    {
        is_due = run.is_requested || ((pdo.trigger == PdoTrigger::kChange) && IsChanged(pdo.map, run.sent, now));
    }
    else if (!IsSynchronous(pdo))
    {
        is_due = false; // Type 252 is only sampled.
    }
    else if ((event.counter != 0U) && (pdo.settings.sync_start != 0U) && !run.is_aligned)
    {
        is_due = (event.counter == pdo.settings.sync_start);
        run.is_aligned = is_due;
    }
    else
    {
        ++run.syncs;
        is_due = (run.syncs >= pdo.settings.type);
    }
    run.syncs = is_due ? std::uint8_t{0U} : run.syncs;
    return is_due;
}

void Tpdos::OnCycle(const Moment& moment) noexcept
{
    FollowState(moment);
    for (std::uint16_t i = 0U; is_operational_ && (i < parts_.table.count); ++i)
    {
        Tpdo& pdo = parts_.table.pdos[i];
        if (pdo.run.is_due)
        {
            SendDue(pdo, moment);
        }
        else if (IsEventDriven(pdo) && IsSendable(pdo))
        {
            RunEvents(pdo, moment);
        }
        else
        {
            // Waits for SYNC or RTR.
        }
    }
}

/// What found no room, unless its window is over.
void Tpdos::SendDue(Tpdo& pdo, const Moment& moment) noexcept
{
    const bool has_window = IsSynchronous(pdo) && (pdo.run.window_us > 0U);
    if (has_window && ((moment.now.us - pdo.run.due_at.us) > pdo.run.window_us))
    {
        pdo.run.is_due = false;
    }
    else if (IsSendable(pdo))
    {
        Transmit(pdo, moment.now);
    }
    else
    {
        // Switched off in between.
    }
}

void Tpdos::RunEvents(Tpdo& pdo, const Moment& moment) noexcept
{
    TpdoRun& run = pdo.run;
    const std::uint32_t inhibit_us = pdo.settings.inhibit_100us * kUsPerStep;
    const bool is_over = IsTimerOver(pdo, moment.now);
    const Instant timer_at = run.timer_at;
    run.is_inhibited = run.is_inhibited && ((moment.now.us - run.sent_at.us) < inhibit_us);
    run.is_requested = run.is_requested || is_over;
    if (run.is_requested || (pdo.trigger == PdoTrigger::kChange))
    {
        const PdoData now = Pack(pdo.map);
        const bool is_changed = (pdo.trigger == PdoTrigger::kChange) && IsChanged(pdo.map, run.sent, now);
        run.is_requested = run.is_requested || is_changed;
        if (run.is_requested && !run.is_inhibited)
        {
            run.sampled = now;
            Transmit(pdo, moment.now);
            run.is_requested = run.is_due;
            run.is_due = false; // It goes later with the values of then.
            run.timer_at = is_over ? timer_at : run.timer_at;
        }
    }
}

bool Tpdos::Request(const std::uint16_t number) noexcept
{
    Tpdo* const pdo = Find(number);
    if (pdo != nullptr)
    {
        pdo->run.is_requested = true;
    }
    return pdo != nullptr;
}

void Tpdos::FollowState(const Moment& moment) noexcept
{
    const bool is_allowed = IsAllowed(Service::kPdo, moment.state);
    for (std::uint16_t i = 0U; is_allowed && !is_operational_ && (i < parts_.table.count); ++i)
    {
        Start(parts_.table.pdos[i]);
    }
    is_operational_ = is_allowed;
}

/// Nothing from before counts, and event-driven values are sent once.
void Tpdos::Start(Tpdo& pdo) noexcept
{
    pdo.run = TpdoRun{};
    pdo.run.is_requested = true;
}

/// Sends `sampled`, or leaves it due.
void Tpdos::Transmit(Tpdo& pdo, const Instant now) noexcept
{
    CanFrame frame{pdo.settings.cob_id & kStandard, FrameKind::kData, CanPortId::kFirst, LengthOf(pdo.map), {}};
    for (std::uint32_t i = 0U; i < kPdoBytes; ++i)
    {
        frame.data[i] = pdo.run.sampled.bytes[i];
    }
    pdo.run.is_due = !parts_.sink.Send(frame);
    if (!pdo.run.is_due)
    {
        pdo.run.sent = pdo.run.sampled;
        pdo.run.sent_at = now;
        pdo.run.timer_at = now;
        pdo.run.is_timed = true;
        pdo.run.is_inhibited = true;
    }
}

Tpdos::Tpdos(const TpdoParts& parts) noexcept : parts_(parts), is_operational_(false), is_configuring_(false)
{
}

void Tpdos::Reset() noexcept
{
    for (std::uint16_t i = 0U; i < parts_.table.count; ++i)
    {
        Tpdo& pdo = parts_.table.pdos[i];
        pdo.settings = TpdoSettings{};
        pdo.run = TpdoRun{};
        ClearMap(pdo.map);
    }
    is_operational_ = false;
    is_configuring_ = false;
}

void Tpdos::BeginConfiguration() noexcept
{
    is_configuring_ = true;
}

void Tpdos::EndConfiguration() noexcept
{
    for (std::uint16_t i = 0U; is_configuring_ && (i < parts_.table.count); ++i)
    {
        Tpdo& pdo = parts_.table.pdos[i];
        const bool is_mapped = ResolveMap(pdo.map, kInTpdo, parts_.dictionary) == SdoAbort::kNone;
        const bool is_set = IsUsable(pdo.settings.cob_id) && IsType(pdo.settings.type);
        pdo.settings.cob_id |= (is_mapped && is_set) ? 0U : kCobOff;
        Start(pdo);
    }
    is_configuring_ = false;
}

void Tpdos::TurnOffShared(const WriteRule& rule) noexcept
{
    cia301::TurnOffShared(parts_.table.pdos, parts_.table.count, kFirstObject, rule);
}

bool Tpdos::Uses(const std::uint32_t identifier, const std::uint16_t except) const noexcept
{
    return IsUsed(parts_.table.pdos, parts_.table.count, identifier, except);
}

ObjectValue Tpdos::FetchSetting(const std::uint16_t number, const std::uint8_t sub) const noexcept
{
    const Tpdo* const pdo = Find(number);
    ObjectValue value{SdoAbort::kObjectUnknown, 0U, 1U};
    if (pdo != nullptr)
    {
        const TpdoSettings& own = pdo->settings;
        value = FetchShared({own.cob_id, own.type, own.inhibit_100us, own.event_ms}, sub, kHighestSub);
        if (sub == kStartSub)
        {
            value = ObjectValue{SdoAbort::kNone, own.sync_start, 1U};
        }
    }
    return value;
}

ObjectValue Tpdos::FetchMapping(const std::uint16_t number, const std::uint8_t sub) const noexcept
{
    const Tpdo* const pdo = Find(number);
    return (pdo != nullptr) ? FetchField(pdo->map, sub) : ObjectValue{SdoAbort::kObjectUnknown, 0U, 1U};
}

SdoAbort Tpdos::StoreSetting(const std::uint16_t number, const std::uint8_t sub, const std::uint32_t value) noexcept
{
    Tpdo* const pdo = Find(number);
    const ObjectValue old = FetchSetting(number, sub);
    SdoAbort abort = old.abort;
    if ((abort == SdoAbort::kNone) && (sub == 0U))
    {
        abort = SdoAbort::kReadOnly;
    }
    else if ((abort == SdoAbort::kNone) && (old.value != value))
    {
        abort = Change(*pdo, sub, value);
    }
    return abort;
}

/// A value that differs from what is there.
SdoAbort Tpdos::Change(Tpdo& pdo, const std::uint8_t sub, const std::uint32_t value) noexcept
{
    const bool is_fixed = IsValid(pdo) && !is_configuring_;
    bool is_taken = true;
    switch (sub)
    {
    case kCobIdSub:
        is_taken = WriteCobId(pdo, value);
        break;
    case kTypeSub:
        is_taken = IsType(value);
        pdo.settings.type = is_taken ? static_cast<std::uint8_t>(value) : pdo.settings.type;
        break;
    case kInhibitSub:
        is_taken = !is_fixed;
        pdo.settings.inhibit_100us = is_taken ? static_cast<std::uint16_t>(value) : pdo.settings.inhibit_100us;
        break;
    case kEventSub:
        pdo.settings.event_ms = static_cast<std::uint16_t>(value);
        break;
    default:
        is_taken = !is_fixed && (value <= kLastSynchronous);
        pdo.settings.sync_start = is_taken ? static_cast<std::uint8_t>(value) : pdo.settings.sync_start;
        break;
    }
    return is_taken ? SdoAbort::kNone : SdoAbort::kValueRange;
}

bool Tpdos::WriteCobId(Tpdo& pdo, const std::uint32_t value) noexcept
{
    const bool is_taken = is_configuring_ || IsAdmitted(pdo.settings.cob_id, value);
    if (is_taken)
    {
        pdo.settings.cob_id = value;
        Start(pdo);
    }
    return is_taken;
}

SdoAbort Tpdos::StoreMapping(const std::uint16_t number, const std::uint8_t sub, const std::uint32_t value) noexcept
{
    Tpdo* const pdo = Find(number);
    const ObjectValue old = FetchMapping(number, sub);
    SdoAbort abort = old.abort;
    if ((abort == SdoAbort::kNone) && is_configuring_)
    {
        PrepareMap(pdo->map, sub, value);
    }
    else if ((abort == SdoAbort::kNone) && (old.value != value))
    {
        abort = ChangeMap(pdo->map, IsValid(*pdo), FieldChange{sub, value, kInTpdo}, parts_.dictionary);
    }
    return abort;
}

Tpdo* Tpdos::Find(const std::uint16_t number) const noexcept
{
    return FindPdo(parts_.table.pdos, parts_.table.count, number);
}

} // namespace counterpoint::cia301
