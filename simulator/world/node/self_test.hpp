// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_NODE_SELF_TEST_HPP
#define SIMULATOR_WORLD_NODE_SELF_TEST_HPP

#include "simulator/faults/part_faults.hpp"
#include "simulator/world/node/image.hpp"
#include "simulator/world/node/memory.hpp"

#include "hal/api/safety_output.hpp"
#include "safety_core/kernel/self_test_part.hpp"
#include "safety_core/selftest/self_test.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace counterpoint::simulator
{
/// The shipped self tests over the memory of one node. Between them and the kernel: the faults of the self test as a
/// part. [SRS_SIM_052, SRS_SIM_054]
class NodeSelfTest final : public SelfTestPart
{
  public:
    /// @brief All outlive it; `output` is what the kernel drives.
    NodeSelfTest(NodeMemory& memory, NodeImage& image, const hal::SafetyOutput& output, PartFaults& faults) noexcept;

    /// @brief The pieces of live memory, and what is constant after the start.
    void AddLive(void* bytes, std::size_t size)
    {
        live_.push_back(memory_.Add(bytes, size));
    }
    void AddConstant(const void* bytes, std::size_t size);
    /// @brief After everything was added: slices as small as a round within so many cycles allows.
    /// False: it cannot be done.
    [[nodiscard]] bool Settle(std::uint32_t interval_cycles);
    /// @brief The start-up test.
    void Start();
    [[nodiscard]] SelfTestOutcome OnCycle() noexcept override;
    /// @brief The first test that failed; kNone: none did.
    [[nodiscard]] selftest::TestId FirstFailed() const noexcept
    {
        return self_test_.FirstFailed();
    }

  private:
    [[nodiscard]] SelfTestOutcome Said() noexcept;
    [[nodiscard]] bool Fits(std::uint8_t ram_words, std::uint16_t signature_words, std::uint32_t interval_cycles);

    NodeMemory& memory_;
    NodeImage& image_;
    PartFaults& faults_;
    NodeLock lock_{};
    selftest::RamWorkspace workspace_{};
    std::vector<hal::MemorySpan> live_;
    std::vector<hal::MemorySpan> constants_;
    std::vector<hal::Address> parts_;
    hal::MemorySpan program_span_{0U, 0U};
    selftest::SelfTestSetup setup_{};
    selftest::SelfTest self_test_;
    SelfTestOutcome said_{};
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_NODE_SELF_TEST_HPP
