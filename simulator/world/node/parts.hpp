// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_NODE_PARTS_HPP
#define SIMULATOR_WORLD_NODE_PARTS_HPP

#include "canopen/cia306/text/input_error.hpp"
#include "runtime/device/assembly.hpp"
#include "simulator/faults/memory_places.hpp"
#include "simulator/world/node/inside.hpp"

#include <cstddef>
#include <vector>

namespace counterpoint::simulator
{
/// The self tests do not fit into the diagnostic interval of a device. [SRS_SIM_052]
class SelfTestMisfit final : public cia306::InputError
{
  public:
    using InputError::InputError;
};

/// The memory of a node's parts: what its self tests watch, and where bits flip and stick. [SRS_SIM_052, SRS_SIM_053,
/// SRS_SIM_055]
class NodeParts
{
  public:
    /// @brief Furnishes the self tests. Both outlive it. Throws cia306::InputError.
    NodeParts(const NodeInside& inside, runtime::DeviceAssembly& assembly);

    /// @brief The memory of a part, in which bits flip.
    [[nodiscard]] std::vector<MemoryPiece> PiecesOf(Part part, std::uint8_t srdo);
    /// @brief Flips one bit of a part's memory, of those that PiecesOf tells.
    void Flip(Part part, std::uint8_t srdo, const runtime::BitPlace& place);
    /// @brief From now on this bit of the part's live memory stays at one level.
    void Stick(const FaultSetup& fault, const runtime::BitPlace& place, std::size_t index);

  private:
    void AddPointers();
    void AddMemory(NodeSelfTest& self_test);

    NodeInside inside_;
    runtime::DeviceAssembly& assembly_;
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_NODE_PARTS_HPP
