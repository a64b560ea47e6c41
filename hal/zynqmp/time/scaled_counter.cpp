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

/// 1 000 000 / hertz in units of 2^-32.
[[nodiscard]] std::uint32_t FractionOf(const std::uint32_t hertz) noexcept
{
    std::uint32_t fraction = 0U;
    std::uint32_t rest = kMillion;
    for (std::uint32_t bit = 0U; bit < kWordBits; ++bit)
    {
        rest <<= 1U;
        if (rest >= hertz)
        {
            rest -= hertz;
            fraction |= kTopBit >> bit;
        }
    }
    return fraction;
}

} // namespace

void ScaledCounter::Start(const CounterRate& rate, const std::uint32_t raw) noexcept
{
    mask_ = (rate.bits < kWordBits) ? ((1U << rate.bits) - 1U) : ~std::uint32_t{0U};
    each_count_ = (rate.hertz > kMillion) ? FractionOf(rate.hertz) : 0U;
    microseconds_ = 0U;
    last_ = raw;
}

Instant ScaledCounter::Take(const std::uint32_t raw) noexcept
{
    const std::uint32_t counts = (raw - last_) & mask_;
    last_ = raw;
    microseconds_ += std::uint64_t{counts} * each_count_;
    return Instant{static_cast<std::uint32_t>(microseconds_ >> kMicrosecondBits)};
}

} // namespace counterpoint::zynqmp
