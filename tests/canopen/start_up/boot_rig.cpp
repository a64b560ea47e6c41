// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/start_up/boot_rig.hpp"

#include <cstdio>

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint32_t kStartUs = 0xFFFF'0000U; // 65 ms before the counter wraps.

} // namespace

BootRig::BootRig(const SdoTimes& sdo_times) : lanes{*this, sdo_times}, sdo{lanes.All(), sdo_times}
{
    nmt.SetActive(true);
}

Instant BootRig::Now() const
{
    return Instant{kStartUs + (1000U * ms)};
}

/// Frames of the manager come while it is called, all others are put on the wire by its slaves.
bool BootRig::Send(const CanFrame& frame) noexcept
{
    wire.push_back(frame);
    return true;
}

void BootRig::OnNodeEvent(NodeId node, NodeEvent event, Instant now) noexcept
{
    const bool is_loss = (event == NodeEvent::kHeartbeatLost) || (event == NodeEvent::kGuardLost);
    events.push_back(std::to_string(ms - begun_ms) + ":" + std::to_string(node.value) + " " +
                     std::to_string(static_cast<int>(event)));
    if (event == NodeEvent::kBootUp)
    {
        sdo.OnBootUp(node);
    }
    if (is_loss || (event == NodeEvent::kBootUp))
    {
        gate.Close(node);
    }
    start_up.OnNodeEvent(node, event, now);
}

/// As the manager does it.
void BootRig::OnStartDropped(const NodeId node, const Instant now) noexcept
{
    gate.Close(node);
    start_up.OnStartDropped(node, now);
}

void BootRig::OnNmtSent(const NmtRequest& request, Instant) noexcept
{
    if ((request.node.value == 0U) || (request.node.value == setup.own.value))
    {
        own.push_back(request);
    }
}

void BootRig::OnNodeStatus(NodeId, Instant) noexcept
{
}

void BootRig::OnMasterState(std::int16_t state, Instant) noexcept
{
    master_states.push_back(state);
}

FakeSlave& BootRig::Add(const std::uint8_t node, const std::uint32_t assignment)
{
    SlaveSetup& slave = setups.at(node);
    slave.assignment = assignment;
    slave.device_type = 0x191U;
    slave.vendor_id = 0x2AU;
    slave.product_code = 7U;
    slave.revision_number = 3U;
    slave.serial_number = 0x1234U;
    auto& made = slaves[node];
    made = std::make_unique<FakeSlave>(node, *this);
    made->PutIdentity();
    return *made;
}

void BootRig::Protect(const std::uint8_t node)
{
    setups.at(node).safety = reinterpret_cast<const SafetyExpectation*>(&gate);
}

void BootRig::PowerAll()
{
    for (auto& [node, slave] : slaves)
    {
        slave->Power(Now());
    }
}

void BootRig::Begin()
{
    PowerAll();
    Run(10U);
    log.clear();
    events.clear();
    begun_ms = ms;
    is_begun = true;
    start_up.Begin(Now());
    Deliver();
}

void BootRig::ToManager(const CanFrame& frame)
{
    table.OnFrame(frame, Now());
    sdo.OnFrame(frame, Now());
    start_up.OnFrame(frame, Now());
}

/// Until nobody sends any more. Nobody but the slaves themselves answers on 580h, 700h; so no origin is needed.
void BootRig::Deliver()
{
    for (int i = 0; (i < 20000) && !wire.empty(); ++i)
    {
        const CanFrame frame = wire.front();
        wire.erase(wire.begin());
        log.push_back(Sent{ms - begun_ms, frame});
        const bool is_data = (frame.kind == FrameKind::kData);
        const bool is_of_slave = is_data && (frame.identifier > 0x580U) && ((frame.identifier & 0x780U) != 0x600U);
        const bool is_lost = is_of_slave && is_begun && (lost_answer == 0);
        lost_answer -= (is_of_slave && is_begun && (lost_answer >= 0)) ? 1 : 0;
        if (is_lost)
        {
            continue;
        }
        if (is_of_slave)
        {
            ToManager(frame);
        }
        else
        {
            for (auto& [node, slave] : slaves)
            {
                slave->OnFrame(frame, Now());
                slave->OnCycle(Now());
            }
        }
    }
}

/// One that is asked for twice in a row waits once.
void BootRig::FillQueue(const std::uint16_t count)
{
    setup.inhibit_100us = 10U;
    for (int i = 0; (i < 300) && (nmt.Waiting() < count); ++i)
    {
        const bool is_reset = (i % 2) == 0;
        const NmtCommand command = is_reset ? NmtCommand::kResetNode : NmtCommand::kPreOperational;
        static_cast<void>(nmt.Request(command, NodeId{99U}, Now()));
    }
}

void BootRig::Run(const std::uint32_t time_ms)
{
    for (std::uint32_t i = 0U; i < time_ms; ++i)
    {
        ++ms;
        for (auto& [node, slave] : slaves)
        {
            slave->OnCycle(Now());
        }
        Deliver();
        table.OnCycle(Now());
        sdo.OnCycle(Now());
        gate.OnCycle(Now());
        if (is_begun)
        {
            start_up.OnCycle(Now());
        }
        nmt.OnCycle(Now());
        Deliver();
    }
}

NodeStatus BootRig::Of(const std::uint8_t node) const
{
    return start_up.Status(NodeId{node});
}

std::string BootRig::Letter(const std::uint8_t node) const
{
    const char letter = Of(node).letter;
    return (letter == '\0') ? std::string{"-"} : std::string(1U, letter);
}

MasterStep BootRig::Step() const
{
    return static_cast<MasterStep>(start_up.MasterState());
}

std::vector<std::string> BootRig::Commands() const
{
    std::vector<std::string> list{};
    for (const Sent& sent : log)
    {
        if (sent.frame.identifier == 0U)
        {
            char text[32];
            std::snprintf(text, sizeof(text), "%u:%02x %02x", static_cast<unsigned>(sent.at_ms),
                          static_cast<unsigned>(sent.frame.data[0]), static_cast<unsigned>(sent.frame.data[1]));
            list.emplace_back(text);
        }
    }
    return list;
}

int BootRig::Count(const std::uint32_t identifier) const
{
    int count = 0;
    for (const Sent& sent : log)
    {
        count += (sent.frame.identifier == identifier) ? 1 : 0;
    }
    return count;
}

void BootRig::AddEntry(Octets& octets, const std::uint16_t index, const std::uint8_t sub, const Octets& value)
{
    if (octets.empty())
    {
        octets.assign(4U, 0U);
    }
    ++octets[0];
    octets.push_back(static_cast<std::uint8_t>(index & 0xFFU));
    octets.push_back(static_cast<std::uint8_t>(index >> 8U));
    octets.push_back(sub);
    octets.push_back(static_cast<std::uint8_t>(value.size()));
    octets.insert(octets.end(), {0U, 0U, 0U});
    octets.insert(octets.end(), value.begin(), value.end());
}

} // namespace counterpoint::cia302
