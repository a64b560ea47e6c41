// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/world/node/self_test.hpp"

#include <algorithm>

namespace counterpoint::simulator
{
namespace
{
using selftest::SignatureSource;

/// Words of a signature that are read in a cycle at most: what the largest slice of a march takes.
constexpr std::uint16_t kMostSignatureWords = 64U;

selftest::SignatureSetup Whole(const selftest::SpanList& memory)
{
    return {memory, 0xFFFFU, SignatureSource::kTaken, 0U};
}

/// One pass by a signature of its own: what whoever makes the image knows.
std::uint32_t ValueOf(const selftest::SpanList& memory, const NodeMemory& cells)
{
    selftest::MemorySignature signature;
    signature.Restart(Whole(memory));
    for (std::uint32_t slice = signature.SlicesAPass(); slice > 0U; --slice)
    {
        static_cast<void>(signature.Slice(cells));
    }
    return signature.Value();
}

selftest::SpanList ListOf(const std::vector<hal::MemorySpan>& spans)
{
    return {spans.data(), static_cast<std::uint8_t>(spans.size())};
}
} // namespace

NodeSelfTest::NodeSelfTest(NodeMemory& memory, NodeImage& image, const hal::SafetyOutput& output,
                           PartFaults& faults) noexcept
    : memory_(memory), image_(image), faults_(faults), self_test_({memory, lock_, output})
{
}

void NodeSelfTest::AddConstant(const void* const bytes, const std::size_t size)
{
    constants_.push_back(memory_.Add(const_cast<void*>(bytes), size)); // Only read.
}

bool NodeSelfTest::Fits(const std::uint8_t ram_words, const std::uint16_t signature_words,
                        const std::uint32_t interval_cycles)
{
    setup_.program.slice_words = signature_words;
    setup_.constants.slice_words = signature_words;
    setup_.ram.slice_words = ram_words;
    selftest::MemorySignature program;
    selftest::MemorySignature constants;
    selftest::RamTest ram;
    program.Restart(setup_.program);
    constants.Restart(setup_.constants);
    ram.Restart(setup_.ram);
    const std::uint32_t once = program.SlicesAPass() + constants.SlicesAPass() + ram.SlicesAPass({memory_, lock_}) +
                               selftest::PermitTest::kSlicesAPass;
    return once + std::max(program.SlicesAPass(), constants.SlicesAPass()) <= interval_cycles;
}

bool NodeSelfTest::Settle(const std::uint32_t interval_cycles)
{
    program_span_ = memory_.Add(image_.program.data(), image_.program.size() * sizeof(std::uint32_t));
    for (void* const part : image_.parts)
    {
        parts_.push_back(memory_.Add(part, sizeof(void*)).first);
    }
    const hal::MemorySpan stack = memory_.Add(image_.stack.data(), sizeof image_.stack);
    const selftest::SpanList program{&program_span_, 1U};
    setup_.parts = {parts_.data(), static_cast<std::uint8_t>(parts_.size())};
    setup_.stack = {stack, NodeImage::kGuardWords};
    setup_.program = {program, 0U, SignatureSource::kGiven, ValueOf(program, memory_)};
    setup_.constants = {ListOf(constants_), 0U, SignatureSource::kTaken, 0U};
    setup_.ram = {ListOf(live_), &workspace_, 0U};
    setup_.interval_cycles = interval_cycles;
    std::uint8_t ram_words = selftest::kMinRamSliceWords;
    while (ram_words < selftest::kMaxRamSliceWords && !Fits(ram_words, kMostSignatureWords, interval_cycles))
    {
        ++ram_words;
    }
    std::uint16_t signature_words = 1U;
    while (signature_words < kMostSignatureWords && !Fits(ram_words, signature_words, interval_cycles))
    {
        ++signature_words;
    }
    return Fits(ram_words, signature_words, interval_cycles);
}

// A start-up test that fails leaves the self test failing: the kernel will hear it in its first cycle.
void NodeSelfTest::Start()
{
    said_ = SelfTestOutcome{};
    static_cast<void>(self_test_.Start(setup_));
}

SelfTestOutcome NodeSelfTest::Said() noexcept
{
    switch (faults_.AnswerOf(Part::kSelfTest))
    {
    case PartAnswer::kOwn:
        said_ = self_test_.OnCycle();
        break;
    case PartAnswer::kLast:
        break;
    case PartAnswer::kZero:
        return SelfTestOutcome{};
    case PartAnswer::kGood:
        faults_.HasEffect(faults_.Condition(Part::kSelfTest));
        said_ = {said_.progress + 1U, DeviceFault::kNone, PartsView::kSound};
        break;
    }
    return said_;
}

// A kernel that hears that its parts are sound calls them. [SRS_SIM_055]
SelfTestOutcome NodeSelfTest::OnCycle() noexcept
{
    const SelfTestOutcome outcome = Said();
    if (outcome.parts == PartsView::kSound && image_.IsWild())
    {
        faults_.Trap();
    }
    return outcome;
}
} // namespace counterpoint::simulator
