// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/tms570/interrupts.hpp"

#include "hal/tms570/esm.hpp"

namespace counterpoint::tms570
{

namespace
{

using namespace vim;

constexpr std::uint32_t kGroups = 4U;
constexpr std::uint32_t kGroupChannels = 32U;
constexpr std::uint32_t kWordBytes = 4U;
/// What the table holds: no address of code. Whoever jumps through it takes an abort.
constexpr std::uint32_t kNoHandler = 0xFFFFFFFCU;

[[nodiscard]] constexpr std::uint32_t BitOf(const InterruptRequest request, const std::uint32_t group) noexcept
{
    const std::uint32_t channel = static_cast<std::uint32_t>(request);
    return ((channel / kGroupChannels) == group) ? (1U << (channel % kGroupChannels)) : 0U;
}

/// Channels 0 and 1 cannot be turned off.
[[nodiscard]] constexpr std::uint32_t EnabledIn(const std::uint32_t group) noexcept
{
    const std::uint32_t always = (group == 0U) ? 3U : 0U;
    return always | BitOf(InterruptRequest::kDcan1, group) | BitOf(InterruptRequest::kDcan2, group) |
           BitOf(InterruptRequest::kEsmLow, group);
}

[[nodiscard]] constexpr std::uint32_t FastIn(const std::uint32_t group) noexcept
{
    return (group == 0U) ? 3U : 0U;
}

[[nodiscard]] InterruptRequest RequestOf(const std::uint32_t index) noexcept
{
    // 0 is the phantom request; channel n has index n + 1.
    const std::uint32_t number = index & kIndexMask;
    switch (number)
    {
    case 0U:
        return InterruptRequest::kNone;
    case static_cast<std::uint32_t>(InterruptRequest::kEsmHigh) + 1U:
        return InterruptRequest::kEsmHigh;
    case static_cast<std::uint32_t>(InterruptRequest::kDcan1) + 1U:
        return InterruptRequest::kDcan1;
    case static_cast<std::uint32_t>(InterruptRequest::kEsmLow) + 1U:
        return InterruptRequest::kEsmLow;
    case static_cast<std::uint32_t>(InterruptRequest::kDcan2) + 1U:
        return InterruptRequest::kDcan2;
    default:
        return InterruptRequest::kUnknown;
    }
}

} // namespace

Outcome Interrupts::TestParity() noexcept
{
    const Register control = At(kParityBase, kParityControl);
    const Register word = At(kTable, 0U);
    const Register parity = At(kTableParity, 0U);
    Write(control, kParityOn);
    Write(word, kNoHandler);
    Write(control, kParityOn | kParityTest);
    Write(parity, Read(parity) ^ 1U);
    Touch(word);
    const bool is_flagged = (Read(At(kParityBase, kParityFlag)) & 1U) != 0U;
    const bool is_reported = (ReadEsm().group_1_low & kEsmVimParity) != 0U;
    Write(parity, Read(parity) ^ 1U);
    Write(control, kParityOn);
    Write(At(kParityBase, kParityFlag), 1U);
    ClearEsm(EsmStatus{kEsmVimParity, 0U, 0U, 0U});
    Touch(word);
    const bool is_clean = (Read(At(kParityBase, kParityFlag)) & 1U) == 0U;
    return (is_flagged && is_reported && is_clean) ? Outcome::kDone : Outcome::kFailed;
}

Outcome Interrupts::Start() noexcept
{
    Outcome outcome = WriteChecked(At(kParityBase, kParityControl), kParityOn, kWholeWord);
    outcome = Both(outcome, WriteChecked(At(kParityBase, kFallback), kNoHandler, kWholeWord));
    for (std::uint32_t word = 0U; word < kTableWords; ++word)
    {
        outcome = Both(outcome, WriteChecked(At(kTable, word * kWordBytes), kNoHandler, kWholeWord));
    }
    for (std::uint32_t group = 0U; group < kGroups; ++group)
    {
        Write(At(kBase, kEnableClear + (group * kWordBytes)), kWholeWord);
        Write(At(kBase, kIsFast + (group * kWordBytes)), FastIn(group));
        Write(At(kBase, kEnableSet + (group * kWordBytes)), EnabledIn(group));
    }
    return Both(outcome, Examine());
}

InterruptRequest Interrupts::Next() noexcept
{
    return RequestOf(Read(At(kBase, kIrqIndex)));
}

InterruptRequest Interrupts::NextFast() noexcept
{
    return RequestOf(Read(At(kBase, kFiqIndex)));
}

void Interrupts::MaskAll() noexcept
{
    for (std::uint32_t group = 0U; group < kGroups; ++group)
    {
        Write(At(kBase, kEnableClear + (group * kWordBytes)), kWholeWord);
    }
}

Outcome Interrupts::Examine() noexcept
{
    bool is_same = true;
    for (std::uint32_t group = 0U; group < kGroups; ++group)
    {
        const bool same_enabled = Read(At(kBase, kEnableSet + (group * kWordBytes))) == EnabledIn(group);
        const bool same_fast = Read(At(kBase, kIsFast + (group * kWordBytes))) == FastIn(group);
        is_same = is_same && same_enabled && same_fast;
    }
    const bool is_on = Read(At(kParityBase, kParityControl)) == kParityOn;
    const bool is_clean = (Read(At(kParityBase, kParityFlag)) & 1U) == 0U;
    return (is_same && is_on && is_clean) ? Outcome::kDone : Outcome::kFailed;
}

} // namespace counterpoint::tms570
