// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/octets.hpp"
#include "channel_a/seal.hpp"
#include "channel_a/slots.hpp"
#include "channel_a/voice.hpp"

#include <cstddef>
#include <cstdint>

// The state of a slot and the steps that change it. Frames of a pair that goes well change the mode by themselves:
// consumer.cpp, producer.cpp.
//
//            Enter                    release
//   Off ---------------> Waiting -------------------> Released
//    ^                      |                          |   ^
//    | Leave                +------> Faulted <---------+   |
//    +------ any               Fail     |     Fail         |
//                                       +------------------+
namespace counterpoint::channel_a
{
namespace
{

constexpr std::uint16_t kErrorCountMax = 0xFFFFU;
constexpr std::uint32_t kCauseBits = 0x1FU; // Causes are smaller, but for the one that is none.

// Only directions 1 and 2 come as far as a resolved mapping. `since` of a producer that is called is one refresh and a
// microsecond before the first possible transmission, so that the first refresh falls due there; it is the first
// possible transmission itself where the application sends.
void EnterSlot(Voice& voice, const std::size_t slot) noexcept
{
    Record& record = At(voice, slot);
    LookUp(voice, record.values[kCobIdPlace]) = static_cast<std::uint8_t>(slot);
    LookUp(voice, record.values[kCobIdPlace + 1U]) = static_cast<std::uint8_t>(slot);
    --voice.outcome.is_invalid;
    if (record.direction == kDirectionConsumer)
    {
        Turn(voice, slot, kWaiting);
        record.awaiting = kMarked;
        ++voice.outcome.sct_checked;
        return;
    }
    Turn(voice, slot, kProducer);
    ++voice.outcome.is_tx;
    record.since = voice.origin;
    if (record.form == ProducerForm::kProviderCalled)
    {
        record.since.us -= SctUs(record) + 1U;
    }
}

} // namespace

void Put(SrdoMask& mask, const std::size_t slot, const std::uint32_t is_in) noexcept
{
    const SrdoMask bit = BitOf(slot);
    mask &= ~bit;
    if (is_in != 0U)
    {
        mask |= bit;
    }
}

void Turn(Voice& voice, const std::size_t slot, const std::uint32_t mode) noexcept
{
    SetMode(At(voice, slot), mode);
    Put(voice.outcome.released, slot, mode & kReleased);
    Put(voice.outcome.faulted, slot, mode & kFaulted);
    Put(voice.outcome.waiting, slot, mode & kWaiting);
    Put(voice.producers, slot, mode & kProducer);
}

// With late detection the limit is always that of the held pair.
void Drop(Voice& voice, const std::size_t slot, const std::uint32_t kept) noexcept
{
    Record& record = At(voice, slot);
    const std::uint32_t pending = record.mode & kept;
    if ((pending == 0U) || (record.detection == SrvtDetection::kLate))
    {
        record.limit_us = kNoLimit;
    }
    voice.outcome.ordinal_sum -= record.ordinal;
    record.ordinal = 0U;
    record.edge = kUnmarked;
    record.awaiting = kUnmarked;
    Put(voice.outcome.fresh, slot, 0U);
    Turn(voice, slot, kFaulted | pending);
}

void Count(Record& record, const SrdoCause cause) noexcept
{
    if (record.first_cause == SrdoCause::kNone)
    {
        SetFirstCause(record, cause);
    }
    if (record.error_count != kErrorCountMax)
    {
        ++record.error_count;
    }
}

void Report(Record& record, const SrdoCause cause) noexcept
{
    Count(record, cause);
    record.unreported |= std::uint32_t{1U} << (static_cast<std::uint32_t>(cause) & kCauseBits);
    Demand(record, kLook);
}

void Fail(Voice& voice, const std::size_t slot, const SrdoCause cause) noexcept
{
    Drop(voice, slot, 0U);
    Report(At(voice, slot), cause);
}

void Abort(Record& record, const SrdoCause cause) noexcept
{
    if (Is(record, kFlying))
    {
        SetMode(record, kProducer);
        record.todo = 0U;
        Report(record, cause);
    }
}

SrdoCause ExpiredLimit(const Record& record, const Instant when, const std::size_t half) noexcept
{
    const bool is_late = record.detection == SrvtDetection::kLate;
    const bool is_expired = IsExpired(record, when);
    const bool has_pending = Is(record, kPending);
    bool is_srvt = is_expired && has_pending; // Early: SRVT follows SCT when a normal frame is there.
    if (is_late)
    {
        const std::uint32_t age_us = when.us - record.frame_since.us;
        const std::uint32_t srvt_us = SrvtUs(record);
        const std::uint32_t over_sct_us = (when.us - record.since.us) - record.limit_us;
        is_srvt =
            (half != 0U) && has_pending && (age_us > srvt_us) && (!is_expired || ((age_us - srvt_us) >= over_sct_us));
    }
    if (is_srvt)
    {
        return SrdoCause::kSrvt;
    }
    return is_expired ? SrdoCause::kSct : SrdoCause::kNone;
}

void Enter(Voice& voice) noexcept
{
    voice.entered = voice.now;
    voice.origin.us = voice.now.us + voice.first_delay_us;
    voice.may_send = false;
    voice.wanted = 0U;
    voice.outcome.ordinal_sum = 0U;
    voice.outcome.not_operational = 0U;
    voice.outcome.is_invalid = voice.count;
    for (std::size_t place = 0U; place < kLookUpSize; ++place)
    {
        voice.storage.look_up[place] = kNoSlot; // MISRA D-002
    }
    for (std::size_t slot = 0U; slot < voice.count; ++slot)
    {
        const Record& record = At(voice, slot);
        if ((record.mapping == kMarked) && (record.check == kMarked) && IsSealed(record))
        {
            EnterSlot(voice, slot);
        }
        Demand(At(voice, slot), kLook);
    }
}

// What an SRDO that is off has to leave is nothing; the next OnCycle, the one that goes on, looks at each.
void Leave(Voice& voice) noexcept
{
    for (std::size_t slot = 0U; slot < voice.count; ++slot)
    {
        Record& record = At(voice, slot);
        if (Is(record, kConsumer))
        {
            Fail(voice, slot, SrdoCause::kNotOperational);
            Put(voice.outcome.new_fault, slot, 1U);
        }
        Turn(voice, slot, kOff);
        record.limit_us = kNoLimit;
        record.ordinal = 0U;
        record.todo = kLook;
        record.refreshed = kUnmarked;
    }
    voice.outcome.sct_checked = 0U;
    voice.outcome.is_tx = 0U;
    voice.outcome.is_invalid = 0U;
    voice.outcome.not_operational = 1U;
}

} // namespace counterpoint::channel_a
