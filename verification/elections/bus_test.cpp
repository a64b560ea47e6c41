// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The light bus against the complete one of hal/host: same frames, same instants, same bus-off.
#include "verification/elections/bus.hpp"

#include "hal/host/virtual/bus.hpp"
#include "simulator/faults/random.hpp"
#include "verification/trace/ids/flying_master.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace counterpoint::elections
{
namespace
{

constexpr std::size_t kNodes = 3U;
constexpr Time kBit = 8;
constexpr Time kStep = 40;

/// What happened on a bus, as lines of text.
using Lines = std::vector<std::string>;

std::string Line(const Time at, const CanFrame& frame, const std::size_t senders)
{
    std::string line = std::to_string(at) + " " + std::to_string(frame.identifier) + " x" + std::to_string(senders);
    for (std::uint8_t i = 0U; i < frame.length_bytes; ++i)
    {
        line += " " + std::to_string(frame.data[i]);
    }
    return line;
}

class LightWriter final : public BusUser
{
  public:
    void OnComplete(const CanFrame& frame, const std::vector<std::size_t>& senders) override
    {
        lines.push_back(Line(now, frame, senders.size()));
    }
    void OnBusOff(const std::size_t node) override
    {
        lines.push_back(std::to_string(now) + " bus-off " + std::to_string(node));
    }

    Lines lines{};
    Time now{0};
};

class FullWriter final : public host::BusObserver
{
  public:
    void OnBusRecord(const host::BusRecord& record) override
    {
        if (record.fate == host::FrameFate::kComplete)
        {
            const std::size_t senders = kNodes - record.receivers;
            lines.push_back(Line(record.end / host::kMicrosecond, record.sent.frame, senders));
        }
    }

    Lines lines{};
};

class FullNode final : public host::BusListener
{
  public:
    void OnReceived(const CanFrame& /*frame*/, host::BusTime /*at*/) override
    {
    }
    void OnConfirmed(const CanFrame& /*frame*/, host::BusTime /*at*/) override
    {
    }
    void OnBusOff(const host::BusTime at) override
    {
        writer->lines.push_back(std::to_string(at / host::kMicrosecond) + " bus-off " + std::to_string(index));
    }

    FullWriter* writer{nullptr};
    std::size_t index{0U};
};

struct Sending
{
    Time at;
    std::size_t node;
    CanFrame frame;
};

Lines OnLight(const std::vector<Sending>& sendings, const Time end)
{
    LightWriter writer{};
    Bus bus(writer, kBit);
    bus.Clear(kNodes);
    for (std::size_t node = 0U; node < kNodes; ++node)
    {
        bus.Attach(node, true, 0);
    }
    std::size_t next = 0U;
    while (writer.now <= end)
    {
        bus.Finish(writer.now);
        for (; (next < sendings.size()) && (sendings[next].at == writer.now); ++next)
        {
            static_cast<void>(bus.Submit(sendings[next].node, sendings[next].frame));
        }
        bus.Arbitrate(writer.now);
        const Time submit = (next < sendings.size()) ? sendings[next].at : (end + 1);
        writer.now = std::min(std::max(writer.now, std::min(bus.Next(), submit)), end + 1);
    }
    return writer.lines;
}

Lines OnFull(const std::vector<Sending>& sendings, const Time end)
{
    host::VirtualBus bus(host::BitRate::k125k);
    FullWriter writer{};
    std::array<FullNode, kNodes> nodes{};
    for (std::size_t i = 0U; i < kNodes; ++i)
    {
        nodes[i].writer = &writer;
        nodes[i].index = bus.Attach(nodes[i], host::NodeSetup{CanPortId::kFirst, 16U});
    }
    for (const Sending& sending : sendings)
    {
        bus.Advance(sending.at * host::kMicrosecond, &writer);
        static_cast<void>(bus.Submit(sending.node, sending.frame));
    }
    bus.Advance(end * host::kMicrosecond, &writer);
    return writer.lines;
}

CanFrame Service(const std::uint32_t identifier, const std::uint8_t level, const std::uint8_t node)
{
    const std::uint8_t length = (identifier == 0x71U) ? 2U : 0U;
    return CanFrame{identifier, FrameKind::kData, CanPortId::kFirst, length, {level, node}};
}

TEST(ElectionBus, SameFramesAtTheSameInstantsAsTheCompleteModel)
{
    Verifies(req::SRS_FLY_023);
    simulator::Random random(11U);
    std::size_t merged = 0U;
    for (int run = 0; run < 200; ++run)
    {
        // Given 30 services of three nodes, many at the same instant; claims are of one node, so that none collide
        std::vector<Sending> sendings{};
        Time at = 0;
        for (int i = 0; i < 30; ++i)
        {
            const std::uint32_t identifier = 0x71U + random.Below(6U);
            const std::size_t node = (identifier == 0x71U) ? 0U : random.Below(kNodes);
            sendings.push_back(Sending{at, node, Service(identifier, 1U, 5U)});
            at += (random.Below(2U) == 0U) ? 0 : (kStep * (1 + random.Below(60U)));
        }
        // When both buses carry them
        const Lines light = OnLight(sendings, at + kSecond);
        // Then they agree on order, instants and merged frames
        ASSERT_EQ(light, OnFull(sendings, at + kSecond)) << "run " << run;
        for (const std::string& line : light)
        {
            merged += (line.find(" x1") == std::string::npos) ? 1U : 0U;
        }
    }
    EXPECT_GT(merged, 100U);
}

TEST(ElectionBus, TwoDifferentClaimsAtOneInstantEndInBusOffOfBoth)
{
    Verifies(req::SRS_FLY_150);
    // Given two masters that claim in the same instant
    const std::vector<Sending> sendings{{100, 0U, Service(0x71U, 1U, 2U)}, {100, 1U, Service(0x71U, 1U, 3U)}};
    // When both buses carry them
    const Lines light = OnLight(sendings, kSecond);
    // Then nothing is complete: 32 collisions, and both are off in one instant
    ASSERT_EQ(light.size(), 2U);
    EXPECT_NE(light[0].find("bus-off 0"), std::string::npos);
    EXPECT_NE(light[1].find("bus-off 1"), std::string::npos);
    EXPECT_EQ(light, OnFull(sendings, kSecond));
}

} // namespace
} // namespace counterpoint::elections
