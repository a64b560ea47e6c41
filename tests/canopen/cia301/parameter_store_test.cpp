// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/absent/absent.hpp"
#include "tests/canopen/cia301/parameter_store_rig.hpp"
#include "verification/trace/ids/hal.hpp"
#include "verification/trace/ids/store.hpp"

namespace counterpoint::cia301
{
namespace
{

TEST_F(ParameterStoreTest, WhatWasSavedIsLoaded)
{
    Verifies(req::SRS_STO_001);
    Verifies(req::SRS_STO_007);
    EXPECT_FALSE(Started(*this).is_mounted);
    EXPECT_TRUE(LoadNow().empty());
    EXPECT_FALSE(report.is_present);
    EXPECT_EQ(part.loads, 0);
    // The generations go on from bank to bank
    for (std::uint8_t fill = 1U; fill <= 5U; ++fill)
    {
        EXPECT_EQ(Save(SetOf(fill)), SdoAbort::kNone);
        EXPECT_EQ(LoadNow(), SetOf(fill));
        EXPECT_EQ(report.loaded, 6U);
    }
    EXPECT_FALSE(memory.is_misused);
    // Only the groups that are asked for
    const Values some = LoadNow(kApplicationGroup);
    EXPECT_EQ(some.size(), 2U);
    EXPECT_EQ(some.count(1), 1U);
    EXPECT_EQ(some.count(61), 1U);
}

TEST_F(ParameterStoreTest, TheCrcIsThatOfTheStandardsExample)
{
    Verifies(req::SRS_STO_001);
    const std::uint8_t digits[9] = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
    EXPECT_EQ(ContinueCrc32(0U, {digits, 9U}), 0xCBF43926U);
    EXPECT_EQ(ContinueCrc32(ContinueCrc32(0U, {digits, 4U}), {&digits[4], 5U}), 0xCBF43926U);
}

TEST_F(ParameterStoreTest, EveryDamagedBitIsFoundAndNoOlderSetComesBack)
{
    Verifies(req::SRS_STO_001);
    Verifies(req::SRS_STO_014);
    Verifies(req::SRS_STO_015);
    EXPECT_EQ(Save(SetOf(1U)), SdoAbort::kNone);
    EXPECT_EQ(Save(SetOf(2U)), SdoAbort::kNone); // in the second bank
    const std::uint32_t items = (6U * 5U) + (3U + 3U + 3U + 13U + 23U + 33U);
    const std::uint32_t length = 40U + ((items + 7U) / 8U) * 8U;
    for (std::uint32_t at = 0U; at < (8U * length); ++at)
    {
        const bool is_mark = (at >= (8U * 24U)) && (at < (8U * 40U)); // It tells of the other bank.
        std::uint8_t& cell = memory.banks[1][at / 8U];
        cell = static_cast<std::uint8_t>(cell ^ (1U << (at % 8U)));
        ASSERT_EQ(LoadNow(), is_mark ? SetOf(2U) : Values{}) << at;
        ASSERT_EQ(report.finding, is_mark ? StoreFinding::kSound : StoreFinding::kLost) << at;
        ASSERT_EQ(part.lost, is_mark ? 0U : 7U) << at;
        cell = static_cast<std::uint8_t>(cell ^ (1U << (at % 8U)));
    }
    EXPECT_EQ(LoadNow(), SetOf(2U));
    EXPECT_EQ(report.finding, StoreFinding::kSound);
}

// The bank of the newest set as a whole: erased, of zeros, or another set's; and the only set that there ever was.
TEST_F(ParameterStoreTest, AWholeBankThatIsGoneIsALostSet)
{
    Verifies(req::SRS_STO_014);
    memory.banks.fill(Octets(512U, 0xFFU));
    for (const std::uint8_t saves : Octets{1U, 2U, 3U})
    {
        EXPECT_EQ(Save(SetOf(saves)), SdoAbort::kNone);
        const auto before = memory.banks;
        for (const std::uint8_t fill : Octets{0xFFU, 0x00U, 0x5AU})
        {
            memory.banks = before;
            memory.banks[(saves + 1U) % 2U] = Octets(512U, fill);
            EXPECT_TRUE(LoadNow().empty()) << int{saves} << " " << int{fill};
            EXPECT_EQ(report.finding, StoreFinding::kLost) << int{saves} << " " << int{fill};
            EXPECT_FALSE(report.is_present);
        }
        // The bank of the set before may go: nobody needs it
        memory.banks = before;
        memory.banks[saves % 2U] = Octets(512U, 0x5AU);
        EXPECT_EQ(LoadNow(), (saves == 1U) ? SetOf(1U) : SetOf(saves));
        memory.banks = before;
    }
}

TEST_F(ParameterStoreTest, AFreshMemoryHasNothingToTellAndAStrangeOneIsLost)
{
    Verifies(req::SRS_STO_014);
    memory.banks.fill(Octets(512U, 0xFFU));
    EXPECT_TRUE(LoadNow().empty());
    EXPECT_EQ(report.finding, StoreFinding::kSound);
    EXPECT_EQ(part.lost, 0U);
    memory.banks[1][511] = 0xFEU;
    EXPECT_TRUE(LoadNow().empty());
    EXPECT_EQ(report.finding, StoreFinding::kLost);
    EXPECT_EQ(Save(SetOf(1U)), SdoAbort::kNone);
    EXPECT_EQ(LoadNow(), SetOf(1U));
    EXPECT_EQ(report.finding, StoreFinding::kSound);
}

// Given a lost set, what is saved of some groups counts, and the others stay lost until they are saved or forgotten.
TEST_F(ParameterStoreTest, ALostGroupStaysLostUntilItIsSavedOrForgotten)
{
    Verifies(req::SRS_STO_016);
    EXPECT_EQ(Save(SetOf(1U)), SdoAbort::kNone);
    EXPECT_EQ(Save(SetOf(2U)), SdoAbort::kNone);
    memory.banks[1][60] ^= 1U;
    EXPECT_EQ(Save(SetOf(3U), {StoreAction::kSave, kApplicationGroup}), SdoAbort::kNone);
    // Nothing of the older set is in the new one
    EXPECT_EQ(LoadNow().size(), 2U);
    EXPECT_EQ(report.finding, StoreFinding::kLost);
    EXPECT_EQ(part.lost, kCommunicationGroup | kManufacturerGroup);
    static_cast<void>(LoadNow(kApplicationGroup));
    EXPECT_EQ(report.finding, StoreFinding::kSound);
    EXPECT_EQ(Save(SetOf(4U), {StoreAction::kForget, kCommunicationGroup}), SdoAbort::kNone);
    EXPECT_EQ(LoadNow().size(), 2U);
    EXPECT_EQ(part.lost, kManufacturerGroup);
    EXPECT_EQ(Save(SetOf(5U)), SdoAbort::kNone);
    EXPECT_EQ(LoadNow(), SetOf(5U));
    EXPECT_EQ(report.finding, StoreFinding::kSound);
    // Settings of LSS that nobody saved again, until that is done
    static_cast<void>(LoadNow(kLssGroup));
    EXPECT_EQ(part.lost, kLssGroup);
    EXPECT_EQ(report.finding, StoreFinding::kLost);
    EXPECT_EQ(Save(SetOf(6U), {StoreAction::kSave, kLssGroup}), SdoAbort::kNone);
    part.lost = 0U;
    static_cast<void>(LoadNow(kLssGroup));
    EXPECT_EQ(part.lost, 0U);
    EXPECT_EQ(report.finding, StoreFinding::kSound);
}

TEST_F(ParameterStoreTest, ASetThatDecaysWhileTheDeviceRunsIsLostAtTheNextReset)
{
    Verifies(req::SRS_STO_014);
    EXPECT_EQ(Save(SetOf(1U)), SdoAbort::kNone);
    EXPECT_EQ(Save(SetOf(2U)), SdoAbort::kNone);
    Started started{*this};
    EXPECT_EQ(started.store.Load(kAllGroups).loaded, 6U);
    memory.banks[1][50] ^= 4U;
    part.lost = 0U;
    EXPECT_EQ(started.store.Load(kAllGroups).loaded, 0U);
    EXPECT_EQ(part.lost, 7U);
    part.values = SetOf(3U);
    EXPECT_EQ(started.Finish(kSaveAll), SdoAbort::kNone);
    EXPECT_EQ(LoadNow(), SetOf(3U));
    EXPECT_EQ(report.finding, StoreFinding::kSound);
}

TEST_F(ParameterStoreTest, WhatAPartCannotUseIsTold)
{
    Verifies(req::SRS_STO_017);
    EXPECT_EQ(Save(SetOf(1U)), SdoAbort::kNone);
    part.is_useless = true;
    EXPECT_EQ(LoadNow(), SetOf(1U));
    EXPECT_EQ(report.finding, StoreFinding::kRefused);
    EXPECT_EQ(report.refused, 0U);
}

// Power fails at each byte of a save, the device starts again or not; then the newest whole set decays.
TEST_F(ParameterStoreTest, AfterAnyPowerLossADecayedSetIsNeverReplacedByAnOlderOne)
{
    Verifies(req::SRS_STO_014);
    Verifies(req::SRS_STO_015);
    Verifies(req::SRS_STO_016);
    memory.banks.fill(Octets(512U, 0xFFU));
    EXPECT_EQ(Save(SetOf(1U)), SdoAbort::kNone);
    EXPECT_EQ(Save(SetOf(2U)), SdoAbort::kNone);
    const auto before = memory.banks;
    int broken_ones = 0;
    bool is_complete = false;
    for (std::int64_t cut = 0; !is_complete; ++cut)
    {
        for (const std::uint8_t torn : Octets{0x00U, 0xFFU, 0x5AU})
        {
            memory.banks = before;
            memory.torn = torn;
            memory.bytes_left = cut;
            static_cast<void>(Save(SetOf(3U)));
            is_complete = !memory.is_off;
            memory.PowerOn();
            // The next start tells of it where the set before had to come back
            const Values loaded = LoadNow();
            const bool is_new = (loaded == SetOf(3U));
            const bool is_told = (report.finding == StoreFinding::kBrokenSave);
            ASSERT_TRUE(!is_new || (report.finding == StoreFinding::kSound)) << cut;
            ASSERT_TRUE(is_told || is_new || (cut <= 8)) << cut; // before, the older set was still whole
            ASSERT_EQ(loaded, SetOf(is_new ? 3U : 2U)) << cut;
            // And so does the one behind it
            ASSERT_EQ(LoadNow(), loaded) << cut;
            ASSERT_EQ(report.finding == StoreFinding::kBrokenSave, is_told) << cut;
            broken_ones += is_told ? 1 : 0;
            Started running{*this};
            for (int i = 0; i < 20; ++i)
            {
                running.store.OnCycle();
            }
            memory.banks[is_new ? 0U : 1U][70] ^= 0x10U;
            ASSERT_TRUE(LoadNow().empty()) << cut;
            ASSERT_EQ(report.finding, StoreFinding::kLost) << cut;
            // A save ends that, and one that breaks off does not
            const auto lost = memory.banks;
            memory.bytes_left = cut / 2;
            static_cast<void>(Save(SetOf(4U)));
            memory.PowerOn();
            const bool is_saved = (LoadNow() == SetOf(4U));
            ASSERT_EQ(report.finding, is_saved ? StoreFinding::kSound : StoreFinding::kLost) << cut;
            memory.banks = lost;
            ASSERT_EQ(Save(SetOf(5U)), SdoAbort::kNone) << cut;
            ASSERT_EQ(LoadNow(), SetOf(5U)) << cut;
            ASSERT_FALSE(memory.is_misused) << cut;
        }
    }
    EXPECT_GT(broken_ones, 3 * 130);
}

// The first save of a memory: until it is complete the defaults hold, and the device says so.
TEST_F(ParameterStoreTest, AFirstSaveThatBreaksOffIsToldAndLosesNothing)
{
    Verifies(req::SRS_STO_015);
    int broken_ones = 0;
    bool is_complete = false;
    for (std::int64_t cut = 0; !is_complete; ++cut)
    {
        for (const std::uint8_t torn : Octets{0x00U, 0xFFU, 0x5AU})
        {
            memory.banks.fill(Octets(512U, 0xFFU));
            memory.torn = torn;
            memory.bytes_left = cut;
            static_cast<void>(Save(SetOf(1U)));
            is_complete = !memory.is_off;
            memory.PowerOn();
            const Values loaded = LoadNow();
            ASSERT_TRUE(loaded.empty() || (loaded == SetOf(1U))) << cut;
            ASSERT_NE(report.finding, StoreFinding::kLost) << cut;
            broken_ones += (report.finding == StoreFinding::kBrokenSave) ? 1 : 0;
            ASSERT_EQ(Save(SetOf(2U)), SdoAbort::kNone) << cut;
            ASSERT_EQ(LoadNow(), SetOf(2U)) << cut;
            ASSERT_FALSE(memory.is_misused) << cut;
        }
    }
    EXPECT_GT(broken_ones, 3 * 600);
}

TEST_F(ParameterStoreTest, TheLaterGenerationCountsAlsoBeyondItsEnd)
{
    Verifies(req::SRS_STO_001);
    EXPECT_EQ(Save(SetOf(1U)), SdoAbort::kNone);
    // Given a set with the last generation that there is
    memory.banks[0][4] = 0xFFU;
    memory.banks[0][5] = 0xFFU;
    memory.banks[0][6] = 0xFFU;
    memory.banks[0][7] = 0xFFU;
    const std::uint32_t crc = ContinueCrc32(0U, {memory.banks[0].data(), 20U});
    for (std::uint32_t i = 0U; i < 4U; ++i)
    {
        memory.banks[0][20U + i] = static_cast<std::uint8_t>((crc >> (8U * i)) & 0xFFU);
    }
    EXPECT_EQ(LoadNow(), SetOf(1U));
    // When two more are saved, the later one counts
    EXPECT_EQ(Save(SetOf(2U)), SdoAbort::kNone);
    EXPECT_EQ(LoadNow(), SetOf(2U));
    EXPECT_EQ(Save(SetOf(3U)), SdoAbort::kNone);
    EXPECT_EQ(LoadNow(), SetOf(3U));
}

// Power fails at each byte of a store, with each of several values in the byte that was being changed.
TEST_F(ParameterStoreTest, PowerLossAtAnyByteLeavesTheWholeOldSetOrTheWholeNewOne)
{
    Verifies(req::SRS_STO_002);
    EXPECT_EQ(Save(SetOf(1U)), SdoAbort::kNone);
    EXPECT_EQ(Save(SetOf(2U)), SdoAbort::kNone);
    const auto before = memory.banks;
    int old_ones = 0;
    int new_ones = 0;
    bool is_complete = false;
    for (std::int64_t cut = 0; !is_complete; ++cut)
    {
        for (const std::uint8_t torn : Octets{0x00U, 0xFFU, 0x5AU, 0xA5U, 0x03U})
        {
            memory.banks = before;
            memory.torn = torn;
            memory.bytes_left = cut;
            const SdoAbort answer = Save(SetOf(3U));
            is_complete = !memory.is_off;
            memory.PowerOn();
            const Values loaded = LoadNow();
            const bool is_new = (loaded == SetOf(3U));
            ASSERT_TRUE(is_new || (loaded == SetOf(2U))) << cut;
            ASSERT_TRUE(is_new || (answer != SdoAbort::kNone)) << cut;
            old_ones += is_new ? 0 : 1;
            new_ones += is_new ? 1 : 0;
            // The next store succeeds, whatever is in the bank
            ASSERT_EQ(Save(SetOf(4U)), SdoAbort::kNone) << cut;
            ASSERT_EQ(LoadNow(), SetOf(4U)) << cut;
            ASSERT_FALSE(memory.is_misused) << cut;
        }
    }
    EXPECT_GT(old_ones, 5 * (512 + 130));
    EXPECT_GE(new_ones, 5);
}

TEST_F(ParameterStoreTest, PowerLossWhileForgettingIsAsHarmless)
{
    Verifies(req::SRS_STO_002);
    Verifies(req::SRS_STO_004);
    EXPECT_EQ(Save(SetOf(1U)), SdoAbort::kNone);
    const auto before = memory.banks;
    const StoreRequest forget{StoreAction::kForget, kCommunicationGroup};
    Values rest = SetOf(1U);
    rest.erase(0);
    rest.erase(30);
    bool is_complete = false;
    for (std::int64_t cut = 0; !is_complete; ++cut)
    {
        memory.banks = before;
        memory.bytes_left = cut;
        static_cast<void>(Started(*this).Finish(forget));
        is_complete = !memory.is_off;
        memory.PowerOn();
        const Values loaded = LoadNow();
        ASSERT_TRUE((loaded == SetOf(1U)) || (loaded == rest)) << cut;
    }
    EXPECT_EQ(LoadNow(), rest);
}

TEST_F(ParameterStoreTest, OtherGroupsStayAsTheyWereStored)
{
    Verifies(req::SRS_STO_003);
    EXPECT_EQ(Save(SetOf(1U)), SdoAbort::kNone);
    EXPECT_EQ(Save(SetOf(2U), {StoreAction::kSave, kApplicationGroup}), SdoAbort::kNone);
    Values expected = SetOf(1U);
    expected[1] = SetOf(2U)[1];
    expected[61] = SetOf(2U)[61];
    EXPECT_EQ(LoadNow(), expected);
    // A group that was never stored stays away
    EXPECT_EQ(Save({}, {StoreAction::kForget, kAllGroups}), SdoAbort::kNone);
    EXPECT_TRUE(LoadNow().empty());
    EXPECT_TRUE(report.is_present);
    EXPECT_EQ(Save(SetOf(3U), {StoreAction::kSave, kManufacturerGroup}), SdoAbort::kNone);
    EXPECT_EQ(LoadNow().size(), 2U);
}

TEST_F(ParameterStoreTest, FailuresAreToldAndLeaveTheOldSet)
{
    Verifies(req::SRS_STO_005);
    EXPECT_EQ(Save(SetOf(1U)), SdoAbort::kNone);
    // An item that cannot be read
    part.abort = SdoAbort::kDeviceState;
    EXPECT_EQ(Save(SetOf(2U)), SdoAbort::kDeviceState);
    part.abort = SdoAbort::kNone;
    // A memory that fails, and one that does not keep what it was given
    memory.is_failed = true;
    EXPECT_EQ(Save(SetOf(2U)), SdoAbort::kHardware);
    memory.is_failed = false;
    part.values = SetOf(2U);
    Started started{*this};
    EXPECT_EQ(started.store.Begin(kSaveAll), SdoAbort::kPending);
    for (int i = 0; i < 20; ++i)
    {
        started.store.OnCycle();
    }
    memory.banks[1][46] ^= 1U;
    EXPECT_EQ(started.Await(kSaveAll), SdoAbort::kHardware);
    // More than a bank
    Values big{};
    for (int number = 0; number < 9; ++number)
    {
        big[number] = Octets(58U, 1U);
    }
    EXPECT_EQ(Save(big), SdoAbort::kNotStored);
    EXPECT_EQ(LoadNow(), SetOf(1U));
    // 472 bytes fill the bank to its end: 7 items of 63 bytes and one of 31
    big.erase(8);
    big[7] = Octets(26U, 1U);
    EXPECT_EQ(Save(big), SdoAbort::kNone);
    EXPECT_EQ(LoadNow(), big);
    EXPECT_FALSE(memory.is_misused);
}

TEST_F(ParameterStoreTest, AFailureOfForgettingIsToldAndLeavesTheOldSet)
{
    Verifies(req::SRS_STO_005);
    EXPECT_EQ(Save(SetOf(1U)), SdoAbort::kNone);
    const StoreRequest forget{StoreAction::kForget, kAllGroups};
    memory.is_failed = true;
    EXPECT_EQ(Started(*this).Finish(forget), SdoAbort::kHardware);
    memory.is_failed = false;
    EXPECT_EQ(LoadNow(), SetOf(1U));
    EXPECT_EQ(Started(*this).Finish(forget), SdoAbort::kNone);
    EXPECT_EQ(LoadNow(), Values{});
}

TEST_F(ParameterStoreTest, OneRequestAtATimeAndAnAnswerThatNobodyFetchesIsForgotten)
{
    Verifies(req::SRS_STO_005);
    Verifies(req::SRS_STO_020);
    part.values = SetOf(1U);
    Started started{*this};
    ParameterStore& store = started.store;
    const StoreRequest forget{StoreAction::kForget, kAllGroups};
    const StoreRequest save_lss{StoreAction::kSave, kLssGroup};
    EXPECT_FALSE(store.IsBusy());
    EXPECT_EQ(store.Begin(kSaveAll), SdoAbort::kPending);
    EXPECT_TRUE(store.IsBusy());
    // The same request of somebody else is another one
    for (const StoreRequest& request : {kSaveAll, forget, save_lss})
    {
        EXPECT_EQ(store.Begin(request), SdoAbort::kLocalControl);
    }
    EXPECT_EQ(store.Continue(forget), SdoAbort::kLocalControl);
    EXPECT_EQ(store.Continue(save_lss), SdoAbort::kLocalControl);
    EXPECT_EQ(store.Continue(kSaveAll), SdoAbort::kPending);
    while (store.IsBusy())
    {
        store.OnCycle();
    }
    store.OnCycle();
    EXPECT_EQ(store.Begin(save_lss), SdoAbort::kLocalControl);
    EXPECT_EQ(store.Begin(kSaveAll), SdoAbort::kLocalControl);
    store.OnCycle();
    // The next one begins anew, and one that was forgotten, too
    part.values = SetOf(2U);
    EXPECT_EQ(store.Continue(kSaveAll), SdoAbort::kPending);
    EXPECT_EQ(started.Await(kSaveAll), SdoAbort::kNone);
    EXPECT_EQ(LoadNow(), SetOf(2U));
    part.values = SetOf(3U);
    EXPECT_EQ(started.Finish(kSaveAll), SdoAbort::kNone);
    EXPECT_EQ(LoadNow(), SetOf(3U));
    // Forgetting is bound alike
    EXPECT_EQ(store.Begin(forget), SdoAbort::kPending);
    EXPECT_EQ(store.Begin(forget), SdoAbort::kLocalControl);
    EXPECT_EQ(started.Await(forget), SdoAbort::kNone);
    EXPECT_EQ(store.Begin(forget), SdoAbort::kPending);
}

TEST_F(ParameterStoreTest, NoStepIsLong)
{
    Verifies(req::SRS_STO_006);
    part.values = SetOf(1U);
    Started started{*this};
    EXPECT_EQ(started.store.Begin(kSaveAll), SdoAbort::kPending);
    int steps = 0;
    std::int64_t greatest = 0;
    while (started.store.IsBusy())
    {
        const std::int64_t before = memory.bytes_left;
        started.store.OnCycle();
        const std::int64_t written = before - memory.bytes_left;
        greatest = ((written > greatest) && (written != 512)) ? written : greatest;
        ++steps;
    }
    EXPECT_EQ(greatest, 64);
    EXPECT_GT(steps, 12);
}

TEST_F(ParameterStoreTest, UnknownItemsAreCounted)
{
    Verifies(req::SRS_STO_007);
    Values values = SetOf(1U);
    values[99] = Octets{1U};
    EXPECT_EQ(Save(values), SdoAbort::kNone);
    static_cast<void>(LoadNow());
    EXPECT_EQ(report.loaded, 6U);
    EXPECT_EQ(report.refused, 1U);
    EXPECT_EQ(part.loads, 2);
}

TEST(ParameterStoreWithoutMemory, SavesAndLoadsNothing)
{
    Verifies(req::SRS_HAL_016);
    hal::AbsentParameterMemory memory{};
    ListPart part{};
    std::array<StoredPart*, 1> parts{&part};
    std::array<std::uint8_t, 64> scratch{};
    ParameterStore store{StoreParts{memory, parts.data(), 1U, Room{scratch.data(), 64U}}};
    EXPECT_FALSE(store.Mount());
    SdoAbort answer = store.Begin(kSaveAll);
    for (int i = 0; (i < 500) && (answer == SdoAbort::kPending); ++i)
    {
        store.OnCycle();
        answer = store.Continue(kSaveAll);
    }
    EXPECT_EQ(answer, SdoAbort::kHardware);
    const LoadReport report = store.Load(kAllGroups);
    EXPECT_FALSE(report.is_present);
    EXPECT_EQ(report.finding, StoreFinding::kSound);
    EXPECT_EQ(part.loads, 0);
}

} // namespace
} // namespace counterpoint::cia301
