// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_SELFTEST_SELF_TEST_HPP
#define SAFETY_CORE_SELFTEST_SELF_TEST_HPP

#include "safety_core/kernel/self_test_part.hpp"
#include "safety_core/selftest/memory_signature.hpp"
#include "safety_core/selftest/parts_check.hpp"
#include "safety_core/selftest/permit_test.hpp"
#include "safety_core/selftest/ram_test.hpp"
#include "safety_core/selftest/stack_guard.hpp"

#include <cstdint>

namespace counterpoint::selftest
{

/// The self tests, as they are named in reports.
enum class TestId : std::uint8_t
{
    kInvalid = 0U, ///< Never started.
    kParts = 1U,
    kStack = 2U,
    kProgram = 3U,   ///< Signature with a given value.
    kConstants = 4U, ///< Signature over what is constant after the start.
    kRam = 5U,
    kPermits = 6U,
    kSchedule = 7U, ///< A round of all slices did not end when it had to.
    kNone = 0x5AU,
};
constexpr std::uint8_t kTestCount = 6U;

/// What became of one test at the start.
enum class TestState : std::uint8_t
{
    kInvalid = 0U, ///< Not done.
    kPassed = 0x69U,
    kFailed = 1U,
    kUnusable = 2U, ///< Its setup cannot be used.
};

/// What the start-up test as a whole came to.
enum class StartAnswer : std::uint8_t
{
    kInvalid = 0U,
    kPassed = 0x69U,
    kUnusable = 1U, ///< The setup of `first_failed` cannot be used.
    kInterval = 2U, ///< The slices do not fit into the diagnostic interval.
    kFailed = 3U,   ///< `first_failed` found a defect.
};

/// Result of the start-up test, and how long a round takes.
struct StartReport
{
    StartAnswer answer;
    TestId first_failed;
    TestState states[kTestCount]; ///< By TestId less 1. // MISRA D-001
    std::uint32_t cycles;         ///< What a round and the longest pass of a signature take: the interval needed.
};

/// What each test works on. All arrays are kept by reference and outlive the self test.
struct SelfTestSetup
{
    PartsSetup parts;
    StackSetup stack;
    SignatureSetup program;
    SignatureSetup constants;
    RamSetup ram;
    std::uint32_t interval_cycles; ///< Diagnostic interval, in cycles as late as allowed.
};

/// What the self tests work with; all outlive them.
struct SelfTestPorts
{
    hal::MemoryAccess& memory;
    hal::InterruptLock& lock;
    const hal::SafetyOutput& output;
};

/// All self tests of a device: once completely at the start, then in slices, one a cycle, for ever. Zero-filled, it
/// reports a fault. After a failure it goes on failing until Start. [SRS_STS_060, SRS_STS_061, SRS_STS_062,
/// SRS_STS_210, SRS_STS_211, SRS_STS_212, SRS_STS_213]
class SelfTest final : public SelfTestPart
{
  public:
    /// @brief Nothing is tested before Start.
    explicit SelfTest(const SelfTestPorts& ports) noexcept;

    /// @brief Runs every test once, completely. Call it before Kernel::Start. O(all memory)
    [[nodiscard]] StartReport Start(const SelfTestSetup& setup) noexcept;
    /// @brief Checks parts and stack guard, and does one slice of the other tests. Once a cycle. O(slice)
    [[nodiscard]] SelfTestOutcome OnCycle() noexcept override;

    /// @brief The test that failed first since Start; kNone while all is well.
    [[nodiscard]] TestId FirstFailed() const noexcept
    {
        return first_failed_;
    }
    /// @brief The RAM test, for its counts.
    [[nodiscard]] const RamTest& Ram() const noexcept
    {
        return ram_;
    }
    /// @brief Most bytes of the stack ever in use since Start. O(words)
    [[nodiscard]] std::uint32_t StackHighWaterBytes() const noexcept
    {
        return stack_.HighWaterBytes(ports_.memory);
    }

  private:
    /// @brief All tests begin anew.
    void Restart(const SelfTestSetup& setup) noexcept;
    /// @brief Whether each test can be used and one round and the longest pass fit into the interval; nothing is
    /// tested.
    [[nodiscard]] StartReport CheckSetup(const SelfTestSetup& setup) noexcept;
    /// @brief One whole pass of a test; it has to end with the last of so many slices.
    [[nodiscard]] TestState RunOnce(TestId test, std::uint32_t slices) noexcept;
    /// @brief One step of this test.
    [[nodiscard]] SliceResult Slice(TestId test) noexcept;
    /// @brief The first test that failed is kept.
    void Note(TestId test, SliceResult result) noexcept;
    /// @brief One slice of the test whose turn it is; a round that is shorter or longer than it has to be is a failure.
    void DoSlice() noexcept;
    /// @brief Grows by 1 with each whole cycle since the start-up test; a part left out, or done twice, makes it
    /// something else.
    [[nodiscard]] std::uint32_t Progress() const noexcept;

    SelfTestPorts ports_;
    PartsCheck parts_{};
    StackGuard stack_{};
    MemorySignature program_{};
    MemorySignature constants_{};
    RamTest ram_{};
    PermitTest permits_{};
    std::uint32_t round_slices_{0U};
    std::uint32_t round_done_{0U};
    TestId current_{TestId::kInvalid};
    TestId first_failed_{TestId::kInvalid};
};

} // namespace counterpoint::selftest

#endif
