// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/zynqmp/link/shared_link.hpp"

namespace counterpoint::zynqmp
{

namespace
{

constexpr std::uint32_t kWordBytes = 4U;
constexpr std::uint32_t kByteBits = 8U;
constexpr std::uint32_t kByteMask = 0xFFU;
constexpr std::uint32_t kMost = 0xFFFFFFFFU;

void Add(std::uint32_t& count, const std::uint32_t more) noexcept
{
    count = (more > (kMost - count)) ? kMost : (count + more);
}

[[nodiscard]] std::uint32_t WordOf(const hal::LinkFrame& frame, const std::uint32_t word) noexcept
{
    std::uint32_t value = 0U;
    for (std::uint32_t byte = 0U; byte < kWordBytes; ++byte)
    {
        value |= static_cast<std::uint32_t>(frame.bytes[(word * kWordBytes) + byte])
                 << (byte * kByteBits); // MISRA D-002
    }
    return value;
}

void SetWord(hal::LinkFrame& frame, const std::uint32_t word, const std::uint32_t value) noexcept
{
    for (std::uint32_t byte = 0U; byte < kWordBytes; ++byte)
    {
        const std::uint32_t bits = (value >> (byte * kByteBits)) & kByteMask;
        frame.bytes[(word * kWordBytes) + byte] = static_cast<std::uint8_t>(bits); // MISRA D-002
    }
}

} // namespace

SharedLink::SharedLink(LinkMailbox& to, LinkMailbox& from) noexcept
    : to_{to}, from_{from}, sent_{to.newest.Load()}, taken_{from.newest.Load()}
{
}

hal::LinkStatus SharedLink::Send(const hal::LinkFrame& frame) noexcept
{
    if ((frame.length == 0U) || (frame.length > hal::kLinkFrameBytes))
    {
        return hal::LinkStatus::kNothing;
    }
    ++sent_;
    LinkSlot& slot = to_.slots[sent_ % kLinkSlots]; // MISRA D-002
    // Each Store is seen after those before it: who reads a new word finds the new number in `begun`, too.
    slot.begun.Store(sent_);
    slot.length.Store(frame.length);
    for (std::uint32_t word = 0U; word < kLinkWords; ++word)
    {
        slot.words[word].Store(WordOf(frame, word)); // MISRA D-002
    }
    slot.ended.Store(sent_);
    to_.newest.Store(sent_);
    return hal::LinkStatus::kDone;
}

hal::LinkStatus SharedLink::Receive(hal::LinkFrame& frame) noexcept
{
    const std::uint32_t newest = from_.newest.Load();
    const std::uint32_t waiting = newest - taken_;
    if (waiting > kLinkSlots)
    {
        Add(losses_.overwritten, waiting - kLinkSlots);
        taken_ += waiting - kLinkSlots;
    }
    for (std::uint32_t look = 0U; (look < kLinkSlots) && (taken_ != newest); ++look)
    {
        ++taken_;
        if (Copy(taken_, frame))
        {
            return hal::LinkStatus::kDone;
        }
        Add(losses_.torn, 1U);
    }
    return hal::LinkStatus::kNothing;
}

bool SharedLink::Copy(const std::uint32_t number, hal::LinkFrame& frame) noexcept
{
    const LinkSlot& slot = from_.slots[number % kLinkSlots]; // MISRA D-002
    const bool is_ended = slot.ended.Load() == number;
    const std::uint32_t length = slot.length.Load();
    for (std::uint32_t word = 0U; word < kLinkWords; ++word)
    {
        SetWord(frame, word, slot.words[word].Load()); // MISRA D-002
    }
    const bool is_untouched = slot.begun.Load() == number; // Loaded last: no writer was here meanwhile.
    const bool is_length = (length != 0U) && (length <= hal::kLinkFrameBytes);
    frame.length = is_length ? static_cast<std::uint16_t>(length) : std::uint16_t{0U};
    return is_ended && is_untouched && is_length;
}

LinkLosses SharedLink::Losses() const noexcept
{
    return losses_;
}

} // namespace counterpoint::zynqmp
