// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What happens to a received PDO. Its objects are in rpdo_settings.cpp.
#include "canopen/cia301/pdo/rpdo.hpp"

#include "canopen/cia301/base/cob_id.hpp"
#include "canopen/cia301/objects/service_table.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint32_t kUsPerMs = 1000U;
constexpr std::uint32_t kStandard = 0x7FFU;
constexpr std::uint8_t kLastSynchronous = 240U;

bool IsSynchronous(const Rpdo& pdo) noexcept
{
    return pdo.settings.type <= kLastSynchronous;
}

} // namespace

void Rpdos::OnFrame(const CanFrame& frame, const Moment& moment) noexcept
{
    FollowState(moment);
    for (std::uint16_t i = 0U; is_operational_ && (frame.kind == FrameKind::kData) && (i < parts_.table.count); ++i)
    {
        Rpdo& pdo = parts_.table.pdos[i];
        const bool is_receiving = ((pdo.settings.cob_id & kCobOff) == 0U) && (pdo.map.count > 0U);
        if (is_receiving && (frame.identifier == (pdo.settings.cob_id & kStandard)))
        {
            Take(pdo, frame, moment.now);
        }
    }
}

void Rpdos::Take(Rpdo& pdo, const CanFrame& frame, const Instant now) noexcept
{
    const std::uint8_t length_bytes = LengthOf(pdo.map);
    if (frame.length_bytes < length_bytes)
    {
        parts_.errors.Raise(CommunicationError::kPdoShort, pdo.number);
    }
    else
    {
        parts_.errors.Clear(CommunicationError::kPdoShort, pdo.number);
        if (frame.length_bytes > length_bytes)
        {
            parts_.errors.Raise(CommunicationError::kPdoLong, pdo.number);
        }
        else
        {
            parts_.errors.Clear(CommunicationError::kPdoLong, pdo.number);
        }
    }
    const bool is_in_time = !IsSynchronous(pdo) || IsInWindow(now);
    if ((frame.length_bytes >= length_bytes) && is_in_time)
    {
        parts_.errors.Clear(CommunicationError::kRpdoTimeOut, pdo.number);
        for (std::uint32_t i = 0U; i < kPdoBytes; ++i)
        {
            pdo.run.data.bytes[i] = frame.data[i];
        }
        pdo.run.received_at = now;
        pdo.run.is_supervised = true;
        pdo.run.is_waiting = true;
        if (!IsSynchronous(pdo))
        {
            Apply(pdo, now);
        }
    }
}

void Rpdos::OnSync(const SyncEvent& event) noexcept
{
    FollowState(event.moment);
    sync_at_ = event.moment.now;
    window_us_ = event.window_us;
    has_sync_ = is_operational_;
    for (std::uint16_t i = 0U; is_operational_ && (i < parts_.table.count); ++i)
    {
        if (parts_.table.pdos[i].run.is_waiting)
        {
            Apply(parts_.table.pdos[i], event.moment.now);
        }
    }
}

void Rpdos::OnCycle(const Moment& moment) noexcept
{
    FollowState(moment);
    for (std::uint16_t i = 0U; is_operational_ && (i < parts_.table.count); ++i)
    {
        Rpdo& pdo = parts_.table.pdos[i];
        const std::uint32_t limit_us = pdo.settings.event_ms * kUsPerMs;
        const bool is_watched = (limit_us > 0U) && pdo.run.is_supervised;
        if (is_watched && ((moment.now.us - pdo.run.received_at.us) > limit_us))
        {
            pdo.run.is_supervised = false;
            parts_.errors.Raise(CommunicationError::kRpdoTimeOut, pdo.number);
        }
    }
}

void Rpdos::FollowState(const Moment& moment) noexcept
{
    const bool is_allowed = IsAllowed(Service::kPdo, moment.state);
    for (std::uint16_t i = 0U; is_allowed && !is_operational_ && (i < parts_.table.count); ++i)
    {
        parts_.table.pdos[i].run = RpdoRun{};
    }
    has_sync_ = has_sync_ && is_operational_;
    is_operational_ = is_allowed;
}

void Rpdos::Apply(Rpdo& pdo, const Instant now) noexcept
{
    pdo.run.is_waiting = false;
    Unpack(pdo.map, pdo.run.data);
    if (parts_.listener != nullptr)
    {
        parts_.listener->OnRpdo(pdo.number, now);
    }
}

bool Rpdos::IsInWindow(const Instant now) const noexcept
{
    return (window_us_ == 0U) || !has_sync_ || ((now.us - sync_at_.us) <= window_us_);
}

} // namespace counterpoint::cia301
