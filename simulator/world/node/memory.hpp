// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_NODE_MEMORY_HPP
#define SIMULATOR_WORLD_NODE_MEMORY_HPP

#include "simulator/faults/memory_places.hpp"
#include "simulator/scenario/scenario.hpp"

#include "hal/api/interrupt_lock.hpp"
#include "hal/api/memory_access.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace counterpoint::simulator
{
/// A bit that stays at one level, whatever is written.
struct StuckBit
{
    std::uint8_t* byte;
    std::uint8_t bit;
    bool level;
    std::size_t fault; ///< Index in Scenario::faults.
};

/// The memory of a simulated node: pieces of the memory of this process under addresses of its own, so that a march
/// takes the same way wherever the process has them. Bits may be stuck. [SRS_SIM_052, SRS_SIM_053]
class NodeMemory final : public hal::MemoryAccess
{
  public:
    NodeMemory() = default;

    /// @brief From now on these words (a rest of less than a word is left out) have addresses here.
    hal::MemorySpan Add(void* bytes, std::size_t size);

    [[nodiscard]] std::uint32_t Read(hal::Address place) const noexcept override;
    void Write(hal::Address place, std::uint32_t value) noexcept override;
    [[nodiscard]] std::uint32_t Exchange(hal::Address place, std::uint32_t value) noexcept override;
    /// @brief Far from every piece: calls run on the stack of the simulator.
    [[nodiscard]] hal::Address StackPosition() const noexcept override;
    /// @brief Where an object of the self tests is: outside of all pieces.
    [[nodiscard]] hal::Address PlaceOf(const void* object) const noexcept override;

    void Stick(const StuckBit& stuck);
    /// @brief No bit is stuck any more.
    void Release() noexcept
    {
        stuck_.clear();
    }
    /// @brief Every stuck bit at its level: before each call into the node.
    void Hold();
    /// @brief Faults whose bit differed from what it should be for the first time since the last call.
    [[nodiscard]] std::vector<std::size_t> TakeEffects();

  private:
    struct Held
    {
        StuckBit stuck;
        bool has_effect;
    };

    [[nodiscard]] std::uint8_t* At(hal::Address place) const noexcept;
    [[gnu::cold]] [[nodiscard]] std::uint32_t ExchangeHeld(std::uint8_t* word, std::uint32_t value) noexcept;
    void HoldWithin(const std::uint8_t* word) noexcept;

    static constexpr std::size_t kMostPieces = 128U;

    std::array<std::uintptr_t, kMostPieces> distances_{}; ///< From a place to its byte in this process, by piece.
    std::size_t pieces_{0U};
    std::vector<Held> stuck_;
    std::vector<std::size_t> effects_;
};

/// Nothing interrupts a simulated node.
class NodeLock final : public hal::InterruptLock
{
  public:
    void Lock() noexcept override
    {
    }
    void Unlock() noexcept override
    {
    }
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_NODE_MEMORY_HPP
