// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What is told of a slave while it boots: each change, and until when it is kept.
#include "tests/canopen/start_up/boot_rig.hpp"
#include "verification/trace/ids/nmt_master.hpp"

#include <cstdint>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace counterpoint::cia302
{
namespace
{

using Lines = std::vector<std::string>;

std::string TextOf(const NodeStatus& status)
{
    std::ostringstream text;
    text << ((status.letter == '\0') ? '-' : status.letter) << std::hex << " " << status.object.index << ":"
         << int{status.object.sub} << " abort " << static_cast<std::uint32_t>(status.abort) << " expected "
         << status.expected << " read " << status.read;
    return text.str();
}

class BootToldTest : public BootRig
{
  public:
    void OnNodeStatus(const NodeId node, const Instant /*now*/) noexcept override
    {
        const NodeStatus status = start_up.Status(node);
        steps[node.value] = status.step;
        const std::string text = TextOf(status);
        Lines& lines = told[node.value];
        if (lines.empty() || (lines.back() != text))
        {
            lines.push_back(text);
        }
    }
    /// In each cycle what was told last is what there is.
    void Live(const std::uint32_t cycles)
    {
        for (std::uint32_t cycle = 0U; cycle < cycles; ++cycle)
        {
            Run(1U);
            for (const auto& [node, lines] : told)
            {
                ASSERT_EQ(lines.back(), TextOf(Of(node))) << int{node} << " at " << ms;
                ASSERT_EQ(steps[node], Of(node).step) << int{node} << " at " << ms;
            }
        }
    }

    std::map<std::uint8_t, Lines> told{};
    std::map<std::uint8_t, StartUpStep> steps{};
};

TEST_F(BootToldTest, IsEachChangeOfEachNodeAndItIsKeptUntilItsNextBoot)
{
    Verifies(req::SRS_BOOT_019);
    // Given a slave of another serial number, one that does not give its own, and one as expected
    Add(10U, kBoot).Put32(0x1018U, 4U, 0xBADU);
    Add(11U, kBoot).refused[0x101804U] = SdoAbort::kHardware;
    Add(12U, kBoot);
    Begin();
    Live(5000U);
    const std::string other = "O 1018:4 abort 0 expected 1234 read bad";
    const std::string none = "O 1018:4 abort 6060000 expected 1234 read 0";
    EXPECT_EQ(told[10U].back(), other);
    EXPECT_EQ(told[11U].back(), none);
    EXPECT_EQ(Letter(12U), "-");
    EXPECT_EQ(steps[10U], StartUpStep::kSerialNumber);
    EXPECT_EQ(steps[11U], StartUpStep::kSerialNumber);
    EXPECT_EQ(steps[12U], StartUpStep::kDone);
    // When the first one boots anew, then nothing of it is left, which is told, and the second one keeps its own
    told[10U].clear();
    const Lines kept = told[11U];
    slaves[10]->Put32(0x1018U, 4U, 0x1234U);
    EXPECT_TRUE(start_up.Boot(NodeId{10U}, Now()));
    ASSERT_FALSE(told[10U].empty());
    EXPECT_EQ(told[10U].front(), "- 0:0 abort 0 expected 0 read 0");
    Live(100U);
    EXPECT_EQ(steps[10U], StartUpStep::kDone);
    EXPECT_EQ(told[11U], kept);
    EXPECT_EQ(TextOf(Of(11U)), none);
}

} // namespace
} // namespace counterpoint::cia302
