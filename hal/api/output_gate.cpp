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

} // namespace

std::uint32_t OutputGate::Challenge() noexcept
{
    sequence_ += kChallengeStep;
    challenge_ = sequence_ | kLowestBit;
    return challenge_;
}

void OutputGate::Drive(const PermitSet& permits, const Instant now) noexcept
{
    const std::uint32_t challenge = challenge_;
    challenge_ = 0U;
    // The masks that open are those that were judged: a wrong address cannot give answers of one place and masks of
    // another.
    const PermitSet given = permits;
    if (Probe(given, challenge) == ProbeAnswer::kAccepted)
    {
        open_ = given.a.mask & given.b.mask & given.kernel.mask;
        NoteClosed(permits);
        driven_ = now;
        driven_copy_ = Instant{~now.us};
    }
    else
    {
        Close();
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
    if ((elapsed | elapsed_copy) > limit.us)
    {
        Close();
    }
    return open_ & ~open_copy_;
}

void OutputGate::Close() noexcept
{
    open_ = 0U;
    open_copy_ = ~open_;
}

} // namespace counterpoint::hal
