// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/elections/bound.hpp"

#include <algorithm>

namespace counterpoint::elections
{

Bound BoundOf(const std::vector<MasterPlan>& masters, const Time bit_us)
{
    constexpr Time kSteps = 6;          // Of a negotiation, each at a cycle and behind a frame of somebody else.
    constexpr Time kLongestFrame = 140; // Bits, with 8 bytes.
    constexpr Time kFrameOfEach = 60;   // Bits of a service frame, three a master and negotiation.
    const Time count = static_cast<Time>(masters.size());
    Bound bound{0, 0, kNever, 0, 0};
    bound.slack = (kSteps * ((kLongestFrame * bit_us) + kMs)) + (3 * count * kFrameOfEach * bit_us);
    for (const MasterPlan& plan : masters)
    {
        const Time slot = plan.times.WaitingUs(plan.node);
        bound.detection = std::max(bound.detection, (plan.times.delay + plan.times.timeout) * kMs);
        bound.greatest_slot = std::max(bound.greatest_slot, slot);
        bound.least_slot = std::min(bound.least_slot, slot);
        bound.greatest_cycle = std::max(bound.greatest_cycle, plan.times.detection_cycle * kMs);
    }
    return bound;
}

} // namespace counterpoint::elections
