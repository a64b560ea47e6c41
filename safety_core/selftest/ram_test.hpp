// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_SELFTEST_RAM_TEST_HPP
#define SAFETY_CORE_SELFTEST_RAM_TEST_HPP

#include "hal/api/interrupt_lock.hpp"
#include "safety_core/selftest/slice.hpp"

#include <cstdint>

namespace counterpoint::selftest
{

constexpr std::uint8_t kMaxRamSliceWords = 16U;
constexpr std::uint8_t kMinRamSliceWords = 2U;

/// Holds the words of the slice that is being tested.
struct RamWorkspace
{
    std::uint32_t saved[kMaxRamSliceWords]; // MISRA D-001
};

/// The spans are memory in use; none may hold this test, its workspace, its memory access or its interrupt lock.
struct RamSetup
{
    SpanList memory;
    RamWorkspace* workspace;
    std::uint8_t slice_words; ///< kMinRamSliceWords to kMaxRamSliceWords.
};

/// The words of one slice: neighbours, or two words whose addresses differ in one line.
struct RamWindow
{
    hal::Address first;
    hal::Address stride;
    std::uint8_t count;
    /// So many words from the first on have their bits tested against each other in this slice; the others in another
    /// slice.
    std::uint8_t own;
};

/// What a test of RAM works with; both outlive the call.
struct RamPorts
{
    hal::MemoryAccess& memory;
    hal::InterruptLock& lock;
};

/// March test over live memory, some words a call, contents kept. Zero-filled, it fails. [SRS_STS_010, SRS_STS_011,
/// SRS_STS_214, SRS_STS_215, SRS_STS_012, SRS_STS_013]
class RamTest
{
  public:
    /// @brief Begins the first pass. The arrays of `setup` are kept by reference.
    void Restart(const RamSetup& setup) noexcept;
    /// @brief Slices of one pass; 0 for a setup that cannot be used with these ports. O(spans)
    [[nodiscard]] std::uint32_t SlicesAPass(const RamPorts& ports) const noexcept;
    /// @brief The next slice. Only with a setup that can be used. O(slice_words)
    [[nodiscard]] SliceResult Slice(const RamPorts& ports) noexcept;
    /// @brief Slices done since Restart, modular.
    [[nodiscard]] std::uint32_t Done() const noexcept
    {
        return done_;
    }
    /// @brief Slices left out since Restart because they were too near to the running stack position, modular.
    [[nodiscard]] std::uint32_t LeftOut() const noexcept
    {
        return left_out_;
    }

  private:
    /// @brief Whether the span leaves out what the test itself works with.
    [[nodiscard]] bool IsFree(const RamPorts& ports, const hal::MemorySpan& span) const noexcept;
    /// @brief Words of the slice that is next: neighbours, or two that differ in one address line.
    [[nodiscard]] RamWindow Current(const hal::MemorySpan& span) const noexcept;
    /// @brief Position of the next slice; kPassed behind the last one of a pass.
    [[nodiscard]] SliceResult Advance(const hal::MemorySpan& span) noexcept;
    /// @brief Tests the window and puts its contents back; 0 where every word was as it had to be. The caller has
    /// locked interrupts.
    [[nodiscard]] std::uint32_t TestWindow(const RamWindow& window, hal::MemoryAccess& memory) noexcept;

    RamSetup setup_{{nullptr, 0U}, nullptr, 0U};
    hal::Address stride_{0U}; ///< 0: neighbours; else the line of the next pair.
    std::uint32_t word_{0U};
    std::uint32_t done_{0U};
    std::uint32_t left_out_{0U};
    std::uint8_t span_{0U};
};

} // namespace counterpoint::selftest

#endif
