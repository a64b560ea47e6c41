// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/selftest/ram_test.hpp"

namespace counterpoint::selftest
{

namespace
{

/// On both sides of the running stack position: frames of this test and of what it calls.
constexpr hal::Address kReachBytes = 2048U;
constexpr std::uint32_t kMaxSpanWords = 0x01000000U;
constexpr std::uint8_t kBackgroundCount = 6U;
/// Any two bits of a word differ in one of them, and agree in the first. The seventh ends the chain.
constexpr std::uint32_t kBackgrounds[kBackgroundCount + 1U] = { // MISRA D-001
    0x00000000U, 0x55555555U, 0x33333333U, 0x0F0F0F0FU, 0x00FF00FFU, 0x0000FFFFU, 0x00000000U};

/// A march element: each word is read as its background XOR `inversion` and written as the inverse of that.
struct Element
{
    hal::Address first;
    hal::Address step; ///< Modular: may lead downwards.
    std::uint32_t inversion;
};

[[nodiscard]] constexpr hal::Address Bytes(const std::uint32_t words) noexcept
{
    return hal::Address{words} * hal::kWordBytes;
}

/// Differs from word to word: an odd multiple of the address.
[[nodiscard]] constexpr std::uint32_t BackgroundOf(const hal::Address place) noexcept
{
    return static_cast<std::uint32_t>(place & 0xFFFFFFFFU) * 0x9E3779B1U;
}

[[nodiscard]] std::uint32_t Run(const Element& element, const std::uint8_t count, hal::MemoryAccess& memory) noexcept
{
    std::uint32_t differences = 0U;
    hal::Address place = element.first;
    for (std::uint8_t number = 0U; number < count; ++number)
    {
        const std::uint32_t wanted = BackgroundOf(place) ^ element.inversion;
        differences |= memory.Exchange(place, ~wanted) ^ wanted;
        place += element.step;
    }
    return differences;
}

/// One word, which reads as its march background, through all backgrounds; it is left 0.
[[nodiscard]] std::uint32_t RunThrough(const hal::Address place, hal::MemoryAccess& memory) noexcept
{
    std::uint32_t differences = memory.Exchange(place, kBackgrounds[0]) ^ BackgroundOf(place);
    for (std::uint8_t number = 0U; number < kBackgroundCount; ++number)
    {
        const std::uint32_t background = kBackgrounds[number];
        differences |= memory.Exchange(place, ~background) ^ background;
        differences |= memory.Exchange(place, background) ^ ~background;
        differences |= memory.Exchange(place, kBackgrounds[number + 1U]) ^ background;
    }
    return differences;
}

/// First address of the span from which the line leads to another word of it; unused if there is none.
[[nodiscard]] hal::Address BaseOf(const hal::MemorySpan& span, const hal::Address line) noexcept
{
    return ((span.first & line) == 0U) ? span.first : ((span.first | (line - 1U)) + 1U);
}

/// The line if two words of the span differ in it alone, else 0. Above a line without such words there is none with.
[[nodiscard]] hal::Address LineWithin(const hal::MemorySpan& span, const hal::Address line) noexcept
{
    const hal::Address extent = Bytes(span.words - 1U);
    const bool leads_inside = (BaseOf(span, line) + line) <= (span.first + extent);
    return leads_inside ? line : 0U;
}

/// Neighbours share one word, so that each window but the last adds one less than it has.
[[nodiscard]] std::uint32_t WindowsOf(const hal::MemorySpan& span, const std::uint8_t slice_words) noexcept
{
    const std::uint32_t gain = slice_words - std::uint32_t{1U};
    return (span.words <= slice_words) ? 1U : ((((span.words - slice_words) + (gain - 1U)) / gain) + 1U);
}

[[nodiscard]] bool IsNear(const hal::Address place, const hal::Address stack) noexcept
{
    return ((place + kReachBytes) - stack) <= (kReachBytes * 2U);
}

} // namespace

void RamTest::Restart(const RamSetup& setup) noexcept
{
    setup_ = setup;
    stride_ = 0U;
    word_ = 0U;
    done_ = 0U;
    left_out_ = 0U;
    span_ = 0U;
}

// Own state outside of the span. [SRS_STS_013]
bool RamTest::IsFree(const RamPorts& ports, const hal::MemorySpan& span) const noexcept
{
    const hal::MemorySpan kept[4] = {// MISRA D-001
                                     {ports.memory.PlaceOf(this), sizeof(RamTest)},
                                     {ports.memory.PlaceOf(setup_.workspace), sizeof(RamWorkspace)},
                                     {ports.memory.PlaceOf(&ports.memory), sizeof(void*)},
                                     {ports.memory.PlaceOf(&ports.lock), sizeof(void*)}};
    bool is_free = true;
    for (const hal::MemorySpan& own : kept)
    {
        const hal::Address own_end = own.first + own.words; // In bytes here.
        const bool begins_after = span.first >= own_end;
        const bool ends_before = (span.first + Bytes(span.words)) <= own.first;
        is_free = is_free && (begins_after || ends_before);
    }
    return is_free;
}

std::uint32_t RamTest::SlicesAPass(const RamPorts& ports) const noexcept
{
    const bool is_sized = (setup_.slice_words >= kMinRamSliceWords) && (setup_.slice_words <= kMaxRamSliceWords);
    if (!is_sized || (setup_.workspace == nullptr))
    {
        return 0U;
    }
    std::uint32_t slices = 0U;
    for (std::uint8_t number = 0U; number < setup_.memory.count; ++number)
    {
        const hal::MemorySpan& span = setup_.memory.spans[number]; // MISRA D-002
        const bool is_span = (span.words != 0U) && (span.words <= kMaxSpanWords);
        const bool is_placed = ((span.first % hal::kWordBytes) == 0U) && IsFree(ports, span);
        if (!(is_span && is_placed))
        {
            return 0U;
        }
        slices += WindowsOf(span, setup_.slice_words);
        for (hal::Address line = LineWithin(span, hal::kWordBytes); line != 0U; line = LineWithin(span, line << 1U))
        {
            ++slices;
        }
    }
    return slices;
}

RamWindow RamTest::Current(const hal::MemorySpan& span) const noexcept
{
    if (stride_ != 0U)
    {
        return RamWindow{BaseOf(span, stride_), stride_, 2U, 0U};
    }
    const hal::Address first = span.first + Bytes(word_);
    const std::uint32_t left = span.words - word_;
    const std::uint8_t count = setup_.slice_words;
    if (left > count)
    {
        return RamWindow{first, hal::kWordBytes, count, static_cast<std::uint8_t>(count - 1U)};
    }
    const std::uint8_t rest = static_cast<std::uint8_t>(left);
    return RamWindow{first, hal::kWordBytes, rest, rest};
}

SliceResult RamTest::Advance(const hal::MemorySpan& span) noexcept
{
    ++done_;
    // Behind the last window of neighbours the position stays there: only lines follow.
    if ((span.words - word_) > setup_.slice_words)
    {
        word_ += setup_.slice_words - std::uint32_t{1U};
        return SliceResult::kContinues;
    }
    stride_ = LineWithin(span, (stride_ == 0U) ? hal::Address{hal::kWordBytes} : (stride_ << 1U));
    if (stride_ != 0U)
    {
        return SliceResult::kContinues;
    }
    word_ = 0U;
    ++span_;
    if (span_ != setup_.memory.count)
    {
        return SliceResult::kContinues;
    }
    span_ = 0U;
    return SliceResult::kPassed;
}

SliceResult RamTest::Slice(const RamPorts& ports) noexcept
{
    // A position outside of what is to be tested must not be written to.
    if (span_ >= setup_.memory.count)
    {
        return SliceResult::kFailed;
    }
    const hal::MemorySpan& span = setup_.memory.spans[span_]; // MISRA D-002
    if (word_ >= span.words)
    {
        return SliceResult::kFailed;
    }
    const RamWindow window = Current(span);
    const hal::Address stack = ports.memory.StackPosition();
    const hal::Address last = window.first + (window.stride * (window.count - hal::Address{1U}));
    std::uint32_t differences = 0U;
    if (IsNear(window.first, stack) || IsNear(last, stack))
    {
        ++left_out_;
    }
    else
    {
        ports.lock.Lock();
        differences = TestWindow(window, ports.memory);
        ports.lock.Unlock();
    }
    const SliceResult result = Advance(span);
    return (differences == 0U) ? result : SliceResult::kFailed;
}

// March C- and the backgrounds. Every step is done whatever was found. [SRS_STS_010]
std::uint32_t RamTest::TestWindow(const RamWindow& window, hal::MemoryAccess& memory) noexcept
{
    constexpr std::uint32_t kUpright = 0U;
    constexpr std::uint32_t kInverse = 0xFFFFFFFFU;
    const hal::Address last = window.first + (window.stride * (window.count - hal::Address{1U}));
    const hal::Address down = hal::Address{0U} - window.stride;
    hal::Address place = window.first;
    for (std::uint8_t number = 0U; number < window.count; ++number)
    {
        setup_.workspace->saved[number] = memory.Exchange(place, BackgroundOf(place));
        place += window.stride;
    }
    std::uint32_t differences = Run(Element{window.first, window.stride, kUpright}, window.count, memory);
    differences |= Run(Element{window.first, window.stride, kInverse}, window.count, memory);
    differences |= Run(Element{last, down, kUpright}, window.count, memory);
    differences |= Run(Element{last, down, kInverse}, window.count, memory);
    place = window.first;
    for (std::uint8_t number = 0U; number < window.own; ++number)
    {
        differences |= RunThrough(place, memory);
        place += window.stride;
    }
    place = window.first;
    for (std::uint8_t number = 0U; number < window.count; ++number)
    {
        const std::uint32_t wanted = (number < window.own) ? 0U : BackgroundOf(place);
        differences |= memory.Exchange(place, setup_.workspace->saved[number]) ^ wanted;
        place += window.stride;
    }
    place = window.first;
    for (std::uint8_t number = 0U; number < window.count; ++number)
    {
        differences |= memory.Read(place) ^ setup_.workspace->saved[number];
        place += window.stride;
    }
    return differences;
}

} // namespace counterpoint::selftest
