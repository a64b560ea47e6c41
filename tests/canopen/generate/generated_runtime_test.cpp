// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What generated tables stand on: constants, stored values with hooks, numbers.
#include "canopen/cia301/dictionary/dictionary.hpp"
#include "canopen/generated/constant_objects.hpp"
#include "canopen/generated/numbers.hpp"
#include "canopen/generated/stored_objects.hpp"
#include "data_digest/object_dictionary.hpp"
#include "safety_core/kernel/variable.hpp"
#include "tests/canopen/cia301/fake_objects.hpp"
#include "verification/trace/ids/cia301.hpp"
#include "verification/trace/ids/generate.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <set>
#include <vector>

namespace counterpoint::generated
{
namespace
{
using cia301::Access;
using cia301::Bytes;
using cia301::DataType;
using cia301::Entry;
using cia301::kInBoth;
using cia301::Reading;
using cia301::Room;
using cia301::SdoAbort;

/// A service that keeps objects: notes what it is told.
class Service final : public cia301::ReadHook, public cia301::WriteHook
{
  public:
    Reading OnRead(const ObjectAddress& /*address*/, const Room& room) noexcept override
    {
        room.data[0] = 0x77U;
        return {SdoAbort::kNone, 1U};
    }
    SdoAbort OnWrite(const ObjectAddress& address, const Bytes& value) noexcept override
    {
        told.push_back({address.index, address.sub, value.data[0], value.size_bytes});
        return (refused.count(address.index) != 0U) ? SdoAbort::kDeviceState : answer;
    }
    SdoAbort OnWriteAgain(const ObjectAddress& /*address*/, const Bytes& /*value*/) noexcept override
    {
        ++asked_again;
        return answer;
    }
    int asked_again{0};
    std::set<std::uint16_t> refused{};
    std::vector<std::array<std::uint32_t, 4U>> told{};
    SdoAbort answer{SdoAbort::kNone};
};

class GeneratedRuntime : public ::testing::Test
{
  protected:
    GeneratedRuntime()
    {
        dictionary.SetNmtState(NmtState::kPreOperational);
    }
    std::uint8_t Read(const std::uint16_t index, const std::uint8_t sub)
    {
        return static_cast<std::uint8_t>(dictionary.ReadNumber({index, sub}).value);
    }
    SdoAbort Write(const std::uint16_t index, const std::uint8_t sub, const std::uint8_t value)
    {
        return dictionary.Write({index, sub}, Bytes{&value, 1U});
    }

    std::array<std::uint8_t, 8U> bytes{1U, 2U, 3U, 4U, 'a', 'b', 0U, 0U};
    std::uint32_t text_length{2U};
    const std::uint8_t constant_bytes[3U]{0xA1U, 0xA2U, 0xA3U};
    const ConstantValue values[2U]{{{0x1018U, 0U}, 1U, constant_bytes}, {{0x5F00U, 1U}, 2U, constant_bytes + 1}};
    ConstantObjects constants{ConstantTable{values, 2U}};
    StoredObjects stored{cia301::EntryTable{entries, 8U}};
    const Entry entries[8U]{
        {0x1016U, 0U, DataType::kUnsigned8, Access::kReadWrite, kInBoth, kInBoth, 1U, &bytes[0], nullptr, nullptr,
         &stored, &stored},
        {0x1016U, 1U, DataType::kUnsigned8, Access::kReadWrite, kInBoth, kInBoth, 1U, &bytes[1], nullptr, nullptr,
         &stored, &stored},
        {0x1017U, 0U, DataType::kUnsigned8, Access::kReadWrite, kInBoth, kInBoth, 1U, &bytes[2], nullptr, nullptr,
         &stored, &stored},
        {0x1018U, 0U, DataType::kUnsigned8, Access::kConstant, kInBoth, kInBoth, 1U, nullptr, nullptr, nullptr,
         &constants, &constants},
        {0x1019U, 0U, DataType::kUnsigned8, Access::kReadOnly, kInBoth, kInBoth, 1U, &bytes[3], nullptr, nullptr,
         &stored, &stored},
        {0x2000U, 0U, DataType::kVisibleString, Access::kReadWrite, kInBoth, kInBoth, 4U, &bytes[4], &text_length,
         nullptr, &stored, &stored},
        {0x2001U, 0U, DataType::kDomain, Access::kReadWrite, kInBoth, kInBoth, 100U, nullptr, &no_length, nullptr,
         &stored, &stored},
        {0x5F00U, 1U, DataType::kUnsigned16, Access::kReadWrite, kInBoth, kInBoth, 2U, nullptr, nullptr, nullptr,
         &constants, &constants},
    };
    std::uint32_t no_length{0U};
    cia301::FakeObjects foreign{};
    cia301::Dictionary dictionary{cia301::EntryTable{entries, 8U}, foreign};
};

TEST_F(GeneratedRuntime, ConstantsAreReadAndTakeOnlyWhatTheyAre)
{
    Verifies(req::SRS_GEN_006);
    EXPECT_EQ(Read(0x1018U, 0U), 0xA1U);
    EXPECT_EQ(dictionary.ReadNumber({0x5F00U, 1U}).value, 0xA3A2U);
    // A constant entry takes nothing; a parameter of the program takes what changes nothing
    EXPECT_EQ(Write(0x1018U, 0U, 0xA1U), SdoAbort::kReadOnly);
    EXPECT_EQ(dictionary.WriteNumber({0x5F00U, 1U}, 0xA3A2U, 2U), SdoAbort::kNone);
    EXPECT_EQ(dictionary.WriteNumber({0x5F00U, 1U}, 0xA3A3U, 2U), SdoAbort::kValueRange);
    EXPECT_EQ(constants.OnWrite({0x5F00U, 1U}, Bytes{constant_bytes, 1U}), SdoAbort::kValueRange);
    EXPECT_EQ(constants.OnWrite({0x5F00U, 2U}, Bytes{constant_bytes, 1U}), SdoAbort::kValueRange);
    // What is not there, and a room that is too small
    std::uint8_t room[1U]{};
    EXPECT_EQ(constants.OnRead({0x5F00U, 2U}, Room{room, 1U}).abort, SdoAbort::kObjectUnknown);
    EXPECT_EQ(constants.OnRead({0x5F00U, 1U}, Room{room, 1U}).abort, SdoAbort::kOutOfMemory);
}

TEST_F(GeneratedRuntime, WithoutHooksTheStoredValueIsAllThereIs)
{
    Verifies(req::SRS_GEN_007);
    EXPECT_EQ(Read(0x1017U, 0U), 3U);
    EXPECT_EQ(Write(0x1017U, 0U, 9U), SdoAbort::kNone);
    EXPECT_EQ(bytes[2], 9U);
    const std::uint8_t text[3U]{'x', 'y', 'z'};
    EXPECT_EQ(dictionary.Write({0x2000U, 0U}, Bytes{text, 3U}), SdoAbort::kNone);
    EXPECT_EQ(text_length, 3U);
    // A DOMAIN has nobody
    EXPECT_EQ(Write(0x2001U, 0U, 1U), SdoAbort::kGeneral);
    EXPECT_EQ(dictionary.ReadNumber({0x2001U, 0U}).abort, SdoAbort::kGeneral);
    std::uint8_t room[1U]{};
    EXPECT_EQ(stored.OnRead({0x3000U, 0U}, Room{room, 1U}).abort, SdoAbort::kObjectUnknown);
    EXPECT_EQ(stored.OnWrite({0x3000U, 0U}, Bytes{room, 1U}), SdoAbort::kGeneral);
}

TEST_F(GeneratedRuntime, AHookKeepsTheObjectsOfItsRange)
{
    Verifies(req::SRS_GEN_008);
    // Given a service on 1017h and one on the DOMAIN
    Service service{};
    ASSERT_EQ(stored.Attach({0x1017U, 0x1019U}, {&service, &service}), AttachResult::kAttached);
    ASSERT_EQ(stored.Attach({0x2001U, 0x2001U}, {nullptr, &service}), AttachResult::kAttached);
    // Then it answers, is told, and what it accepts is stored too
    EXPECT_EQ(Read(0x1017U, 0U), 0x77U);
    EXPECT_EQ(Write(0x1017U, 0U, 9U), SdoAbort::kNone);
    EXPECT_EQ(bytes[2], 9U);
    EXPECT_EQ(Write(0x2001U, 0U, 5U), SdoAbort::kNone);
    service.answer = SdoAbort::kValueRange;
    EXPECT_EQ(Write(0x1017U, 0U, 8U), SdoAbort::kValueRange);
    EXPECT_EQ(bytes[2], 9U);
    EXPECT_EQ(service.told.size(), 3U);
    // Others are as before
    EXPECT_EQ(Read(0x1016U, 1U), 2U);
    EXPECT_EQ(Read(0x1018U, 0U), 0xA1U);
}

// What a hook delays is stored when it has taken it, and asking again is no new write.
TEST_F(GeneratedRuntime, AHookThatDelaysAWriteIsToldThatItIsAskedAgain)
{
    Verifies(req::SRS_OBD_015);
    Service service{};
    ASSERT_EQ(stored.Attach({0x1017U, 0x1017U}, {&service, &service}), AttachResult::kAttached);
    const std::uint8_t value = 9U;
    service.answer = SdoAbort::kPending;
    EXPECT_EQ(Write(0x1017U, 0U, value), SdoAbort::kPending);
    EXPECT_EQ(dictionary.WriteAgain({0x1017U, 0U}, Bytes{&value, 1U}), SdoAbort::kPending);
    EXPECT_EQ(bytes[2], 3U);
    service.answer = SdoAbort::kNone;
    EXPECT_EQ(dictionary.WriteNumberAgain({0x1017U, 0U}, 9U, 1U), SdoAbort::kNone);
    EXPECT_EQ(bytes[2], 9U);
    EXPECT_EQ(service.told.size(), 1U);
    EXPECT_EQ(service.asked_again, 2);
    // A hook that makes no difference is asked as the first time; where there is none, there is nothing to wait for
    EXPECT_EQ(dictionary.WriteNumberAgain({0x5F00U, 1U}, 0xA3A2U, 2U), SdoAbort::kNone);
    EXPECT_EQ(stored.OnWriteAgain({0x1016U, 1U}, Bytes{&value, 1U}), SdoAbort::kNone);
}

TEST_F(GeneratedRuntime, RangesDoNotOverlapAndAreEightAtMost)
{
    Verifies(req::SRS_GEN_008);
    Service service{};
    const ObjectHooks hooks{&service, &service};
    EXPECT_EQ(stored.Attach({0x2001U, 0x2000U}, hooks), AttachResult::kOverlap);
    for (std::uint16_t index = 0x3000U; index < 0x3080U; index = static_cast<std::uint16_t>(index + 0x10U))
    {
        EXPECT_EQ(stored.Attach({index, static_cast<std::uint16_t>(index + 1U)}, hooks), AttachResult::kAttached);
        EXPECT_NE(stored.Attach({static_cast<std::uint16_t>(index + 1U), 0xFFFFU}, hooks), AttachResult::kAttached);
    }
    EXPECT_EQ(stored.Attach({0x1017U, 0x1017U}, hooks), AttachResult::kFull);
    EXPECT_EQ(stored.Attach({0x3000U, 0x3000U}, hooks), AttachResult::kOverlap);
}

TEST_F(GeneratedRuntime, PresetTellsTheHookItsStoredValues)
{
    Verifies(req::SRS_GEN_008);
    Service service{};
    ASSERT_EQ(stored.Attach({0x1016U, 0x2FFFU}, {nullptr, &service}), AttachResult::kAttached);
    // When the values of 1016h to 2000h are preset, then all are told, constants and read-only ones, too; a counter is
    // not
    EXPECT_EQ(stored.Preset({0x1016U, 0x2000U}).abort, SdoAbort::kNone);
    const std::vector<std::array<std::uint32_t, 4U>> told{{0x1016U, 1U, 2U, 1U},
                                                          {0x1017U, 0U, 3U, 1U},
                                                          {0x1018U, 0U, 0xA1U, 1U},
                                                          {0x1019U, 0U, 4U, 1U},
                                                          {0x2000U, 0U, 'a', 2U}};
    EXPECT_EQ(service.told, told);
}

TEST_F(GeneratedRuntime, PresetGoesOnBehindARefusalAndNamesTheFirst)
{
    Verifies(req::SRS_GEN_019);
    // Given a service that refuses 1017h and 2000h
    Service service{};
    service.refused = {0x1017U, 0x2000U};
    ASSERT_EQ(stored.Attach({0x1016U, 0x2FFFU}, {&service, &service}), AttachResult::kAttached);
    // When all is preset, then it is told everything, and the first refusal is named with the number of them
    const PresetReply reply = stored.Preset({0x1016U, 0xFFFFU});
    EXPECT_EQ(reply.abort, SdoAbort::kDeviceState);
    EXPECT_EQ(reply.object.index, 0x1017U);
    EXPECT_EQ(reply.object.sub, 0U);
    EXPECT_EQ(reply.refused, 2U);
    EXPECT_EQ(service.told.size(), 5U);
    // And without a refusal there is nothing to name
    service.refused.clear();
    EXPECT_EQ(stored.Preset({0x1016U, 0xFFFFU}).abort, SdoAbort::kNone);
    EXPECT_EQ(stored.Preset({0x1016U, 0xFFFFU}).refused, 0U);
}

TEST_F(GeneratedRuntime, PresetLeavesOutCountersAndWhatIsNoSetting)
{
    Verifies(req::SRS_GEN_008);
    // Given errors, store, defaults, SDO parameters, and a PDO with its mapping, each of which a file gives a value
    std::vector<Entry> list;
    for (const auto& [index, sub] : std::vector<std::pair<std::uint16_t, std::uint8_t>>{{0x1001U, 0U},
                                                                                        {0x1003U, 0U},
                                                                                        {0x1003U, 1U},
                                                                                        {0x1010U, 0U},
                                                                                        {0x1010U, 1U},
                                                                                        {0x1011U, 1U},
                                                                                        {0x1017U, 0U},
                                                                                        {0x1200U, 1U},
                                                                                        {0x1400U, 0U},
                                                                                        {0x1400U, 1U},
                                                                                        {0x1600U, 0U},
                                                                                        {0x1600U, 1U}})
    {
        list.push_back({index, sub, DataType::kUnsigned8, Access::kReadWrite, kInBoth, kInBoth, 1U, bytes.data(),
                        nullptr, nullptr, nullptr, nullptr});
    }
    StoredObjects own{cia301::EntryTable{list.data(), static_cast<std::uint32_t>(list.size())}};
    for (Entry& entry : list)
    {
        entry.read_hook = &own;
        entry.write_hook = &own;
    }
    Service service{};
    ASSERT_EQ(own.Attach({0x1000U, 0x1FFFU}, {nullptr, &service}), AttachResult::kAttached);
    EXPECT_EQ(own.Preset({0x1000U, 0x1FFFU}).refused, 0U);
    // Then the hook is handed what it can be set to, and of the counts the one of the mapping
    std::vector<std::pair<std::uint32_t, std::uint32_t>> told;
    for (const auto& each : service.told)
    {
        told.emplace_back(each[0], each[1]);
    }
    EXPECT_EQ(told, (std::vector<std::pair<std::uint32_t, std::uint32_t>>{
                        {0x1017U, 0U}, {0x1400U, 1U}, {0x1600U, 0U}, {0x1600U, 1U}}));
}

TEST_F(GeneratedRuntime, CompareNamesWhatAHookHasNot)
{
    Verifies(req::SRS_GEN_019);
    // Given a service that answers 77h for every object
    Service service{};
    ASSERT_EQ(stored.Attach({0x1016U, 0x2FFFU}, {&service, &service}), AttachResult::kAttached);
    bytes[2] = 0x77U;
    // Then 1017h is as it is stored; 1016h:01 (2), 1018h (A1h), 1019h (4) and the text of 2000h are not
    const PresetReply reply = stored.Compare({0x1016U, 0x2000U});
    EXPECT_EQ(reply.abort, SdoAbort::kIncompatible);
    EXPECT_EQ(reply.object.index, 0x1016U);
    EXPECT_EQ(reply.object.sub, 1U);
    EXPECT_EQ(reply.refused, 4U);
    EXPECT_EQ(stored.Compare({0x1017U, 0x1017U}).refused, 0U);
}

/// Place of a variable of the device.
VariablePlace PlaceOf(const DeviceConfig& device, const std::uint16_t index)
{
    for (std::uint16_t object = 0U; object < device.object_count; ++object)
    {
        if (device.objects[object].index == index)
        {
            return {device.objects[object].place, device.objects[object].length_bits};
        }
    }
    return {nullptr, 0U};
}

TEST(GeneratedAccess, ValueIsThatOfAReleasedWholePairElseTheSafeOne)
{
    Verifies(req::SRS_GEN_020);
    // Given a consumer with the safe value A1B2C3D4h, before anything was received: the pair is not inverse
    namespace digest = test_data_digest;
    digest::ResetApplication();
    EXPECT_EQ(digest::GetIn1(0xFFFFFFFFU), 0xA1B2C3D4U);
    EXPECT_EQ(digest::GetIn1Unchecked(), 0U);
    // When the channels write a pair
    const VariablePlace normal = PlaceOf(digest::kDevice, 0x2200U);
    const VariablePlace inverse = PlaceOf(digest::kDevice, 0x2300U);
    WriteVariable(normal, VariableValue{0x00000005U});
    WriteVariable(inverse, VariableValue{0xFFFFFFFAU});
    // Then it is the value while SRDO 2, slot 0, is released, and the safe value while only others are
    EXPECT_EQ(digest::GetIn1(1U), 5U);
    EXPECT_EQ(digest::GetIn1(3U), 5U);
    EXPECT_EQ(digest::GetIn1(0U), 0xA1B2C3D4U);
    EXPECT_EQ(digest::GetIn1(2U), 0xA1B2C3D4U);
    EXPECT_EQ(digest::GetIn1Unchecked(), 5U);
    // When one bit flips in either half
    WriteVariable(inverse, VariableValue{0xFFFFFFFBU});
    EXPECT_EQ(digest::GetIn1(1U), 0xA1B2C3D4U);
    WriteVariable(inverse, VariableValue{0xFFFFFFFAU});
    WriteVariable(normal, VariableValue{0x80000005U});
    EXPECT_EQ(digest::GetIn1(1U), 0xA1B2C3D4U);
    digest::ResetApplication();
}

TEST(GeneratedNumbers, AreRightToTheirEnds)
{
    Verifies(req::SRS_GEN_013);
    std::array<std::uint8_t, 8U> bytes{};
    const VariablePlace three{bytes.data(), 24U};
    for (const std::int64_t value : {0LL, 1LL, -1LL, 8388607LL, -8388608LL})
    {
        WriteSigned(three, value);
        EXPECT_EQ(ReadSigned(three), value);
        EXPECT_EQ(bytes[3], 0U);
    }
    EXPECT_EQ(bytes[2], 0x80U); // The last one, low byte first.
    const VariablePlace eight{bytes.data(), 64U};
    for (const std::int64_t value :
         {std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max()})
    {
        WriteSigned(eight, value);
        EXPECT_EQ(ReadSigned(eight), value);
    }
    WriteReal64(eight, -1.5);
    EXPECT_EQ(ReadReal64(eight), -1.5);
    EXPECT_EQ(bytes, (std::array<std::uint8_t, 8U>{0U, 0U, 0U, 0U, 0U, 0U, 0xF8U, 0xBFU}));
    const VariablePlace four{bytes.data(), 32U};
    WriteReal32(four, 1.0F);
    EXPECT_EQ(ReadReal32(four), 1.0F);
    EXPECT_EQ(bytes[3], 0x3FU);
}
} // namespace
} // namespace counterpoint::generated
