// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/flow_monitor.hpp"

#include <cstdint>

namespace counterpoint
{
namespace
{

constexpr std::uint32_t kMultiplier = 0x0019660DU; // Odd, so that no earlier step is ever lost from the signature.
constexpr std::uint32_t kStepKey = 0x3C6EF35FU;
constexpr std::uint32_t kEvidenceKey = 0x9E3779B9U;
constexpr std::uint32_t kStart = 0x1F123BB5U;

std::uint32_t Fold(const std::uint32_t signature, const std::uint32_t step, const std::uint32_t difference) noexcept
{
    return (((signature + (step * kStepKey)) * kMultiplier) ^ step) + (difference * kEvidenceKey);
}

// What brings the signature of eleven undisturbed steps to hal::kFlowReference; the test of an undisturbed cycle
// recomputes it.
constexpr std::uint32_t kOffset = 0x6376BCC6U;

} // namespace

void FlowMonitor::Begin() noexcept
{
    signature_ = kStart;
}

void FlowMonitor::Mark(const FlowStep step, const FlowEvidence& evidence) noexcept
{
    signature_ = Fold(signature_, static_cast<std::uint32_t>(step), evidence.observed - evidence.expected);
}

hal::WatchdogAnswer FlowMonitor::End(const hal::WatchdogQuestion& question) noexcept
{
    ended_ = signature_ + kOffset;
    return hal::WatchdogAnswer{(ended_ + question.value) * hal::kWatchdogConstant};
}

DeviceFault FlowMonitor::Finding() const noexcept
{
    return (ended_ == hal::kFlowReference) ? DeviceFault::kNone : DeviceFault::kFlow;
}

} // namespace counterpoint
