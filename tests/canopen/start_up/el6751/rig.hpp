// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_CANOPEN_START_UP_EL6751_RIG_HPP
#define TESTS_CANOPEN_START_UP_EL6751_RIG_HPP

#include "canopen/start_up/el6751/start_up.hpp"
#include "tests/canopen/start_up/profile_rig.hpp"

#include <array>
#include <map>
#include <vector>

namespace counterpoint::cia302
{

/// ProfileRig with the EL6751 profile. SDO time-out 2 s unless a test has another one.
class El6751Rig : public ProfileRig
{
  public:
    explicit El6751Rig(const El6751Times& network_times = El6751Times{}, const SdoTimes& sdo_times = kEl6751SdoTimes)
        : ProfileRig(sdo_times), times(network_times)
    {
        profile = &el;
    }

    /// A slave with its part of the profile; PDOs are added by Rx and Tx before Begin.
    BusSlave& AddBox(const std::uint8_t node)
    {
        setups.at(node).el6751 = &boxes[node];
        return Add(node);
    }
    void Rx(const std::uint8_t node, const El6751Pdo& pdo)
    {
        rx[node].push_back(pdo);
        boxes[node].rx_pdos = rx[node].data();
        boxes[node].rx_count = static_cast<std::uint8_t>(rx[node].size());
    }
    void Tx(const std::uint8_t node, const El6751Pdo& pdo)
    {
        tx[node].push_back(pdo);
        boxes[node].tx_pdos = tx[node].data();
        boxes[node].tx_count = static_cast<std::uint8_t>(tx[node].size());
    }
    void User(const std::uint8_t node, const std::uint16_t index, const std::uint8_t sub, const Octets& value)
    {
        BootRig::AddEntry(lists[node], index, sub, value);
        setups.at(node).concise_dcf = Bytes{lists[node].data(), static_cast<std::uint32_t>(lists[node].size())};
    }
    /// A safety slave; what the gate says is up to FakeGate.
    BusSlave& AddSafety(const std::uint8_t node)
    {
        setups.at(node).safety = expectation;
        return AddBox(node);
    }
    NmtAnswer Control(const std::uint8_t node, const std::uint16_t ads_state, const std::uint16_t device_state)
    {
        return Do([&] { return el.Control(NodeId{node}, ads_state, device_state, Now()); });
    }
    /// SDOs of a slave since Begin, without NMT.
    [[nodiscard]] Log Sdos(const std::uint8_t node)
    {
        Log list{};
        for (const std::string& line : slaves[node]->log)
        {
            if (line[0] != 'n')
            {
                list.push_back(line);
            }
        }
        return list;
    }
    void OnOwnFrame(const CanFrame& frame) override
    {
        el.OnSent(frame);
    }

    std::map<std::uint8_t, El6751Slave> boxes{};
    std::map<std::uint8_t, std::vector<El6751Pdo>> rx{};
    std::map<std::uint8_t, std::vector<El6751Pdo>> tx{};
    std::map<std::uint8_t, Octets> lists{};
    std::array<El6751Node, kNodeRoom> el_nodes{};
    std::array<El6751PdoRecord, 64> records{};
    El6751Times times;
    El6751StartUp el{El6751Parts{Parts(), el_nodes.data(), El6751PdoRoom{records.data(), 64U}, times}};
};

/// PDO by number, COB-ID, type, bytes, inhibit (100 us) and event time (ms).
[[nodiscard]] inline El6751Pdo MakePdo(const std::uint16_t number, const std::uint32_t cob_id, const std::uint8_t type,
                                       const std::uint8_t length, const std::uint16_t inhibit,
                                       const std::uint16_t event)
{
    El6751Pdo pdo{};
    pdo.number = number;
    pdo.cob_id = cob_id;
    pdo.type = type;
    pdo.length_bytes = length;
    pdo.inhibit_100us = inhibit;
    pdo.event_ms = event;
    return pdo;
}

} // namespace counterpoint::cia302

#endif
