// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/manager/rig.hpp"

#include <algorithm>

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint32_t kStartUs = 0xFFFF'0000U; // 65 ms before the counter wraps.
constexpr std::uint32_t kAssignment = kInNetwork | kBootSlave | kMandatory;

} // namespace

bool ManagerRig::Send(const CanFrame& frame) noexcept
{
    const bool is_taken = !(is_sink_full && is_ours_);
    const bool is_request = (frame.identifier == 0U) || ((frame.identifier & 0x780U) == 0x600U);
    if (is_taken)
    {
        asked += (is_ours_ && is_request) ? 1 : 0;
        wire_.push_back({frame, is_ours_});
    }
    return is_taken;
}

void ManagerRig::OnNodeEvent(NodeId, NodeEvent, Instant) noexcept
{
}

void ManagerRig::OnNodeStatus(NodeId, Instant) noexcept
{
}

void ManagerRig::OnMasterState(std::int16_t, Instant) noexcept
{
}

void ManagerRig::OnNmtSent(const NmtRequest& request, Instant) noexcept
{
    // What the manager says to itself goes to nobody.
    if (request.command == NmtCommand::kStart && request.node.value != setup.own.value)
    {
        starts.push_back(std::to_string(request.node.value));
    }
    stops += (request.command == NmtCommand::kStop) ? 1 : 0;
}

void ManagerRig::OnGate(NodeId, GateState, Instant) noexcept
{
}

void ManagerRig::OnEmergency(NodeId, const EmergencyRecord&, Instant) noexcept
{
}

void ManagerRig::OnDuplicate(const NodeId node, Instant) noexcept
{
    duplicates.push_back(node.value);
}

void ManagerRig::OnFlyingMaster(FlyingEvent, const MasterClaim&, Instant) noexcept
{
}

FakeSlave& ManagerRig::Add(const std::uint8_t node)
{
    SlaveSetup& slave = setups.at(node);
    slave.assignment |= kAssignment;
    slave.device_type = 0x191U;
    slave.vendor_id = 0x2AU;
    slave.product_code = 7U;
    slave.revision_number = 3U;
    slave.serial_number = 0x1234U;
    devices.push_back(std::make_unique<FakeSlave>(node, *this));
    devices.back()->PutIdentity();
    return *devices.back();
}

void ManagerRig::MakeSafe(const std::uint8_t node)
{
    constexpr std::uint32_t kSettings[] = {1U, 25U, 20U, 2U, 0x101U, 0x102U};
    std::size_t place = 0U;
    objects_.at(place++) = ExpectedObject{{0x1300U, 0U}, 1U, false};
    for (std::uint8_t sub = 1U; sub <= 6U; ++sub)
    {
        objects_.at(place++) = ExpectedObject{{0x1301U, sub}, kSettings[sub - 1U], false};
    }
    objects_.at(place++) = ExpectedObject{{0x1381U, 0U}, 0U, false};
    objects_.at(place) = ExpectedObject{{0x13FFU, 1U}, 0x1234U, false};
    setups.at(node).safety = &expectation_;
    for (const auto& device : devices)
    {
        if (device->node == node)
        {
            device->Put8(0x13FEU, 0U, 0xA5U);
            for (const ExpectedObject& object : objects_)
            {
                Octets value{};
                for (std::uint8_t byte = 0U; byte < SizeOf(object.address); ++byte)
                {
                    value.push_back(static_cast<std::uint8_t>((object.value >> (8U * byte)) & 0xFFU));
                }
                device->Put(object.address.index, object.address.sub, value);
            }
        }
    }
}

void ManagerRig::Begin(const Profile profile)
{
    const ManagerRoom room{records_.data(),     watched_.data(), gates_.data(),         {queue_.data(), 256U},
                           {slots_.data(), 4U}, lanes_.All(),    SdoTimes{500'000U, 1U}};
    manager = std::make_unique<Manager>(ManagerParts{setup, *this, *this, room, 0U});
    const StartUpParts parts = manager->ProfileParts();
    cia302_ = std::make_unique<Cia302StartUp>(parts, boots_.data());
    el6751_ = std::make_unique<El6751StartUp>(El6751Parts{parts, el6751_nodes_.data(), {nullptr, 0U}, {}});
    plc_ = std::make_unique<PlcStartUp>(PlcParts{parts, plc_nodes_.data()});
    if (profile == Profile::kEl6751)
    {
        manager->Use(*el6751_);
    }
    else if (profile == Profile::kPlcDesigner)
    {
        manager->Use(*plc_);
    }
    else
    {
        manager->Use(*cia302_);
    }
    for (const auto& device : devices)
    {
        device->Power(Now());
    }
    Run(10U);
    AsManager([this] { manager->Begin(Now()); });
    Deliver();
}

NmtAnswer ManagerRig::Order(const NmtCommand command, const std::uint8_t node)
{
    NmtAnswer answer = NmtAnswer::kInvalid;
    AsManager([&] { answer = manager->Role().Command(command, NodeId{node}, Now()); });
    Deliver();
    return answer;
}

void ManagerRig::Put(const CanFrame& frame)
{
    wire_.push_back({frame, false});
    Deliver();
}

void ManagerRig::Deliver()
{
    for (int i = 0; (i < 20000) && !wire_.empty(); ++i)
    {
        const OnWire passed = wire_.front();
        wire_.erase(wire_.begin());
        if (passed.is_ours && is_echo_heard)
        {
            manager->OnSent(passed.frame);
        }
        else if (!passed.is_ours)
        {
            AsManager([&] { manager->OnFrame(passed.frame, Now()); });
        }
        else
        {
            // Nobody tells the manager what it sent.
        }
        const bool is_for_slaves = (passed.frame.identifier & 0x780U) != 0x580U;
        for (const auto& device : devices)
        {
            if (is_for_slaves)
            {
                device->OnFrame(passed.frame, Now());
                device->OnCycle(Now());
            }
        }
    }
}

void ManagerRig::Run(const std::uint32_t time_ms)
{
    for (std::uint32_t i = 0U; i < time_ms; ++i)
    {
        ++ms;
        for (const auto& device : devices)
        {
            device->OnCycle(Now());
        }
        Deliver();
        AsManager([this] { manager->OnCycle(Now()); });
        Deliver();
    }
}

Instant ManagerRig::Now() const
{
    return Instant{kStartUs + (1000U * ms)};
}

bool ManagerRig::IsSuspected(const std::uint8_t node) const
{
    return std::find(duplicates.begin(), duplicates.end(), node) != duplicates.end();
}

int ManagerRig::Running(const std::uint8_t node) const
{
    const auto is_running = [node](const std::unique_ptr<FakeSlave>& device)
    { return (device->node == node) && device->is_on && (device->State() == cia301::NodeState::kOperational); };
    return static_cast<int>(std::count_if(devices.begin(), devices.end(), is_running));
}

GateState ManagerRig::Gate(const std::uint8_t node) const
{
    return manager->Gate().State(NodeId{node});
}

} // namespace counterpoint::cia302
