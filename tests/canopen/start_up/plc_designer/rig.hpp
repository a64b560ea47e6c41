// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_CANOPEN_START_UP_PLC_DESIGNER_RIG_HPP
#define TESTS_CANOPEN_START_UP_PLC_DESIGNER_RIG_HPP

#include "canopen/start_up/plc_designer/start_up.hpp"
#include "tests/canopen/start_up/profile_rig.hpp"

#include <array>
#include <map>

namespace counterpoint::cia302
{

/// ProfileRig with the PLC Designer profile. SDO time-out 0.5 s.
class PlcRig : public ProfileRig
{
  public:
    explicit PlcRig(const SdoTimes& times = kPlcSdoTimes) : ProfileRig(times)
    {
        profile = &plc;
    }

    BusSlave& AddPlc(const std::uint8_t node)
    {
        setups.at(node).plc = &plc_slaves[node];
        return Add(node);
    }
    BusSlave& AddSafety(const std::uint8_t node)
    {
        setups.at(node).safety = expectation;
        return AddPlc(node);
    }
    void User(const std::uint8_t node, const std::uint16_t index, const std::uint8_t sub, const Octets& value)
    {
        BootRig::AddEntry(lists[node], index, sub, value);
        setups.at(node).concise_dcf = Bytes{lists[node].data(), static_cast<std::uint32_t>(lists[node].size())};
    }
    void Begin600()
    {
        Begin();
        Run(600U);
    }
    NmtAnswer Command(const NmtCommand what, const std::uint8_t node)
    {
        return Do([&] { return plc.Command(what, NodeId{node}, Now()); });
    }
    /// Every answer and change of a slave, as "state object abort".
    void OnNodeStatus(const NodeId node, const Instant now) noexcept override
    {
        ProfileRig::OnNodeStatus(node, now);
        const NodeStatus status = plc.Status(node);
        answers[node.value].push_back(status);
    }

    std::map<std::uint8_t, PlcSlave> plc_slaves{};
    std::map<std::uint8_t, Octets> lists{};
    std::map<std::uint8_t, std::vector<NodeStatus>> answers{};
    std::array<PlcNode, kNodeRoom> plc_nodes{};
    PlcStartUp plc{PlcParts{Parts(), plc_nodes.data()}};
};

} // namespace counterpoint::cia302

#endif
