// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/world/node/memory.hpp"

#include <cstring>
#include <utility>

namespace counterpoint::simulator
{
namespace
{
/// Each piece begins at a multiple of this and ends before the next one.
constexpr std::uint32_t kPieceBits = 20U;
constexpr hal::Address kStack = hal::Address{0x7FU} << 32U;
constexpr hal::Address kElsewhere = hal::Address{0x7EU} << 32U;

std::uint32_t WordAt(const std::uint8_t* const bytes) noexcept
{
    std::uint32_t word = 0U;
    std::memcpy(&word, bytes, sizeof word);
    return word;
}
} // namespace

hal::MemorySpan NodeMemory::Add(void* const bytes, const std::size_t size)
{
    const hal::Address first = hal::Address{pieces_} << kPieceBits;
    distances_.at(pieces_) = reinterpret_cast<std::uintptr_t>(bytes) - first;
    ++pieces_;
    return {first, static_cast<std::uint32_t>(size / hal::kWordBytes)};
}

std::uint8_t* NodeMemory::At(const hal::Address place) const noexcept
{
    return reinterpret_cast<std::uint8_t*>(distances_[place >> kPieceBits] + place);
}

std::uint32_t NodeMemory::Read(const hal::Address place) const noexcept
{
    return WordAt(At(place));
}

void NodeMemory::Write(const hal::Address place, const std::uint32_t value) noexcept
{
    std::uint8_t* const word = At(place);
    std::memcpy(word, &value, sizeof value);
    if (!stuck_.empty())
    {
        HoldWithin(word);
    }
}

std::uint32_t NodeMemory::Exchange(const hal::Address place, const std::uint32_t value) noexcept
{
    std::uint8_t* const word = At(place);
    if (!stuck_.empty())
    {
        return ExchangeHeld(word, value);
    }
    const std::uint32_t before = WordAt(word);
    std::memcpy(word, &value, sizeof value);
    return before;
}

// Apart from Exchange: a march calls that dozens of times a cycle.
std::uint32_t NodeMemory::ExchangeHeld(std::uint8_t* const word, const std::uint32_t value) noexcept
{
    const std::uint32_t before = WordAt(word);
    std::memcpy(word, &value, sizeof value);
    HoldWithin(word);
    return before;
}

hal::Address NodeMemory::StackPosition() const noexcept
{
    return kStack;
}

hal::Address NodeMemory::PlaceOf(const void* const /*object*/) const noexcept
{
    return kElsewhere;
}

void NodeMemory::Stick(const StuckBit& stuck)
{
    stuck_.push_back({stuck, false});
    effects_.reserve(stuck_.size());
    Hold();
}

void NodeMemory::Hold()
{
    for (const Held& held : stuck_)
    {
        HoldWithin(held.stuck.byte);
    }
}

// `word` is the first of four bytes, or the stuck byte itself.
void NodeMemory::HoldWithin(const std::uint8_t* const word) noexcept
{
    for (Held& held : stuck_)
    {
        const StuckBit& stuck = held.stuck;
        const bool is_within = stuck.byte >= word && stuck.byte < word + hal::kWordBytes;
        const bool is_one = ((*stuck.byte >> stuck.bit) & 1U) != 0U;
        if (!is_within || is_one == stuck.level)
        {
            continue;
        }
        *stuck.byte = static_cast<std::uint8_t>(*stuck.byte ^ (1U << stuck.bit));
        if (!held.has_effect)
        {
            held.has_effect = true;
            effects_.push_back(stuck.fault);
        }
    }
}

std::vector<std::size_t> NodeMemory::TakeEffects()
{
    return std::exchange(effects_, {});
}
} // namespace counterpoint::simulator
