// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_NODE_SELF_TEST_HPP
#define SIMULATOR_WORLD_NODE_SELF_TEST_HPP

#include "simulator/faults/memory_places.hpp"
#include "simulator/faults/part_faults.hpp"
#include "simulator/world/node_memory.hpp"

#include "hal/api/safety_output.hpp"
#include "safety_core/contract/channel.hpp"
#include "safety_core/kernel/self_test_part.hpp"
#include "safety_core/selftest/self_test.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace counterpoint::simulator
{
/// What self tests and faults find in the memory of a node beside its channels and its kernel: its copy of the program,
/// its stack guard, the pointers to virtual tables. [SRS_SIM_052, SRS_SIM_053]
class NodeImage
{
  public:
    NodeImage() = default;

    /// @brief Copies the machine code of these channels and of the kernel, and the virtual tables: what a flash holds.
    void TakeProgram(const Channel& channel_a, const Channel& channel_b);
    /// @brief An object that begins with the pointer to its virtual table.
    void AddPart(void* part);
    /// @brief Power-on: what lies in RAM is as after the start of the program again.
    void RestorePointers();
    /// @brief Whether a call of one of the parts would lead anywhere.
    [[nodiscard]] bool IsWild() const noexcept;
    [[nodiscard]] std::vector<MemoryPiece> Program();
    [[nodiscard]] std::vector<MemoryPiece> Pointers();
    [[nodiscard]] std::vector<MemoryPiece> Guard();

    static constexpr std::uint8_t kGuardWords = 4U;
    static constexpr std::size_t kStackWords = 64U;

    std::vector<std::uint32_t> program;
    std::vector<void*> parts;
    std::array<std::uint32_t, kStackWords> stack{};

  private:
    void CopyTable(const Channel& channel);
    void CopyCode(std::uintptr_t function);

    std::vector<std::uintptr_t> pointers_; ///< As they are to be.
};

/// The shipped self tests over the memory of one node. Between them and the kernel: the faults of the self test as a
/// part. [SRS_SIM_052, SRS_SIM_054]
class NodeSelfTest final : public SelfTestPart
{
  public:
    /// @brief All outlive it; `output` is what the kernel drives.
    NodeSelfTest(NodeMemory& memory, NodeImage& image, const hal::SafetyOutput& output, PartFaults& faults) noexcept;

    /// @brief The pieces of live memory, and what is constant after the start.
    void AddLive(void* bytes, std::size_t size);
    void AddConstant(const void* bytes, std::size_t size);
    /// @brief After everything was added: slices as small as a round within so many cycles allows.
    /// False: it cannot be done.
    [[nodiscard]] bool Settle(std::uint32_t interval_cycles);
    /// @brief The start-up test.
    void Start();
    [[nodiscard]] SelfTestOutcome OnCycle() noexcept override;
    /// @brief The first test that failed; kNone: none did.
    [[nodiscard]] selftest::TestId FirstFailed() const noexcept;

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
