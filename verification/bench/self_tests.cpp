// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/bench/self_tests.hpp"

#include "hal/api/output_gate.hpp"
#include "hal/api/plain_memory.hpp"
#include "safety_core/selftest/self_test.hpp"
#include "verification/bench/meter.hpp"

namespace counterpoint::bench
{
namespace
{

using selftest::PermitTest;
using selftest::SelfTest;
using selftest::StartAnswer;

constexpr std::uint16_t kSignatureSliceWords = 24U;
constexpr std::uint8_t kRamSliceWords = 4U;
constexpr std::uint8_t kParts = 8U;
constexpr std::uint8_t kGuardWords = 4U;
constexpr std::uint32_t kSignatureSlices = 64U;
// Windows of four words that share one: 3 * 64 + 1 words.
constexpr std::uint32_t kWindows = 64U;
constexpr std::uint32_t kConstantWords = 24U;

// In static storage: too large for the stack of a target, and far from the running position.
std::uint32_t program[kSignatureSlices * kSignatureSliceWords];
std::uint32_t constants[kConstantWords];
std::uint32_t ram[(kWindows * (kRamSliceWords - 1U)) + 1U];
std::uint32_t stack[64];
selftest::RamWorkspace workspace;

/// Locking takes an instruction or two on a target, a call of the system on a host: not the self tests' cost.
class NoLock final : public hal::InterruptLock
{
  public:
    void Lock() noexcept override
    {
    }
    void Unlock() noexcept override
    {
    }
};

class ProbedGate final : public hal::SafetyOutput
{
  public:
    [[nodiscard]] std::uint32_t Challenge() noexcept override
    {
        return gate_.Challenge();
    }
    void Drive(const hal::PermitSet& permits) noexcept override
    {
        gate_.Drive(permits, Instant{0U});
    }
    [[nodiscard]] hal::ProbeAnswer Probe(const hal::PermitSet& permits,
                                         const std::uint32_t challenge) const noexcept override
    {
        return hal::OutputGate::Probe(permits, challenge);
    }

  private:
    hal::OutputGate gate_{};
};

/// One kind of slice.
struct Phase
{
    const char* item;
    std::uint32_t cycles;
};

[[nodiscard]] bool MeasurePhase(SelfTest& self_test, const Phase& phase) noexcept
{
    bool is_well = true;
    MeterReset();
    for (std::uint32_t cycle = 0U; cycle < phase.cycles; ++cycle)
    {
        MeterBegin();
        const SelfTestOutcome outcome = self_test.OnCycle();
        MeterEnd();
        is_well = is_well && (outcome.fault == DeviceFault::kNone);
    }
    MeterReport({phase.item, 1U, phase.cycles});
    return is_well;
}

} // namespace

BenchResult MeasureSelfTests() noexcept
{
    hal::PlainMemory memory{};
    NoLock lock{};
    ProbedGate output{};
    SelfTest self_test{selftest::SelfTestPorts{memory, lock, output}};
    hal::Address parts[kParts];
    for (hal::Address& part : parts)
    {
        part = memory.PlaceOf(&output);
    }
    const hal::MemorySpan program_span{memory.PlaceOf(program), sizeof program / hal::kWordBytes};
    const hal::MemorySpan constants_span{memory.PlaceOf(constants), kConstantWords};
    const hal::MemorySpan ram_span{memory.PlaceOf(ram), sizeof ram / hal::kWordBytes};
    constexpr auto kTaken = selftest::SignatureSource::kTaken;
    const selftest::SelfTestSetup setup{{parts, kParts},
                                        {{memory.PlaceOf(stack), sizeof stack / hal::kWordBytes}, kGuardWords},
                                        {{&program_span, 1U}, kSignatureSliceWords, kTaken, 0U},
                                        {{&constants_span, 1U}, kSignatureSliceWords, kTaken, 0U},
                                        {{&ram_span, 1U}, &workspace, kRamSliceWords},
                                        1000U};
    const selftest::StartReport report = self_test.Start(setup);
    if (report.answer != StartAnswer::kPassed)
    {
        return BenchResult::kNotStarted;
    }
    // What is left of a round after its windows are the address lines of the RAM and the permits.
    const std::uint32_t lines =
        report.cycles - kSignatureSlices - (kSignatureSlices + 1U) - kWindows - PermitTest::kSlicesAPass;
    const Phase phases[] = {{"selftest_signature", kSignatureSlices},
                            {"selftest_constants", 1U},
                            {"selftest_ram", kWindows},
                            {"selftest_lines", lines},
                            {"selftest_permits", PermitTest::kSlicesAPass}};
    bool is_well = true;
    for (const Phase& phase : phases)
    {
        is_well = MeasurePhase(self_test, phase) && is_well;
    }
    return is_well ? BenchResult::kDone : BenchResult::kFaulted;
}

} // namespace counterpoint::bench
