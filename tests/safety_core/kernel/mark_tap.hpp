// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_SAFETY_CORE_KERNEL_MARK_TAP_HPP
#define TESTS_SAFETY_CORE_KERNEL_MARK_TAP_HPP

#include "safety_core/kernel/flow_monitor.hpp"

#include <functional>
#include <vector>

namespace counterpoint
{

/// What happens to one mark of a cycle.
enum class MarkFault : std::uint8_t
{
    kNone = 0U,
    kLeftOut = 1U,
    kDoubled = 2U,
    kSwapped = 3U, ///< With its neighbour: made behind the next one.
    kOtherEvidence = 4U,
};

/// Hands every call on to a flow monitor; a test may spoil the mark of one step.
class MarkTap final : public FlowWatch
{
  public:
    void Begin() noexcept override
    {
        ++begun;
        steps.clear();
        evidences.clear();
        monitor_.Begin();
    }
    void Mark(FlowStep step, const FlowEvidence& evidence) noexcept override
    {
        steps.push_back(step);
        evidences.push_back(evidence);
        if (on_step)
        {
            on_step(step);
        }
        if (step != at)
        {
            monitor_.Mark(step, evidence);
            MarkKept();
            return;
        }
        switch (fault)
        {
        case MarkFault::kLeftOut:
            break;
        case MarkFault::kSwapped:
            kept_.push_back(evidence);
            break;
        case MarkFault::kOtherEvidence:
            monitor_.Mark(step, FlowEvidence{evidence.observed ^ 1U, evidence.expected});
            break;
        case MarkFault::kDoubled:
            monitor_.Mark(step, evidence);
            monitor_.Mark(step, evidence);
            break;
        case MarkFault::kNone:
            monitor_.Mark(step, evidence);
            break;
        }
    }
    hal::WatchdogAnswer End(const hal::WatchdogQuestion& question) noexcept override
    {
        ++ended;
        return monitor_.End(question);
    }
    DeviceFault Finding() const noexcept override
    {
        ++asked;
        return monitor_.Finding();
    }

    std::vector<FlowStep> steps{};         ///< Of the present cycle, in their order.
    std::vector<FlowEvidence> evidences{}; ///< Likewise.
    std::uint32_t begun{0U};
    std::uint32_t ended{0U};
    mutable std::uint32_t asked{0U};
    std::function<void(FlowStep)> on_step{}; ///< Behind what was done in this step.
    MarkFault fault{MarkFault::kNone};
    FlowStep at{FlowStep::kInvalid};

  private:
    void MarkKept() noexcept
    {
        for (const FlowEvidence& evidence : kept_)
        {
            monitor_.Mark(at, evidence);
        }
        kept_.clear();
    }

    FlowMonitor monitor_{};
    std::vector<FlowEvidence> kept_{}; ///< Of the mark that waits for its neighbour.
};

/// Comes before Rig among the bases of a fixture whose kernel is given the tap.
struct MarkTapHolder
{
    MarkTap flow{};
};

} // namespace counterpoint

#endif
