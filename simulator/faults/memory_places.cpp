// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/faults/memory_places.hpp"

namespace counterpoint::simulator
{
namespace
{
// The language lets an explicit instantiation name private members. That is how a fault gets at the kernel's memory
// without the kernel knowing: friend functions declared here, defined for each member named below.
template <typename Tag, typename Tag::Member kMember> struct Opened
{
    friend typename Tag::Member Open(Tag tag)
    {
        static_cast<void>(tag);
        return kMember;
    }
};

struct ContextTag
{
    using Member = KernelContext Kernel::*;
    friend Member Open(ContextTag tag);
};
struct DecisionTag
{
    using Member = Decision Kernel::*;
    friend Member Open(DecisionTag tag);
};
struct ProductionTag
{
    using Member = Production Kernel::*;
    friend Member Open(ProductionTag tag);
};
struct FlowTag
{
    using Member = FlowMonitor Kernel::*;
    friend Member Open(FlowTag tag);
};
struct ClocksTag
{
    using Member = ClockSupervisor Kernel::*;
    friend Member Open(ClocksTag tag);
};
struct RunTag
{
    using Member = KernelRun Kernel::*;
    friend Member Open(RunTag tag);
};
struct ComparatorTag
{
    using Member = Comparator Decision::*;
    friend Member Open(ComparatorTag tag);
};
struct CommittedTag
{
    using Member = SrdoMask Decision::*;
    friend Member Open(CommittedTag tag);
};
struct SelfTestTag
{
    using Member = ComparatorSelfTest Decision::*;
    friend Member Open(SelfTestTag tag);
};
struct TestBegunTag
{
    using Member = Instant ComparatorSelfTest::*;
    friend Member Open(TestBegunTag tag);
};
struct RequestsTag
{
    using Member = SrdoMask Production::*;
    friend Member Open(RequestsTag tag);
};
struct NowTag
{
    using Member = Instant Production::*;
    friend Member Open(NowTag tag);
};
struct GfcUntilTag
{
    using Member = Instant Production::*;
    friend Member Open(GfcUntilTag tag);
};
struct GuardValidTag
{
    using Member = std::uint8_t ConfigurationGuard::*;
    friend Member Open(GuardValidTag tag);
};
struct DiagnosisTag
{
    using Member = ConfigurationDiagnosis ConfigurationGuard::*;
    friend Member Open(DiagnosisTag tag);
};
struct DiagnosisBegunTag
{
    using Member = Instant ConfigurationDiagnosis::*;
    friend Member Open(DiagnosisBegunTag tag);
};

template struct Opened<ContextTag, &Kernel::context_>;
template struct Opened<DecisionTag, &Kernel::decision_>;
template struct Opened<ProductionTag, &Kernel::production_>;
template struct Opened<FlowTag, &Kernel::flow_>;
template struct Opened<ClocksTag, &Kernel::clocks_>;
template struct Opened<RunTag, &Kernel::run_>;
template struct Opened<ComparatorTag, &Decision::comparator_>;
template struct Opened<CommittedTag, &Decision::committed_>;
template struct Opened<SelfTestTag, &Decision::self_test_>;
template struct Opened<TestBegunTag, &ComparatorSelfTest::begun_>;
template struct Opened<RequestsTag, &Production::requests_>;
template struct Opened<NowTag, &Production::now_>;
template struct Opened<GfcUntilTag, &Production::gfc_until_>;
template struct Opened<GuardValidTag, &ConfigurationGuard::valid_>;
template struct Opened<DiagnosisTag, &ConfigurationGuard::diagnosis_>;
template struct Opened<DiagnosisBegunTag, &ConfigurationDiagnosis::begun_>;

template <typename Object> MemoryPiece PieceOf(Object& object)
{
    return {reinterpret_cast<std::uint8_t*>(&object), sizeof(object)};
}

std::vector<MemoryPiece> StateOf(Kernel& kernel)
{
    KernelRun& run = kernel.*Open(RunTag{});
    Decision& decision = kernel.*Open(DecisionTag{});
    Production& production = kernel.*Open(ProductionTag{});
    ComparatorSelfTest& self_test = decision.*Open(SelfTestTag{});
    return {PieceOf(decision.*Open(CommittedTag{})),
            PieceOf(production.*Open(RequestsTag{})),
            PieceOf(production.*Open(NowTag{})),
            PieceOf(production.*Open(GfcUntilTag{})),
            PieceOf(run.cycle),
            PieceOf(self_test.*Open(TestBegunTag{})),
            PieceOf(run.queue)};
}
} // namespace

std::vector<MemoryPiece> PiecesOf(const Part part, Kernel& kernel)
{
    switch (part)
    {
    case Part::kLatch:
        return {PieceOf((kernel.*Open(ContextTag{})).latch)};
    case Part::kComparator:
        return {PieceOf(kernel.*Open(DecisionTag{}).*Open(ComparatorTag{}))};
    case Part::kFlowMonitor:
        return {PieceOf(kernel.*Open(FlowTag{}))};
    case Part::kClocks:
        return {PieceOf(kernel.*Open(ClocksTag{}))};
    case Part::kGuard:
    {
        ConfigurationGuard& guard = (kernel.*Open(ContextTag{})).guard;
        return {PieceOf(guard.*Open(GuardValidTag{})), PieceOf(guard.*Open(DiagnosisTag{}).*Open(DiagnosisBegunTag{}))};
    }
    default:
        return StateOf(kernel);
    }
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
