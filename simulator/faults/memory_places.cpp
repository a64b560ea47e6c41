// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/faults/memory_places.hpp"

namespace counterpoint::simulator
{
namespace
{
// The language lets an explicit instantiation name private members. That is how a fault gets at the kernel's memory
// without the kernel knowing: each one below says, before the program begins, where a member is.
template <typename Owner, typename Member, int kNumber = 0> Member Owner::* opened{};
template <auto kMember, auto& kPlace> struct Opener
{
    static inline const bool kIsOpen = ((kPlace = kMember), true);
};
template struct Opener<&Kernel::context_, opened<Kernel, KernelContext>>;
template struct Opener<&Kernel::decision_, opened<Kernel, Decision>>;
template struct Opener<&Kernel::production_, opened<Kernel, Production>>;
template struct Opener<&Kernel::flow_, opened<Kernel, FlowMonitor>>;
template struct Opener<&FlowMonitor::signature_, opened<FlowMonitor, std::uint32_t>>;
template struct Opener<&FlowMonitor::ended_, opened<FlowMonitor, std::uint32_t, 1>>;
template struct Opener<&Kernel::clocks_, opened<Kernel, ClockSupervisor>>;
template struct Opener<&Kernel::run_, opened<Kernel, KernelRun>>;
template struct Opener<&Decision::comparator_, opened<Decision, Comparator>>;
template struct Opener<&Decision::committed_, opened<Decision, SrdoMask>>;
template struct Opener<&Decision::self_test_, opened<Decision, ComparatorSelfTest>>;
template struct Opener<&ComparatorSelfTest::begun_, opened<ComparatorSelfTest, Instant>>;
template struct Opener<&Production::requests_, opened<Production, SrdoMask>>;
template struct Opener<&Production::now_, opened<Production, Instant>>;
template struct Opener<&Production::gfc_until_, opened<Production, Instant, 1>>;
template struct Opener<&ConfigurationGuard::valid_, opened<ConfigurationGuard, std::uint8_t>>;
template struct Opener<&ConfigurationGuard::diagnosis_, opened<ConfigurationGuard, ConfigurationDiagnosis>>;
template struct Opener<&ConfigurationDiagnosis::begun_, opened<ConfigurationDiagnosis, Instant>>;

template <typename Object> MemoryPiece PieceOf(Object& object)
{
    return {reinterpret_cast<std::uint8_t*>(&object), sizeof(object)};
}

} // namespace

std::vector<MemoryPiece> PiecesOf(const Part part, Kernel& kernel, FlowFaults* const flow)
{
    KernelContext& context = kernel.*opened<Kernel, KernelContext>;
    Decision& decision = kernel.*opened<Kernel, Decision>;
    if (part == Part::kLatch)
    {
        return {PieceOf(context.latch)};
    }
    if (part == Part::kComparator)
    {
        return {PieceOf(decision.*opened<Decision, Comparator>)};
    }
    if (part == Part::kFlowMonitor)
    {
        FlowMonitor& monitor = (flow == nullptr) ? kernel.*opened<Kernel, FlowMonitor> : flow->Monitor();
        return {PieceOf(monitor.*opened<FlowMonitor, std::uint32_t>),
                PieceOf(monitor.*opened<FlowMonitor, std::uint32_t, 1>)};
    }
    if (part == Part::kClocks)
    {
        return {PieceOf(kernel.*opened<Kernel, ClockSupervisor>)};
    }
    if (part == Part::kGuard)
    {
        ConfigurationDiagnosis& diagnosis = context.guard.*opened<ConfigurationGuard, ConfigurationDiagnosis>;
        return {PieceOf(context.guard.*opened<ConfigurationGuard, std::uint8_t>),
                PieceOf(diagnosis.*opened<ConfigurationDiagnosis, Instant>)};
    }
    KernelRun& run = kernel.*opened<Kernel, KernelRun>;
    Production& production = kernel.*opened<Kernel, Production>;
    ComparatorSelfTest& self_test = decision.*opened<Decision, ComparatorSelfTest>;
    return {PieceOf(decision.*opened<Decision, SrdoMask>),
            PieceOf(production.*opened<Production, SrdoMask>),
            PieceOf(production.*opened<Production, Instant>),
            PieceOf(production.*opened<Production, Instant, 1>),
            PieceOf(run.cycle),
            PieceOf(self_test.*opened<ComparatorSelfTest, Instant>),
            PieceOf(run.queue)};
}

std::vector<MemoryPiece> PiecesOf(const Part part, runtime::DeviceModel& model, const std::uint8_t srdo)
{
    std::vector<MemoryPiece> pieces;
    if (part == Part::kVariables)
    {
        return {{model.Memory().data(), model.Memory().size()}};
    }
    if (part == Part::kObjects)
    {
        for (MappableObject& object : model.ObjectTable())
        {
            pieces.push_back(PieceOf(object.index));
            pieces.push_back(PieceOf(object.sub));
            pieces.push_back(PieceOf(object.access));
        }
        return pieces;
    }
    const SlotIndex slot = model.SlotOf(srdo).value_or(0U);
    SrdoSetup& setup = model.SetupTable()[slot];
    if (part == Part::kSetup)
    {
        pieces = {PieceOf(setup.number), PieceOf(setup.policy), PieceOf(setup.form), PieceOf(setup.detection)};
    }
    pieces.push_back(PieceOf(setup.safe_value));
    runtime::StaticTable* const table = model.StaticTableOf(model.NumberOf(slot));
    if (part == Part::kSetup && table != nullptr)
    {
        // The places the pointer leads to, not the pointer: a wild one is the processor's affair.
        pieces.push_back(PieceOf(setup.map.count));
        pieces.push_back(
            {reinterpret_cast<std::uint8_t*>(table->entries.data()), table->count * sizeof(std::uint32_t)});
    }
    return pieces;
}

std::size_t SizeOf(const std::vector<MemoryPiece>& pieces)
{
    std::size_t size = 0U;
    for (const MemoryPiece& piece : pieces)
    {
        size += piece.size;
    }
    return size;
}

void FlipIn(const std::vector<MemoryPiece>& pieces, const std::size_t offset, const std::uint8_t bit)
{
    std::size_t place = offset;
    for (const MemoryPiece& piece : pieces)
    {
        if (place < piece.size)
        {
            piece.bytes[place] = static_cast<std::uint8_t>(piece.bytes[place] ^ (1U << bit));
            return;
        }
        place -= piece.size;
    }
}
} // namespace counterpoint::simulator
