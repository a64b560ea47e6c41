// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/start_up/el6751/pdos.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint32_t kSyncIdentifier = 0x80U;
constexpr std::uint32_t kIdentifierMask = 0x7FFU;
constexpr std::uint32_t kOffBit = 0x80000000U;
constexpr std::uint8_t kLastCyclicType = 240U;
constexpr std::uint8_t kFirstEventType = 254U;
constexpr std::uint32_t kUsPerMs = 1000U;
constexpr std::uint32_t kUsPerInhibitUnit = 100U;

constexpr std::int16_t kTooShort = 20;
constexpr std::int16_t kMissing = 22;
constexpr std::int16_t kMissingInCycle = 40;

bool IsUsed(const El6751Pdo& pdo) noexcept
{
    return (pdo.cob_id & kOffBit) == 0U;
}

bool IsCyclic(const El6751Pdo& pdo) noexcept
{
    return (pdo.type >= 1U) && (pdo.type <= kLastCyclicType);
}

bool IsItsFrame(const El6751Pdo& pdo, const CanFrame& frame) noexcept
{
    return IsUsed(pdo) && (frame.kind == FrameKind::kData) && ((pdo.cob_id & kIdentifierMask) == frame.identifier);
}

std::uint8_t ByteOf(const El6751Pdo& pdo, const std::uint32_t i) noexcept
{
    return (pdo.data_bytes != nullptr) ? pdo.data_bytes[i] : std::uint8_t{0U};
}

bool HasChanged(const El6751Pdo& pdo, const El6751PdoRecord& record) noexcept
{
    bool has_changed = false;
    for (std::uint32_t i = 0U; (i < pdo.length_bytes) && (i < kMaxPayloadBytes); ++i)
    {
        has_changed = has_changed || (ByteOf(pdo, i) != record.sent[i]);
    }
    return has_changed;
}

/// One SYNC cycle is over for a TxPDO of types 1 to 240 that was received before. [SRS_ELM_034, SRS_ELM_035,
/// SRS_ELM_036]
void JudgeCycle(const El6751Pdo& pdo, const std::uint16_t event_ms, El6751PdoRecord& record) noexcept
{
    const bool is_strict = (pdo.type == 1U) && (event_ms == 0U);
    const std::uint8_t tolerated = is_strict ? std::uint8_t{0U} : std::uint8_t{1U};
    if (record.is_in_cycle)
    {
        record.missed = 0U;
        record.age = 0U;
    }
    else
    {
        ++record.age;
        if (record.age >= pdo.type)
        {
            record.age = 0U;
            const bool is_over = (record.missed >= tolerated);
            record.missed = is_over ? record.missed : static_cast<std::uint8_t>(record.missed + 1U);
            const std::int16_t fault = is_strict ? kMissingInCycle : kMissing;
            record.fault = is_over ? fault : record.fault;
        }
    }
}

} // namespace

El6751Pdos::El6751Pdos(const El6751PdoParts& parts) noexcept
    : parts_(parts), first_{}, duty_{}, window_us_(0U), awaited_(0U), is_sync_sent_(false), is_running_(false),
      is_window_open_(false), is_waiting_(false), sync_due_{0U}, sync_at_{0U}
{
}

bool El6751Pdos::Begin() noexcept
{
    End();
    const bool is_room = El6751PdoCount(parts_.setup) <= parts_.room.count;
    std::uint16_t next = 0U;
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const NodeId node{id};
        const std::uint8_t pdos =
            parts_.setup.IsListed(node) ? El6751SlaveOf(parts_.setup, node).PdoCount() : std::uint8_t{0U};
        first_[id] = next;
        next = static_cast<std::uint16_t>(next + pdos);
    }
    const std::uint32_t period_us = parts_.setup.sync_period_us;
    const std::uint32_t parts = (parts_.times.sync_multiplier == 0U) ? 1U : parts_.times.sync_multiplier;
    window_us_ = (period_us - (period_us / parts)) + parts_.times.input_shift_us;
    is_sync_sent_ = is_room && NeedsSync(parts_.setup);
    return is_room;
}

void El6751Pdos::End() noexcept
{
    is_sync_sent_ = false;
    is_running_ = false;
    is_window_open_ = false;
    is_waiting_ = false;
    awaited_ = 0U;
    for (Duty& duty : duty_)
    {
        duty = Duty::kRest;
    }
}

bool El6751Pdos::IsSyncSent() const noexcept
{
    return is_sync_sent_;
}

void El6751Pdos::Await(const NodeId node) noexcept
{
    duty_[node.value] = Duty::kAwait;
    for (std::uint8_t i = 0U; i < El6751SlaveOf(parts_.setup, node).PdoCount(); ++i)
    {
        Record(node, i) = El6751PdoRecord{};
    }
}

void El6751Pdos::Feed(const NodeId node) noexcept
{
    const El6751Slave& slave = El6751SlaveOf(parts_.setup, node);
    duty_[node.value] = Duty::kFeed;
    for (std::uint8_t i = 0U; i < slave.rx_count; ++i)
    {
        Record(node, i).is_due = IsUsed(El6751PdoOf(slave, i));
    }
}

void El6751Pdos::Rest(const NodeId node) noexcept
{
    duty_[node.value] = Duty::kRest;
}

El6751PdoRecord& El6751Pdos::Record(const NodeId node, const std::uint8_t position) const noexcept
{
    return parts_.room.records[first_[node.value] + position];
}

void El6751Pdos::OnFrame(const CanFrame& frame, const Instant now) noexcept
{
    EndWindowIfOver(now);
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const NodeId node{id};
        const El6751Slave& slave = El6751SlaveOf(parts_.setup, node);
        const std::uint8_t pdos = (duty_[id] == Duty::kRest) ? std::uint8_t{0U} : slave.PdoCount();
        for (std::uint8_t i = slave.rx_count; i < pdos; ++i)
        {
            if (IsItsFrame(El6751PdoOf(slave, i), frame))
            {
                Take(node, i, frame, now);
            }
        }
    }
}

void El6751Pdos::Take(const NodeId node, const std::uint8_t position, const CanFrame& frame, const Instant now) noexcept
{
    const El6751Pdo& pdo = El6751PdoOf(El6751SlaveOf(parts_.setup, node), position);
    El6751PdoRecord& record = Record(node, position);
    // One that always comes too late is always missing in its cycle; one that is too short is there. [SRS_ELM_480]
    const bool is_late = IsCyclic(pdo) && !is_window_open_;
    const bool is_missing = (record.fault != 0) && (record.fault != kTooShort);
    const bool is_short = (frame.length_bytes < pdo.length_bytes);
    const std::int16_t fault = is_short ? kTooShort : std::int16_t{0};
    record.has_come = true;
    record.has_passed = record.has_passed || !is_short;
    record.is_in_cycle = is_window_open_;
    record.age = 0U;
    record.last = now;
    record.fault = (is_late && is_missing) ? record.fault : fault;
}

void El6751Pdos::OnSent(const CanFrame& frame) noexcept
{
    for (std::uint8_t id = 1U; (id <= kLastNode) && (awaited_ > 0U); ++id)
    {
        const El6751Slave& slave = El6751SlaveOf(parts_.setup, NodeId{id});
        const std::uint8_t pdos = (duty_[id] == Duty::kFeed) ? slave.rx_count : std::uint8_t{0U};
        for (std::uint8_t i = 0U; i < pdos; ++i)
        {
            El6751PdoRecord& record = Record(NodeId{id}, i);
            if (record.is_awaited && IsItsFrame(El6751PdoOf(slave, i), frame))
            {
                record.is_awaited = false;
                --awaited_;
            }
        }
        if ((awaited_ == 0U) && (parts_.times.window == El6751Window::kLastRxPdo))
        {
            EndWindow();
        }
    }
}

void El6751Pdos::OnCycle(const Instant now) noexcept
{
    EndWindowIfOver(now);
    is_waiting_ = false;
    SendSync(now);
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        if (duty_[id] != Duty::kRest)
        {
            CheckTimes(NodeId{id}, now);
        }
        if (duty_[id] == Duty::kFeed)
        {
            SendTo(NodeId{id}, now);
        }
    }
}

void El6751Pdos::SendAgain(const Instant now) noexcept
{
    if (is_waiting_)
    {
        is_waiting_ = false;
        SendSync(now);
        for (std::uint8_t id = 1U; id <= kLastNode; ++id)
        {
            if (duty_[id] == Duty::kFeed)
            {
                SendTo(NodeId{id}, now);
            }
        }
    }
}

void El6751Pdos::SendSync(const Instant now) noexcept
{
    const std::uint32_t elapsed_us = now.us - sync_due_.us;
    if (is_sync_sent_ && (!is_running_ || (elapsed_us >= parts_.setup.sync_period_us)))
    {
        const CanFrame sync{kSyncIdentifier, FrameKind::kData, CanPortId::kFirst, 0U, {}};
        if (parts_.sink.Send(sync))
        {
            // What was too late for one SYNC or more does not shift the next one.
            sync_due_.us = is_running_ ? (now.us - (elapsed_us % parts_.setup.sync_period_us)) : now.us;
            is_running_ = true;
            OnSync(now);
        }
        else
        {
            is_waiting_ = true;
        }
    }
}

void El6751Pdos::OnSync(const Instant now) noexcept
{
    EndWindow();
    sync_at_ = now;
    is_window_open_ = true;
    awaited_ = 0U;
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        if (duty_[id] != Duty::kRest)
        {
            OpenFor(NodeId{id});
        }
    }
}

/// A new SYNC cycle for the PDOs of one slave. [SRS_ELM_031, SRS_ELM_033]
void El6751Pdos::OpenFor(const NodeId node) noexcept
{
    const El6751Slave& slave = El6751SlaveOf(parts_.setup, node);
    const bool is_fed = (duty_[node.value] == Duty::kFeed);
    for (std::uint8_t i = 0U; i < slave.PdoCount(); ++i)
    {
        const El6751Pdo& pdo = El6751PdoOf(slave, i);
        El6751PdoRecord& record = Record(node, i);
        record.is_in_cycle = false;
        record.is_awaited = false;
        if ((i < slave.rx_count) && is_fed && IsUsed(pdo) && (pdo.type <= kLastCyclicType))
        {
            ++record.age;
            const bool is_turn = (record.age >= pdo.type);
            const bool is_wanted = (pdo.type != 0U) || HasChanged(pdo, record);
            record.age = is_turn ? std::uint8_t{0U} : record.age;
            record.is_due = record.is_due || (is_turn && is_wanted);
            record.is_awaited = record.is_due;
            awaited_ = static_cast<std::uint16_t>(awaited_ + (record.is_due ? 1U : 0U));
        }
    }
}

void El6751Pdos::EndWindowIfOver(const Instant now) noexcept
{
    const bool is_shift = (parts_.times.window == El6751Window::kInputShift);
    if (is_window_open_ && is_shift && ((now.us - sync_at_.us) > window_us_))
    {
        EndWindow();
    }
}

void El6751Pdos::EndWindow() noexcept
{
    for (std::uint8_t id = 1U; (id <= kLastNode) && is_window_open_; ++id)
    {
        const El6751Slave& slave = El6751SlaveOf(parts_.setup, NodeId{id});
        const std::uint8_t pdos = (duty_[id] == Duty::kRest) ? std::uint8_t{0U} : slave.PdoCount();
        for (std::uint8_t i = slave.rx_count; i < pdos; ++i)
        {
            const El6751Pdo& pdo = El6751PdoOf(slave, i);
            El6751PdoRecord& record = Record(NodeId{id}, i);
            if (record.has_come && IsCyclic(pdo))
            {
                JudgeCycle(pdo, El6751EventOf(slave, pdo), record);
            }
        }
    }
    is_window_open_ = false;
}

/// Event times of TxPDOs; event, inhibit time and changes of RxPDOs that do not follow SYNC. [SRS_ELM_031,
/// SRS_ELM_037]
void El6751Pdos::CheckTimes(const NodeId node, const Instant now) noexcept
{
    const El6751Slave& slave = El6751SlaveOf(parts_.setup, node);
    for (std::uint8_t i = 0U; i < slave.PdoCount(); ++i)
    {
        const El6751Pdo& pdo = El6751PdoOf(slave, i);
        El6751PdoRecord& record = Record(node, i);
        const std::uint32_t silence_us = now.us - record.last.us;
        const std::uint32_t event_us = kUsPerMs * El6751EventOf(slave, pdo);
        const bool is_timed = (record.has_come || record.has_passed) && (event_us != 0U);
        if ((i >= slave.rx_count) && is_timed && (pdo.type >= kFirstEventType) && (silence_us > (2U * event_us)))
        {
            record.fault = kMissing;
        }
        else if ((i < slave.rx_count) && IsUsed(pdo) && (pdo.type > kLastCyclicType) && record.has_passed)
        {
            record.is_inhibited =
                record.is_inhibited && (silence_us < (kUsPerInhibitUnit * El6751InhibitOf(slave, pdo)));
            const bool is_late = is_timed && (silence_us >= event_us);
            record.is_due = record.is_due || (!record.is_inhibited && (is_late || HasChanged(pdo, record)));
        }
        else
        {
            // SYNC times it.
        }
    }
}

void El6751Pdos::SendTo(const NodeId node, const Instant now) noexcept
{
    const El6751Slave& slave = El6751SlaveOf(parts_.setup, node);
    for (std::uint8_t i = 0U; i < slave.rx_count; ++i)
    {
        const El6751Pdo& pdo = El6751PdoOf(slave, i);
        El6751PdoRecord& record = Record(node, i);
        if (record.is_due)
        {
            CanFrame frame{pdo.cob_id & kIdentifierMask, FrameKind::kData, CanPortId::kFirst, 0U, {}};
            for (; (frame.length_bytes < pdo.length_bytes) && (frame.length_bytes < kMaxPayloadBytes);
                 ++frame.length_bytes)
            {
                frame.data[frame.length_bytes] = ByteOf(pdo, frame.length_bytes);
            }
            record.is_due = !parts_.sink.Send(frame);
            is_waiting_ = is_waiting_ || record.is_due;
            for (std::uint32_t byte = 0U; (byte < frame.length_bytes) && !record.is_due; ++byte)
            {
                record.sent[byte] = frame.data[byte];
            }
            record.has_passed = record.has_passed || !record.is_due;
            record.is_inhibited = record.is_inhibited || !record.is_due;
            record.last = record.is_due ? record.last : now;
        }
    }
}

std::int16_t El6751Pdos::Fault(const NodeId node) const noexcept
{
    const El6751Slave& slave = El6751SlaveOf(parts_.setup, node);
    const std::uint8_t pdos = (duty_[node.value] == Duty::kRest) ? std::uint8_t{0U} : slave.PdoCount();
    std::int16_t fault = 0;
    for (std::uint8_t i = slave.rx_count; (i < pdos) && (fault == 0); ++i)
    {
        fault = Record(node, i).fault;
    }
    return fault;
}

/// TxPDOs in use, or those of them that were received.
std::uint8_t El6751Pdos::CountTx(const NodeId node, const bool has_passed) const noexcept
{
    const El6751Slave& slave = El6751SlaveOf(parts_.setup, node);
    std::uint8_t count = 0U;
    for (std::uint8_t i = slave.rx_count; i < slave.PdoCount(); ++i)
    {
        const bool is_counted = IsUsed(El6751PdoOf(slave, i)) && (!has_passed || Record(node, i).has_passed);
        count = static_cast<std::uint8_t>(count + (is_counted ? 1U : 0U));
    }
    return count;
}

bool El6751Pdos::HasAll(const NodeId node) const noexcept
{
    return CountTx(node, true) == CountTx(node, false);
}

bool El6751Pdos::HasAny(const NodeId node) const noexcept
{
    return (CountTx(node, true) > 0U) || (CountTx(node, false) == 0U);
}

} // namespace counterpoint::cia302
