// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/kernel_places.hpp"

#include <cstddef>

// The members of the kernel are private. A structure with the same members lies in memory alike, so that each of them
// has a name; that both are of one size is checked when this is compiled.
namespace counterpoint::campaign
{
namespace
{
struct DecisionShape
{
    SrdoMask committed;
    std::uint16_t demotions;
    Verdict verdict;
    ComparatorSelfTest self_test;
    Comparator comparator;
};
static_assert(sizeof(DecisionShape) == sizeof(Decision), "the members of the decision");

struct KernelShape
{
    KernelRun run;
    SecondNmt second_nmt;
    FlowMonitor flow;
    KernelContext context;
    ClockSupervisor clocks;
    Reporting reporting;
    Production production;
    Decision decision;
};
static_assert(sizeof(KernelShape) == sizeof(Kernel), "the members of the kernel");

struct Member
{
    Part part;
    const char* name;
    std::size_t offset;
    std::size_t size;
};

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Winvalid-offsetof"
constexpr std::size_t kContext = offsetof(KernelShape, context);
constexpr std::size_t kDecision = offsetof(KernelShape, decision);
constexpr Member kMembers[] = {
    {Part::kKernel, "kernel.run", offsetof(KernelShape, run), sizeof(KernelRun)},
    {Part::kKernel, "kernel.second_nmt", offsetof(KernelShape, second_nmt), sizeof(SecondNmt)},
    {Part::kKernel, "kernel.parts", kContext + offsetof(KernelContext, parts), sizeof(KernelParts)},
    {Part::kKernel, "kernel.seal", kContext + offsetof(KernelContext, seal), sizeof(std::uintptr_t)},
    {Part::kKernel, "kernel.config", kContext + offsetof(KernelContext, config), sizeof(const DeviceConfig*)},
    {Part::kLatch, "latch", kContext + offsetof(KernelContext, latch), sizeof(SafeStateLatch)},
    {Part::kGuard, "guard", kContext + offsetof(KernelContext, guard), sizeof(ConfigurationGuard)},
    {Part::kClocks, "clocks", offsetof(KernelShape, clocks), sizeof(ClockSupervisor)},
    {Part::kKernel, "kernel.reporting", offsetof(KernelShape, reporting), sizeof(Reporting)},
    {Part::kKernel, "kernel.production", offsetof(KernelShape, production), sizeof(Production)},
    {Part::kKernel, "kernel.committed", kDecision + offsetof(DecisionShape, committed), sizeof(SrdoMask)},
    {Part::kKernel, "kernel.demotions", kDecision + offsetof(DecisionShape, demotions), sizeof(std::uint16_t)},
    {Part::kComparator, "comparator.verdict", kDecision + offsetof(DecisionShape, verdict), sizeof(Verdict)},
    {Part::kComparator, "comparator.self_test", kDecision + offsetof(DecisionShape, self_test),
     sizeof(ComparatorSelfTest)},
    {Part::kComparator, "comparator.object", kDecision + offsetof(DecisionShape, comparator), sizeof(Comparator)},
};
#pragma GCC diagnostic pop
} // namespace

std::vector<Place> PlacesOf(const Kernel& kernel, const Region& region)
{
    std::vector<Place> places;
    for (const Member& member : kMembers)
    {
        places.push_back({member.part, member.name, region.OffsetOf(&kernel) + member.offset, member.size});
    }
    return places;
}
} // namespace counterpoint::campaign
