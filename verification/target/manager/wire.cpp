// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/target/manager/wire.hpp"

namespace counterpoint::target
{
namespace
{

constexpr std::uint32_t kFramesPerMs = 4U;
constexpr std::uint32_t kMillisecondUs = 1000U;

} // namespace

void Wire::Plug(const std::uint32_t place, WireNode* const node) noexcept
{
    nodes_[place % kPlaces] = node;
}

WireNode* Wire::Next() const noexcept
{
    WireNode* next = nullptr;
    for (WireNode* const node : nodes_)
    {
        const bool waits = (node != nullptr) && (node->Waiting().kind == FrameKind::kData);
        if (waits && ((next == nullptr) || (node->Waiting().identifier < next->Waiting().identifier)))
        {
            next = node;
        }
    }
    return next;
}

void Wire::Mix(const std::uint32_t value, const std::uint32_t bytes) noexcept
{
    constexpr std::uint32_t kPrime = 0x01000193U;
    for (std::uint32_t byte = 0U; byte < bytes; ++byte)
    {
        hash_ = (hash_ ^ ((value >> (8U * byte)) & 0xFFU)) * kPrime;
    }
}

void Wire::Count(const CanFrame& frame) noexcept
{
    ++frames_;
    Mix(now_us_, 4U);
    Mix(frame.identifier, 2U);
    Mix(frame.length_bytes, 1U);
    for (std::uint32_t byte = 0U; byte < frame.length_bytes; ++byte)
    {
        Mix(frame.data[byte], 1U);
    }
}

void Wire::Pass() noexcept
{
    now_us_ += kMillisecondUs;
    for (WireNode* const node : nodes_)
    {
        if (node != nullptr)
        {
            node->Cycle(Now());
        }
    }
    WireNode* sender = Next();
    for (std::uint32_t frames = 0U; (frames < kFramesPerMs) && (sender != nullptr); ++frames)
    {
        const CanFrame frame = sender->Waiting();
        Count(frame);
        sender->Sent(Now());
        for (WireNode* const node : nodes_)
        {
            if ((node != nullptr) && (node != sender))
            {
                node->Hear(frame, Now());
            }
        }
        sender = Next();
    }
}

} // namespace counterpoint::target
