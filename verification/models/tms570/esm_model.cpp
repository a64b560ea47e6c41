// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/models/tms570/esm_model.hpp"

#include "hal/tms570/diagnosis/esm_registers.hpp"

namespace counterpoint::tms570::model
{

namespace
{

using namespace esm;

/// 16384 cycles of an 80 MHz clock.
constexpr std::uint64_t kLowTimeNs = 204'800U;

struct SetAndClear
{
    std::uint32_t set;
    std::uint32_t clear;
};
constexpr SetAndClear kPairs[] = {
    {kPinSet1, kPinClear1}, {kInterruptSet1, kInterruptClear1}, {kLevelSet1, kLevelClear1},
    {kPinSet4, kPinClear4}, {kInterruptSet4, kInterruptClear4}, {kLevelSet4, kLevelClear4}};
constexpr std::uint32_t kHighHalf = 32U;
constexpr std::uint32_t kHighest = 64U;

[[nodiscard]] bool IsStatus(const std::uint32_t offset)
{
    return (offset == kStatus1) || (offset == kStatus2) || (offset == kStatus3) || (offset == kStatus4) ||
           (offset == kStatus7) || (offset == kShadowStatus2);
}

} // namespace

void EsmModel::PullLow()
{
    low_ = true;
    released_ = false;
    low_left_ns_ = kLowTimeNs;
}

void EsmModel::Raise(const std::uint32_t group, const std::uint32_t channel)
{
    const std::uint32_t bit = 1U << (channel % 32U);
    if ((group == 1U) && (channel >= kHighest))
    {
        // No driver gives these an interrupt or an influence on the pin.
        Kept(kStatus7) |= bit;
        return;
    }
    const bool is_high_half = (group == 1U) && (channel >= kHighHalf);
    const std::uint32_t status1 = is_high_half ? kStatus4 : kStatus1;
    const std::uint32_t offset = (group == 1U) ? status1 : ((group == 2U) ? kStatus2 : kStatus3);
    Kept(offset) |= bit;
    if (group == 2U)
    {
        Kept(kShadowStatus2) |= bit;
    }
    const std::uint32_t influence = Kept(is_high_half ? kPinSet4 : kPinSet1);
    if ((group != 1U) || ((influence & bit) != 0U))
    {
        PullLow();
    }
}

bool EsmModel::IsPinHigh() const
{
    return !low_ && !forced_;
}

bool EsmModel::HighLine()
{
    const std::uint32_t low_half = Kept(kStatus1) & Kept(kInterruptSet1) & Kept(kLevelSet1);
    const std::uint32_t high_half = Kept(kStatus4) & Kept(kInterruptSet4) & Kept(kLevelSet4);
    return ((low_half | high_half | Kept(kStatus2)) != 0U);
}

bool EsmModel::LowLine()
{
    const std::uint32_t low_half = Kept(kStatus1) & Kept(kInterruptSet1) & ~Kept(kLevelSet1);
    const std::uint32_t high_half = Kept(kStatus4) & Kept(kInterruptSet4) & ~Kept(kLevelSet4);
    return (low_half | high_half) != 0U;
}

std::uint32_t EsmModel::Read(const std::uint32_t offset)
{
    if (offset == kPinStatus)
    {
        const bool is_stuck = Has(Fault::kEsmPinStuckHigh) || Has(Fault::kEsmPinStuckLow);
        return (is_stuck ? Has(Fault::kEsmPinStuckHigh) : IsPinHigh()) ? kPinIsHigh : 0U;
    }
    for (const SetAndClear& pair : kPairs)
    {
        if (offset == pair.clear)
        {
            return Kept(pair.set);
        }
    }
    return Kept(offset);
}

void EsmModel::Write(const std::uint32_t offset, const std::uint32_t value)
{
    if (IsStatus(offset))
    {
        Kept(offset) &= ~value;
        return;
    }
    for (const SetAndClear& pair : kPairs)
    {
        if (offset == pair.set)
        {
            Kept(offset) |= Has(Fault::kEsmWriteLost) ? 0U : value;
            return;
        }
        if (offset == pair.clear)
        {
            Kept(pair.set) &= ~value;
            return;
        }
    }
    if (offset == kErrorKey)
    {
        forced_ = value == kKeyForce;
        if (forced_)
        {
            PullLow();
        }
        released_ = value == kKeyRelease;
    }
    const bool is_lost = (offset == kLowTimePreload) && Has(Fault::kEsmLowTimeLost);
    Kept(offset) = is_lost ? 0U : value;
}

void EsmModel::Advance(const std::uint64_t ns)
{
    low_left_ns_ -= (ns < low_left_ns_) ? ns : low_left_ns_;
    if (released_ && (low_left_ns_ == 0U))
    {
        low_ = false;
        released_ = false;
    }
}

} // namespace counterpoint::tms570::model
