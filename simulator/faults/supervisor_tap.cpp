// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/faults/supervisor_tap.hpp"

#include "simulator/faults/told.hpp"

// The linker's --wrap=SYMBOL leads every call of SYMBOL to __wrap_SYMBOL and gives the shipped function the name
// __real_SYMBOL. A member function takes its object as first argument (Itanium C++ ABI), so that plain functions with
// these names can stand in for it.

namespace counterpoint::simulator
{
namespace
{
/// A5h, a valid configuration, in each byte: see CycleInput::guard_token.
constexpr std::uint32_t kValidToken = 0xA5A5A5A5U;

thread_local SupervisorTap* active_tap = nullptr;

} // namespace

Verdict RealCompare(Comparator& self, const Comparison& comparison) noexcept
    __asm__("__real__ZN12counterpoint10Comparator7CompareERKNS_10ComparisonE");
std::uint32_t RealGuardCycle(ConfigurationGuard& self, std::uint32_t challenge, Instant now) noexcept
    __asm__("__real__ZN12counterpoint18ConfigurationGuard5CycleEjNS_7InstantE");

Verdict WrapCompare(Comparator& self, const Comparison& comparison) noexcept
    __asm__("__wrap__ZN12counterpoint10Comparator7CompareERKNS_10ComparisonE");
std::uint32_t WrapGuardCycle(ConfigurationGuard& self, std::uint32_t challenge, Instant now) noexcept
    __asm__("__wrap__ZN12counterpoint18ConfigurationGuard5CycleEjNS_7InstantE");

Verdict WrapCompare(Comparator& self, const Comparison& comparison) noexcept
{
    SupervisorTap* const tap = active_tap;
    return (tap == nullptr) ? RealCompare(self, comparison) : tap->Compare(self, comparison);
}

std::uint32_t WrapGuardCycle(ConfigurationGuard& self, const std::uint32_t challenge, const Instant now) noexcept
{
    SupervisorTap* const tap = active_tap;
    return (tap == nullptr) ? RealGuardCycle(self, challenge, now) : tap->GuardCycle(self, challenge, now);
}

SupervisorTap::SupervisorTap(PartFaults& faults) noexcept : faults_(faults)
{
}

SupervisorTap::Scope::Scope(SupervisorTap* const tap) noexcept
{
    active_tap = tap;
}

SupervisorTap::Scope::~Scope()
{
    active_tap = nullptr;
}

Verdict SupervisorTap::Compare(Comparator& self, const Comparison& comparison) noexcept
{
    return Told(
        EffectiveAnswerOf(faults_, Part::kComparator), verdict_, [&]() { return RealCompare(self, comparison); },
        [&comparison]()
        {
            // Fresh echo and all: whatever channel A releases is agreed and matched.
            Verdict good{};
            good.agreement = {comparison.outcome_a->released, ~SrdoMask{0U}};
            good.start = comparison.outcome_a->due;
            good.newly_matched = comparison.outcome_a->fresh;
            good.echo = comparison.challenge;
            good.fault = DeviceFault::kNone;
            good.slot = kNoSlot;
            return good;
        });
}

std::uint32_t SupervisorTap::GuardCycle(ConfigurationGuard& self, const std::uint32_t challenge,
                                        const Instant now) noexcept
{
    return Told(
        EffectiveAnswerOf(faults_, Part::kGuard), token_, [&]() { return RealGuardCycle(self, challenge, now); },
        [challenge]() { return ((challenge << 8U) | (challenge >> 24U)) ^ kValidToken; });
}
} // namespace counterpoint::simulator
