// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/device/outbox.hpp"

namespace counterpoint::device
{
namespace
{

constexpr std::uint32_t kLongestConfirmationUs = 100000U;

} // namespace

Outbox::Outbox(hal::CanPorts& can) noexcept
    : can_(can), frames_{}, first_(0U), count_(0U), unconfirmed_(0U), sent_{0U}, confirmed_(0U), confirmations_seen_(0U)
{
}

bool Outbox::Send(const CanFrame& frame) noexcept
{
    const bool has_room = HasRoom();
    if (has_room)
    {
        frames_[(first_ + count_) % kRoom] = frame;
        ++count_;
    }
    return has_room;
}

bool Outbox::HasRoom() const noexcept
{
    return count_ < kRoom;
}

bool Outbox::Waits(const std::uint32_t identifier, const std::uint8_t first_byte) const noexcept
{
    bool is_waiting = false;
    for (std::uint32_t place = 0U; place < count_; ++place)
    {
        const CanFrame& frame = frames_[(first_ + place) % kRoom];
        if (frame.identifier == identifier)
        {
            is_waiting = frame.data[0] == first_byte;
        }
    }
    return is_waiting;
}

void Outbox::OnConfirm() noexcept
{
    static_cast<void>(confirmed_.fetch_add(1U));
}

void Outbox::Poll(const Instant now) noexcept
{
    TakeConfirmations(now);
    bool is_taken = true;
    while (is_taken && (count_ > 0U) && (unconfirmed_ < kUnconfirmed))
    {
        const hal::TransmitStatus status = can_.Transmit(frames_[first_]);
        const bool is_refused = status == hal::TransmitStatus::kRefused; // It never will be taken.
        is_taken = is_refused || (status == hal::TransmitStatus::kAccepted);
        if (is_taken)
        {
            first_ = (first_ + 1U) % kRoom;
            --count_;
            unconfirmed_ += is_refused ? 0U : 1U;
            sent_ = now;
        }
    }
}

void Outbox::TakeConfirmations(const Instant now) noexcept
{
    const std::uint32_t confirmed = confirmed_.load();
    const std::uint32_t fresh = confirmed - confirmations_seen_;
    confirmations_seen_ = confirmed;
    unconfirmed_ = (fresh >= unconfirmed_) ? 0U : (unconfirmed_ - fresh);
    if ((now.us - sent_.us) >= kLongestConfirmationUs)
    {
        unconfirmed_ = 0U;
    }
}

void Outbox::Clear() noexcept
{
    first_ = 0U;
    count_ = 0U;
    unconfirmed_ = 0U;
}

} // namespace counterpoint::device
