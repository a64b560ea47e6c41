// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Conditions of the EL6751 text that no row's own test has: silence in each row that has no read-back, networks and
// slaves to which a row does not apply.
#include "tests/canopen/start_up/el6751/rig.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"

namespace counterpoint::cia302
{
namespace
{

struct SilentRow
{
    std::uint16_t index;
    std::uint8_t sub;
    const char* line;
    StartUpStep step;
};

class El6751SilentRowTest : public El6751Rig, public ::testing::WithParamInterface<SilentRow>
{
};

INSTANTIATE_TEST_SUITE_P(Rows, El6751SilentRowTest,
                         ::testing::Values(SilentRow{0x1006U, 0U, "w 1006:00 10 27 00 00", StartUpStep::kSyncPeriod},
                                           SilentRow{0x5500U, 0U, "w 5500:00 07 00 00 00", StartUpStep::kPdo},
                                           SilentRow{0x1016U, 1U, "w 1016:01 2C 01 7F 00", StartUpStep::kHeartbeat},
                                           SilentRow{0x100CU, 0U, "w 100C:00 64 00", StartUpStep::kGuarding},
                                           SilentRow{0x100DU, 0U, "w 100D:00 03", StartUpStep::kGuarding},
                                           SilentRow{0x2000U, 0U, "w 2000:00 01", StartUpStep::kUserObjects}));

TEST_P(El6751SilentRowTest, EndsTheStartUpAndIsNoAbort)
{
    Verifies(req::SRS_ELM_025);
    const SilentRow& row = GetParam();
    // Given a slave with all these rows, which answers everything but this one
    setup.sync_period_us = 10000U;
    AddBox(5U);
    boxes[5].guard_time_ms = 100U;
    boxes[5].life_time_factor = 3U;
    boxes[5].coupler_pdos = 7U;
    boxes[5].kind = (row.index == 0x5500U) ? El6751Kind::kBusCoupler : El6751Kind::kGeneral;
    Tx(5U, MakePdo(1U, 0x185U, 1U, 2U, 0U, 0U));
    User(5U, 0x2000U, 0U, {1U});
    const bool is_guarded = (row.index == 0x100CU) || (row.index == 0x100DU);
    slaves[5]->Behave(0x1017U, 0U, is_guarded ? Manner::kAbort : Manner::kGood);
    slaves[5]->Behave(row.index, row.sub, Manner::kSilent);
    // When 2 s are over, then the row was the last one
    Begin();
    Run(1990U);
    EXPECT_EQ(Code(5U), 8);
    Run(100U);
    EXPECT_EQ(Code(5U), 4);
    EXPECT_EQ(Sdos(5U).back(), row.line);
    EXPECT_EQ(Of(5U).step, row.step);
    EXPECT_EQ(Of(5U).object.index, row.index);
    EXPECT_EQ(Of(5U).object.sub, row.sub);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kTimeOut);
    EXPECT_EQ(Nmt(), (Log{"0:82 00"}));
}

using El6751ConditionsTest = El6751Rig;

TEST_F(El6751ConditionsTest, WithoutASlaveNobodyIsStarted)
{
    Verifies(req::SRS_ELM_027);
    Begin();
    Run(3000U);
    EXPECT_EQ(Nmt(), (Log{"0:82 00"}));
}

TEST_F(El6751ConditionsTest, AHeldSlaveThatIsLostIsStoppedAndConfiguredAnew)
{
    Verifies(req::SRS_ELM_039);
    Verifies(req::SRS_ELM_042);
    // Given a supervised slave without automatic start
    AddBox(5U);
    boxes[5].is_started = false;
    boxes[5].guard_time_ms = 100U;
    boxes[5].life_time_factor = 3U;
    Begin();
    Run(500U);
    ASSERT_EQ(Code(5U), 12);
    told.clear();
    sent.clear();
    // When its heartbeat ends
    slaves[5]->heartbeat_us = 0U;
    Run(400U);
    // Then the reaction is the default one, and it is held again
    EXPECT_EQ(told[5], (Log{"1", "8", "12"}));
    ASSERT_EQ(Nmt().size(), 2U);
    EXPECT_EQ(Nmt()[0].substr(4U), "02 05");
    EXPECT_EQ(Nmt()[1].substr(4U), "82 05");
    EXPECT_EQ(slaves[5]->state, 127U);
}

TEST_F(El6751ConditionsTest, ANodeThatIsNotListedTakesNoCommandThoughItSaysItsState)
{
    Verifies(req::SRS_ELM_047);
    AddBox(5U);
    AddBox(6U);
    setups[6].assignment = 0U;
    Begin();
    Run(100U);
    slaves[6]->Turn(127U);
    slaves[6]->Beat();
    Run(10U);
    sent.clear();
    EXPECT_EQ(Control(6U, 5U, 1U), NmtAnswer::kWrong);
    EXPECT_EQ(Control(6U, 6U, 0U), NmtAnswer::kWrong);
    Run(10U);
    EXPECT_EQ(Nmt(), (Log{}));
}

// t [ms]   SYNC + 5      SYNC + 5
// 185h     2 of 4 bytes  4 of 4 bytes, behind the window
// state    20            0
TEST_F(El6751ConditionsTest, ATxPdoIsTooShortUntilOneIsNotThoughThatOneIsLate)
{
    Verifies(req::SRS_ELM_038);
    Verifies(req::SRS_ELM_043);
    setup.sync_period_us = 10000U;
    AddBox(5U);
    boxes[5].node_reaction = El6751NodeReaction::kNone;
    Tx(5U, MakePdo(1U, 0x185U, 2U, 4U, 0U, 0U));
    Begin();
    Run(205U);
    ASSERT_EQ(Code(5U), 23);
    Put(0x185U, {1U, 2U});
    EXPECT_EQ(Code(5U), 20);
    Run(10U);
    EXPECT_EQ(Code(5U), 20);
    Put(0x185U, {1U, 2U, 3U, 4U});
    Run(1U);
    EXPECT_EQ(Code(5U), 0);
}

} // namespace
} // namespace counterpoint::cia302
