// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/start_up/el6751/slaves.hpp"

namespace counterpoint::cia302
{

bool El6751Slaves::IsBusy(const NodeId node) const noexcept
{
    const El6751Phase phase = Of(node).phase;
    return (phase == El6751Phase::kResetting) || (phase == El6751Phase::kRows) || (phase == El6751Phase::kVerify) ||
           (phase == El6751Phase::kStarting) || IsStopping(phase);
}

void El6751Slaves::Tell(const NodeId node, const std::int16_t code, const StartUpStep step, const Instant now) noexcept
{
    NodeStatus& status = Of(node).status;
    const bool has_changed = (status.code != code) || (status.step != step);
    status.code = code;
    status.step = step;
    if (has_changed)
    {
        parts_.common.listener.OnNodeStatus(node, now);
    }
}

} // namespace counterpoint::cia302
