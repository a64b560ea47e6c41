// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// PBIST (reference manual, chapter "Programmable Built-In Self-Test (PBIST)"; facts/tms570 4). The program that must
// fail is the vendor's own: two words an instruction, of which nothing else is published.
#include "hal/tms570/diagnosis/built_in_tests.hpp"

#include "hal/tms570/chip/system_registers.hpp"

namespace counterpoint::tms570
{

namespace
{

using namespace system_module;

/// March 13N over a few KiB takes less than a millisecond; the ROMs are longer.
constexpr Looks kTestLooks{1000000U};
/// 32 cycles of the bus until the controller is there.
constexpr Looks kSettleLooks{64U};

constexpr std::uint32_t kFailSteps = 6U;
constexpr std::uint32_t kFailInstruction = 0x4C000001U;
constexpr std::uint32_t kFailOperand = 0x75U;
constexpr std::uint32_t kSecondWord = 0x40U;
constexpr std::uint32_t kWordBytes = 4U;
constexpr std::uint32_t kFailRam = 0x2000U;
constexpr std::uint32_t kByProcessor = 0x10U;
constexpr std::uint32_t kFromRom = 0x14U;
constexpr std::uint32_t kClocksOn = 0x3U;
constexpr std::uint32_t kRomAlgorithms = 0x3U; ///< Triple read slow and fast, for ROMs.
constexpr std::uint32_t kDualPortMarch = 0x4U; ///< March 13N for dual-port memories.

void Begin() noexcept
{
    Write(At(kPbist, kPbistActive), 0U);
    Write(At(kBase, kTestControl), kTestOff);
    Write(At(kBase, kInitControl), kKeyOff);
    Write(At(kBase, kTestStatus), kTestDone);
    Write(At(kBase, kTestControl), kTestOn);
    Write(At(kBase, kInitEnable), 1U);
    // The value never comes: only the time of the looks counts.
    static_cast<void>(WaitFor(At(kBase, kInitEnable), Bits{kWholeWord, 0U}, kSettleLooks));
    Write(At(kPbist, kPbistActive), kClocksOn);
}

[[nodiscard]] Outcome End() noexcept
{
    const Outcome done = WaitFor(At(kBase, kTestStatus), Bits{kTestDone, kTestDone}, kTestLooks);
    Write(At(kBase, kTestStatus), kTestDone);
    return done;
}

void Stop() noexcept
{
    Write(At(kPbist, kPbistActive), 0U);
    Write(At(kBase, kTestControl), kTestOff);
}

[[nodiscard]] bool HasFailed() noexcept
{
    return (Read(At(kPbist, kPbistFail0)) != 0U) || (Read(At(kPbist, kPbistFail1)) != 0U);
}

[[nodiscard]] Outcome MustFail() noexcept
{
    Begin();
    Write(At(kPbist, kPbistLogger), kByProcessor);
    Write(At(kPbist, kPbistRam), kFailRam);
    for (std::uint32_t step = 0U; step < kFailSteps; ++step)
    {
        Write(At(kPbist, step * kWordBytes), kFailInstruction + step);
        Write(At(kPbist, kSecondWord + (step * kWordBytes)), kFailOperand);
    }
    Write(At(kPbist, kFailSteps * kWordBytes), 0U);
    Write(At(kPbist, kSecondWord + (kFailSteps * kWordBytes)), 1U);
    Write(At(kPbist, kPbistRun), 1U);
    const Outcome done = End();
    const bool has_failed = HasFailed();
    Stop();
    return has_failed ? done : Outcome::kFailed;
}

[[nodiscard]] Outcome MustPass(const std::uint32_t groups, const std::uint32_t algorithms) noexcept
{
    Begin();
    Write(At(kPbist, kPbistAlgorithms), algorithms);
    Write(At(kPbist, kPbistGroupsLow), groups);
    Write(At(kPbist, kPbistGroupsHigh), 0U);
    Write(At(kPbist, kPbistOverride), 0U);
    Write(At(kPbist, kPbistRom), kClocksOn);
    Write(At(kPbist, kPbistLogger), kFromRom);
    const Outcome done = End();
    const bool has_failed = HasFailed();
    Stop();
    return has_failed ? Outcome::kFailed : done;
}

} // namespace

Outcome TestMemories(const MemorySelection& memories) noexcept
{
    // One after the other: a test that does not end must not be waited for three times.
    if (MustFail() != Outcome::kDone)
    {
        return Outcome::kFailed;
    }
    if (MustPass(memories.test_rom, kRomAlgorithms) != Outcome::kDone)
    {
        return Outcome::kFailed;
    }
    return MustPass(memories.test_memory, kDualPortMarch);
}

} // namespace counterpoint::tms570
