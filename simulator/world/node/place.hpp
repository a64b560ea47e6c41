// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_NODE_PLACE_HPP
#define SIMULATOR_WORLD_NODE_PLACE_HPP

#include "simulator/journal/journal.hpp"

#include "canopen/cia306/file/device.hpp"
#include "hal/host/virtual/bus.hpp"

#include <cstdint>

namespace counterpoint::simulator
{
/// Where a node is, and who looks at it.
struct NodePlace
{
    NodeIndex index;
    host::VirtualBus& bus;
    Journal& journal;
    bool is_tapped;             ///< It is looked into: taps around channels and supervisors cost time.
    const cia306::Device* file; ///< Null: the node has no services but NMT commands. Read only while the node is built.

    [[nodiscard]] bool HasServices() const noexcept
    {
        return file != nullptr;
    }
    [[nodiscard]] Nanoseconds Now() const noexcept
    {
        return bus.Now();
    }
    /// @brief Something that expectations need, here and now; see Journal.
    void Note(const EventKind kind, const std::uint8_t srdo, const std::uint64_t value, const std::uint64_t other) const
    {
        journal.Note({bus.Now(), kind, index, srdo, value, other});
    }
    /// @brief Something for people.
    void Tell(const EventKind kind, const std::uint8_t srdo, const std::uint64_t value, const std::uint64_t other) const
    {
        journal.Tell({bus.Now(), kind, index, srdo, value, other});
    }
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_NODE_PLACE_HPP
