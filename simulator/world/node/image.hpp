// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_NODE_IMAGE_HPP
#define SIMULATOR_WORLD_NODE_IMAGE_HPP

#include "simulator/faults/memory_places.hpp"

#include "safety_core/contract/channel.hpp"

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
    /// @brief A pointer may be another one now; until then none is wild.
    void DoubtPointers() noexcept
    {
        may_be_wild_ = true;
    }
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
    bool may_be_wild_{false};
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_NODE_IMAGE_HPP
