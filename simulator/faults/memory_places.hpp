// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_FAULTS_MEMORY_PLACES_HPP
#define SIMULATOR_FAULTS_MEMORY_PLACES_HPP

#include "runtime/device/model.hpp"
#include "simulator/faults/flow_faults.hpp"
#include "simulator/scenario/scenario.hpp"

#include "safety_core/kernel/kernel.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace counterpoint::simulator
{
/// A piece of memory in which bits may flip.
struct MemoryPiece
{
    std::uint8_t* bytes;
    std::size_t size;
};

/// The memory of a part of the kernel, without pointers and indices. A flip in one of those is an access to anywhere:
/// the processor's memory protection answers it, and no simulation can. `flow` is what the kernel was given instead of
/// its own flow monitor; null: nothing. [SRS_SIM_035]
[[nodiscard]] std::vector<MemoryPiece> PiecesOf(Part part, Kernel& kernel, FlowFaults* flow);
/// The memory of a part of the device's tables and variables. `srdo` is the number of an SRDO; 0: the first one.
[[nodiscard]] std::vector<MemoryPiece> PiecesOf(Part part, runtime::DeviceModel& model, std::uint8_t srdo);
/// @brief Number of bytes of all pieces.
[[nodiscard]] std::size_t SizeOf(const std::vector<MemoryPiece>& pieces);
/// @brief Flips one bit; `offset` is below the size of all pieces.
void FlipIn(const std::vector<MemoryPiece>& pieces, std::size_t offset, std::uint8_t bit);
} // namespace counterpoint::simulator

#endif // SIMULATOR_FAULTS_MEMORY_PLACES_HPP
