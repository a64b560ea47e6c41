// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The SDO server of the manager beside its requests to slaves, where the bus takes one frame at a time.
#include "tests/runtime/manager/rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::tools
{
namespace
{
using test::kAnswers;
using test::kRequests;
using test::Lines;

/// Given slave 6, whose first request found no room, and a client whose question did not either.
class FullStationTest : public test::ManagerRig
{
  protected:
    void AskWithoutRoom()
    {
        Make("manager: {node: 127}\nslaves: [{node: 6}]\n");
        Run(2U);
        room = 0U;
        Hear(0x706U, {0x00U});
        Hear(kRequests, {0x40U, 0x80U, 0x1FU, 0U, 0U, 0U, 0U, 0U});
        Run(5U);
        sent.clear();
    }
    [[nodiscard]] std::vector<std::uint32_t> Sent() const
    {
        std::vector<std::uint32_t> identifiers;
        for (const CanFrame& frame : sent)
        {
            identifiers.push_back(frame.identifier);
        }
        return identifiers;
    }
};

TEST_F(FullStationTest, AnAnswerThatFoundNoRoomGoesBeforeARequestInACycle)
{
    Verifies(req::SRS_MGR_321);
    AskWithoutRoom();
    room = 1U;
    Run(1U);
    EXPECT_EQ(Sent(), (std::vector<std::uint32_t>{kAnswers}));
    EXPECT_EQ(sent.front().data[4], 1U); // 1F80h.
    room = 1U;
    Run(1U);
    EXPECT_EQ(Sent(), (std::vector<std::uint32_t>{kAnswers, 0x606U}));
}

// The slave answers, which makes room for the next request.
TEST_F(FullStationTest, AnAnswerThatFoundNoRoomGoesBeforeTheRequestBehindAFrame)
{
    Verifies(req::SRS_MGR_321);
    Make("manager: {node: 127}\nslaves: [{node: 6, device_type: 0x191, vendor_id: 0x2A, product_code: 3}]\n");
    Run(2U);
    Hear(0x706U, {0x00U});
    Run(2U);
    Hear(0x586U, {0x43U, 0x00U, 0x10U, 0U, 0x91U, 0x01U, 0U, 0U});
    room = 0U;
    Run(2U);
    Hear(kRequests, {0x40U, 0x80U, 0x1FU, 0U, 0U, 0U, 0U, 0U});
    sent.clear();
    room = 1U;
    Hear(0x586U, {0x43U, 0x18U, 0x10U, 1U, 0x2AU, 0U, 0U, 0U});
    EXPECT_EQ(Sent(), (std::vector<std::uint32_t>{kAnswers}));
}

TEST_F(FullStationTest, ACommandGoesBeforeAnAnswerThatFoundNoRoom)
{
    Verifies(req::SRS_MGR_321);
    AskWithoutRoom();
    EXPECT_EQ(Order("stop 6"), "taken");
    room = 1U;
    Hear(0x701U, {0x05U});
    EXPECT_EQ(Commands(), (Lines{"2 6"}));
    room = 1U;
    Hear(0x701U, {0x05U});
    EXPECT_EQ(Sent(), (std::vector<std::uint32_t>{0U, kAnswers}));
}
} // namespace
} // namespace counterpoint::tools
