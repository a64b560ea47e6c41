// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What the marks of both banks say, whatever brought them there, and a memory that answers no more.
#include "tests/canopen/cia301/parameter_store_rig.hpp"
#include "verification/trace/ids/store.hpp"

namespace counterpoint::cia301
{
namespace
{

/// Hands everything on to another memory until it fails: to read from `from` on, or to keep a mark.
class FailingMemory final : public hal::ParameterMemory
{
  public:
    explicit FailingMemory(hal::ParameterMemory& memory) : memory_(memory)
    {
    }
    [[nodiscard]] std::uint32_t BankBytes() const noexcept override
    {
        return memory_.BankBytes();
    }
    [[nodiscard]] hal::MemoryStatus Status() noexcept override
    {
        return memory_.Status();
    }
    void Erase(hal::MemoryBank bank) noexcept override
    {
        memory_.Erase(bank);
    }
    void Program(const hal::MemorySection& section, const std::uint8_t* from) noexcept override
    {
        const bool is_lost = loses_superseded && (section.offset == 32U) && (section.count == 8U);
        if (!is_lost)
        {
            memory_.Program(section, from);
        }
    }
    [[nodiscard]] bool Read(const hal::MemorySection& section, std::uint8_t* to) noexcept override
    {
        const bool is_read = memory_.Read(section, to);
        ++reads;
        return is_read && (reads < fails_from);
    }

    bool loses_superseded{false};
    int reads{0};
    int fails_from{1000000};

  private:
    hal::ParameterMemory& memory_;
};

class StoreMarksTest : public ParameterStoreTest
{
  public:
    StoreMarksTest()
    {
        memory.banks.fill(Octets(512U, 0xFFU));
    }
    [[nodiscard]] bool IsMarked(std::size_t bank, std::size_t offset) const
    {
        return memory.banks[bank][offset] == 0x00U;
    }

    static constexpr std::size_t kBegun = 24U;
    static constexpr std::size_t kSuperseded = 32U;
};

TEST_F(StoreMarksTest, OfTwoSetsOfOneGenerationTheFirstCounts)
{
    Verifies(req::SRS_STO_001);
    EXPECT_EQ(Save(SetOf(1U)), SdoAbort::kNone);
    memory.banks[1] = memory.banks[0];
    Started started{*this};
    EXPECT_TRUE(started.is_mounted);
    EXPECT_EQ(LoadNow(), SetOf(1U));
    EXPECT_EQ(Save(SetOf(2U)), SdoAbort::kNone);
    EXPECT_EQ(memory.banks[1][4], 2U); // Generation 2, in the other bank.
    EXPECT_EQ(LoadNow(), SetOf(2U));
}

TEST_F(StoreMarksTest, ASaveIntoTheSecondBankThatHasNotEndedIsTold)
{
    Verifies(req::SRS_STO_014);
    // Given a first save whose marks stand in the first bank
    memory.banks[0][kBegun] = 0U;
    memory.banks[1][100] = 0x12U;
    EXPECT_EQ(LoadNow(), Values{});
    EXPECT_EQ(report.finding, StoreFinding::kBrokenSave);
    EXPECT_EQ(part.lost, 0U);
    // Then the next one goes into the second bank again, so that the mark stays until it is whole
    EXPECT_EQ(Save(SetOf(1U)), SdoAbort::kNone);
    EXPECT_EQ(memory.banks[1][4], 1U);
    EXPECT_EQ(LoadNow(), SetOf(1U));
    // With the other mark as well it was complete, and is lost
    memory.banks.fill(Octets(512U, 0xFFU));
    memory.banks[0][kBegun] = 0U;
    memory.banks[0][kSuperseded] = 0U;
    memory.banks[1][100] = 0x12U;
    EXPECT_EQ(LoadNow(), Values{});
    EXPECT_EQ(report.finding, StoreFinding::kLost);
}

TEST_F(StoreMarksTest, ASetThatIsBegunAndSupersededIsOfAnOtherOneThatIsLost)
{
    Verifies(req::SRS_STO_014);
    EXPECT_EQ(Save(SetOf(1U)), SdoAbort::kNone);
    EXPECT_EQ(Save(SetOf(2U)), SdoAbort::kNone);
    EXPECT_TRUE(IsMarked(0U, kBegun));
    EXPECT_TRUE(IsMarked(0U, kSuperseded));
    memory.banks[1][60] ^= 1U;
    EXPECT_EQ(LoadNow(), Values{});
    EXPECT_EQ(report.finding, StoreFinding::kLost);
    EXPECT_FALSE(report.is_present);
}

/// A set whose seal power cut off.
class StoreMendTest : public StoreMarksTest
{
  public:
    StoreMendTest()
    {
        EXPECT_EQ(Save(SetOf(1U)), SdoAbort::kNone);
        EXPECT_EQ(Save(SetOf(2U)), SdoAbort::kNone);
        for (std::size_t i = 0U; i < 8U; ++i)
        {
            memory.banks[0][kSuperseded + i] = 0xFFU;
        }
    }
};

TEST_F(StoreMendTest, TheSealIsPutOnWhenTheMemoryRests)
{
    Verifies(req::SRS_STO_015);
    Started started{*this};
    EXPECT_TRUE(started.is_mounted);
    // Not while it is busy
    memory.busy_calls = 1;
    started.store.OnCycle();
    EXPECT_FALSE(IsMarked(0U, kSuperseded));
    started.store.OnCycle();
    EXPECT_TRUE(IsMarked(0U, kSuperseded));
    EXPECT_TRUE(started.store.IsBusy());
    for (int i = 0; i < 4; ++i)
    {
        started.store.OnCycle();
    }
    EXPECT_FALSE(started.store.IsBusy());
    EXPECT_FALSE(memory.is_misused);
    EXPECT_EQ(LoadNow(), SetOf(2U));
}

TEST_F(StoreMendTest, ARequestNeedNotWaitForTheSeal)
{
    Verifies(req::SRS_STO_015);
    Verifies(req::SRS_STO_020);
    for (const bool is_continued : {false, true})
    {
        Started started{*this};
        started.store.OnCycle(); // Begins to mend.
        ASSERT_TRUE(started.store.IsBusy());
        part.values = SetOf(is_continued ? 4U : 3U);
        const SdoAbort first = is_continued ? started.store.Continue(kSaveAll) : started.store.Begin(kSaveAll);
        EXPECT_EQ(first, SdoAbort::kPending);
        EXPECT_EQ(started.Await(kSaveAll), SdoAbort::kNone);
        EXPECT_EQ(LoadNow(), SetOf(is_continued ? 4U : 3U));
        EXPECT_FALSE(memory.is_misused);
        // The new set is in the other bank, and its seal is cut off in turn
        for (std::size_t i = 0U; i < 8U; ++i)
        {
            memory.banks[1][kSuperseded + i] = 0xFFU;
        }
    }
}

TEST_F(StoreMendTest, ASealThatFailsIsTriedAtTheNextStart)
{
    Verifies(req::SRS_STO_015);
    Started started{*this};
    started.store.OnCycle();
    memory.busy_calls = 0;
    memory.is_failed = true;
    started.store.OnCycle();
    EXPECT_FALSE(started.store.IsBusy());
    memory.is_failed = false;
    EXPECT_EQ(LoadNow(), SetOf(2U));
}

TEST_F(StoreMarksTest, WhatCannotBeReadBackIsNoSet)
{
    Verifies(req::SRS_STO_005);
    // Given a save whose header is not there when it is read back
    part.values = SetOf(1U);
    Started started{*this};
    EXPECT_EQ(started.store.Begin(kSaveAll), SdoAbort::kPending);
    bool has_header = false;
    for (int i = 0; (i < 300) && !has_header; ++i)
    {
        started.store.OnCycle();
        has_header = (memory.banks[0][0] != 0xFFU);
    }
    ASSERT_TRUE(has_header);
    memory.banks[0][0] ^= 1U;
    EXPECT_EQ(started.Await(kSaveAll), SdoAbort::kHardware);
    EXPECT_EQ(LoadNow(), Values{});
}

TEST_F(StoreMarksTest, ASealThatIsNotKeptIsAnError)
{
    Verifies(req::SRS_STO_005);
    FailingMemory failing{memory};
    failing.loses_superseded = true;
    part.values = SetOf(1U);
    ParameterStore store{StoreParts{failing, parts.data(), 1U, Room{scratch.data(), 64U}}};
    static_cast<void>(store.Mount());
    SdoAbort answer = store.Begin(kSaveAll);
    for (int i = 0; (i < 300) && (answer == SdoAbort::kPending); ++i)
    {
        store.OnCycle();
        answer = store.Continue(kSaveAll);
    }
    EXPECT_EQ(answer, SdoAbort::kHardware);
}

TEST_F(StoreMarksTest, AMemoryThatIsReadNoMoreLoadsNothingAndIsTold)
{
    Verifies(req::SRS_STO_007);
    EXPECT_EQ(Save(SetOf(1U)), SdoAbort::kNone);
    FailingMemory failing{memory};
    ParameterStore store{StoreParts{failing, parts.data(), 1U, Room{scratch.data(), 64U}}};
    ASSERT_TRUE(store.Mount());
    const int reads = failing.reads;
    // Given the reads of a whole Load
    failing.reads = 0;
    EXPECT_EQ(store.Load(kAllGroups).loaded, 6U);
    const int whole = failing.reads;
    EXPECT_GT(whole, reads);
    // When it fails from one of them on, fewer items are loaded, and none of them twice; behind them it may fail
    std::uint32_t before = 0U;
    for (int fails_from = 1; fails_from <= (whole + 1); ++fails_from)
    {
        failing.reads = -1000000;
        ASSERT_TRUE(store.Mount());
        failing.reads = 0;
        failing.fails_from = fails_from;
        part.unread = 0U;
        const LoadReport got = store.Load(kAllGroups);
        EXPECT_EQ(part.unread, got.refused) << fails_from;
        EXPECT_GE(got.loaded, before) << fails_from;
        EXPECT_LE(got.loaded + got.refused, 6U) << fails_from;
        before = got.loaded;
    }
    EXPECT_EQ(before, 6U);
}

TEST_F(StoreMarksTest, AnItemThatIsLongerThanTheScratchRoomIsRefused)
{
    Verifies(req::SRS_STO_007);
    Values values = SetOf(1U);
    values[30] = Octets(40U, 1U);
    EXPECT_EQ(Save(values), SdoAbort::kNone);
    // Given a device whose room is smaller than that of the one that saved
    ParameterStore store{StoreParts{memory, parts.data(), 1U, Room{scratch.data(), 40U}}};
    ASSERT_TRUE(store.Mount());
    part.unread = 0U;
    const LoadReport got = store.Load(kAllGroups);
    EXPECT_EQ(got.loaded, 5U);
    EXPECT_EQ(got.refused, 1U);
    // Its part knows that there was one
    EXPECT_EQ(part.unread, 1U);
}

TEST_F(StoreMarksTest, AnOldSetThatCannotBeReadIsNotCopied)
{
    Verifies(req::SRS_STO_005);
    EXPECT_EQ(Save(SetOf(1U)), SdoAbort::kNone);
    FailingMemory failing{memory};
    part.values = SetOf(2U);
    ParameterStore store{StoreParts{failing, parts.data(), 1U, Room{scratch.data(), 64U}}};
    ASSERT_TRUE(store.Mount());
    const StoreRequest some{StoreAction::kSave, kApplicationGroup};
    int hardware = 0;
    int whole = 0;
    for (int fails_from = 1; (fails_from < 100) && (whole == 0); ++fails_from)
    {
        failing.reads = 0;
        failing.fails_from = fails_from;
        SdoAbort answer = store.Begin(some);
        for (int i = 0; (i < 300) && (answer == SdoAbort::kPending); ++i)
        {
            store.OnCycle();
            answer = store.Continue(some);
        }
        hardware += (answer == SdoAbort::kHardware) ? 1 : 0;
        whole += (answer == SdoAbort::kNone) ? 1 : 0;
    }
    EXPECT_GT(hardware, 3);
    EXPECT_EQ(LoadNow().size(), 6U);
}

TEST_F(StoreMarksTest, AnOldSetThatFindsNoRoomBehindTheNewItemsIsNotStored)
{
    Verifies(req::SRS_STO_005);
    // Given 472 bytes of room, and items of one group that nearly fill it
    Values values{};
    values[0] = Octets(50U, 1U);
    EXPECT_EQ(Save(values), SdoAbort::kNone);
    for (int number = 1; number < 22; number += 3)
    {
        values[number] = Octets(55U, 2U);
    }
    EXPECT_EQ(Save(values, {StoreAction::kSave, kApplicationGroup}), SdoAbort::kNotStored);
    values.erase(19);
    EXPECT_EQ(Save(values, {StoreAction::kSave, kApplicationGroup}), SdoAbort::kNone);
    EXPECT_EQ(LoadNow(), values);
}

TEST_F(StoreMarksTest, AHeaderOfALengthBeyondItsBankIsNone)
{
    Verifies(req::SRS_STO_001);
    EXPECT_EQ(Save(SetOf(1U)), SdoAbort::kNone);
    ImageReader reader{memory};
    EXPECT_TRUE(reader.Open(hal::MemoryBank::kFirst));
    EXPECT_TRUE(reader.HeadAt(0U).is_present);
    EXPECT_FALSE(reader.HeadAt(108U).is_present); // FFh up to the next unit,
    EXPECT_FALSE(reader.HeadAt(109U).is_present); // too few of them for a head, and no set at all.
    EXPECT_FALSE(reader.HeadAt(0xFFFFFFFFU).is_present);
    // Given a header whose CRC is right, with one byte more than a bank has behind it
    const std::pair<std::uint8_t, bool> lengths[] = {{std::uint8_t{0xD8U}, true}, {std::uint8_t{0xD9U}, false}};
    for (const auto& [low, is_open] : lengths)
    {
        memory.banks[0][8] = low; // 472 and 473
        memory.banks[0][9] = 1U;
        const std::uint32_t crc = ContinueCrc32(0U, {memory.banks[0].data(), 20U});
        for (std::uint32_t i = 0U; i < 4U; ++i)
        {
            memory.banks[0][20U + i] = static_cast<std::uint8_t>((crc >> (8U * i)) & 0xFFU);
        }
        EXPECT_EQ(reader.Open(hal::MemoryBank::kFirst), is_open);
    }
}

} // namespace
} // namespace counterpoint::cia301
