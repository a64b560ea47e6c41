// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_NODE_PROCESSOR_HPP
#define SIMULATOR_WORLD_NODE_PROCESSOR_HPP

#include "simulator/faults/flow_faults.hpp"
#include "simulator/faults/part_faults.hpp"
#include "simulator/faults/supervisor_tap.hpp"
#include "simulator/world/node/image.hpp"
#include "simulator/world/node/memory.hpp"
#include "simulator/world/node/place.hpp"

#include <csetjmp>

namespace counterpoint::simulator
{
/// Runs the program of a node, with the faults that it has. Any call into the program may never return.
/// [SRS_SIM_025, SRS_SIM_055]
class NodeProcessor
{
  public:
    /// @brief `place` outlives it.
    explicit NodeProcessor(const NodePlace& place) noexcept;

    void PowerOn() noexcept;
    void PowerOff() noexcept;
    /// @brief Makes a call into the program that may never return.
    template <typename Call> void Run(const Call& call)
    {
        if (!place_.is_tapped)
        {
            call();
            return;
        }
        faults_.SetNow(place_.Now());
        memory_.Hold();
        const SupervisorTap::Scope scope(&supervisors_);
        if (setjmp(faults_.WayOut()) != 0)
        {
            NoteHung();
            return;
        }
        call();
    }
    /// @brief Within such a call: ends as an exception does if a call into the kernel would lead anywhere.
    void RequireSound()
    {
        if (image_.IsWild())
        {
            faults_.Trap();
        }
    }
    /// @brief Run, with RequireSound first. A cycle looks at the pointers itself.
    template <typename Call> void RunSound(const Call& call)
    {
        Run(
            [this, &call]()
            {
                RequireSound();
                call();
            });
    }
    /// @brief Nothing of the node runs any more, until a power cycle.
    void StandStill();
    /// @brief Faults that changed something since the last call.
    void NoteEffects();

    [[nodiscard]] bool HasSupply() const noexcept
    {
        return is_on_;
    }
    [[nodiscard]] bool IsHung() const noexcept
    {
        return is_hung_;
    }
    [[nodiscard]] bool IsRunning() const noexcept
    {
        return is_on_ && !is_hung_;
    }
    [[nodiscard]] PartFaults& Faults() noexcept
    {
        return faults_;
    }
    /// @brief What the kernel is given instead of its own flow monitor; null: nothing, the node is not looked into.
    [[nodiscard]] FlowFaults* Flow() noexcept
    {
        return place_.is_tapped ? &flow_ : nullptr;
    }
    [[nodiscard]] NodeMemory& Memory() noexcept
    {
        return memory_;
    }
    [[nodiscard]] NodeImage& Image() noexcept
    {
        return image_;
    }

  private:
    void NoteHung();

    const NodePlace& place_;
    PartFaults faults_{};
    SupervisorTap supervisors_;
    FlowFaults flow_;
    NodeMemory memory_;
    NodeImage image_;
    bool is_on_{false};
    bool is_hung_{false};
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_NODE_PROCESSOR_HPP
