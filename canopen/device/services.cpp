// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/device/services.hpp"

namespace counterpoint::device
{
namespace
{

constexpr std::uint32_t kCobOff = 0x80000000U;
constexpr std::uint32_t kEmergencyIdentifier = 0x80U;
constexpr std::uint16_t kGuardTimeIndex = 0x100CU;
constexpr std::uint16_t kLifeFactorIndex = 0x100DU;
constexpr cia301::StartUp kNoStartUp{false, 0U};

} // namespace

Services::Services(const cia301::NodeId own_node, const cia301::SupervisedNodes& room) noexcept
    : node(own_node), supervised(room), slave(own_node, kNoStartUp), emergency(own_node), errors(emergency),
      consumer(room, *this), producer(own_node), guarding(own_node),
      objects({emergency, consumer, producer, guarding, room.count})
{
}

void Services::Reset() noexcept
{
    static_cast<void>(emergency.WriteCobId(emergency.CobId() | kCobOff)); // Off, then another identifier may come.
    static_cast<void>(emergency.WriteCobId(kEmergencyIdentifier + node.value));
    emergency.SetInhibitTime(0U);
    for (std::uint8_t place = 0U; place < supervised.count; ++place)
    {
        supervised.nodes[place] = cia301::SupervisedNode{};
    }
    producer.SetPeriod(0U);
    constexpr std::uint8_t kZero[2] = {0U, 0U};
    static_cast<void>(objects.OnWrite({kGuardTimeIndex, 0U}, {kZero, 2U}));
    static_cast<void>(objects.OnWrite({kLifeFactorIndex, 0U}, {kZero, 1U}));
    guarding.Reset();
}

void Services::SetStartUp(const cia301::StartUp& start_up) noexcept
{
    slave = cia301::NmtSlave{node, start_up};
    static_cast<void>(slave.Advance()); // To reset application,
    static_cast<void>(slave.Advance()); // and back to where it was: reset communication.
}

} // namespace counterpoint::device
