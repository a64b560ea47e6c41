// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/device.hpp"
#include "tests/tools/echo_bus.hpp"
#include "verification/trace/ids/cia301.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

// A device from a file that supervises more nodes than a producer of emergencies has places of its own.
namespace counterpoint::tools::test
{
namespace
{
constexpr std::uint64_t kNsPerUs = 1000U;
constexpr std::uint64_t kNsPerMs = 1000000U;
constexpr std::uint8_t kNodes = 20U;
constexpr std::uint8_t kFirstNode = 21U;

/// The slave of the tests with 20 entries in 1016h: nodes 21 to 40, 50 ms each.
std::string FileWithManyNodes()
{
    std::ifstream file(std::string(COUNTERPOINT_SOURCE) + "/tests/runtime/data/third_party_slave.dcf");
    std::stringstream text;
    text << file.rdbuf();
    std::string dcf = text.str();
    const std::size_t first = dcf.find("[1016]");
    std::string entries = "[1016]\nParameterName=Consumer heartbeat time\nObjectType=0x8\nSubNumber=21\n\n"
                          "[1016sub0]\nParameterName=Highest sub-index supported\nObjectType=0x7\nDataType=0x0005\n"
                          "AccessType=const\nDefaultValue=20\nPDOMapping=0\n\n";
    for (unsigned number = 1U; number <= kNodes; ++number)
    {
        std::ostringstream entry;
        entry << "[1016sub" << std::hex << std::uppercase << number << "]\nParameterName=Consumer heartbeat time\n"
              << "ObjectType=0x7\nDataType=0x0007\nAccessType=rw\nDefaultValue=0x"
              << ((std::uint32_t{kFirstNode} + number - 1U) << 16U) + 50U << "\nPDOMapping=0\n\n";
        entries += entry.str();
    }
    dcf.replace(first, dcf.find("[1017]") - first, entries);
    const std::string name = ::testing::TempDir() + "many_nodes.dcf";
    std::ofstream(name) << dcf;
    return name;
}

runtime::NodeSettings SettingsOf(const std::string& dcf)
{
    runtime::NodeSettings settings;
    settings.dcf = dcf;
    settings.has_self_tests = false;
    return settings;
}

/// Codes of the emergencies of node 10 among these frames.
std::vector<unsigned> CodesIn(const std::vector<host::LiveFrame>& frames)
{
    std::vector<unsigned> codes;
    for (const host::LiveFrame& frame : frames)
    {
        if (frame.identifier == 0x8AU)
        {
            codes.push_back(frame.data[0] | (unsigned{frame.data[1]} << 8U));
        }
    }
    return codes;
}

TEST(NodeEmergencyTest, EachOfManyLostNodesIsToldAndItsReturnToo)
{
    Verifies(req::SRS_EMCY_010);
    Verifies(req::SRS_DEV_012);
    std::ostringstream out;
    runtime::NodeReport report{out, runtime::ReportForm::kText, 0U};
    auto services = std::make_unique<EchoBus>(false, 0U);
    EchoBus& bus = *services;
    runtime::NodePorts ports{std::make_unique<EchoBus>(false, 0U), std::move(services)};
    runtime::NodeDevice device{SettingsOf(FileWithManyNodes()), ports, report};
    std::uint64_t now_ns = kNsPerMs;
    const auto now = [&now_ns]
    {
        const Instant instant{static_cast<std::uint32_t>(now_ns / kNsPerUs)};
        return InstantPair{instant, instant};
    };
    const auto beat = [&device, &now, &now_ns]
    {
        for (std::uint32_t number = 0U; number < kNodes; ++number)
        {
            device.OnFrame(FrameOf(0x700U + kFirstNode + number, {5U}, now_ns), CanPortId::kFirst, now());
        }
    };
    const auto serve = [&device, &now, &now_ns, &bus](const int milliseconds)
    {
        for (int count = 0; count < milliseconds; ++count)
        {
            host::LiveFrame own;
            while (bus.Receive(own))
            {
                device.OnFrame(own, CanPortId::kFirst, now());
            }
            device.Serve(now(), now_ns);
            now_ns += kNsPerMs;
        }
    };
    ASSERT_TRUE(device.PowerOn(now(), now_ns)) << out.str();
    // Given 20 nodes that were heard once, and never again
    beat();
    serve(40);
    EXPECT_TRUE(CodesIn(bus.Sent()).empty());
    serve(60);
    // Then 20 errors were told, and all are over with the next heartbeats
    EXPECT_EQ(CodesIn(bus.Sent()), std::vector<unsigned>(20U, 0x8130U));
    EXPECT_EQ(device.Assembly().Dictionary().ReadNumber({0x1001U, 0U}).value, 0x11U);
    beat();
    serve(40);
    std::vector<unsigned> all(20U, 0x8130U);
    all.insert(all.end(), 20U, 0U);
    EXPECT_EQ(CodesIn(bus.Sent()), all);
    EXPECT_EQ(device.Assembly().Dictionary().ReadNumber({0x1001U, 0U}).value, 0x00U);
}
} // namespace
} // namespace counterpoint::tools::test
