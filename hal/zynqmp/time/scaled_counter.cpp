// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/zynqmp/time/scaled_counter.hpp"

namespace counterpoint::zynqmp
{

namespace
{

constexpr std::uint32_t kMicrosecondBits = 32U;
constexpr std::uint32_t kWordBits = 32U;
constexpr std::uint32_t kMillion = 1000000U;
/// Bits of the quotient are found one by one: no compiler's function for 64 bits is in the image.
constexpr std::uint32_t kTopBit = 0x80000000U;

/// The next 32 bits of the quotient; `rest` is what is left behind them.
[[nodiscard]] std::uint32_t NextBits(const std::uint32_t hertz, std::uint32_t& rest) noexcept
{
    std::uint32_t quotient = 0U;
    for (std::uint32_t bit = 0U; bit < kWordBits; ++bit)
    {
        rest <<= 1U;
        if (rest >= hertz)
        {
            rest -= hertz;
            quotient |= kTopBit >> bit;
        }
    }
    return quotient;
}

} // namespace

void ScaledCounter::Start(const CounterRate& rate, const std::uint32_t raw) noexcept
{
    mask_ = (rate.bits < kWordBits) ? ((1U << rate.bits) - 1U) : ~std::uint32_t{0U};
    std::uint32_t rest = kMillion;
    const bool is_rate = rate.hertz > kMillion;
    each_count_ = is_rate ? NextBits(rate.hertz, rest) : 0U;
    each_count_rest_ = is_rate ? NextBits(rate.hertz, rest) : 0U;
    rest_ = 0U;
    microseconds_ = 0U;
    last_ = raw;
}

Instant ScaledCounter::Take(const std::uint32_t raw) noexcept
{
    const std::uint32_t counts = (raw - last_) & mask_;
    last_ = raw;
    const std::uint64_t rest = (std::uint64_t{counts} * each_count_rest_) + rest_;
    rest_ = static_cast<std::uint32_t>(rest);
    microseconds_ += (std::uint64_t{counts} * each_count_) + (rest >> kMicrosecondBits);
    return Instant{static_cast<std::uint32_t>(microseconds_ >> kMicrosecondBits)};
}

} // namespace counterpoint::zynqmp
