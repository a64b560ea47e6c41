// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/device/outbox.hpp"

namespace counterpoint::device
{
namespace
{

constexpr std::uint32_t kLongestConfirmationUs = 100000U;

} // namespace

Outbox::Outbox(hal::CanPorts& can) noexcept
    : can_(can), frames_{}, owners_{}, counts_{}, first_(0U), count_(0U), unconfirmed_(0U), sent_{0U}, confirmed_(0U),
      confirmations_seen_(0U)
{
}

bool Outbox::Send(const CanFrame& frame) noexcept
{
    return Put(frame, Owner::kTransfer, (CountOf(Owner::kTransfer) + CountOf(Owner::kProcess)) < kRoom);
}

bool Outbox::SendProcessData(const CanFrame& frame) noexcept
{
    const std::uint32_t process = CountOf(Owner::kProcess);
    return Put(frame, Owner::kProcess, (process < kProcessRoom) && ((CountOf(Owner::kTransfer) + process) < kRoom));
}

bool Outbox::SendOwn(const CanFrame& frame) noexcept
{
    return Put(frame, Owner::kDevice, CountOf(Owner::kDevice) < kOwnRoom);
}

bool Outbox::HasOwnRoom() const noexcept
{
    return CountOf(Owner::kDevice) < (kOwnRoom - 1U);
}

std::uint32_t Outbox::CountOf(const Owner owner) const noexcept
{
    return counts_[static_cast<std::uint32_t>(owner)];
}

bool Outbox::Put(const CanFrame& frame, const Owner owner, const bool has_room) noexcept
{
    if (has_room)
    {
        const std::uint32_t place = (first_ + count_) % kAllRoom;
        frames_[place] = frame;
        owners_[place] = owner;
        ++counts_[static_cast<std::uint32_t>(owner)];
        ++count_;
    }
    return has_room;
}

bool Outbox::Waits(const std::uint32_t identifier, const std::uint8_t first_byte) const noexcept
{
    bool is_waiting = false;
    for (std::uint32_t place = 0U; place < count_; ++place)
    {
        const CanFrame& frame = frames_[(first_ + place) % kAllRoom];
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
            --counts_[static_cast<std::uint32_t>(owners_[first_])];
            first_ = (first_ + 1U) % kAllRoom;
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

void Outbox::ForgetPdos(const cia301::Sync& sync) noexcept
{
    const std::uint32_t all = count_;
    count_ = 0U;
    for (std::uint32_t n = 0U; n < all; ++n)
    {
        const std::uint32_t from = (first_ + n) % kAllRoom;
        const std::uint32_t to = (first_ + count_) % kAllRoom; // Never behind `from`.
        const bool is_pdo = (owners_[from] == Owner::kProcess) && !sync.Uses(frames_[from].identifier);
        frames_[to] = frames_[from];
        owners_[to] = owners_[from];
        count_ += is_pdo ? 0U : 1U;
        counts_[static_cast<std::uint32_t>(Owner::kProcess)] -= is_pdo ? 1U : 0U;
    }
}

void Outbox::Clear() noexcept
{
    first_ = 0U;
    count_ = 0U;
    unconfirmed_ = 0U;
    for (std::uint32_t& count : counts_)
    {
        count = 0U;
    }
}

ProcessSink::ProcessSink(Outbox& outbox) noexcept : outbox_(outbox)
{
}

bool ProcessSink::Send(const CanFrame& frame) noexcept
{
    return outbox_.SendProcessData(frame);
}

} // namespace counterpoint::device
