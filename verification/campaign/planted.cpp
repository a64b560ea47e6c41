// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/planted.hpp"

namespace counterpoint::campaign
{
namespace
{
constexpr std::uint32_t kWordBits = 32U;
constexpr std::uint32_t kRotation = 16U;

/// The permit with the answer that the gate waits for, whatever the party answered. The defect.
Permit Righted(const Permit& given, const std::uint32_t challenge, const std::uint32_t constant)
{
    const auto low = static_cast<std::uint32_t>(given.mask);
    const auto high = static_cast<std::uint32_t>(given.mask >> kWordBits);
    const std::uint32_t rotated = (high << kRotation) | (high >> (kWordBits - kRotation));
    return {given.mask, ((challenge + low) ^ rotated) * constant};
}

hal::PermitSet Righted(const hal::PermitSet& given, const std::uint32_t challenge)
{
    return {Righted(given.a, challenge, kPermitConstantA), Righted(given.b, challenge, kPermitConstantB),
            Righted(given.kernel, challenge, kPermitConstantKernel)};
}
} // namespace

std::uint32_t LooseOutput::Challenge() noexcept
{
    issued_ = FlatOutput::Challenge();
    return issued_;
}

void LooseOutput::Drive(const hal::PermitSet& permits) noexcept
{
    FlatOutput::Drive(Righted(permits, issued_));
}

std::uint32_t HeldOutput::Challenge() noexcept
{
    issued_ = FlatOutput::Challenge();
    return issued_;
}

void HeldOutput::Drive(const hal::PermitSet& permits) noexcept
{
    const bool opens = Probe(permits, issued_) == hal::ProbeAnswer::kAccepted && permits.kernel.mask != 0U;
    last_ = opens ? permits : last_;
    FlatOutput::Drive(Righted(last_, issued_));
}
} // namespace counterpoint::campaign
