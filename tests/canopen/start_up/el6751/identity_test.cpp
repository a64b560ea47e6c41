// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Reset, boot-up, and the rows of the EL6751 text up to the serial number.
#include "tests/canopen/start_up/el6751/rig.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"

namespace counterpoint::cia302
{
namespace
{

class El6751IdentityTest : public El6751Rig
{
  public:
    /// Slave 5 alone, with everything configured that the identity rows can compare.
    BusSlave& AddFull()
    {
        BusSlave& slave = AddBox(5U);
        setups[5].vendor_id = 0x2AU;
        setups[5].product_code = 7U;
        setups[5].revision_number = 3U;
        setups[5].serial_number = 0x1234U;
        return slave;
    }
    /// Ends as a start-up that was given up: no start, and why is kept.
    void ExpectEnd(const int code, const std::uint16_t index, const std::uint8_t sub)
    {
        Run(3000U);
        EXPECT_EQ(Code(5U), code);
        EXPECT_EQ(Of(5U).object.index, index);
        EXPECT_EQ(Of(5U).object.sub, sub);
        EXPECT_EQ(Nmt(), (Log{"0:82 00"}));
        EXPECT_FALSE(Of(5U).is_busy);
        EXPECT_EQ(el.Cause(NodeId{5U}), code);
    }
};

TEST_F(El6751IdentityTest, OneResetCommunicationBeforeAnySdoThenEachSlaveForItself)
{
    Verifies(req::SRS_ELM_001);
    Verifies(req::SRS_ELM_150);
    // Given two slaves and a node that is not in the network
    AddBox(5U);
    AddBox(6U);
    Add(7U);
    setups[7].assignment = 0U;
    // When the start-up begins
    Begin();
    // Then one reset goes to all, and nothing else
    ASSERT_EQ(sent.size(), 1U);
    EXPECT_EQ(Nmt(), (Log{"0:82 00"}));
    Run(20U);
    // and the slaves are served at the same time, the other node not at all
    EXPECT_EQ(Sdos(5U), (Log{"r 1000:00"}));
    EXPECT_EQ(Sdos(6U), (Log{"r 1000:00"}));
    EXPECT_EQ(Sdos(7U), (Log{}));
    EXPECT_EQ(Code(5U), 0);
    EXPECT_EQ(Code(6U), 0);
}

TEST_F(El6751IdentityTest, AQueueWithoutRoomDelaysTheReset)
{
    Verifies(req::SRS_ELM_001);
    AddBox(5U);
    nmt.SetActive(false);
    Begin();
    Run(50U);
    EXPECT_TRUE(sent.empty());
    nmt.SetActive(true);
    Run(20U);
    EXPECT_EQ(Nmt(), (Log{"51:82 00", "54:01 05", "54:01 00"}));
}

class El6751OwnTimeTest : public El6751Rig
{
  public:
    El6751OwnTimeTest() : El6751Rig(El6751Times{}, SdoTimes{500'000U, 1U})
    {
    }
};

TEST_F(El6751OwnTimeTest, TheConfiguredTimeOutSaysWhenASlaveIsNotFound)
{
    Verifies(req::SRS_ELM_003);
    AddBox(5U).is_on = false;
    Begin();
    Run(499U);
    EXPECT_EQ(Code(5U), 8);
    Run(2U);
    EXPECT_EQ(Code(5U), 2);
    EXPECT_EQ(Of(5U).object.index, 0x1000U);
    // The same SDO is sent again; a slave that never said STOPPED is not commanded
    Run(3000U);
    EXPECT_EQ(Code(5U), 2);
    EXPECT_EQ(Nmt(), (Log{"0:82 00"}));
    slaves[5]->is_on = true;
    Run(600U);
    EXPECT_EQ(Code(5U), 0);
}

TEST_F(El6751IdentityTest, TheBootUpMessageBeginsTheStartUpAgain)
{
    Verifies(req::SRS_ELM_002);
    AddFull();
    Begin();
    Run(20U);
    ASSERT_EQ(Code(5U), 0);
    slaves[5]->log.clear();
    // When the slave restarts by itself
    slaves[5]->Power(Now().us);
    Run(3U);
    EXPECT_EQ(Code(5U), 8);
    Run(20U);
    // Then every row comes again
    EXPECT_EQ(slaves[5]->log, (Log{"r 1000:00", "r 1018:01", "r 1018:02", "r 1018:03", "r 1018:04", "nmt 01"}));
    EXPECT_EQ(Code(5U), 0);
}

TEST_F(El6751IdentityTest, ABootUpMessageInTheMiddleOfTheRowsToo)
{
    Verifies(req::SRS_ELM_002);
    AddFull();
    slaves[5]->Behave(0x1018U, 2U, Manner::kSilent);
    Begin();
    Run(100U);
    EXPECT_EQ(Sdos(5U).back(), "r 1018:02");
    slaves[5]->Behave(0x1018U, 2U, Manner::kGood);
    slaves[5]->Power(Now().us);
    Run(20U);
    EXPECT_EQ(Code(5U), 0);
    // An abandoned start-up begins again in the same way
    slaves[5]->Set(0x1018U, 4U, 1U);
    slaves[5]->Power(Now().us);
    Run(20U);
    EXPECT_EQ(Code(5U), 5);
    slaves[5]->Set(0x1018U, 4U, 0x1234U);
    slaves[5]->Power(Now().us);
    Run(20U);
    EXPECT_EQ(Code(5U), 0);
}

TEST_F(El6751IdentityTest, ASlaveThatIsNotThereIsAskedUntilItAnswers)
{
    Verifies(req::SRS_ELM_003);
    BusSlave& slave = AddFull();
    slave.is_on = false;
    Begin();
    Run(1999U);
    EXPECT_EQ(Code(5U), 8);
    Run(2U);
    EXPECT_EQ(Code(5U), 2);
    EXPECT_EQ(Of(5U).object.index, 0x1000U);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kTimeOut);
    Run(8000U);
    EXPECT_EQ(Code(5U), 2);
    EXPECT_TRUE(Of(5U).is_busy);
    // When it comes without a boot-up message
    slave.is_on = true;
    Run(2100U);
    EXPECT_EQ(Code(5U), 0);
    EXPECT_EQ(told[5], (Log{"8", "2", "8", "0"}));
}

TEST_F(El6751IdentityTest, RowDeviceTypeIsComparedWithZeroToo)
{
    Verifies(req::SRS_ELM_004);
    AddFull();
    slaves[5]->Set(0x1000U, 0U, 0x192U);
    Begin();
    ExpectEnd(5, 0x1000U, 0U);
    EXPECT_EQ(Of(5U).expected, 0x191U);
    EXPECT_EQ(Of(5U).read, 0x192U);
    EXPECT_EQ(Sdos(5U), (Log{"r 1000:00"}));
    // Configured 0 is compared: 192h is another type
    setups[5].device_type = 0U;
    slaves[5]->Power(Now().us);
    Run(20U);
    EXPECT_EQ(Code(5U), 5);
    EXPECT_EQ(Of(5U).expected, 0U);
    slaves[5]->Set(0x1000U, 0U, 0U);
    slaves[5]->Power(Now().us);
    Run(20U);
    EXPECT_EQ(Code(5U), 0);
}

TEST_F(El6751IdentityTest, RowDeviceTypeCanBeSwitchedOff)
{
    Verifies(req::SRS_ELM_004);
    AddFull();
    boxes[5].is_device_type_checked = false;
    slaves[5]->Set(0x1000U, 0U, 0x192U);
    Begin();
    Run(20U);
    EXPECT_EQ(Sdos(5U), (Log{"r 1018:01", "r 1018:02", "r 1018:03", "r 1018:04"}));
    EXPECT_EQ(Code(5U), 0);
}

TEST_F(El6751IdentityTest, RowDeviceTypeAbortedOrOfWrongLengthIsASyntaxError)
{
    Verifies(req::SRS_ELM_004);
    Verifies(req::SRS_ELM_025);
    AddFull();
    slaves[5]->Behave(0x1000U, 0U, Manner::kAbort);
    Begin();
    ExpectEnd(4, 0x1000U, 0U);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kObjectUnknown);
    slaves[5]->Behave(0x1000U, 0U, Manner::kShort);
    slaves[5]->Power(Now().us);
    Run(20U);
    EXPECT_EQ(Code(5U), 4);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kLengthMismatch);
    slaves[5]->Behave(0x1000U, 0U, Manner::kLong);
    slaves[5]->Power(Now().us);
    Run(20U);
    EXPECT_EQ(Code(5U), 4);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kLengthMismatch);
    EXPECT_EQ(Nmt(), (Log{"0:82 00"}));
}

/// The four rows of the identity, and whether a BK51x0 has them.
struct IdentityRow
{
    std::uint8_t sub;
    std::uint32_t good;
    bool is_of_coupler;
};
constexpr IdentityRow kIdentity[]{{1U, 0x2AU, true}, {2U, 7U, true}, {3U, 3U, false}, {4U, 0x1234U, false}};

class El6751IdentityRowTest : public El6751IdentityTest, public ::testing::WithParamInterface<IdentityRow>
{
  public:
    void Configure(const std::uint32_t value)
    {
        std::uint32_t* const places[]{&setups[5].vendor_id, &setups[5].product_code, &setups[5].revision_number,
                                      &setups[5].serial_number};
        *places[GetParam().sub - 1U] = value;
    }
    [[nodiscard]] std::string Read() const
    {
        return "r 1018:0" + std::to_string(static_cast<unsigned>(GetParam().sub));
    }
    void VerifiesRow() const
    {
        const req::RequirementId ids[]{req::SRS_ELM_005, req::SRS_ELM_006, req::SRS_ELM_007, req::SRS_ELM_008};
        Verifies(ids[GetParam().sub - 1U]);
    }
};

INSTANTIATE_TEST_SUITE_P(Rows, El6751IdentityRowTest, ::testing::ValuesIn(kIdentity));

TEST_P(El6751IdentityRowTest, OfAGeneralSlaveIsReadIfConfiguredAndOtherwiseNot)
{
    VerifiesRow();
    AddBox(5U);
    Begin();
    Run(20U);
    EXPECT_EQ(Sdos(5U), (Log{"r 1000:00"}));
    EXPECT_EQ(Code(5U), 0);
    Configure(GetParam().good);
    slaves[5]->log.clear();
    slaves[5]->Power(Now().us);
    Run(20U);
    EXPECT_EQ(Sdos(5U), (Log{"r 1000:00", Read()}));
    EXPECT_EQ(Code(5U), 0);
}

TEST_P(El6751IdentityRowTest, OfABusCouplerIsReadAlwaysOrNever)
{
    VerifiesRow();
    AddBox(5U);
    boxes[5].kind = El6751Kind::kBusCoupler;
    Begin();
    Run(20U);
    // Nothing is configured: vendor and product are read all the same and may be anything
    EXPECT_EQ(Sdos(5U), (Log{"r 1000:00", "r 1018:01", "r 1018:02", "w 5500:00 00 00 00 00"}));
    EXPECT_EQ(Nmt(), (Log{"0:82 00", "6:01 05", "6:01 00"}));
    // Configured and wrong: only what is read can fail
    Configure(99U);
    slaves[5]->log.clear();
    slaves[5]->Power(Now().us);
    Run(20U);
    EXPECT_EQ(Code(5U), GetParam().is_of_coupler ? 5 : 0);
    EXPECT_EQ(Sdos(5U).size(), GetParam().is_of_coupler ? (GetParam().sub + 1U) : 4U);
}

TEST_P(El6751IdentityRowTest, AnotherValueEndsTheStartUp)
{
    VerifiesRow();
    AddFull();
    slaves[5]->Set(0x1018U, GetParam().sub, GetParam().good + 1U);
    Begin();
    ExpectEnd(5, 0x1018U, GetParam().sub);
    EXPECT_EQ(Of(5U).expected, GetParam().good);
    EXPECT_EQ(Of(5U).read, GetParam().good + 1U);
    EXPECT_EQ(Sdos(5U).back(), Read());
}

TEST_P(El6751IdentityRowTest, AnAbortEndsTheStartUpWithASyntaxError)
{
    VerifiesRow();
    AddFull();
    slaves[5]->Behave(0x1018U, GetParam().sub, Manner::kAbort);
    Begin();
    ExpectEnd(4, 0x1018U, GetParam().sub);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kObjectUnknown);
}

TEST_P(El6751IdentityRowTest, AWrongLengthEndsTheStartUpWithASyntaxError)
{
    VerifiesRow();
    AddFull();
    slaves[5]->Behave(0x1018U, GetParam().sub, Manner::kShort);
    Begin();
    ExpectEnd(4, 0x1018U, GetParam().sub);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kLengthMismatch);
    slaves[5]->Behave(0x1018U, GetParam().sub, Manner::kLong);
    slaves[5]->Power(Now().us);
    Run(20U);
    EXPECT_EQ(Code(5U), 4);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kLengthMismatch);
}

TEST_P(El6751IdentityRowTest, SilenceAfterTheFirstAnswerIsNotASlaveThatWasNotFound)
{
    VerifiesRow();
    Verifies(req::SRS_ELM_025);
    AddFull();
    slaves[5]->Behave(0x1018U, GetParam().sub, Manner::kSilent);
    Begin();
    ExpectEnd(4, 0x1018U, GetParam().sub);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kTimeOut);
    EXPECT_EQ(told[5], (Log{"8", "4"}));
}

} // namespace
} // namespace counterpoint::cia302
