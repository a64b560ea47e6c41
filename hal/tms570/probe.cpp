// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/tms570/probe.hpp"

#include "hal/tms570/chip/shared.hpp"
#include "hal/tms570/diagnosis/esm.hpp"

namespace counterpoint::tms570
{

namespace
{

// A handler gets nothing from whoever armed it but what stands at a fixed place.
Shared<ProbeKind> armed_kind{ProbeKind::kInvalid}; // MISRA D-007
Shared<std::uint32_t> armed_place{0U};             // MISRA D-007

/// The hardware tells the double word.
constexpr std::uint32_t kUnitMask = ~7U;

[[nodiscard]] bool IsReported(const ProbeKind kind) noexcept
{
    const std::uint32_t group_3 = ReadEsm().group_3;
    switch (kind)
    {
    case ProbeKind::kEvenRam:
        return (group_3 & kEsm3EvenRam) != 0U;
    case ProbeKind::kOddRam:
        return (group_3 & kEsm3OddRam) != 0U;
    case ProbeKind::kFlash:
        return (group_3 & kEsm3Flash) != 0U;
    case ProbeKind::kInvalid:
        break;
    }
    return false;
}

} // namespace

void ArmProbe(const ProbeKind kind, const Register place) noexcept
{
    armed_place.Store(place.address);
    armed_kind.Store(kind);
}

bool IsProvoked(const AbortFacts& facts) noexcept
{
    const ProbeKind kind = armed_kind.Load();
    armed_kind.Store(ProbeKind::kInvalid);
    const bool same_place = (facts.accessed & kUnitMask) == (armed_place.Load() & kUnitMask);
    const bool is_probe = facts.instruction == ProbeInstruction();
    const bool is_access = facts.cause == hal::ExceptionCause::kDataAccess;
    return same_place && is_probe && is_access && IsReported(kind);
}

} // namespace counterpoint::tms570
