// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What stays to be told of a slave that was started.
#include "tests/canopen/start_up/plc_designer/rig.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"

namespace counterpoint::cia302
{
namespace
{

class PlcFindingsTest : public PlcRig
{
  protected:
    /// A safety slave that could not be read, and is started by an order when it can.
    void StartAtLast()
    {
        gate.verdict = GateState::kFailed;
        gate.finding = GateFinding{{0x1301U, 1U}, SdoAbort::kTimeOut, 0U, 0U};
        Begin600();
        ASSERT_EQ(Code(5U), 4);
        ASSERT_EQ(Of(5U).object.index, 0x1301U);
        ASSERT_EQ(Of(5U).abort, SdoAbort::kTimeOut);
        gate.verdict = GateState::kOpen;
        ASSERT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
        Run(100U);
        ASSERT_EQ(Code(5U), 5);
    }
};

TEST_F(PlcFindingsTest, WhatTheGateFoundIsOverWhenItIsOpen)
{
    Verifies(req::SRS_PLC_586);
    AddSafety(5U);
    StartAtLast();
    EXPECT_EQ(Of(5U).object.index, 0U);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kNone);
}

TEST_F(PlcFindingsTest, WhatItsStartUpFoundStays)
{
    Verifies(req::SRS_PLC_586);
    Verifies(req::SRS_PLC_470);
    AddSafety(5U);
    User(5U, 0x2000U, 0U, {1U});
    slaves[5]->Behave(0x2000U, 0U, Manner::kAbort);
    StartAtLast();
    EXPECT_EQ(Of(5U).object.index, 0x2000U);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kObjectUnknown);
}

} // namespace
} // namespace counterpoint::cia302
