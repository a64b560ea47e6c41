// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/start_up/plc_designer/slaves.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr PlcSlave kPlainSlave{};

} // namespace

const PlcSlave& PlcSlaves::SetupOf(const NodeId node) const noexcept
{
    const PlcSlave* const slave = parts_.common.setup.Slave(node).plc;
    return (slave != nullptr) ? *slave : kPlainSlave;
}

void PlcSlaves::Go(const NodeId node, const PlcEvent event, const StartUpStep step, const Instant now) noexcept
{
    PlcNode& slave = Of(node);
    const std::int16_t state = Next(slave.status.code, event);
    const bool has_changed = (slave.status.code != state) || (slave.status.step != step);
    slave.since = (slave.status.code != state) ? now : slave.since;
    slave.status.code = state;
    slave.status.step = step;
    if (has_changed)
    {
        parts_.common.listener.OnNodeStatus(node, now);
    }
}

} // namespace counterpoint::cia302
