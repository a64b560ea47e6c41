// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/start_up/bus_slave.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint8_t kInitialising = 0U;
constexpr std::uint8_t kStopped = 4U;
constexpr std::uint8_t kOperational = 5U;
constexpr std::uint8_t kPreOperational = 127U;

std::uint32_t KeyOfRequest(const CanFrame& frame)
{
    return (static_cast<std::uint32_t>(frame.data[2]) << 16U) | (static_cast<std::uint32_t>(frame.data[1]) << 8U) |
           frame.data[3];
}

std::string Text(const char kind, const CanFrame& frame, const std::uint8_t size)
{
    char text[40];
    int length = std::snprintf(text, sizeof(text), "%c %02X%02X:%02X", kind, static_cast<unsigned>(frame.data[2]),
                               static_cast<unsigned>(frame.data[1]), static_cast<unsigned>(frame.data[3]));
    for (std::uint8_t i = 0U; i < size; ++i)
    {
        length += std::snprintf(text + length, sizeof(text) - static_cast<std::size_t>(length), " %02X",
                                static_cast<unsigned>(frame.data[4U + i]));
    }
    return std::string{text};
}

} // namespace

BusSlave::BusSlave(const std::uint8_t id, cia301::FrameSink& bus) : node(id), bus_(bus)
{
}

void BusSlave::Set(const std::uint16_t index, const std::uint8_t sub, const std::uint32_t value,
                   const std::uint8_t size)
{
    values_[(static_cast<std::uint32_t>(index) << 8U) | sub] = Value{value, size};
}

void BusSlave::Behave(const std::uint16_t index, const std::uint8_t sub, const Manner manner)
{
    manners_[(static_cast<std::uint32_t>(index) << 8U) | sub] = manner;
}

void BusSlave::Turn(const std::uint8_t to)
{
    state = to;
}

void BusSlave::Power(const std::uint32_t now_us)
{
    is_on = true;
    Restart(now_us);
}

void BusSlave::Restart(const std::uint32_t now_us)
{
    ++resets;
    state = kInitialising;
    toggle_ = 0U;
    heartbeat_us = 0U;
    boots_at_us_ = now_us + boot_us;
    pending_.clear();
    segment_ = 0U;
}

void BusSlave::Put(const std::uint32_t identifier, const std::uint8_t length)
{
    CanFrame frame{identifier, FrameKind::kData, CanPortId::kFirst, length, {}};
    frame.data[0] = (identifier >= 0x700U) ? state : std::uint8_t{0x11U};
    static_cast<void>(bus_.Send(frame));
}

void BusSlave::Beat()
{
    Put(0x700U + node, 1U);
}

void BusSlave::OnCycle(const std::uint32_t now_us)
{
    if (is_on && (state == kInitialising) && ((now_us - boots_at_us_) < 0x80000000U))
    {
        if (has_boot_up)
        {
            Beat();
        }
        state = kPreOperational;
        beats_at_us_ = now_us;
    }
    if (is_on && (state != kInitialising) && ((now_us - boots_at_us_ - kept_us) < 0x80000000U))
    {
        const std::vector<CanFrame> kept = std::move(kept_);
        kept_.clear();
        for (const CanFrame& frame : kept)
        {
            OnSdo(frame);
        }
    }
    if (is_on && (state != kInitialising) && (heartbeat_us != 0U) && ((now_us - beats_at_us_) >= heartbeat_us))
    {
        beats_at_us_ += heartbeat_us;
        Beat();
    }
    for (SentPdo& pdo : pdos)
    {
        if (is_on && (state == kOperational) && (pdo.syncs == 0U) && ((now_us - pdo.next_us) < 0x80000000U))
        {
            pdo.next_us += pdo.period_us;
            const bool is_left_out = (pdo.skip > 0);
            pdo.skip -= is_left_out ? 1 : 0;
            if (!is_left_out)
            {
                Put(pdo.identifier, pdo.length_bytes);
            }
        }
    }
    for (std::size_t i = 0U; i < pending_.size();)
    {
        const bool is_due = (now_us - pending_[i].due_us) < 0x80000000U;
        if (is_due)
        {
            if (is_on && (state == kOperational))
            {
                static_cast<void>(bus_.Send(pending_[i].frame));
            }
            pending_.erase(pending_.begin() + static_cast<std::ptrdiff_t>(i));
        }
        else
        {
            ++i;
        }
    }
}

void BusSlave::OnFrame(const CanFrame& frame, const std::uint32_t now_us)
{
    const bool is_data = (frame.kind == FrameKind::kData);
    if (!is_on)
    {
        return;
    }
    if (is_data && (frame.identifier == 0U))
    {
        Obey(frame, now_us);
    }
    else if (is_data && (frame.identifier == 0x80U) && (state == kOperational))
    {
        OnSync(now_us);
    }
    else if (!is_data && (frame.identifier == (0x700U + node)) && answers_guard && (state != kInitialising))
    {
        CanFrame reply{0x700U + node, FrameKind::kData, CanPortId::kFirst, 1U, {}};
        reply.data[0] = static_cast<std::uint8_t>(state | toggle_);
        toggle_ = is_toggle_stuck ? toggle_ : static_cast<std::uint8_t>(toggle_ ^ 0x80U);
        static_cast<void>(bus_.Send(reply));
    }
    else if (is_data && (frame.identifier == (0x600U + node)) && keeps_requests &&
             ((state == kInitialising) || !kept_.empty()))
    {
        kept_.push_back(frame);
    }
    else if (is_data && (frame.identifier == (0x600U + node)) && (state != kInitialising) && (state != kStopped))
    {
        OnSdo(frame);
    }
    else
    {
        // Not for this slave.
    }
}

void BusSlave::Obey(const CanFrame& frame, const std::uint32_t now_us)
{
    if ((frame.data[1] == 0U) || (frame.data[1] == node))
    {
        char text[16];
        std::snprintf(text, sizeof(text), "nmt %02X", static_cast<unsigned>(frame.data[0]));
        log.emplace_back(text);
        const bool is_running = (state != kInitialising);
        if (frame.data[0] >= 129U)
        {
            Restart(now_us);
        }
        else if (is_running && (frame.data[0] == 1U) && !is_deaf_to_start)
        {
            state = kOperational;
            for (SentPdo& pdo : pdos)
            {
                pdo.next_us = now_us + pdo.delay_us;
                pdo.count = 0U;
            }
        }
        else if (is_running && (frame.data[0] != 1U))
        {
            state = (frame.data[0] == 2U) ? kStopped : kPreOperational;
        }
        else
        {
            // Booting, or deaf.
        }
    }
}

void BusSlave::OnSync(const std::uint32_t now_us)
{
    for (SentPdo& pdo : pdos)
    {
        pdo.count = static_cast<std::uint8_t>(pdo.count + 1U);
        if ((pdo.syncs != 0U) && (pdo.count >= pdo.syncs))
        {
            pdo.count = 0U;
            const bool is_left_out = (pdo.skip > 0);
            pdo.skip -= is_left_out ? 1 : 0;
            const CanFrame frame{pdo.identifier, FrameKind::kData, CanPortId::kFirst, pdo.length_bytes, {}};
            if (!is_left_out)
            {
                pending_.push_back(Pending{now_us + pdo.delay_us, frame});
            }
        }
    }
}

void BusSlave::Answer(const std::uint8_t command, const CanFrame& frame, const std::uint32_t value)
{
    CanFrame answer{0x580U + node, FrameKind::kData, CanPortId::kFirst, 8U, {}};
    answer.data[0] = command;
    answer.data[1] = frame.data[1];
    answer.data[2] = frame.data[2];
    answer.data[3] = frame.data[3];
    for (std::uint32_t i = 0U; i < 4U; ++i)
    {
        answer.data[4U + i] = static_cast<std::uint8_t>((value >> (8U * i)) & 0xFFU);
    }
    static_cast<void>(bus_.Send(answer));
}

void BusSlave::OnSdo(const CanFrame& frame)
{
    constexpr std::uint32_t kUnknown = 0x06020000U;
    const std::uint32_t key = KeyOfRequest(frame);
    const Manner manner = (manners_.count(key) != 0U) ? manners_[key] : Manner::kGood;
    const std::uint8_t kind = frame.data[0] & 0xE0U;
    const bool is_mark = (key > 0x100000U) && (key < 0x1000FFU);
    const bool is_read = (kind == 0x40U) && !is_mark;
    const bool is_write = (kind == 0x20U);
    if (is_read || is_write)
    {
        const auto size = is_read ? std::uint8_t{0U} : static_cast<std::uint8_t>(4U - ((frame.data[0] >> 2U) & 3U));
        log.push_back(Text(is_read ? 'r' : 'w', frame, size));
    }
    if ((kind == 0x60U) && has_no_segment_)
    {
        Answer(0xE0U, CanFrame{}, 0U);
    }
    else if ((kind == 0x60U) && answers_segments)
    {
        OnSegment();
    }
    if ((manner == Manner::kSilent) || ((kind != 0x40U) && !is_write && (kind != 0U)))
    {
        return; // Also aborts of the client.
    }
    if (is_mark || (manner == Manner::kAbort) || ((manner == Manner::kAbortWrite) && is_write))
    {
        Answer(0x80U, frame, kUnknown);
    }
    else if (is_read)
    {
        const auto found = values_.find(key);
        const auto size = static_cast<std::uint8_t>((found == values_.end()) ? 0U : found->second.size);
        const auto told = static_cast<std::uint8_t>((manner == Manner::kShort) ? (size - 1U) : size);
        const auto command = static_cast<std::uint8_t>(0x43U | ((4U - told) << 2U));
        has_no_segment_ = (manner == Manner::kNoSegment);
        const bool is_long = (manner == Manner::kLong);
        const bool is_segmented = is_long || has_no_segment_ || (manner == Manner::kSegments);
        const std::uint32_t length = is_long ? 100U : (has_no_segment_ ? 4U : told);
        segment_ = (manner == Manner::kSegments) ? key : segment_;
        Answer((size == 0U) ? 0x80U : (is_segmented ? 0x41U : command), frame,
               (size == 0U) ? kUnknown : (is_segmented ? length : found->second.value));
    }
    else if (is_write)
    {
        Answer(0x60U, frame, 0U);
        if (key == 0x101700U)
        {
            heartbeat_us = 1000U * (frame.data[4] | (static_cast<std::uint32_t>(frame.data[5]) << 8U));
        }
    }
    else
    {
        Answer(static_cast<std::uint8_t>(0x20U | (frame.data[0] & 0x10U)), CanFrame{}, 0U); // A segment.
    }
}

/// The one segment of a value that is read so; who knows of no transfer says so, and names no object.
void BusSlave::OnSegment()
{
    const auto found = values_.find(segment_);
    CanFrame answer{0x580U + node, FrameKind::kData, CanPortId::kFirst, 8U, {0x80U, 0U, 0U, 0U, 1U, 0U, 4U, 5U}};
    if (found != values_.end())
    {
        answer.data[0] = static_cast<std::uint8_t>(((7U - found->second.size) << 1U) | 1U);
        for (std::uint32_t i = 0U; i < 4U; ++i)
        {
            answer.data[1U + i] = static_cast<std::uint8_t>((found->second.value >> (8U * i)) & 0xFFU);
        }
        std::fill(answer.data + 5U, answer.data + 8U, std::uint8_t{0U});
    }
    segment_ = 0U;
    static_cast<void>(bus_.Send(answer));
}

} // namespace counterpoint::cia302
