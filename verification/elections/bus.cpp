// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/elections/bus.hpp"

#include "hal/host/virtual/frame_bits.hpp"

#include <algorithm>

namespace counterpoint::elections
{
namespace
{

constexpr Time kIntermission = host::kIntermissionBits;
constexpr Time kErrorFrame = 12 + 8; // Superposed flags and delimiter.
constexpr std::uint16_t kBusOff = 256U;
constexpr std::uint16_t kTransmitError = 8U;

bool IsSame(const CanFrame& left, const CanFrame& right)
{
    return (left.identifier == right.identifier) && (left.length_bytes == right.length_bytes) &&
           std::equal(left.data, left.data + left.length_bytes, right.data);
}

} // namespace

Bus::Bus(BusUser& user, const Time bit_us) : user_(user), bit_us_(bit_us)
{
}

void Bus::Clear(const std::size_t nodes)
{
    waiting_.clear();
    senders_.clear();
    attached_.assign(nodes, 0U);
    errors_.assign(nodes, 0U);
    free_at_ = 0;
    frame_end_ = kNever;
    attached_count_ = 0U;
    ready_ = 0U;
    frames_ = 0U;
    collisions_ = 0U;
    is_collision_ = false;
}

bool Bus::Submit(const std::size_t node, const CanFrame& frame)
{
    const auto is_of_node = [node](const Waiting& waiting) { return waiting.node == node; };
    const bool has_room =
        static_cast<std::size_t>(std::count_if(waiting_.begin(), waiting_.end(), is_of_node)) < kQueue;
    if (has_room)
    {
        waiting_.push_back(Waiting{frame, node});
        ready_ += attached_[node];
    }
    return has_room;
}

void Bus::Drop(const std::size_t node)
{
    const auto is_of_node = [node](const Waiting& waiting) { return waiting.node == node; };
    const auto gone = std::remove_if(waiting_.begin(), waiting_.end(), is_of_node);
    const std::size_t count = static_cast<std::size_t>(waiting_.end() - gone);
    ready_ -= (attached_[node] != 0U) ? count : 0U;
    waiting_.erase(gone, waiting_.end());
}

void Bus::Attach(const std::size_t node, const bool is_attached, const Time now)
{
    if (IsAttached(node) == is_attached)
    {
        return;
    }
    const auto is_of_node = [node](const Waiting& waiting) { return waiting.node == node; };
    const std::size_t count = static_cast<std::size_t>(std::count_if(waiting_.begin(), waiting_.end(), is_of_node));
    attached_[node] = is_attached ? 1U : 0U;
    attached_count_ = is_attached ? (attached_count_ + 1U) : (attached_count_ - 1U);
    ready_ = is_attached ? (ready_ + count) : (ready_ - count);
    if (frame_end_ != kNever)
    {
        frame_end_ = kNever;
        senders_.clear();
        free_at_ = now + ((kErrorFrame + kIntermission) * bit_us_);
    }
}

void Bus::Move(const std::size_t node, Bus& to, const Time now)
{
    const bool is_attached = IsAttached(node);
    const auto stays = [node](const Waiting& waiting) { return waiting.node != node; };
    Attach(node, false, now);
    const auto gone = std::stable_partition(waiting_.begin(), waiting_.end(), stays);
    to.waiting_.insert(to.waiting_.end(), gone, waiting_.end());
    waiting_.erase(gone, waiting_.end());
    to.errors_[node] = errors_[node];
    to.Attach(node, is_attached, now);
}

Time Bus::Next() const
{
    const bool may_start = (ready_ > 0U) && (attached_count_ > 1U);
    return (frame_end_ != kNever) ? frame_end_ : (may_start ? free_at_ : kNever);
}

void Bus::Arbitrate(const Time now)
{
    if ((frame_end_ != kNever) || (ready_ == 0U) || (attached_count_ < 2U) || (now < free_at_))
    {
        return;
    }
    Choose();
    Time bits = host::MeasureFrame(frame_).OnWire();
    if (is_collision_)
    {
        bits = FirstDifference() + 1 + kErrorFrame;
    }
    frame_end_ = now + (bits * bit_us_);
}

/// The lowest identifier wins; whoever sends it at the same time sends too.
void Bus::Choose()
{
    std::uint32_t lowest = UINT32_MAX;
    for (const Waiting& waiting : waiting_)
    {
        if (IsAttached(waiting.node) && (waiting.frame.identifier < lowest))
        {
            lowest = waiting.frame.identifier;
            frame_ = waiting.frame;
        }
    }
    is_collision_ = false;
    senders_.clear();
    for (const Waiting& waiting : waiting_)
    {
        const bool is_known = std::find(senders_.begin(), senders_.end(), waiting.node) != senders_.end();
        if (IsAttached(waiting.node) && (waiting.frame.identifier == frame_.identifier) && !is_known)
        {
            senders_.push_back(waiting.node);
            is_collision_ = is_collision_ || !IsSame(waiting.frame, frame_);
        }
    }
}

std::uint16_t Bus::FirstDifference() const
{
    std::uint16_t first = UINT16_MAX;
    const host::WireImage image = host::DrawFrame(frame_);
    for (const Waiting& waiting : waiting_)
    {
        if (IsAttached(waiting.node) && (waiting.frame.identifier == frame_.identifier))
        {
            const host::WireImage other = host::DrawFrame(waiting.frame);
            const auto found = std::mismatch(image.level.begin(), image.level.begin() + image.count,
                                             other.level.begin(), other.level.begin() + other.count);
            const auto place = static_cast<std::uint16_t>(found.first - image.level.begin());
            first = (place < image.count) ? std::min(first, place) : first;
        }
    }
    return first;
}

void Bus::Finish(const Time now)
{
    if (frame_end_ != now)
    {
        return;
    }
    frame_end_ = kNever;
    free_at_ = now + (kIntermission * bit_us_);
    if (is_collision_)
    {
        Destroy();
        return;
    }
    for (const std::size_t sender : senders_)
    {
        const auto is_this = [this, sender](const Waiting& waiting)
        { return (waiting.node == sender) && IsSame(waiting.frame, frame_); };
        waiting_.erase(std::find_if(waiting_.begin(), waiting_.end(), is_this));
        --ready_;
        errors_[sender] = static_cast<std::uint16_t>((errors_[sender] > 0U) ? (errors_[sender] - 1U) : 0U);
    }
    ++frames_;
    // A copy: whoever hears may send.
    const CanFrame frame = frame_;
    const std::vector<std::size_t> senders = senders_;
    user_.OnComplete(frame, senders);
}

void Bus::Destroy()
{
    ++collisions_;
    const std::vector<std::size_t> senders = senders_;
    for (const std::size_t sender : senders)
    {
        errors_[sender] = static_cast<std::uint16_t>(errors_[sender] + kTransmitError);
        if (errors_[sender] >= kBusOff)
        {
            errors_[sender] = 0U;
            Drop(sender);
            user_.OnBusOff(sender);
        }
    }
}

} // namespace counterpoint::elections
