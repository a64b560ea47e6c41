// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/contract_test/check.hpp"

namespace counterpoint::hal::contract
{

namespace
{

constexpr std::uint32_t kBase = 10U;
constexpr std::uint32_t kDecimalDigits = 10U;
constexpr std::uint32_t kCodeDigits = 8U;
constexpr std::uint32_t kDigitBits = 4U;

} // namespace

void WriteNumber(const PortBench& bench, const std::uint32_t value) noexcept
{
    char digits[kDecimalDigits + 1U]{};
    std::uint32_t place = kDecimalDigits;
    std::uint32_t rest = value;
    do
    {
        --place;
        digits[place] = static_cast<char>('0' + static_cast<char>(rest % kBase));
        rest /= kBase;
    } while (rest != 0U);
    bench.write(bench.bench, &digits[place]);
}

void WriteCode(const PortBench& bench, const std::uint32_t value) noexcept
{
    char digits[kCodeDigits + 1U]{};
    for (std::uint32_t place = 0U; place < kCodeDigits; ++place)
    {
        digits[place] = "0123456789ABCDEF"[(value >> ((kCodeDigits - 1U - place) * kDigitBits)) & 0xFU];
    }
    bench.write(bench.bench, "0x");
    bench.write(bench.bench, digits);
}

Check::Check(const PortBench& bench, const char* const part, const char* const name) noexcept : bench_(bench)
{
    Write(part);
    Write(": ");
    Write(name);
    Write(": ");
}

void Check::Equal(const char* const what, const std::uint32_t expected, const std::uint32_t got) noexcept
{
    if ((expected != got) && IsHeld())
    {
        BeginBroken(what);
        WriteNumber(bench_, expected);
        Write(", got ");
        WriteNumber(bench_, got);
    }
}

void Check::EqualCode(const char* const what, const std::uint32_t expected, const std::uint32_t got) noexcept
{
    if ((expected != got) && IsHeld())
    {
        BeginBroken(what);
        WriteCode(bench_, expected);
        Write(", got ");
        WriteCode(bench_, got);
    }
}

void Check::Within(const char* const what, const Span& expected, const std::uint32_t got) noexcept
{
    const bool is_inside = (got >= expected.least) && (got <= expected.most);
    if (!is_inside && IsHeld())
    {
        BeginBroken(what);
        WriteNumber(bench_, expected.least);
        Write(" to ");
        WriteNumber(bench_, expected.most);
        Write(", got ");
        WriteNumber(bench_, got);
    }
}

void Check::NotShown(const char* const why) noexcept
{
    if (IsHeld())
    {
        verdict_ = Verdict::kNotShown;
        Write("not shown: ");
        Write(why);
    }
}

void Check::End(ContractCount& count) const noexcept
{
    count.held += (verdict_ == Verdict::kHeld) ? 1U : 0U;
    count.broken += (verdict_ == Verdict::kBroken) ? 1U : 0U;
    count.not_shown += (verdict_ == Verdict::kNotShown) ? 1U : 0U;
    Write(IsHeld() ? "held\n" : "\n");
}

void Check::BeginBroken(const char* const what) noexcept
{
    verdict_ = Verdict::kBroken;
    Write("broken: ");
    Write(what);
    Write(": expected ");
}

void Check::Write(const char* const text) const noexcept
{
    bench_.write(bench_.bench, text);
}

} // namespace counterpoint::hal::contract
