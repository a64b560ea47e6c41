// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/api/output_gate.hpp"

namespace counterpoint::hal
{

namespace
{

/// Odd, with many changing bits a step; two neighbours in the sequence of its multiples differ in more than bit 0.
constexpr std::uint32_t kChallengeStep = 0x9E3779B1U;
constexpr std::uint32_t kLowestBit = 1U;
constexpr std::uint32_t kHalfWordBits = 16U;
constexpr std::uint32_t kWordBits = 32U;

/// What a party must have answered; contract/channel.hpp has the formula.
struct PermitKey
{
    std::uint32_t challenge;
    std::uint32_t constant;
};

[[nodiscard]] bool IsRight(const Permit& permit, const PermitKey& key) noexcept
{
    const std::uint32_t low = static_cast<std::uint32_t>(permit.mask & 0xFFFFFFFFU);
    const std::uint32_t high = static_cast<std::uint32_t>(permit.mask >> kWordBits);
    const std::uint32_t high_rotated = (high << kHalfWordBits) | (high >> kHalfWordBits);
    const std::uint32_t response = ((key.challenge + low) ^ high_rotated) * key.constant;
    return (permit.response != 0U) && (permit.response == response);
}

/// No slot and no response of anybody: what a kernel gives that stops or starts, and no cycle of one that runs.
[[nodiscard]] bool IsEmpty(const PermitSet& permits) noexcept
{
    const SrdoMask masks = permits.a.mask | permits.b.mask | permits.kernel.mask;
    const std::uint32_t responses = permits.a.response | permits.b.response | permits.kernel.response;
    return (masks | responses) == 0U;
}

} // namespace

// An interrupted gate has a challenge outstanding as well, which it tells nobody: what comes next is an answer to it,
// and no order to arm. [SRS_HAL_300, SRS_HAL_301]
std::uint32_t OutputGate::Challenge() noexcept
{
    if (challenge_ != 0U)
    {
        Interrupt(); // The Drive of the cycle before is lost.
    }
    sequence_ += kChallengeStep;
    challenge_ = sequence_ | kLowestBit;
    return IsArmed() ? challenge_ : 0U;
}

void OutputGate::Drive(const PermitSet& permits, const Instant now) noexcept
{
    const std::uint32_t challenge = challenge_;
    challenge_ = 0U;
    // The masks that open are those that were judged: a wrong address cannot give answers of one place and masks of
    // another.
    const PermitSet given = permits;
    const bool is_right = Probe(given, challenge) == ProbeAnswer::kAccepted;
    if (is_right && IsArmed())
    {
        open_ = given.a.mask & given.b.mask & given.kernel.mask;
        NoteClosed(permits);
        driven_ = now;
        driven_copy_ = Instant{~now.us};
    }
    else if ((challenge == 0U) && IsEmpty(given))
    {
        Arm();
    }
    else
    {
        Interrupt();
    }
}

// A call of its own, which reads the permits anew: no register ever holds the bits of both copies.
void OutputGate::NoteClosed(const PermitSet& permits) noexcept
{
    open_copy_ = ~(permits.a.mask & permits.b.mask & permits.kernel.mask);
}

ProbeAnswer OutputGate::Probe(const PermitSet& permits, const std::uint32_t challenge) noexcept
{
    const bool a_right = IsRight(permits.a, PermitKey{challenge, kPermitConstantA});
    const bool b_right = IsRight(permits.b, PermitKey{challenge, kPermitConstantB});
    const bool kernel_right = IsRight(permits.kernel, PermitKey{challenge, kPermitConstantKernel});
    const bool all_right = a_right && b_right && kernel_right;
    return ((challenge != 0U) && all_right) ? ProbeAnswer::kAccepted : ProbeAnswer::kRefused;
}

SrdoMask OutputGate::Open(const Instant now, const GateLimit limit) noexcept
{
    const std::uint32_t elapsed = now.us - driven_.us;
    const std::uint32_t elapsed_copy = now.us - ~driven_copy_.us;
    // The bits of both together are at least as much as the greater one: no copy alone can make the time shorter.
    const bool is_late = (elapsed | elapsed_copy) > limit.us;
    if (is_late || (open_ != ~open_copy_))
    {
        Interrupt();
    }
    return open_ & ~open_copy_;
}

void OutputGate::Close() noexcept
{
    open_ = 0U;
    open_copy_ = ~open_;
}

// A bit that was otherwise and comes back arms nothing. [SRS_HAL_302]
bool OutputGate::IsArmed() noexcept
{
    const bool is_armed = (armed_ == kArmed) && (armed_copy_ == ~kArmed);
    if (!is_armed)
    {
        armed_ = kInterrupted;
        armed_copy_ = kInterrupted;
    }
    return is_armed;
}

void OutputGate::Arm() noexcept
{
    Close();
    armed_ = kArmed;
    armed_copy_ = ~kArmed;
}

// What was closed was not interrupted: a peer that does not run yet, the start. Either copy may say that a slot is
// open. [SRS_HAL_300]
void OutputGate::Interrupt() noexcept
{
    if ((open_ | ~open_copy_) != 0U)
    {
        armed_ = kInterrupted;
        armed_copy_ = kInterrupted;
    }
    Close();
}

} // namespace counterpoint::hal
