// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Several causes of one SRDO in one cycle, as the bus hears of them.
#include "tests/canopen/device/device_rig.hpp"
#include "verification/trace/ids/kernel.hpp"
#include "verification/trace/ids/node.hpp"

namespace counterpoint::device
{
namespace
{

using DeviceCausesTest = DeviceRig;

// SCT 50 ms, 10 us from frame to frame.
TEST_F(DeviceCausesTest, EmergencyOfTheFirstCauseLeavesFirst)
{
    Verifies(req::SRS_DEV_013);
    Verifies(req::SRS_KRN_570);
    Run();
    Pair();
    Cycles(50U);
    Forget();
    // Given an SCT that has expired 10 us before a normal frame of one byte
    Frame(0x5FFU, {});
    Frame(0x101U, {0x12U});
    // When the next cycle sees both
    Cycles(3U);
    // Then the time-out (6) is told before the length (1), as the SRDO has it
    ASSERT_EQ(Emergencies(), (std::vector<unsigned>{0x8250U, 0x8210U}));
    EXPECT_EQ(Sent(0x82U)[0], (Octets{0x50U, 0x82U, 0x11U, 1U, 6U, 0U, 0U, 0U}));
    EXPECT_EQ(Sent(0x82U)[1], (Octets{0x10U, 0x82U, 0x11U, 1U, 1U, 0U, 0U, 0U}));
    EXPECT_EQ(core.GetState(CommunicationIndex{0x1301U}).first_cause, SrdoCause::kSct);
}

} // namespace
} // namespace counterpoint::device
