// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/manager/consumers.hpp"

namespace counterpoint::runtime
{
namespace
{
using cia301::SdoAbort;
using cia302::NodeId;

constexpr std::uint32_t kNodeShift = 16U;
constexpr std::uint32_t kReservedShift = 24U;

NodeId NodeOf(const std::uint32_t value)
{
    return NodeId{static_cast<std::uint8_t>((value >> kNodeShift) & 0xFFU)};
}

std::uint16_t TimeOf(const std::uint32_t value)
{
    return static_cast<std::uint16_t>(value & 0xFFFFU);
}

/// With time 0 or without a node nobody is meant.
bool IsOn(const std::uint32_t value)
{
    return NodeOf(value).value >= 1U && NodeOf(value).value <= cia302::kLastNode && TimeOf(value) > 0U;
}
} // namespace

bool IsStartingUp(const ManagerAssembly& assembly, const NodeId node) noexcept
{
    using cia302::StartUpStep;
    const cia302::NodeStatus status = assembly.Core().Status(node);
    const bool is_cia302 = assembly.Net().Plan().manager.profile == network_plan::StartProfile::kCia302;
    const bool is_waiting = status.step == StartUpStep::kReset || status.step == StartUpStep::kWaitBootUp ||
                            (is_cia302 && status.step == StartUpStep::kDeviceType);
    return status.is_busy && !is_waiting;
}

ManagerConsumers::ManagerConsumers(ManagerAssembly& assembly, network_plan::LoadedNetwork& net)
    : assembly_(assembly), net_(net)
{
    std::size_t count = 0U;
    for (std::uint8_t node = 1U; node <= cia302::kLastNode; ++node)
    {
        const std::uint32_t consumer_ms = net.Setup().Slave(NodeId{node}).heartbeat.consumer_ms;
        if (net.Setup().IsListed(NodeId{node}) && consumer_ms != 0U)
        {
            ++count;
            values_.at(count) = (std::uint32_t{node} << kNodeShift) | consumer_ms;
        }
    }
}

std::uint32_t ManagerConsumers::Value(const std::uint8_t sub) const noexcept
{
    return values_[sub & cia302::kLastNode];
}

SdoAbort ManagerConsumers::Write(const std::uint8_t sub, const std::uint32_t value, const Instant now) noexcept
{
    const std::uint32_t before = Value(sub);
    const SdoAbort abort = (value == before) ? SdoAbort::kNone : MayWrite(sub, value);
    if (abort == SdoAbort::kNone && value != before)
    {
        values_[sub & cia302::kLastNode] = value;
        const bool is_left = IsOn(before) && !(IsOn(value) && NodeOf(value).value == NodeOf(before).value);
        if (is_left)
        {
            Watch(NodeOf(before), 0U, now);
        }
        if (IsOn(value))
        {
            Watch(NodeOf(value), TimeOf(value), now);
        }
    }
    return abort;
}

SdoAbort ManagerConsumers::MayWrite(const std::uint8_t sub, const std::uint32_t value) const noexcept
{
    const bool is_own = IsOn(value) && NodeOf(value).value == net_.Setup().own.value;
    if ((value >> kReservedShift) != 0U || is_own)
    {
        return SdoAbort::kValueRange;
    }
    for (std::uint8_t other = 1U; other <= cia302::kLastNode; ++other)
    {
        const bool is_twice = IsOn(value) && IsOn(Value(other)) && NodeOf(Value(other)).value == NodeOf(value).value;
        if (other != sub && is_twice)
        {
            return SdoAbort::kIncompatible;
        }
    }
    const SdoAbort before = MayChange(Value(sub));
    return (before == SdoAbort::kNone) ? MayChange(value) : before;
}

/// As of what else the manager knows of a slave: see ManagerObjects. A node that is no slave may always be watched.
SdoAbort ManagerConsumers::MayChange(const std::uint32_t value) const noexcept
{
    const NodeId node = NodeOf(value);
    if (IsOn(value) && net_.Setup().IsSafetySlave(node))
    {
        return SdoAbort::kReadOnly;
    }
    const bool is_busy = IsOn(value) && net_.Setup().IsListed(node) && IsStartingUp(assembly_, node);
    return is_busy ? SdoAbort::kDeviceState : SdoAbort::kNone;
}

void ManagerConsumers::Watch(const NodeId node, const std::uint16_t consumer_ms, const Instant now) noexcept
{
    cia302::HeartbeatSetup& setup = net_.SlaveRoom()[node.value].heartbeat;
    cia302::NodeTable& table = assembly_.Core().ProfileParts().table;
    const bool is_listed = net_.Setup().IsListed(node);
    setup.consumer_ms = consumer_ms;
    setup.arming = is_listed ? setup.arming : cia302::Arming::kFirstHeartbeat;
    const bool is_watched = table.Record(node).watch != cia302::Watch::kNone;
    if (is_watched || !is_listed || assembly_.Core().Status(node).is_started)
    {
        table.WatchAsSetUp(node, now);
    }
}
} // namespace counterpoint::runtime
