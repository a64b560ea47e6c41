// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_CANOPEN_CIA302_NETWORK_NODE_TABLE_RIG_HPP
#define TESTS_CANOPEN_CIA302_NETWORK_NODE_TABLE_RIG_HPP

#include "canopen/cia302/network/node_table.hpp"
#include "tests/canopen/cia301/keeping_sink.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace counterpoint::cia302
{

/// Node 5 is listed. Time in ms from the start; the counter wraps early in each test.
class NodeTableTest : public ::testing::Test, public NodeListener
{
  public:
    NodeTableTest()
    {
        slaves[5].assignment = kInNetwork;
    }
    void OnNodeEvent(NodeId node, NodeEvent event, Instant) noexcept override
    {
        EXPECT_EQ(node.value, watched);
        events.push_back(event);
    }
    [[nodiscard]] Instant Now() const
    {
        return Instant{0xFFFF'FF00U + (1000U * ms)};
    }
    void Hear(std::uint8_t byte)
    {
        const CanFrame frame{0x700U + watched, FrameKind::kData, CanPortId::kFirst, 1U, {byte}};
        table.OnFrame(frame, Now());
    }
    /// An answer by SDO.
    void Answer(const std::uint8_t length)
    {
        table.OnFrame(CanFrame{0x585U, FrameKind::kData, CanPortId::kFirst, length, {0x43U}}, Now());
    }
    /// A command of somebody else.
    void Foreign(const NmtCommand command, const std::uint8_t node)
    {
        table.OnFrame(CanFrame{0U, FrameKind::kData, CanPortId::kFirst, 2U, {static_cast<std::uint8_t>(command), node}},
                      Now());
    }
    void At(std::uint32_t time_ms)
    {
        while (ms < time_ms)
        {
            ++ms;
            table.OnCycle(Now());
        }
    }
    /// The events since the last call.
    std::vector<NodeEvent> Told()
    {
        std::vector<NodeEvent> told{};
        told.swap(events);
        return told;
    }
    [[nodiscard]] SlaveState State() const
    {
        return table.Record(NodeId{watched}).state;
    }
    void Sent(NmtCommand command, std::uint8_t node)
    {
        table.OnNmtSent(NmtRequest{command, NodeId{node}}, Now());
    }

    std::uint8_t watched{5U};
    std::uint32_t ms{0U};
    std::vector<NodeEvent> events{};
    std::array<SlaveSetup, kNodeRoom> slaves{};
    NetworkSetup setup{NodeId{127U}, kIsMaster, 0U, 0U, 0U, slaves.data()};
    cia301::KeepingSink sink{};
    std::array<NodeRecord, kNodeRoom> records{};
    NodeTable table{NodeTableParts{records.data(), setup, sink, *this}};
};

using Events = std::vector<NodeEvent>;

} // namespace counterpoint::cia302

#endif
