// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Slaves of the PLC Designer profile that refused an SDO of their start-up: they are started all the same.
#include "tests/runtime/manager/rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::tools
{
namespace
{
const std::vector<std::uint8_t> kRightType{0x43U, 0x00U, 0x10U, 0x00U, 0x91U, 0x01U, 0x00U, 0x00U};
const std::vector<std::uint8_t> kNotRestored{0x80U, 0x11U, 0x10U, 0x01U, 0x20U, 0x00U, 0x00U, 0x08U};
const std::vector<std::uint8_t> kRestored{0x60U, 0x11U, 0x10U, 0x01U, 0U, 0U, 0U, 0U};
const std::string kAbortTold = "0x1011:01: 0x08000020 (not stored)";

class ManagerAbortedTest : public test::ManagerRig
{
  protected:
    /// Slave 6 boots up, answers 1000h, and 1011h:01 by `restore`.
    void Boot(const std::vector<std::uint8_t>& restore, const std::string& keys = "")
    {
        Make("manager: {node: 127, profile: plc_designer" + keys +
             "}\nslaves: [{node: 6, device_type: 0x191, plc_designer: {reset_node: true}}]\n");
        Run(10U);
        Hear(0x706U, {0U});
        for (int ms = 0; ms < 4000; ++ms)
        {
            const auto asked = std::find_if(sent.begin(), sent.end(),
                                            [](const CanFrame& frame) { return frame.identifier == 0x606U; });
            const bool is_restore = asked != sent.end() && asked->data[1] == 0x11U;
            Answer(6U, is_restore ? restore : kRightType, 1);
        }
        Hear(0x706U, {0x7FU});
    }
    [[nodiscard]] bool IsGood()
    {
        const bool is_good = Row(6U).is_good;
        EXPECT_EQ(station->Assembly().HasStarted(), is_good);
        EXPECT_EQ(runtime::StatusJson(*station, now_us)["slaves"][0]["good"], is_good);
        return is_good;
    }
};

TEST_F(ManagerAbortedTest, OneThatRefusedAnSdoIsStartedAndNotGood)
{
    Verifies(req::SRS_PLC_585);
    Verifies(req::SRS_MGR_131);
    Boot(kNotRestored);
    ASSERT_EQ(Row(6U).result, "5");
    Hear(0x706U, {0x05U});
    EXPECT_EQ(Row(6U).finding, kAbortTold);
    EXPECT_FALSE(IsGood());
    // Near miss: one that takes it is good, and nothing was found
    Boot(kRestored);
    ASSERT_EQ(Row(6U).result, "5");
    Hear(0x706U, {0x05U});
    EXPECT_EQ(Row(6U).finding, "");
    EXPECT_TRUE(IsGood());
}

TEST_F(ManagerAbortedTest, TheAnswerToItsStartSaysWhatItRefused)
{
    Verifies(req::SRS_PLC_587);
    // Given slaves that only an order starts
    Boot(kNotRestored, ", start_up: 0x0D");
    ASSERT_EQ(Row(6U).result, "4");
    EXPECT_EQ(Order("start 6"), "taken; started all the same: node 6: 4: pre-operational (" + kAbortTold + ")");
    Run(2U);
    ASSERT_EQ(Row(6U).result, "5");
    EXPECT_FALSE(IsGood());
    // A start of all changes nothing for one that runs
    EXPECT_EQ(Order("start all"), "taken");
    Boot(kNotRestored, ", start_up: 0x0D");
    EXPECT_EQ(Order("start all"), "taken; started all the same: node 6: 4: pre-operational (" + kAbortTold + ")");
    Boot(kRestored, ", start_up: 0x0D");
    EXPECT_EQ(Order("start 6"), "taken");
}

TEST_F(ManagerAbortedTest, OneThatIsLeftOutIsNamedOnce)
{
    Verifies(req::SRS_PLC_587);
    // Given a slave that refuses 1000h: it is not started at all
    Make("manager: {node: 127, profile: plc_designer}\nslaves: [{node: 6, device_type: 0x191}]\n");
    Run(10U);
    Hear(0x706U, {0U});
    Answer(6U, {0x80U, 0x00U, 0x10U, 0x00U, 0x00U, 0x00U, 0x02U, 0x06U}, 1000);
    ASSERT_EQ(Row(6U).result, "98");
    const std::string answer = Order("start all");
    EXPECT_EQ(answer.find("started all the same"), std::string::npos) << answer;
    EXPECT_NE(answer.find("node 6 (98: "), std::string::npos) << answer;
    const std::string single = Order("start 6");
    EXPECT_EQ(single.find("started all the same"), std::string::npos) << single;
}
} // namespace
} // namespace counterpoint::tools
