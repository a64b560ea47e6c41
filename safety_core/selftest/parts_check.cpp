// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/selftest/parts_check.hpp"

namespace counterpoint::selftest
{

void PartsCheck::Restart(const PartsSetup& setup, const hal::MemoryAccess& memory) noexcept
{
    setup_ = setup;
    done_ = 0U;
    if (!IsUsable())
    {
        setup_.count = 0U;
        return;
    }
    std::uint8_t reference = 0U;
    for (std::uint8_t part = 0U; part < setup_.count; ++part)
    {
        for (std::uint8_t word = 0U; word < kPointerWords; ++word)
        {
            references_[reference] = memory.Read(setup_.parts[part] + (word * hal::kWordBytes)); // MISRA D-002
            ++reference;
        }
    }
}

bool PartsCheck::IsUsable() const noexcept
{
    hal::Address places = 0U;
    const bool is_counted = (setup_.count != 0U) && (setup_.count <= kMaxParts);
    for (std::uint8_t part = 0U; is_counted && (part < setup_.count); ++part)
    {
        places |= setup_.parts[part]; // MISRA D-002
    }
    return is_counted && ((places % hal::kWordBytes) == 0U);
}

SliceResult PartsCheck::Check(const hal::MemoryAccess& memory) noexcept
{
    std::uint32_t differences = (setup_.count == 0U) ? 1U : 0U;
    std::uint8_t reference = 0U;
    for (std::uint8_t part = 0U; part < setup_.count; ++part)
    {
        const hal::Address place = setup_.parts[part]; // MISRA D-002
        for (std::uint8_t word = 0U; word < kPointerWords; ++word)
        {
            differences |= memory.Read(place + (word * hal::kWordBytes)) ^ references_[reference];
            ++reference;
        }
    }
    ++done_;
    return (differences == 0U) ? SliceResult::kPassed : SliceResult::kFailed;
}

} // namespace counterpoint::selftest
