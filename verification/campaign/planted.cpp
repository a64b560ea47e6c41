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
} // namespace

std::uint32_t LooseOutput::Challenge() noexcept
{
    issued_ = FlatOutput::Challenge();
    return issued_;
}

void LooseOutput::Drive(const hal::PermitSet& permits) noexcept
{
    FlatOutput::Drive({Righted(permits.a, issued_, kPermitConstantA), Righted(permits.b, issued_, kPermitConstantB),
                       Righted(permits.kernel, issued_, kPermitConstantKernel)});
}
} // namespace counterpoint::campaign
