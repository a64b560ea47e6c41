// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Who a safety slave is, asked with each verification and before each writing.
#include "canopen/start_up/el6751/setup.hpp"
#include "tests/canopen/manager/rig.hpp"
#include "verification/trace/ids/manager.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr NodeId kSlave{5U};

struct RowCase
{
    IdentityRule rule;
    El6751Kind kind;
    bool is_type_checked;
    std::array<std::uint32_t, 5U> masks; ///< 1000h, 1018h:01 to :04.
};

TEST(SafetyIdentityRows, AreThoseOfTheProfile)
{
    Verifies(req::SRS_SFS_215);
    constexpr std::uint32_t kAll = 0xFFFFFFFFU;
    const RowCase cases[] = {
        {IdentityRule::kCia302, El6751Kind::kBusCoupler, false, {kAll, kAll, kAll, kAll, kAll}},
        {IdentityRule::kEl6751, El6751Kind::kGeneral, true, {kAll, kAll, kAll, kAll, kAll}},
        {IdentityRule::kEl6751, El6751Kind::kGeneral, false, {0U, kAll, kAll, kAll, kAll}},
        {IdentityRule::kEl6751, El6751Kind::kBusCoupler, true, {kAll, kAll, kAll, 0U, 0U}},
        {IdentityRule::kPlcDesigner, El6751Kind::kGeneral, true, {0xFFFFU, 0U, 0U, 0U, 0U}},
    };
    const std::array<ObjectAddress, 5U> objects{
        {{0x1000U, 0U}, {0x1018U, 1U}, {0x1018U, 2U}, {0x1018U, 3U}, {0x1018U, 4U}}};
    for (const RowCase& one : cases)
    {
        El6751Slave box{};
        box.kind = one.kind;
        box.is_device_type_checked = one.is_type_checked;
        SlaveSetup slave{};
        slave.el6751 = &box;
        for (std::uint8_t row = 0U; row < 5U; ++row)
        {
            // Nothing expected: not asked, but the device type of EL6751.
            const bool is_type = (one.rule == IdentityRule::kEl6751) && (row == 0U) && one.is_type_checked;
            EXPECT_EQ(IdentityRowOf(slave, one.rule, row).mask, is_type ? kAll : 0U);
        }
        slave.device_type = 11U;
        slave.vendor_id = 12U;
        slave.product_code = 13U;
        slave.revision_number = 14U;
        slave.serial_number = 15U;
        for (std::uint8_t row = 0U; row < 5U; ++row)
        {
            const IdentityRow found = IdentityRowOf(slave, one.rule, row);
            EXPECT_EQ(found.object.index, objects[row].index);
            EXPECT_EQ(found.object.sub, objects[row].sub);
            EXPECT_EQ(found.expected, 11U + row);
            EXPECT_EQ(found.mask, one.masks[row]);
        }
        EXPECT_EQ(IdentityRowOf(slave, one.rule, 5U).mask, 0U);
    }
    SlaveSetup slave{};
    slave.device_type = 11U;
    EXPECT_EQ(IdentityRowOf(slave, IdentityRule::kEl6751, 0U).mask, kAll);
}

/// Given a safety slave 5 that a device replaces unheard: other device, very same safety configuration.
class SafetyIdentityTest : public ManagerRig, public ::testing::WithParamInterface<Profile>
{
  public:
    SafetyIdentityTest()
    {
        Add(5U).heartbeat_ms = 100U;
        MakeSafe(5U);
    }
    /// What PLC Designer compares is another object.
    void Replace()
    {
        const bool is_plc = (GetParam() == Profile::kPlcDesigner);
        devices[0]->Put32(is_plc ? 0x1000U : 0x1018U, is_plc ? 0U : 4U, is_plc ? 0x192U : 0x4321U);
    }
    void RunUntil(const GateState state)
    {
        for (int i = 0; (i < 5000) && (Gate() != state); ++i)
        {
            Run(1U);
        }
        ASSERT_EQ(Gate(), state);
    }
    void ExpectOther()
    {
        const bool is_plc = (GetParam() == Profile::kPlcDesigner);
        const GateFinding finding = manager->Gate().Finding(kSlave);
        EXPECT_EQ(Gate(), GateState::kDiffers);
        EXPECT_EQ(finding.object.index, is_plc ? 0x1000U : 0x1018U);
        EXPECT_EQ(finding.object.sub, is_plc ? 0U : 4U);
        EXPECT_EQ(finding.expected, is_plc ? 0x191U : 0x1234U);
        EXPECT_EQ(finding.read, is_plc ? 0x192U : 0x4321U);
        EXPECT_TRUE(manager->Status(kSlave).is_other);
        EXPECT_EQ(manager->Status(kSlave).object.index, finding.object.index);
        EXPECT_EQ(manager->Status(kSlave).letter, (GetParam() == Profile::kCia302) ? 'O' : '\0');
        EXPECT_TRUE(!is_plc || (manager->Status(kSlave).code == kPlcWrongType));
        EXPECT_TRUE(!is_plc || (manager->Status(kSlave).step == StartUpStep::kDeviceType));
        EXPECT_EQ(Running(5U), 0);
        EXPECT_EQ(Order(NmtCommand::kStart, 5U), NmtAnswer::kOtherDevice);
        EXPECT_FALSE(manager->WriteSafety(kSlave, Now()));
    }
};

TEST_P(SafetyIdentityTest, ReplacedUnheardWhileItIsReadIsNotStarted)
{
    Verifies(req::SRS_SFS_010);
    Verifies(req::SRS_SFS_217);
    Begin(GetParam());
    RunUntil(GateState::kBusy);
    // When another one takes its place while frames are lost, its boot-up message among them
    Replace();
    manager->OnLost(Now());
    Run(3000U);
    ExpectOther();
    EXPECT_EQ(starts, (std::vector<std::string>{}));
    // When the expected one is back
    devices[0]->PutIdentity();
    EXPECT_EQ(Order(NmtCommand::kResetNode, 5U), NmtAnswer::kTaken);
    Run(6000U);
    EXPECT_EQ(Running(5U), 1);
    EXPECT_FALSE(manager->Status(kSlave).is_other);
    EXPECT_EQ(manager->Status(kSlave).letter, '\0');
}

TEST_P(SafetyIdentityTest, ReplacedUnheardByOneThatRunsIsStopped)
{
    Verifies(req::SRS_SFS_010);
    Verifies(req::SRS_SFS_217);
    Begin(GetParam());
    Run(3000U);
    ASSERT_EQ(Running(5U), 1);
    Replace();
    manager->OnLost(Now());
    Run(3000U);
    ExpectOther();
    EXPECT_EQ(devices[0]->State(), cia301::NodeState::kStopped);
}

TEST_P(SafetyIdentityTest, ReplacedUnheardBeforeAnOrderIsNeitherStartedNorWritten)
{
    Verifies(req::SRS_SFS_010);
    Verifies(req::SRS_SFS_217);
    Begin(GetParam());
    Run(3000U);
    EXPECT_EQ(Order(NmtCommand::kPreOperational, 5U), NmtAnswer::kTaken);
    Run(500U);
    Replace();
    starts.clear();
    // When it is written by order
    EXPECT_TRUE(manager->WriteSafety(kSlave, Now()));
    Run(1000U);
    EXPECT_EQ(Gate(), GateState::kDiffers);
    EXPECT_TRUE(manager->Gate().IsOther(kSlave));
    EXPECT_EQ(devices[0]->writes, (std::vector<std::uint32_t>{}));
    // When it is started by order
    EXPECT_EQ(Order(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(3000U);
    ExpectOther();
    EXPECT_EQ(starts, (std::vector<std::string>{}));
}

TEST_P(SafetyIdentityTest, ThatDoesNotAnswerIsNoOtherDevice)
{
    Verifies(req::SRS_SFS_218);
    Begin(GetParam());
    RunUntil(GateState::kBusy);
    devices[0]->is_sdo_mute = true;
    manager->OnLost(Now());
    Run(4000U);
    EXPECT_EQ(Gate(), GateState::kFailed);
    EXPECT_FALSE(manager->Gate().IsOther(kSlave));
    EXPECT_FALSE(manager->Status(kSlave).is_other);
    EXPECT_EQ(Running(5U), 0);
}

TEST_P(SafetyIdentityTest, IsTheNumberInAnyLengthThatTheStartUpTakes)
{
    Verifies(req::SRS_SFS_216);
    devices[0]->Put(0x1018U, 4U, {0x34U, 0x12U});
    devices[0]->Put(0x1000U, 0U, {0x91U, 0x01U});
    Begin(GetParam());
    Run(3000U);
    // Then as the profile's own start-up takes it, of which EL6751 looks at the length
    EXPECT_EQ(Running(5U), (GetParam() == Profile::kEl6751) ? 0 : 1);
}

TEST_P(SafetyIdentityTest, IsTheLowWordOfTheTypeUnderPlcDesigner)
{
    Verifies(req::SRS_SFS_215);
    devices[0]->Put32(0x1000U, 0U, 0x000F'0191U);
    Begin(GetParam());
    Run(3000U);
    EXPECT_EQ(Running(5U), (GetParam() == Profile::kPlcDesigner) ? 1 : 0);
}

TEST_F(SafetyIdentityTest, OfOneThatNobodyBootsIsAskedAllTheSame)
{
    Verifies(req::SRS_SFS_010);
    // Given cia302, 1F81h without bit 2, and another device with the very configuration that is expected
    setups[5].assignment &= ~kBootSlave;
    devices[0]->Put32(0x1018U, 4U, 0x4321U);
    Begin(Profile::kCia302);
    Run(2000U);
    EXPECT_EQ(manager->Status(kSlave).letter, 'O');
    // When it is to be written and started all the same
    EXPECT_FALSE(manager->WriteSafety(kSlave, Now()));
    EXPECT_EQ(Order(NmtCommand::kStart, 5U), NmtAnswer::kOtherDevice);
    Run(1000U);
    EXPECT_EQ(devices[0]->writes, (std::vector<std::uint32_t>{}));
    EXPECT_EQ(starts, (std::vector<std::string>{}));
    EXPECT_EQ(Running(5U), 0);
}

TEST_F(SafetyIdentityTest, IsWithoutTheTypeWhereEl6751DoesNotCheckIt)
{
    Verifies(req::SRS_SFS_215);
    El6751Slave box{};
    box.is_device_type_checked = false;
    setups[5].el6751 = &box;
    devices[0]->Put32(0x1000U, 0U, 0x192U);
    Begin(Profile::kEl6751);
    Run(6000U);
    EXPECT_EQ(Running(5U), 1);
}

TEST_F(SafetyIdentityTest, IsADeviceTypeOf0ToEl6751Too)
{
    Verifies(req::SRS_SFS_010);
    Verifies(req::SRS_SFS_215);
    // Given one that is to have device type 0, and has another one
    setups[5].device_type = 0U;
    Begin(Profile::kEl6751);
    Run(6000U);
    EXPECT_EQ(manager->Status(kSlave).code, 5);
    // When somebody else starts it
    Put(Nmt(NmtCommand::kStart, 5U));
    Run(3000U);
    EXPECT_EQ(Running(5U), 0);
    EXPECT_EQ(Gate(), GateState::kDiffers);
    EXPECT_EQ(manager->Gate().Finding(kSlave).read, 0x191U);
    // When it is the one, it runs
    devices[0]->Put32(0x1000U, 0U, 0U);
    EXPECT_EQ(Order(NmtCommand::kResetNode, 5U), NmtAnswer::kTaken);
    Run(6000U);
    EXPECT_EQ(Running(5U), 1);
}

INSTANTIATE_TEST_SUITE_P(Profiles, SafetyIdentityTest, ::testing::ValuesIn(kProfiles));

struct LetterCase
{
    ObjectAddress object;
    char letter;
};

class SafetyIdentityLetterTest : public ManagerRig, public ::testing::WithParamInterface<LetterCase>
{
};

TEST_P(SafetyIdentityLetterTest, IsThatOfTheObject)
{
    Verifies(req::SRS_SFS_217);
    // Given cia302 and a slave that runs
    Add(5U).heartbeat_ms = 100U;
    MakeSafe(5U);
    Begin(Profile::kCia302);
    Run(1000U);
    ASSERT_EQ(Running(5U), 1);
    // When it becomes another one in this very object
    devices[0]->Put32(GetParam().object.index, GetParam().object.sub, 0x9999U);
    manager->OnLost(Now());
    Run(1000U);
    EXPECT_EQ(manager->Status(kSlave).letter, GetParam().letter);
    EXPECT_EQ(manager->Status(kSlave).read, 0x9999U);
    EXPECT_EQ(Running(5U), 0);
}

INSTANTIATE_TEST_SUITE_P(Objects, SafetyIdentityLetterTest,
                         ::testing::Values(LetterCase{{0x1000U, 0U}, 'C'}, LetterCase{{0x1018U, 1U}, 'D'},
                                           LetterCase{{0x1018U, 2U}, 'M'}, LetterCase{{0x1018U, 3U}, 'N'},
                                           LetterCase{{0x1018U, 4U}, 'O'}));

} // namespace
} // namespace counterpoint::cia302
