// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Error signalling module (reference manual, chapter ESM; facts/tms570 4). Group 1 has interrupts and influence on
// nERROR by choice, group 2 always both, group 3 nERROR only.
#include "hal/tms570/diagnosis/esm.hpp"

namespace counterpoint::tms570
{

namespace
{

using namespace esm;

constexpr std::uint32_t kRecordedLow = RecordedChannels(0U);
constexpr std::uint32_t kRecordedHigh = RecordedChannels(32U);
constexpr std::uint32_t kWordBits = 32U;
constexpr std::uint8_t kHighHalf = 32U;
constexpr std::uint16_t kMostCount = 0xFFFFU;
/// The low time is 16384 cycles of VCLK; a look takes 4 of them at least.
constexpr Looks kPinLooks{20000U};

[[nodiscard]] std::uint8_t LowestBit(const std::uint32_t mask) noexcept
{
    std::uint8_t bit = 0U;
    while ((bit < kWordBits) && (((mask >> bit) & 1U) == 0U))
    {
        ++bit;
    }
    return bit;
}

} // namespace

EsmStatus ReadEsm() noexcept
{
    return EsmStatus{Read(At(kBase, kStatus1)), Read(At(kBase, kStatus4)), Read(At(kBase, kStatus2)),
                     Read(At(kBase, kStatus3))};
}

void ClearEsm(const EsmStatus& forced) noexcept
{
    Write(At(kBase, kStatus1), forced.group_1_low);
    Write(At(kBase, kStatus4), forced.group_1_high);
    Write(At(kBase, kStatus2), forced.group_2);
    Write(At(kBase, kShadowStatus2), forced.group_2);
    Write(At(kBase, kStatus3), forced.group_3);
}

void ForceErrorPin() noexcept
{
    Write(At(kBase, kErrorKey), kKeyForce);
}

void ReleaseErrorPin() noexcept
{
    Write(At(kBase, kErrorKey), kKeyRelease);
}

Outcome Esm::ExamineCold() noexcept
{
    const EsmStatus status = ReadEsm();
    const std::uint32_t shadow = Read(At(kBase, kShadowStatus2));
    const bool is_clean = (status.group_2 == 0U) && (status.group_3 == 0U) && (shadow == 0U);
    if (is_clean)
    {
        return Outcome::kDone;
    }
    Keep(3U, status.group_3, 0U);
    Keep(2U, status.group_2 | shadow, 0U);
    return Outcome::kFailed;
}

Outcome Esm::TestErrorPin() noexcept
{
    const Outcome low_time = WriteChecked(At(kBase, kLowTimePreload), kLeastLowTime, kWholeWord);
    ForceErrorPin();
    const Outcome low = WaitFor(At(kBase, kPinStatus), Bits{kPinIsHigh, 0U}, kPinLooks);
    ReleaseErrorPin();
    const Outcome high = WaitFor(At(kBase, kPinStatus), Bits{kPinIsHigh, kPinIsHigh}, kPinLooks);
    return Both(low_time, Both(low, high));
}

Outcome Esm::Start() noexcept
{
    corrected_.Store(0U);
    Write(At(kBase, kPinClear1), kRecordedLow);
    Write(At(kBase, kPinClear4), kRecordedHigh);
    Write(At(kBase, kLevelClear1), kRecordedLow);
    Write(At(kBase, kLevelClear4), kRecordedHigh);
    Write(At(kBase, kPinSet1), ~kRecordedLow);
    Write(At(kBase, kPinSet4), ~kRecordedHigh);
    Write(At(kBase, kLevelSet1), ~kRecordedLow);
    Write(At(kBase, kLevelSet4), ~kRecordedHigh);
    Write(At(kBase, kInterruptSet1), kWholeWord);
    Write(At(kBase, kInterruptSet4), kWholeWord);
    return Both(Examine(), Serve());
}

Outcome Esm::Examine() const noexcept
{
    const bool same_pins =
        (Read(At(kBase, kPinSet1)) == ~kRecordedLow) && (Read(At(kBase, kPinSet4)) == ~kRecordedHigh);
    const bool same_levels =
        (Read(At(kBase, kLevelSet1)) == ~kRecordedLow) && (Read(At(kBase, kLevelSet4)) == ~kRecordedHigh);
    const bool all_interrupts =
        (Read(At(kBase, kInterruptSet1)) == kWholeWord) && (Read(At(kBase, kInterruptSet4)) == kWholeWord);
    return (same_pins && same_levels && all_interrupts) ? Outcome::kDone : Outcome::kFailed;
}

Outcome Esm::Serve() noexcept
{
    const EsmStatus status = ReadEsm();
    const std::uint32_t recorded_low = status.group_1_low & kRecordedLow;
    const std::uint32_t recorded_high = status.group_1_high & kRecordedHigh;
    const bool is_corrected = (recorded_low != 0U) || (recorded_high != 0U);
    if (is_corrected)
    {
        Write(At(kBase, kStatus1), recorded_low);
        Write(At(kBase, kStatus4), recorded_high);
        const std::uint16_t count = corrected_.Load();
        const std::uint32_t more = std::uint32_t{count} + ((count == kMostCount) ? 0U : 1U);
        corrected_.Store(static_cast<std::uint16_t>(more));
        if (more > kMostCorrected)
        {
            Keep(1U, recorded_low, 0U);
            Keep(1U, recorded_high, kHighHalf);
        }
    }
    return Judge(status);
}

Outcome Esm::Judge(const EsmStatus& status) noexcept
{
    Keep(3U, status.group_3, 0U);
    Keep(2U, status.group_2, 0U);
    Keep(1U, status.group_1_low & ~kRecordedLow, 0U);
    Keep(1U, status.group_1_high & ~kRecordedHigh, kHighHalf);
    // Or their interrupt would come for ever. First has the reason, and over a reset the shadow of group 2.
    Write(At(kBase, kStatus1), status.group_1_low & ~kRecordedLow);
    Write(At(kBase, kStatus4), status.group_1_high & ~kRecordedHigh);
    Write(At(kBase, kStatus2), status.group_2);
    if (First().group == 0U)
    {
        return Outcome::kDone;
    }
    ForceErrorPin();
    return Outcome::kFailed;
}

void Esm::Keep(const std::uint8_t group, const std::uint32_t errors, const std::uint8_t first_channel) noexcept
{
    const bool is_first = (errors != 0U) && (first_.Load() == 0U);
    if (is_first)
    {
        const std::uint32_t channel = std::uint32_t{first_channel} + LowestBit(errors);
        first_.Store((std::uint32_t{group} << kGroupShift) | channel);
    }
}

} // namespace counterpoint::tms570
