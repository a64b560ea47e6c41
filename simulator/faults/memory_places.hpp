// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_FAULTS_MEMORY_PLACES_HPP
#define SIMULATOR_FAULTS_MEMORY_PLACES_HPP

#include "runtime/device/model.hpp"
#include "simulator/scenario/scenario.hpp"

#include "safety_core/kernel/kernel.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace counterpoint::simulator
{
/// A piece of memory in which a bit may flip.
struct MemoryPiece
{
    std::uint8_t* bytes;
    std::size_t size;
};

/// The memory of a part of the kernel. Pointers and indices are left out: a flip in them is an access to anywhere,
/// which the processor's memory protection answers and no simulation can. [SRS_SIM_035]
[[nodiscard]] std::vector<MemoryPiece> PiecesOf(Part part, Kernel& kernel);
/// The memory of a part of the device's tables and variables; `srdo` 0: the first SRDO.
[[nodiscard]] std::vector<MemoryPiece> PiecesOf(Part part, runtime::DeviceModel& model, std::uint8_t srdo);
[[nodiscard]] std::size_t SizeOf(const std::vector<MemoryPiece>& pieces);
/// @brief Flips one bit; `offset` is below the size of all pieces.
void FlipIn(const std::vector<MemoryPiece>& pieces, std::size_t offset, std::uint8_t bit);
} // namespace counterpoint::simulator

#endif // SIMULATOR_FAULTS_MEMORY_PLACES_HPP
