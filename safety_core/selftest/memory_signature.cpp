// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/selftest/memory_signature.hpp"

namespace counterpoint::selftest
{

namespace
{

constexpr std::uint32_t kStart = 0xFFFFFFFFU;
constexpr std::uint32_t kNibbleMask = 0xFU;
constexpr std::uint32_t kNibbleBits = 4U;

/// Remainders of the 16 values of four bits for the reflected polynomial EDB88320h.
constexpr std::uint32_t kRemainders[16] = { // MISRA D-001
    0x00000000U, 0x1DB71064U, 0x3B6E20C8U, 0x26D930ACU, 0x76DC4190U, 0x6B6B51F4U, 0x4DB26158U, 0x5005713CU,
    0xEDB88320U, 0xF00F9344U, 0xD6D6A3E8U, 0xCB61B38CU, 0x9B64C2B0U, 0x86D3D2D4U, 0xA00AE278U, 0xBDBDF21CU};

[[nodiscard]] constexpr std::uint32_t Nibble(const std::uint32_t crc) noexcept
{
    return (crc >> kNibbleBits) ^ kRemainders[crc & kNibbleMask];
}

/// Eight times four bits, without a loop: most of the effort of a slice.
[[nodiscard]] constexpr std::uint32_t Continue(const std::uint32_t before, const std::uint32_t word) noexcept
{
    const std::uint32_t half = Nibble(Nibble(Nibble(Nibble(before ^ word))));
    return Nibble(Nibble(Nibble(Nibble(half))));
}

} // namespace

void MemorySignature::Restart(const SignatureSetup& setup) noexcept
{
    setup_ = setup;
    crc_ = kStart;
    value_ = 0U;
    word_ = 0U;
    done_ = 0U;
    span_ = 0U;
}

std::uint32_t MemorySignature::SlicesAPass() const noexcept
{
    if (setup_.slice_words == 0U)
    {
        return 0U;
    }
    std::uint32_t slices = 0U;
    for (std::uint8_t number = 0U; number < setup_.memory.count; ++number)
    {
        const hal::MemorySpan& span = setup_.memory.spans[number]; // MISRA D-002
        if ((span.words == 0U) || ((span.first % hal::kWordBytes) != 0U))
        {
            return 0U;
        }
        slices += ((span.words - 1U) / setup_.slice_words) + 1U;
    }
    return slices;
}

SliceResult MemorySignature::Slice(const hal::MemoryAccess& memory) noexcept
{
    // A position outside of what is to be read must not be used.
    if (span_ >= setup_.memory.count)
    {
        return SliceResult::kFailed;
    }
    const hal::MemorySpan& span = setup_.memory.spans[span_]; // MISRA D-002
    if (word_ >= span.words)
    {
        return SliceResult::kFailed;
    }
    const std::uint32_t left = span.words - word_;
    const std::uint32_t count = (left < setup_.slice_words) ? left : setup_.slice_words;
    std::uint32_t crc = crc_;
    hal::Address place = span.first + (static_cast<hal::Address>(word_) * hal::kWordBytes);
    for (std::uint32_t number = 0U; number < count; ++number)
    {
        crc = Continue(crc, memory.Read(place));
        place += hal::kWordBytes;
    }
    crc_ = crc;
    word_ += count;
    ++done_;
    if (word_ != span.words)
    {
        return SliceResult::kContinues;
    }
    word_ = 0U;
    ++span_;
    return (span_ == setup_.memory.count) ? EndPass() : SliceResult::kContinues;
}

SliceResult MemorySignature::EndPass() noexcept
{
    value_ = ~crc_;
    crc_ = kStart;
    span_ = 0U;
    if (setup_.source == SignatureSource::kTaken)
    {
        setup_.source = SignatureSource::kGiven;
        setup_.expected = value_;
    }
    const bool is_right = (setup_.source == SignatureSource::kGiven) && (value_ == setup_.expected);
    return is_right ? SliceResult::kPassed : SliceResult::kFailed;
}

} // namespace counterpoint::selftest
