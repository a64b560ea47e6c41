// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/selftest/permit_test.hpp"

namespace counterpoint::selftest
{

namespace
{

/// A multiple of 4 added to an odd multiple of 2: always even, never 0.
constexpr std::uint32_t kChallengeStep = 0x7F4A7C14U;
constexpr std::uint32_t kFirstChallenge = 0x2545F492U;
constexpr std::uint8_t kKinds = 3U;

/// What is wrong with the one permit that must be refused.
enum class Flaw : std::uint8_t
{
    kWrong = 0U,
    kOld = 1U,
    kMissing = 2U,
};

/// The right answer for no slot at all; contract/channel.hpp has the formula.
[[nodiscard]] Permit AnswerFor(const std::uint32_t challenge, const std::uint32_t constant) noexcept
{
    return Permit{0U, challenge * constant};
}

[[nodiscard]] Permit Spoilt(const Permit& right, const Flaw flaw, const std::uint32_t constant) noexcept
{
    if (flaw == Flaw::kWrong)
    {
        return Permit{right.mask, right.response ^ 1U};
    }
    // The answer to the challenge before is that to this one less a step.
    return (flaw == Flaw::kOld) ? Permit{right.mask, right.response - (kChallengeStep * constant)} : Permit{0U, 0U};
}

} // namespace

void PermitTest::Restart() noexcept
{
    challenge_ = kFirstChallenge;
    done_ = 0U;
    variant_ = 0U;
}

SliceResult PermitTest::Slice(const hal::SafetyOutput& output) noexcept
{
    challenge_ += kChallengeStep;
    hal::PermitSet permits{AnswerFor(challenge_, kPermitConstantA), AnswerFor(challenge_, kPermitConstantB),
                           AnswerFor(challenge_, kPermitConstantKernel)};
    const std::uint8_t party = variant_ / kKinds;
    const Flaw flaw = static_cast<Flaw>(variant_ % kKinds);
    // The last variant names no party: all three are right.
    permits.a = (party == 0U) ? Spoilt(permits.a, flaw, kPermitConstantA) : permits.a;
    permits.b = (party == 1U) ? Spoilt(permits.b, flaw, kPermitConstantB) : permits.b;
    permits.kernel = (party == 2U) ? Spoilt(permits.kernel, flaw, kPermitConstantKernel) : permits.kernel;
    const bool is_last = party == kKinds;
    const hal::ProbeAnswer wanted = is_last ? hal::ProbeAnswer::kAccepted : hal::ProbeAnswer::kRefused;
    const hal::ProbeAnswer answer = output.Probe(permits, challenge_);
    variant_ = is_last ? std::uint8_t{0U} : static_cast<std::uint8_t>(variant_ + 1U);
    ++done_;
    if (answer != wanted)
    {
        return SliceResult::kFailed;
    }
    return is_last ? SliceResult::kPassed : SliceResult::kContinues;
}

} // namespace counterpoint::selftest
