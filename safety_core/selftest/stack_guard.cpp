// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/selftest/stack_guard.hpp"

namespace counterpoint::selftest
{

namespace
{

constexpr std::uint32_t kGuardPattern = 0x6B75A1C3U;
constexpr std::uint32_t kFillPattern = 0xC5E1B72DU;
/// Distance from the running stack position to the first word that is filled: what is called until the filling is done.
constexpr hal::Address kReachBytes = 2048U;

[[nodiscard]] hal::Address PlaceOf(const hal::MemorySpan& span, const std::uint32_t word) noexcept
{
    return span.first + (hal::Address{word} * hal::kWordBytes);
}

} // namespace

void StackGuard::Restart(const StackSetup& setup, hal::MemoryAccess& memory) noexcept
{
    setup_ = setup;
    done_ = 0U;
    if (!IsUsable())
    {
        setup_.guard_words = 0U;
        return;
    }
    const hal::Address area_end = PlaceOf(setup.area, setup.area.words);
    const hal::Address used = memory.StackPosition();
    // A stack other than the running one, as that of an interrupt, is filled to its end.
    const bool is_running = (used >= setup.area.first) && (used < area_end);
    const hal::Address fill_end = is_running ? (used - kReachBytes) : area_end;
    std::uint32_t guards = setup.guard_words;
    for (hal::Address place = setup.area.first; place < fill_end; place += hal::kWordBytes)
    {
        memory.Write(place, (guards != 0U) ? kGuardPattern : kFillPattern);
        guards -= (guards != 0U) ? 1U : 0U;
    }
}

bool StackGuard::IsUsable() const noexcept
{
    const bool is_aligned = (setup_.area.first % hal::kWordBytes) == 0U;
    return is_aligned && (setup_.guard_words != 0U) && (setup_.area.words > setup_.guard_words);
}

SliceResult StackGuard::Check(const hal::MemoryAccess& memory) noexcept
{
    std::uint32_t differences = (setup_.guard_words == 0U) ? 1U : 0U;
    hal::Address place = setup_.area.first;
    for (std::uint8_t word = 0U; word < setup_.guard_words; ++word)
    {
        differences |= memory.Read(place) ^ kGuardPattern;
        place += hal::kWordBytes;
    }
    ++done_;
    return (differences == 0U) ? SliceResult::kPassed : SliceResult::kFailed;
}

std::uint32_t StackGuard::HighWaterBytes(const hal::MemoryAccess& memory) const noexcept
{
    std::uint32_t word = setup_.guard_words;
    while ((word < setup_.area.words) && (memory.Read(PlaceOf(setup_.area, word)) == kFillPattern))
    {
        ++word;
    }
    return (setup_.area.words - word) * hal::kWordBytes;
}

} // namespace counterpoint::selftest
