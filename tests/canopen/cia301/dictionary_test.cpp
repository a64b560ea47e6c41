// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/dictionary/dictionary.hpp"
#include "canopen/cia301/dictionary/entry_value.hpp"
#include "tests/canopen/cia301/fake_objects.hpp"
#include "verification/trace/ids/cia301.hpp"
#include "verification/trace/verifies.hpp"

#include <array>
#include <vector>

namespace counterpoint::cia301
{
namespace
{

class RecordingHook final : public ReadHook, public WriteHook
{
  public:
    Reading OnRead(const ObjectAddress& address, const Room& room) noexcept override
    {
        last = address;
        if ((answer == SdoAbort::kNone) && (room.size_bytes > 0U))
        {
            room.data[0] = 0x5AU;
        }
        return Reading{answer, size};
    }
    SdoAbort OnWrite(const ObjectAddress& address, const Bytes& value) noexcept override
    {
        last = address;
        written.assign(value.data, value.data + value.size_bytes);
        return answer;
    }

    SdoAbort answer{SdoAbort::kNone};
    std::uint32_t size{1U};
    ObjectAddress last{};
    std::vector<std::uint8_t> written{};
};

class DictionaryTest : public ::testing::Test
{
  public:
    DictionaryTest()
    {
        dictionary.SetNmtState(NmtState::kPreOperational);
    }

    Reading Read(std::uint16_t index, std::uint8_t sub)
    {
        return dictionary.Read({index, sub}, {room.data(), 16U});
    }
    SdoAbort Write(std::uint16_t index, std::uint8_t sub, const std::vector<std::uint8_t>& value)
    {
        return dictionary.Write({index, sub}, {value.data(), static_cast<std::uint32_t>(value.size())});
    }

    RecordingHook hook{};
    std::array<std::uint8_t, 4> u32{0x44U, 0x33U, 0x22U, 0x11U};
    std::array<std::uint8_t, 1> i8{0xFEU};
    std::array<std::uint8_t, 1> flag{0U};
    std::array<std::uint8_t, 8> text{'a', 'b'};
    std::uint32_t text_length{2U};
    std::array<std::uint8_t, 2> u16{};
    ValueLimits signed_limits{static_cast<std::uint64_t>(std::int64_t{-5}), 5U};
    ValueLimits limits{10U, 20U};
    ValueLimits contradiction{20U, 10U};
    std::array<Entry, 14> entries{{
        {0x1000U, 0U, DataType::kUnsigned32, Access::kConstant, kInBoth, kInBoth, 4U, u32.data(), nullptr, nullptr,
         nullptr, nullptr},
        {0x2000U, 0U, DataType::kUnsigned8, Access::kReadOnly, kInBoth, 0U, 1U, i8.data(), nullptr, nullptr, nullptr,
         nullptr},
        {0x2000U, 3U, DataType::kUnsigned32, Access::kReadWrite, kInBoth, kInBoth, 4U, u32.data(), nullptr, nullptr,
         nullptr, nullptr},
        {0x2001U, 0U, DataType::kUnsigned32, Access::kWriteOnly, kInBoth, kInBoth, 4U, u32.data(), nullptr, nullptr,
         nullptr, nullptr},
        {0x2002U, 0U, DataType::kInteger8, Access::kReadWrite, kInBoth, kInBoth, 1U, i8.data(), nullptr, &signed_limits,
         nullptr, nullptr},
        {0x2003U, 0U, DataType::kUnsigned16, Access::kReadWrite, kInBoth, kInBoth, 2U, u16.data(), nullptr, &limits,
         nullptr, nullptr},
        {0x2004U, 0U, DataType::kUnsigned16, Access::kReadWrite, kInBoth, kInBoth, 2U, u16.data(), nullptr,
         &contradiction, nullptr, nullptr},
        {0x2005U, 0U, DataType::kBoolean, Access::kReadWrite, kInBoth, kInBoth, 1U, flag.data(), nullptr, nullptr,
         nullptr, nullptr},
        {0x2006U, 0U, DataType::kVisibleString, Access::kReadWrite, kInBoth, kInBoth, 8U, text.data(), &text_length,
         nullptr, nullptr, nullptr},
        {0x2007U, 0U, DataType::kUnsigned8, Access::kReadWrite, kInBoth, kInBoth, 1U, nullptr, nullptr, nullptr, &hook,
         &hook},
        {0x2008U, 0U, DataType::kUnsigned8, Access::kReadWrite, kInBoth, kInPreOperational, 1U, flag.data(), nullptr,
         nullptr, nullptr, &hook},
        {0x2009U, 0U, DataType::kUnsigned8, Access::kInvalid, kInBoth, kInBoth, 1U, flag.data(), nullptr, nullptr,
         nullptr, nullptr},
        {0x200AU, 0U, DataType::kUnsigned8, Access::kReadWrite, kInBoth, kInBoth, 1U, nullptr, nullptr, nullptr,
         nullptr, nullptr},
        {0x200BU, 0U, DataType::kUnsigned8, Access::kReadWrite, kInOperational, kInOperational, 1U, flag.data(),
         nullptr, nullptr, nullptr, nullptr},
    }};
    FakeObjects foreign{};
    Dictionary dictionary{EntryTable{entries.data(), 14U}, foreign};
    std::array<std::uint8_t, 17> room{};
};

TEST_F(DictionaryTest, FindsEachEntryAndNothingElse)
{
    Verifies(req::SRS_OBD_001);
    for (const Entry& entry : entries)
    {
        EXPECT_EQ(dictionary.Find({entry.index, entry.sub}), &entry);
    }
    EXPECT_EQ(dictionary.Find({0x0FFFU, 0U}), nullptr);
    EXPECT_EQ(dictionary.Find({0x2000U, 2U}), nullptr);
    EXPECT_EQ(dictionary.Find({0xFFFFU, 255U}), nullptr);
    Dictionary empty{EntryTable{nullptr, 0U}, foreign};
    EXPECT_EQ(empty.Find({0x1000U, 0U}), nullptr);
}

// A search by halves gets from the table what it needs in 1 + log2(n) looks; every other entry may be anything.
TEST_F(DictionaryTest, LooksAtNoOtherEntriesThanHalvingNeeds)
{
    Verifies(req::SRS_OBD_001);
    const std::pair<std::uint32_t, std::uint32_t> sizes[] = {{1U, 1U}, {2U, 2U},   {3U, 2U},  {7U, 3U},
                                                             {8U, 4U}, {100U, 7U}, {255U, 8U}};
    for (const auto& [count, most] : sizes)
    {
        for (std::uint32_t place = 0U; place < count; ++place)
        {
            // Given a table in which only what halving looks at is right, and each other entry is the one that is
            // sought
            const auto index = static_cast<std::uint16_t>(0x2000U + place);
            std::vector<Entry> table(count, entries[1]);
            for (Entry& entry : table)
            {
                entry.index = index;
            }
            std::uint32_t looks = 0U;
            std::uint32_t low = 0U;
            std::uint32_t high = count;
            while (low < high)
            {
                const std::uint32_t middle = (low + high) / 2U;
                table[middle].index = static_cast<std::uint16_t>(0x2000U + middle);
                ++looks;
                (middle < place) ? (low = middle + 1U) : (high = middle);
            }
            // Then it is found, and nothing else
            const Dictionary own{EntryTable{table.data(), count}, foreign};
            EXPECT_EQ(own.Find({index, 0U}), &table[place]) << count << " " << place;
            EXPECT_LE(looks, most) << count << " " << place;
        }
    }
}

TEST_F(DictionaryTest, TablesOutOfOrderOrWithTheKernelsObjectsAreNotUsable)
{
    Verifies(req::SRS_OBD_001);
    EXPECT_TRUE(IsUsable({entries.data(), 14U}));
    EXPECT_TRUE(IsUsable({nullptr, 0U}));
    // Given two entries in the wrong order, twice the same, and one in the kernel's range
    const Entry wrong[] = {entries[2], entries[1]};
    const Entry twice[] = {entries[2], entries[2]};
    Entry kernels[] = {entries[0]};
    EXPECT_FALSE(IsUsable({wrong, 2U}));
    EXPECT_FALSE(IsUsable({twice, 2U}));
    kernels[0].index = 0x1300U;
    EXPECT_FALSE(IsUsable({kernels, 1U}));
    kernels[0].index = 0x13FFU;
    EXPECT_FALSE(IsUsable({kernels, 1U}));
    kernels[0].index = 0x12FFU;
    EXPECT_TRUE(IsUsable({kernels, 1U}));
    kernels[0].index = 0x1400U;
    EXPECT_TRUE(IsUsable({kernels, 1U}));
}

TEST_F(DictionaryTest, WhatDoesNotExistIsToldApart)
{
    Verifies(req::SRS_OBD_002);
    EXPECT_EQ(Read(0x3000U, 0U).abort, SdoAbort::kObjectUnknown);
    EXPECT_EQ(Write(0x3000U, 0U, {1U}), SdoAbort::kObjectUnknown);
    EXPECT_EQ(Read(0x1000U, 1U).abort, SdoAbort::kSubUnknown);
    EXPECT_EQ(Read(0x2000U, 2U).abort, SdoAbort::kSubUnknown);
    EXPECT_EQ(Write(0x2000U, 4U, {1U}), SdoAbort::kSubUnknown);
    EXPECT_EQ(dictionary.SizeOf({0x2000U, 4U}).abort, SdoAbort::kSubUnknown);
    EXPECT_EQ(dictionary.MayWrite({0x3000U, 0U}, 1U), SdoAbort::kObjectUnknown);
    EXPECT_EQ(static_cast<std::uint32_t>(SdoAbort::kObjectUnknown), 0x06020000U);
    EXPECT_EQ(static_cast<std::uint32_t>(SdoAbort::kSubUnknown), 0x06090011U);
}

TEST_F(DictionaryTest, AccessIsKept)
{
    Verifies(req::SRS_OBD_003);
    const Reading constant = Read(0x1000U, 0U);
    EXPECT_EQ(constant.abort, SdoAbort::kNone);
    EXPECT_EQ(constant.size_bytes, 4U);
    EXPECT_EQ(room[0], 0x44U);
    EXPECT_EQ(room[3], 0x11U);
    EXPECT_EQ(Write(0x1000U, 0U, {1U, 2U, 3U, 4U}), SdoAbort::kReadOnly);
    EXPECT_EQ(Write(0x2000U, 0U, {1U}), SdoAbort::kReadOnly);
    EXPECT_EQ(Read(0x2000U, 0U).abort, SdoAbort::kNone);
    EXPECT_EQ(Read(0x2001U, 0U).abort, SdoAbort::kWriteOnly);
    EXPECT_EQ(Write(0x2001U, 0U, {1U, 2U, 3U, 4U}), SdoAbort::kNone);
    EXPECT_EQ(u32, (std::array<std::uint8_t, 4>{1U, 2U, 3U, 4U}));
    EXPECT_EQ(Read(0x2009U, 0U).abort, SdoAbort::kUnsupportedAccess);
    EXPECT_EQ(Write(0x2009U, 0U, {1U}), SdoAbort::kUnsupportedAccess);
}

TEST_F(DictionaryTest, StatesDecideAboutAccess)
{
    Verifies(req::SRS_OBD_004);
    // Given an entry for OPERATIONAL only, in PRE-OPERATIONAL
    EXPECT_EQ(Read(0x200BU, 0U).abort, SdoAbort::kDeviceState);
    EXPECT_EQ(Write(0x200BU, 0U, {1U}), SdoAbort::kDeviceState);
    EXPECT_EQ(dictionary.ReadNumber({0x200BU, 0U}).abort, SdoAbort::kNone); // the device itself may
    EXPECT_EQ(dictionary.WriteNumber({0x200BU, 0U}, 1U, 1U), SdoAbort::kNone);
    EXPECT_EQ(Write(0x2008U, 0U, {1U}), SdoAbort::kNone);
    // When the device is OPERATIONAL
    dictionary.SetNmtState(NmtState::kOperational);
    EXPECT_EQ(Read(0x200BU, 0U).abort, SdoAbort::kNone);
    EXPECT_EQ(Write(0x200BU, 0U, {1U}), SdoAbort::kNone);
    EXPECT_EQ(Write(0x2008U, 0U, {1U}), SdoAbort::kDeviceState);
    EXPECT_EQ(Read(0x2008U, 0U).abort, SdoAbort::kNone);
    // Then in no other state anything
    for (const NmtState state : {NmtState::kInvalid, NmtState::kInitialising, NmtState::kStopped})
    {
        dictionary.SetNmtState(state);
        EXPECT_EQ(Read(0x1000U, 0U).abort, SdoAbort::kDeviceState);
        EXPECT_EQ(Write(0x2008U, 0U, {1U}), SdoAbort::kDeviceState);
    }
}

TEST_F(DictionaryTest, LengthsAreKept)
{
    Verifies(req::SRS_OBD_005);
    EXPECT_EQ(Write(0x2000U, 3U, {1U, 2U, 3U, 4U, 5U}), SdoAbort::kTooLong);
    EXPECT_EQ(Write(0x2000U, 3U, {1U, 2U, 3U}), SdoAbort::kTooShort);
    EXPECT_EQ(Write(0x2000U, 3U, {}), SdoAbort::kTooShort);
    EXPECT_EQ(u32[0], 0x44U);
    // A string takes every length up to its room
    EXPECT_EQ(Write(0x2006U, 0U, {'1', '2', '3', '4', '5', '6', '7', '8', '9'}), SdoAbort::kTooLong);
    EXPECT_EQ(text_length, 2U);
    EXPECT_EQ(Write(0x2006U, 0U, {'1', '2', '3'}), SdoAbort::kNone);
    EXPECT_EQ(Read(0x2006U, 0U).size_bytes, 3U);
    EXPECT_EQ(Write(0x2006U, 0U, {'1', '2', '3', '4', '5', '6', '7', '8'}), SdoAbort::kNone);
    EXPECT_EQ(Read(0x2006U, 0U).size_bytes, 8U);
    EXPECT_EQ(Write(0x2006U, 0U, {}), SdoAbort::kNone);
    EXPECT_EQ(Read(0x2006U, 0U).size_bytes, 0U);
}

TEST_F(DictionaryTest, LimitsAreKept)
{
    Verifies(req::SRS_OBD_006);
    EXPECT_EQ(Write(0x2002U, 0U, {0x05U}), SdoAbort::kNone);
    EXPECT_EQ(Write(0x2002U, 0U, {0xFBU}), SdoAbort::kNone); // -5
    EXPECT_EQ(Write(0x2002U, 0U, {0x06U}), SdoAbort::kValueHigh);
    EXPECT_EQ(Write(0x2002U, 0U, {0xFAU}), SdoAbort::kValueLow); // -6
    EXPECT_EQ(i8[0], 0xFBU);
    EXPECT_EQ(Write(0x2003U, 0U, {20U, 0U}), SdoAbort::kNone);
    EXPECT_EQ(Write(0x2003U, 0U, {21U, 0U}), SdoAbort::kValueHigh);
    EXPECT_EQ(Write(0x2003U, 0U, {0x0AU, 0x01U}), SdoAbort::kValueHigh);
    EXPECT_EQ(Write(0x2003U, 0U, {10U, 0U}), SdoAbort::kNone);
    EXPECT_EQ(Write(0x2003U, 0U, {9U, 0U}), SdoAbort::kValueLow);
    EXPECT_EQ(Write(0x2004U, 0U, {15U, 0U}), SdoAbort::kLimitsContradict);
    EXPECT_EQ(u16, (std::array<std::uint8_t, 2>{10U, 0U}));
    EXPECT_EQ(Write(0x2005U, 0U, {1U}), SdoAbort::kNone);
    EXPECT_EQ(Write(0x2005U, 0U, {2U}), SdoAbort::kValueRange);
    EXPECT_EQ(flag[0], 1U);
    // Limits of what is no number, or longer than one, are not looked at
    const std::uint8_t nine[9] = {};
    Entry entry = entries[5];
    entry.type = DataType::kOctetString;
    EXPECT_EQ(CheckLimits(entry, {nine, 2U}), SdoAbort::kNone);
    entry.type = DataType::kUnsigned64;
    EXPECT_EQ(CheckLimits(entry, {nine, 9U}), SdoAbort::kNone);
    EXPECT_EQ(CheckLimits(entry, {nine, 8U}), SdoAbort::kValueLow);
}

TEST_F(DictionaryTest, HooksTakePart)
{
    Verifies(req::SRS_OBD_007);
    EXPECT_EQ(Read(0x2007U, 0U).abort, SdoAbort::kNone);
    EXPECT_EQ(room[0], 0x5AU);
    EXPECT_EQ(hook.last.index, 0x2007U);
    EXPECT_EQ(Write(0x2007U, 0U, {0x17U}), SdoAbort::kNone);
    EXPECT_EQ(hook.written, (std::vector<std::uint8_t>{0x17U}));
    EXPECT_EQ(Write(0x2008U, 0U, {0x18U}), SdoAbort::kNone); // hook and place
    EXPECT_EQ(flag[0], 0x18U);
    // When the hook refuses, with whatever code
    for (const SdoAbort code :
         {SdoAbort::kNotMappable, SdoAbort::kInternal, SdoAbort::kHardware, SdoAbort::kNoConnection,
          SdoAbort::kNotStored, SdoAbort::kLocalControl, SdoAbort::kNoDictionary, SdoAbort::kNoData})
    {
        hook.answer = code;
        EXPECT_EQ(Read(0x2007U, 0U).abort, code);
        EXPECT_EQ(Write(0x2008U, 0U, {0x19U}), code);
    }
    EXPECT_EQ(flag[0], 0x18U); // Then nothing is stored
    hook.written.clear();
    EXPECT_EQ(Write(0x2008U, 0U, {1U, 2U}), SdoAbort::kTooLong);
    EXPECT_TRUE(hook.written.empty());
    EXPECT_EQ(Read(0x200AU, 0U).abort, SdoAbort::kGeneral);
    EXPECT_EQ(Write(0x200AU, 0U, {1U}), SdoAbort::kGeneral);
}

TEST_F(DictionaryTest, AHookIsNotAskedForWhatIsRefusedWithoutIt)
{
    Verifies(req::SRS_OBD_007);
    // Given hooks of an entry with limits, of one that is read only, and of one with a state
    entries[5].write_hook = &hook;
    entries[1].write_hook = &hook;
    EXPECT_EQ(Write(0x2003U, 0U, {21U, 0U}), SdoAbort::kValueHigh);
    EXPECT_EQ(Write(0x2000U, 0U, {1U}), SdoAbort::kReadOnly);
    dictionary.SetNmtState(NmtState::kOperational);
    EXPECT_EQ(Write(0x2008U, 0U, {1U}), SdoAbort::kDeviceState);
    EXPECT_TRUE(hook.written.empty());
    // When nothing speaks against the value, then it is
    EXPECT_EQ(Write(0x2003U, 0U, {20U, 0U}), SdoAbort::kNone);
    EXPECT_EQ(hook.written, (std::vector<std::uint8_t>{20U, 0U}));
}

TEST_F(DictionaryTest, TheKernelsObjectsAreReachedThroughItsFacade)
{
    Verifies(req::SRS_OBD_008);
    EXPECT_EQ(Read(0x1300U, 0U).abort, SdoAbort::kNone);
    EXPECT_EQ(room[0], 0x01U);
    EXPECT_EQ(Write(0x1300U, 0U, {0x00U}), SdoAbort::kNone);
    EXPECT_EQ(foreign.gate.bytes[0], 0x00U);
    EXPECT_EQ(Write(0x1300U, 1U, {0x00U}), SdoAbort::kSubUnknown);
    EXPECT_EQ(Read(0x1341U, 0U).abort, SdoAbort::kObjectUnknown);
    // A variable of the kernel between own sub-indices of the same object
    EXPECT_EQ(Read(0x2000U, 1U).size_bytes, 4U);
    EXPECT_EQ(room[0], 0x78U);
    EXPECT_EQ(Write(0x2000U, 1U, {1U, 2U, 3U, 4U}), SdoAbort::kReadOnly);
    EXPECT_EQ(dictionary.SizeOf({0x2000U, 1U}).size_bytes, 4U);
    foreign.refusal = AbortCode::kDeviceState;
    EXPECT_EQ(Write(0x1300U, 0U, {0x00U}), SdoAbort::kDeviceState);
    // Nine bytes never reach it
    foreign.writes = 0;
    EXPECT_EQ(Write(0x1300U, 0U, {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 9U}), SdoAbort::kLengthMismatch);
    EXPECT_EQ(foreign.writes, 0);
    // and eight do
    EXPECT_EQ(Write(0x1300U, 0U, {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U}), SdoAbort::kDeviceState);
    EXPECT_EQ(foreign.writes, 1);
}

TEST_F(DictionaryTest, TheReadersRoomIsKept)
{
    Verifies(req::SRS_OBD_009);
    room.fill(0xEEU);
    EXPECT_EQ(dictionary.Read({0x1000U, 0U}, {room.data(), 3U}).abort, SdoAbort::kOutOfMemory);
    EXPECT_EQ(dictionary.Read({0x2000U, 1U}, {room.data(), 3U}).abort, SdoAbort::kOutOfMemory);
    EXPECT_EQ(room[0], 0xEEU);
    EXPECT_EQ(dictionary.Read({0x1000U, 0U}, {room.data(), 4U}).abort, SdoAbort::kNone);
    EXPECT_EQ(room[4], 0xEEU);
    hook.size = 17U; // a hook that tells more than it was given
    EXPECT_EQ(Read(0x2007U, 0U).abort, SdoAbort::kOutOfMemory);
}

TEST_F(DictionaryTest, NumbersAreNative)
{
    Verifies(req::SRS_OBD_010);
    EXPECT_EQ(dictionary.ReadNumber({0x1000U, 0U}).value, 0x11223344U);
    EXPECT_EQ(dictionary.ReadNumber({0x2002U, 0U}).value, 0xFFFFFFFFFFFFFFFEU); // -2
    EXPECT_EQ(dictionary.ReadNumber({0x2000U, 0U}).value, 0xFEU);
    EXPECT_EQ(dictionary.ReadNumber({0x2000U, 1U}).value, 0x12345678U);
    EXPECT_EQ(dictionary.WriteNumber({0x2003U, 0U}, 0x0014U, 2U), SdoAbort::kNone);
    EXPECT_EQ(u16, (std::array<std::uint8_t, 2>{0x14U, 0x00U}));
    EXPECT_EQ(dictionary.WriteNumber({0x2003U, 0U}, 0x0015U, 2U), SdoAbort::kValueHigh);
    EXPECT_EQ(dictionary.WriteNumber({0x1300U, 0U}, 0U, 1U), SdoAbort::kNone);
    EXPECT_EQ(dictionary.WriteNumber({0x2003U, 0U}, 1U, 4U), SdoAbort::kLengthMismatch);
    EXPECT_EQ(dictionary.WriteNumber({0x2003U, 0U}, 1U, 0U), SdoAbort::kLengthMismatch);
    EXPECT_EQ(dictionary.WriteNumber({0x2003U, 0U}, 1U, 9U), SdoAbort::kLengthMismatch);
    text_length = 0U;
    EXPECT_EQ(dictionary.ReadNumber({0x2006U, 0U}).abort, SdoAbort::kLengthMismatch);
    EXPECT_EQ(dictionary.ReadNumber({0x3000U, 0U}).abort, SdoAbort::kObjectUnknown);
    EXPECT_EQ(NumberOf(DataType::kInteger64, {u32.data(), 4U}), 0x11223344U);
}

TEST_F(DictionaryTest, AWriteIsJudgedBeforehand)
{
    Verifies(req::SRS_OBD_011);
    EXPECT_EQ(dictionary.MayWrite({0x2000U, 3U}, 4U), SdoAbort::kNone);
    EXPECT_EQ(dictionary.MayWrite({0x2000U, 3U}, kUnknownLength), SdoAbort::kNone);
    EXPECT_EQ(dictionary.MayWrite({0x2000U, 3U}, 5U), SdoAbort::kTooLong);
    EXPECT_EQ(dictionary.MayWrite({0x2000U, 3U}, 3U), SdoAbort::kTooShort);
    EXPECT_EQ(dictionary.MayWrite({0x1000U, 0U}, 4U), SdoAbort::kReadOnly);
    EXPECT_EQ(dictionary.MayWrite({0x2000U, 9U}, 4U), SdoAbort::kSubUnknown);
    EXPECT_EQ(dictionary.MayWrite({0x1300U, 0U}, 1U), SdoAbort::kNone);
    EXPECT_EQ(dictionary.MayWrite({0x1300U, 0U}, kUnknownLength), SdoAbort::kNone);
    EXPECT_EQ(dictionary.MayWrite({0x1300U, 0U}, 9U), SdoAbort::kLengthMismatch);
    EXPECT_EQ(dictionary.MayWrite({0x2009U, 0U}, 1U), SdoAbort::kUnsupportedAccess);
    EXPECT_EQ(dictionary.MayWrite({0x2001U, 0U}, 4U), SdoAbort::kNone);
    EXPECT_EQ(dictionary.MayWrite({0x200BU, 0U}, 1U), SdoAbort::kDeviceState);
    EXPECT_EQ(dictionary.MayWrite({0x200BU, 0U}, kUnknownLength), SdoAbort::kDeviceState);
    // An entry with a length of its own
    EXPECT_EQ(dictionary.MayWrite({0x2006U, 0U}, 1U), SdoAbort::kNone);
    EXPECT_EQ(dictionary.MayWrite({0x2006U, 0U}, 8U), SdoAbort::kNone);
    EXPECT_EQ(dictionary.MayWrite({0x2006U, 0U}, 9U), SdoAbort::kTooLong);
    EXPECT_EQ(u32[0], 0x44U);
    EXPECT_EQ(foreign.writes, 0);
}

struct WideCase
{
    DataType type;
    std::uint32_t bytes;
    bool is_signed;
};

TEST(WideNumbers, TypesOf24To56BitsHaveSignAndLimits)
{
    Verifies(req::SRS_OBD_014);
    constexpr WideCase kCases[] = {{DataType::kInteger24, 3U, true}, {DataType::kUnsigned24, 3U, false},
                                   {DataType::kInteger40, 5U, true}, {DataType::kUnsigned40, 5U, false},
                                   {DataType::kInteger48, 6U, true}, {DataType::kUnsigned48, 6U, false},
                                   {DataType::kInteger56, 7U, true}, {DataType::kUnsigned56, 7U, false}};
    const ValueLimits limits{static_cast<std::uint64_t>(std::int64_t{-5}), 5U};
    const ValueLimits positive{0U, 5U};
    for (const WideCase& one : kCases)
    {
        std::uint8_t place[8] = {};
        const Entry entry{0x2000U,   0U,
                          one.type,  Access::kReadWrite,
                          kInBoth,   kInBoth,
                          one.bytes, place,
                          nullptr,   one.is_signed ? &limits : &positive,
                          nullptr,   nullptr};
        FakeObjects foreign{};
        Dictionary dictionary{EntryTable{&entry, 1U}, foreign};
        EXPECT_EQ(dictionary.WriteNumber({0x2000U, 0U}, 6U, one.bytes), SdoAbort::kValueHigh);
        EXPECT_EQ(dictionary.WriteNumber({0x2000U, 0U}, 5U, one.bytes), SdoAbort::kNone);
        EXPECT_EQ(dictionary.ReadNumber({0x2000U, 0U}).value, 5U);
        const auto minus_five = static_cast<std::uint64_t>(std::int64_t{-5});
        EXPECT_EQ(dictionary.WriteNumber({0x2000U, 0U}, minus_five, one.bytes),
                  one.is_signed ? SdoAbort::kNone : SdoAbort::kValueHigh);
        EXPECT_EQ(dictionary.ReadNumber({0x2000U, 0U}).value, one.is_signed ? minus_five : 5U);
        EXPECT_EQ(dictionary.WriteNumber({0x2000U, 0U}, minus_five - 1U, one.bytes),
                  one.is_signed ? SdoAbort::kValueLow : SdoAbort::kValueHigh);
        EXPECT_EQ(dictionary.WriteNumber({0x2000U, 0U}, 1U, one.bytes + 1U), SdoAbort::kLengthMismatch);
        EXPECT_EQ(place[one.bytes], 0U); // nothing beside it
    }
}

TEST_F(DictionaryTest, TheKernelsIndicesAreNotTheTables)
{
    Verifies(req::SRS_OBD_008);
    Verifies(req::SRS_OBD_001);
    // Given a table that is not usable, since it has an object of the kernel
    Entry mine[2] = {entries[1], entries[1]};
    mine[0].index = 0x1301U;
    mine[1].index = 0x1400U;
    EXPECT_FALSE(IsUsable(EntryTable{mine, 2U}));
    EXPECT_TRUE(IsUsable(EntryTable{&mine[1], 1U}));
    Dictionary own{EntryTable{mine, 2U}, foreign};
    // Then the word of the kernel, which has none, still counts; of other indices that of the table
    EXPECT_EQ(own.Read({0x1301U, 2U}, {room.data(), 16U}).abort, SdoAbort::kObjectUnknown);
    EXPECT_EQ(own.Read({0x1400U, 2U}, {room.data(), 16U}).abort, SdoAbort::kSubUnknown);
}

TEST_F(DictionaryTest, AnAccessThatIsNoneGivesNone)
{
    Verifies(req::SRS_OBD_003);
    for (const std::uint8_t access : {std::uint8_t{0U}, std::uint8_t{5U}, std::uint8_t{0xFFU}})
    {
        Entry one = entries[2];
        one.access = static_cast<Access>(access);
        Dictionary own{EntryTable{&one, 1U}, foreign};
        own.SetNmtState(NmtState::kPreOperational);
        EXPECT_EQ(own.Read({0x2000U, 3U}, {room.data(), 16U}).abort, SdoAbort::kUnsupportedAccess);
        EXPECT_EQ(own.Write({0x2000U, 3U}, {room.data(), 4U}), SdoAbort::kUnsupportedAccess);
    }
}

TEST_F(DictionaryTest, NumbersOfEightBytesAndWhatIsLonger)
{
    Verifies(req::SRS_OBD_010);
    std::array<std::uint8_t, 9> bytes{0xFEU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 1U};
    Entry table[2] = {entries[2], entries[2]};
    table[0].type = DataType::kInteger64;
    table[0].size_bytes = 8U;
    table[0].place = bytes.data();
    table[1] = table[0];
    table[1].sub = 4U;
    table[1].type = DataType::kDomain;
    table[1].size_bytes = 9U;
    Dictionary own{EntryTable{table, 2U}, foreign};
    EXPECT_EQ(own.ReadNumber({0x2000U, 3U}).abort, SdoAbort::kNone);
    EXPECT_EQ(own.ReadNumber({0x2000U, 3U}).value, 0xFFFF'FFFF'FFFF'FFFEU);
    EXPECT_EQ(own.ReadNumber({0x2000U, 4U}).abort, SdoAbort::kLengthMismatch);
}

TEST_F(DictionaryTest, AHookWithoutASecondAnswerOfItsOwnIsAskedAsTheFirstTime)
{
    Verifies(req::SRS_OBD_015);
    hook.answer = SdoAbort::kPending;
    EXPECT_EQ(dictionary.WriteNumber({0x2007U, 0U}, 7U, 1U), SdoAbort::kPending);
    hook.answer = SdoAbort::kNone;
    hook.written.clear();
    EXPECT_EQ(dictionary.WriteNumberAgain({0x2007U, 0U}, 7U, 1U), SdoAbort::kNone);
    EXPECT_EQ(hook.written, (std::vector<std::uint8_t>{7U}));
}

TEST_F(DictionaryTest, TheEndOfADelayedWriteIsToldInWhateverStateItComes)
{
    Verifies(req::SRS_OBD_530);
    hook.answer = SdoAbort::kPending;
    const std::uint8_t value = 1U;
    EXPECT_EQ(dictionary.Write({0x2008U, 0U}, {&value, 1U}), SdoAbort::kPending);
    dictionary.SetNmtState(NmtState::kOperational);
    EXPECT_EQ(dictionary.WriteAgain({0x2008U, 0U}, {&value, 1U}), SdoAbort::kPending);
    hook.answer = SdoAbort::kNone;
    EXPECT_EQ(dictionary.WriteAgain({0x2008U, 0U}, {&value, 1U}), SdoAbort::kNone);
    EXPECT_EQ(dictionary.Write({0x2008U, 0U}, {&value, 1U}), SdoAbort::kDeviceState);
}

TEST_F(DictionaryTest, AHookHasAnObjectUnlessItKnowsNeitherIndexNorSubIndex)
{
    Verifies(req::SRS_OBD_007);
    const std::pair<SdoAbort, bool> cases[] = {{SdoAbort::kNone, true},
                                               {SdoAbort::kDeviceState, true},
                                               {SdoAbort::kSubUnknown, false},
                                               {SdoAbort::kObjectUnknown, false}};
    for (const auto& [answer, has_it] : cases)
    {
        hook.answer = answer;
        EXPECT_EQ(HasObject(hook, {0x2007U, 0U}), has_it) << static_cast<std::uint32_t>(answer);
    }
}

} // namespace
} // namespace counterpoint::cia301
