// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/tms570/interrupts.hpp"

#include "hal/tms570/diagnosis/esm.hpp"

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

/// What differs between parity and ECC. The VIM reads the table itself, for a request that it takes: a check that is on
/// needs a table that fits from its first word to the last.
struct CheckSetup
{
    std::uint32_t control; ///< In operation.
    std::uint32_t test;    ///< As `control`, and check bits can be written.
    std::uint32_t flags;   ///< All that say error.
    std::uint32_t filled;  ///< Words that the test fills first.
    std::uint32_t place;   ///< Word whose check bits the test spoils.
};

constexpr CheckSetup kParitySetup{kParityOn, kParityOn | kParityTest, kErrorFlag, 1U, 0U};
constexpr CheckSetup kEccSetup{kEccOn, kEccTest, kErrorFlag | kOneBitFlag, kTableWords, 0x55U};

[[nodiscard]] const CheckSetup& SetupOf(const TableCheck check) noexcept
{
    return (check == TableCheck::kEcc) ? kEccSetup : kParitySetup;
}

/// Check bits to spoil, and what then has to say so.
struct ForcedError
{
    std::uint32_t flipped;
    std::uint32_t flag;
    std::uint32_t channels_low;     ///< ESM group 1, one of channels 0 to 31.
    std::uint32_t channels_highest; ///< 64 to 95.
    bool tells_place;               ///< The address register is that of the word, as long as the flag is set.
};

constexpr ForcedError kParityError{1U, kErrorFlag, kEsmVimTable, 0U, false};
/// The error flag comes with it, since it is not corrected; whether the ESM's channel 15 does is not said anywhere.
constexpr ForcedError kOneBitError{1U, kOneBitFlag, 0U, kEsmVimOneBit, false};
constexpr ForcedError kTwoBitError{3U, kErrorFlag, kEsmVimTable, 0U, true};

void FlipCheckBits(const CheckSetup& setup, const std::uint32_t flipped) noexcept
{
    const Register bits = At(kTableCheckBits, setup.place * kWordBytes);
    Write(bits, Read(bits) ^ flipped);
}

/// Of channels 64 to 95, which a controller with parity does not have.
void ClearHighestChannels(const std::uint32_t channels) noexcept
{
    if (channels != 0U)
    {
        Write(At(esm::kBase, esm::kStatus7), channels);
    }
}

[[nodiscard]] bool AreHighestRaised(const std::uint32_t channels) noexcept
{
    return (channels == 0U) || ((Read(At(esm::kBase, esm::kStatus7)) & channels) == channels);
}

[[nodiscard]] bool IsToldAt(const Register word, const ForcedError& error) noexcept
{
    return !error.tells_place || (Read(At(kCheckBase, kErrorAddress)) == word.address);
}

/// Forces one error with the check on, sees it reported, and takes it back.
[[nodiscard]] bool IsReported(const CheckSetup& setup, const ForcedError& error) noexcept
{
    const Register control = At(kCheckBase, kCheckControl);
    const Register word = At(kTable, setup.place * kWordBytes);
    Write(control, setup.test);
    FlipCheckBits(setup, error.flipped);
    Touch(word);
    const bool is_flagged = (Read(At(kCheckBase, kCheckStatus)) & error.flag) != 0U;
    const bool is_raised = (ReadEsm().group_1_low & error.channels_low) == error.channels_low;
    const bool are_highest_raised = AreHighestRaised(error.channels_highest);
    const bool is_at_place = IsToldAt(word, error);
    FlipCheckBits(setup, error.flipped);
    Write(control, setup.control);
    Write(At(kCheckBase, kCheckStatus), setup.flags);
    ClearEsm(EsmStatus{kEsmVimTable, 0U, 0U, 0U});
    ClearHighestChannels(error.channels_highest);
    Touch(word);
    const bool is_clean = (Read(At(kCheckBase, kCheckStatus)) & setup.flags) == 0U;
    return is_flagged && is_raised && are_highest_raised && is_at_place && is_clean;
}

[[nodiscard]] bool TellsErrorsApart() noexcept
{
    const bool is_one_reported = IsReported(kEccSetup, kOneBitError);
    const bool are_two_reported = IsReported(kEccSetup, kTwoBitError);
    return is_one_reported && are_two_reported;
}

} // namespace

Outcome Interrupts::TestTable(const TableCheck check) noexcept
{
    const CheckSetup& setup = SetupOf(check);
    Write(At(kCheckBase, kCheckControl), setup.control);
    for (std::uint32_t word = 0U; (word < kTableWords) && (word < setup.filled); ++word)
    {
        Write(At(kTable, word * kWordBytes), kNoHandler);
    }
    switch (check)
    {
    case TableCheck::kParity:
        return IsReported(setup, kParityError) ? Outcome::kDone : Outcome::kFailed;
    case TableCheck::kEcc:
        return TellsErrorsApart() ? Outcome::kDone : Outcome::kFailed;
    case TableCheck::kInvalid:
        break;
    }
    return Outcome::kFailed;
}

Outcome Interrupts::Start(const TableCheck check) noexcept
{
    Outcome outcome = WriteChecked(At(kCheckBase, kCheckControl), SetupOf(check).control, kWholeWord);
    outcome = Both(outcome, WriteChecked(At(kCheckBase, kFallback), kNoHandler, kWholeWord));
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
    return Both(outcome, Examine(check));
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

Outcome Interrupts::Examine(const TableCheck check) noexcept
{
    const CheckSetup& setup = SetupOf(check);
    bool is_same = true;
    for (std::uint32_t group = 0U; group < kGroups; ++group)
    {
        const bool same_enabled = Read(At(kBase, kEnableSet + (group * kWordBytes))) == EnabledIn(group);
        const bool same_fast = Read(At(kBase, kIsFast + (group * kWordBytes))) == FastIn(group);
        is_same = is_same && same_enabled && same_fast;
    }
    const bool is_on = Read(At(kCheckBase, kCheckControl)) == setup.control;
    const bool is_clean = (Read(At(kCheckBase, kCheckStatus)) & setup.flags) == 0U;
    return (is_same && is_on && is_clean) ? Outcome::kDone : Outcome::kFailed;
}

} // namespace counterpoint::tms570
