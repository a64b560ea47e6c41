// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/start_up/profile_rig.hpp"

#include "canopen/cia302/safety_gate/safety_check.hpp"

#include <algorithm>
#include <cstdio>

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint32_t kStartUs = 0xFFFF'0000U; // 65 ms before the counter wraps.
constexpr ExpectedObject kExpected[]{{{0x1301U, 1U}, 1U, false}};
constexpr SafetyExpectation kExpectation{kExpected, 1U};

} // namespace

ProfileRig::ProfileRig(const SdoTimes& times) : lanes(*this, times), sdo(lanes.All(), times), expectation(&kExpectation)
{
    nmt.SetActive(true);
}

Instant ProfileRig::Now() const
{
    return Instant{kStartUs + us};
}

bool ProfileRig::Send(const CanFrame& frame) noexcept
{
    wire.push_back(frame);
    by_manager_.push_back(is_manager_);
    return true;
}

void ProfileRig::OnNodeEvent(const NodeId node, const NodeEvent event, const Instant now) noexcept
{
    const bool is_loss = (event == NodeEvent::kHeartbeatLost) || (event == NodeEvent::kGuardLost);
    if (event == NodeEvent::kBootUp)
    {
        sdo.OnBootUp(node);
    }
    if (is_loss || (event == NodeEvent::kBootUp))
    {
        gate.Close(node);
    }
    profile->OnNodeEvent(node, event, now);
}

void ProfileRig::OnNmtSent(const NmtRequest&, Instant) noexcept
{
}

/// As the manager does it.
void ProfileRig::OnStartDropped(const NodeId node, const Instant now) noexcept
{
    gate.Close(node);
    profile->OnStartDropped(node, now);
}

void ProfileRig::OnNodeStatus(const NodeId node, Instant) noexcept
{
    const std::string code = std::to_string(profile->Status(node).code);
    Log& log = told[node.value];
    if (log.empty() || (log.back() != code))
    {
        log.push_back(code);
    }
}

void ProfileRig::OnMasterState(const std::int16_t state, Instant) noexcept
{
    masters.push_back(std::to_string(state));
}

BusSlave& ProfileRig::Add(const std::uint8_t node)
{
    SlaveSetup& slave = setups.at(node);
    slave.assignment = kInNetwork | kBootSlave | kMandatory;
    slave.device_type = 0x191U;
    auto& made = slaves[node];
    made = std::make_unique<BusSlave>(node, *this);
    made->Set(0x1000U, 0U, 0x191U);
    made->Set(0x1018U, 1U, 0x2AU);
    made->Set(0x1018U, 2U, 7U);
    made->Set(0x1018U, 3U, 3U);
    made->Set(0x1018U, 4U, 0x1234U);
    made->is_on = true;
    made->state = 127U;
    return *made;
}

void ProfileRig::OnOwnFrame(const CanFrame&)
{
}

/// A frame of the manager reaches the slaves, one of a slave the manager.
void ProfileRig::Deliver()
{
    for (std::size_t i = 0U; (i < 20000U) && !wire.empty(); ++i)
    {
        const CanFrame frame = wire.front();
        const bool is_manager = by_manager_.front();
        wire.erase(wire.begin());
        by_manager_.erase(by_manager_.begin());
        if (is_bus_cut)
        {
            continue;
        }
        is_manager_ = !is_manager;
        if (is_manager)
        {
            sent.push_back(Sent{us, frame});
            is_manager_ = true;
            OnOwnFrame(frame);
            is_manager_ = false;
            for (auto& [node, slave] : slaves)
            {
                slave->OnFrame(frame, Now().us);
            }
        }
        else
        {
            table.OnFrame(frame, Now());
            sdo.OnFrame(frame, Now());
            profile->OnFrame(frame, Now());
        }
        is_manager_ = false;
    }
}

void ProfileRig::Put(const std::uint32_t identifier, const Octets& data)
{
    CanFrame frame{identifier, FrameKind::kData, CanPortId::kFirst, static_cast<std::uint8_t>(data.size()), {}};
    std::copy(data.begin(), data.end(), frame.data);
    static_cast<void>(Send(frame));
    Deliver();
}

void ProfileRig::Step()
{
    us += step_us;
    for (auto& [node, slave] : slaves)
    {
        slave->OnCycle(Now().us);
    }
    Deliver();
    is_manager_ = true;
    table.OnCycle(Now());
    sdo.OnCycle(Now());
    gate.OnCycle(Now());
    profile->OnCycle(Now());
    nmt.OnCycle(Now());
    is_manager_ = false;
    Deliver();
}

void ProfileRig::Begin()
{
    const bool is_begun = Do(
        [this]
        {
            profile->Begin(Now());
            return true;
        });
    EXPECT_TRUE(is_begun);
}

void ProfileRig::RunUs(const std::uint32_t time_us)
{
    const std::uint32_t from_us = us;
    while ((us - from_us) < time_us)
    {
        Step();
    }
}

void ProfileRig::Run(const std::uint32_t ms)
{
    RunUs(1000U * ms);
}

NodeStatus ProfileRig::Of(const std::uint8_t node) const
{
    return profile->Status(NodeId{node});
}

int ProfileRig::Code(const std::uint8_t node) const
{
    return Of(node).code;
}

Log ProfileRig::Nmt() const
{
    Log list{};
    for (const Sent& one : sent)
    {
        if (one.frame.identifier == 0U)
        {
            char text[32];
            std::snprintf(text, sizeof(text), "%u:%02X %02X", static_cast<unsigned>(one.at_us / 1000U),
                          static_cast<unsigned>(one.frame.data[0]), static_cast<unsigned>(one.frame.data[1]));
            list.emplace_back(text);
        }
    }
    return list;
}

Log ProfileRig::Commands() const
{
    Log list{};
    for (const std::string& line : Nmt())
    {
        list.push_back(line.substr(line.find(':') + 1U));
    }
    return list;
}

std::vector<std::uint32_t> ProfileRig::Times(const std::uint32_t identifier) const
{
    std::vector<std::uint32_t> times{};
    for (const Sent& one : sent)
    {
        if (one.frame.identifier == identifier)
        {
            times.push_back(one.at_us);
        }
    }
    return times;
}

} // namespace counterpoint::cia302
