// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// A node whose node-ID LSS takes away.
#include "runtime/node/device.hpp"
#include "tests/tools/echo_bus.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
namespace
{
constexpr std::uint64_t kNsPerMs = 1000000U;

class LostNodeIdTest : public ::testing::Test
{
  protected:
    void Hear(const std::uint32_t identifier, const std::vector<std::uint8_t>& data)
    {
        host::LiveFrame frame;
        frame.identifier = identifier;
        frame.length_bytes = static_cast<std::uint8_t>(data.size());
        std::copy(data.begin(), data.end(), &frame.data[0]);
        device->OnFrame(frame, CanPortId::kFirst, {Instant{0U}, Instant{0U}});
        now_ns += kNsPerMs;
        device->Serve({Instant{0U}, Instant{0U}}, now_ns);
    }
    [[nodiscard]] std::size_t Count(const std::string& text) const
    {
        std::size_t count = 0U;
        const std::string told = out.str();
        for (std::size_t at = told.find(text); at != std::string::npos; at = told.find(text, at + 1U))
        {
            ++count;
        }
        return count;
    }

    std::ostringstream out{};
    NodeReport report{out, ReportForm::kText, 0U};
    NodePorts ports{std::make_unique<tools::test::EchoBus>(false, 0U),
                    std::make_unique<tools::test::EchoBus>(false, 0U)};
    std::unique_ptr<NodeDevice> device{};
    std::uint64_t now_ns{kNsPerMs};
};

TEST_F(LostNodeIdTest, ANodeIdThatLssTakesAwayIsTold)
{
    Verifies(req::SRS_NODE_470);
    const std::string lost = "LSS took node-ID 9 away: node without a node-ID";
    NodeSettings settings;
    settings.dcf = std::string(COUNTERPOINT_SOURCE) + "/tests/runtime/data/everything.dcf";
    settings.cycle_us = 5000U;
    settings.node_id = 9U;
    settings.has_lss = true;
    settings.has_self_tests = false;
    device = std::make_unique<NodeDevice>(settings, ports, report);
    ASSERT_TRUE(device->PowerOn({Instant{0U}, Instant{0U}}, now_ns));
    // Given a reset communication with its node-ID
    Hear(0x000U, {0x82U, 9U});
    // When LSS configures 255 for it, which is not active yet
    Hear(0x7E5U, {0x04U, 1U, 0U, 0U, 0U, 0U, 0U, 0U});
    Hear(0x7E5U, {0x11U, 0xFFU, 0U, 0U, 0U, 0U, 0U, 0U});
    Hear(0x7E5U, {0x04U, 0U, 0U, 0U, 0U, 0U, 0U, 0U});
    // Then it is told with the reset that makes it so, in the sixth millisecond, once
    Hear(0x000U, {0x82U, 9U});
    Hear(0x000U, {0x82U, 0U});
    static_cast<void>(report.Finish());
    EXPECT_EQ(Count("NMT pre_operational"), 2U) << out.str();
    EXPECT_EQ(Count(lost), 1U) << out.str();
    EXPECT_EQ(Count("0.006000 s  " + lost), 1U) << out.str();
}
} // namespace
} // namespace counterpoint::runtime
