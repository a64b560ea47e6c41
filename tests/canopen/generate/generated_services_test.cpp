// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Services that keep the objects of a generated table: values of every access right reach them, and what they have not
// stays the table's.
#include "canopen/cia301/objects/service_objects.hpp"
#include "canopen/generated/constant_objects.hpp"
#include "canopen/generated/stored_objects.hpp"
#include "tests/canopen/cia301/service_rig.hpp"
#include "verification/trace/ids/generate.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <array>
#include <utility>
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

using Four = std::array<std::uint8_t, 4U>;

/// A service that has none of the objects that it is asked for.
class Nobody final : public cia301::ReadHook, public cia301::WriteHook
{
  public:
    Reading OnRead(const ObjectAddress& /*address*/, const Room& /*room*/) noexcept override
    {
        return {SdoAbort::kSubUnknown, 0U};
    }
    SdoAbort OnWrite(const ObjectAddress& /*address*/, const Bytes& /*value*/) noexcept override
    {
        return SdoAbort::kSubUnknown;
    }
};

class GeneratedServices : public cia301::ServiceRig
{
  protected:
    GeneratedServices()
    {
        table.SetNmtState(NmtState::kPreOperational);
        EXPECT_EQ(stored.Attach({0x1010U, 0x1011U}, {&nobody, &nobody}), AttachResult::kAttached);
        EXPECT_EQ(stored.Attach({0x1028U, 0x1029U}, {&nobody, &nobody}), AttachResult::kAttached);
        EXPECT_EQ(stored.Attach({0x1200U, 0x12FFU}, {&nobody, &nobody}), AttachResult::kAttached);
        EXPECT_EQ(stored.Attach({0x1014U, 0x1017U}, {&service_objects, &service_objects}), AttachResult::kAttached);
        EXPECT_EQ(stored.Attach({0x1400U, 0x1BFFU}, {&objects, &objects}), AttachResult::kAttached);
    }
    /// As a reset of canopen/device does it.
    PresetReply Preset()
    {
        service_objects.BeginConfiguration();
        tpdos.Reset();
        tpdos.BeginConfiguration();
        rpdos.Reset();
        rpdos.BeginConfiguration();
        const PresetReply reply = stored.Preset({0x1000U, 0x1FFFU});
        service_objects.EndConfiguration(nullptr);
        rpdos.EndConfiguration();
        tpdos.EndConfiguration();
        return reply;
    }
    std::uint32_t ReadTable(const std::uint16_t index, const std::uint8_t sub)
    {
        Four bytes{};
        const Reading reading = table.Read({index, sub}, {bytes.data(), 4U});
        EXPECT_EQ(reading.abort, SdoAbort::kNone) << std::hex << index;
        return bytes[0] | (std::uint32_t{bytes[1]} << 8U) | (std::uint32_t{bytes[2]} << 16U) |
               (std::uint32_t{bytes[3]} << 24U);
    }
    SdoAbort WriteTable(const std::uint16_t index, const std::uint8_t sub, const std::uint8_t value)
    {
        return table.Write({index, sub}, {&value, 1U});
    }
    Entry Fixed(const std::uint16_t index, const std::uint8_t sub, const std::uint32_t size_bytes)
    {
        return {index,
                sub,
                DataType::kUnsigned32,
                Access::kConstant,
                kInBoth,
                kInBoth,
                size_bytes,
                nullptr,
                nullptr,
                nullptr,
                &constants,
                &constants,
                0U};
    }
    Entry Stored(const std::uint16_t index, const std::uint8_t sub, const Access access, const std::uint32_t size_bytes,
                 Four& place)
    {
        return {index,      sub,          DataType::kUnsigned32,
                access,     kInBoth,      kInBoth,
                size_bytes, place.data(), nullptr,
                nullptr,    &stored,      &stored,
                0U};
    }

    const Four emergency_id{0xA0U, 0U, 0U, 0U};
    const Four period{100U, 0U, 0U, 0U};
    const Four two{2U, 0U, 0U, 0U};
    const Four tpdo_id{0x85U, 0x01U, 0U, 0x40U};
    const Four one{1U, 0U, 0U, 0U};
    const Four field{0x08U, 0U, 0U, 0x21U}; // 2100h:00, 8 bit
    const ConstantValue values[8U]{
        {{0x1014U, 0U}, 4U, emergency_id.data()}, {{0x1017U, 0U}, 2U, period.data()}, {{0x1800U, 0U}, 1U, two.data()},
        {{0x1800U, 1U}, 4U, tpdo_id.data()},      {{0x1800U, 2U}, 1U, one.data()},    {{0x1A00U, 0U}, 1U, one.data()},
        {{0x1A00U, 1U}, 4U, field.data()},        {{0x1A00U, 2U}, 4U, field.data()},
    };
    ConstantObjects constants{ConstantTable{values, 8U}};
    Four groups{5U};
    Four group{1U};
    Four restores{6U};
    Four restore{1U};
    Four watched{3U};
    Four behaviours{2U};
    Four behaviour{1U};
    Four server{2U};
    Four client{3U};
    Four last_rpdo{5U};
    Four last_tpdo{6U};
    Four consumers{1U};
    Four consumer_time{0x64U, 0x00U, 0x06U, 0x00U};
    Four last{4U};
    Four rpdo_id{0x05U, 0x02U};
    Four rpdo_type{1U};
    Four reserved{9U};
    Four mapped{1U};
    Four rpdo_field{0x08U, 0x00U, 0x00U, 0x21U};
    StoredObjects stored{cia301::EntryTable{file, 27U}};
    const Entry file[27U]{
        Stored(0x1010U, 0U, Access::kReadOnly, 1U, groups),
        Stored(0x1010U, 5U, Access::kReadWrite, 4U, group),
        Stored(0x1011U, 0U, Access::kReadWrite, 1U, restores),
        Stored(0x1011U, 5U, Access::kReadWrite, 4U, restore),
        Fixed(0x1014U, 0U, 4U),
        Stored(0x1016U, 0U, Access::kReadWrite, 1U, consumers),
        Stored(0x1016U, 1U, Access::kReadOnly, 4U, consumer_time),
        Fixed(0x1017U, 0U, 2U),
        Stored(0x1028U, 0U, Access::kReadWrite, 1U, watched),
        Stored(0x1029U, 0U, Access::kReadWrite, 1U, behaviours),
        Stored(0x1029U, 1U, Access::kReadWrite, 1U, behaviour),
        Stored(0x1200U, 0U, Access::kReadWrite, 1U, server),
        Stored(0x12FFU, 0U, Access::kReadWrite, 1U, client),
        Stored(0x1400U, 0U, Access::kReadOnly, 1U, last),
        Stored(0x1400U, 1U, Access::kReadWrite, 4U, rpdo_id),
        Stored(0x1400U, 2U, Access::kReadOnly, 1U, rpdo_type),
        Stored(0x1400U, 4U, Access::kReadWrite, 1U, reserved),
        Stored(0x15FFU, 0U, Access::kReadWrite, 1U, last_rpdo),
        Stored(0x1600U, 0U, Access::kReadOnly, 1U, mapped),
        Stored(0x1600U, 1U, Access::kReadWrite, 4U, rpdo_field),
        Fixed(0x1800U, 0U, 1U),
        Fixed(0x1800U, 1U, 4U),
        Fixed(0x1800U, 2U, 1U),
        Stored(0x19FFU, 0U, Access::kReadWrite, 1U, last_tpdo),
        Fixed(0x1A00U, 0U, 1U),
        Fixed(0x1A00U, 1U, 4U),
        Fixed(0x1A00U, 2U, 4U),
    };
    Nobody nobody{};
    std::array<cia301::SupervisedNode, 1U> supervised{};
    cia301::HeartbeatConsumer consumer{cia301::SupervisedNodes{supervised.data(), 1U}, errors};
    cia301::HeartbeatProducer producer{cia301::NodeId{5U}};
    cia301::NodeGuarding guarding{cia301::NodeId{5U}};
    cia301::ServiceObjects service_objects{cia301::ServiceParts{emergency, consumer, producer, guarding, 1U}};
    cia301::Dictionary table{cia301::EntryTable{file, 27U}, foreign};
};

TEST_F(GeneratedServices, ValuesThatNobodyMayWriteReachTheServices)
{
    Verifies(req::SRS_GEN_008);
    Verifies(req::SRS_GEN_019);
    // When the values of the file are handed to the services, then none is refused, and none is missing
    EXPECT_EQ(Preset().refused, 0U);
    EXPECT_EQ(stored.Compare({0x1000U, 0x1FFFU}).refused, 0U);
    // And the services work with them: constants, and what is read-only
    EXPECT_EQ(emergency.CobId(), 0xA0U);
    EXPECT_EQ(producer.PeriodMs(), 100U);
    EXPECT_EQ(consumer.Value(1U), 0x00060064U);
    EXPECT_EQ(tpdos.FetchSetting(1U, 1U).value, 0x40000185U);
    EXPECT_EQ(rpdos.FetchSetting(1U, 2U).value, 1U);
    Sync0();
    EXPECT_EQ(sink.Next(), (std::vector<std::uint8_t>{0x11U}));
    Hear({0x5AU});
    Sync0();
    EXPECT_EQ(u8[0], 0x5AU);
    // And a client changes neither
    EXPECT_EQ(WriteTable(0x1800U, 2U, 1U), SdoAbort::kReadOnly);
    EXPECT_EQ(WriteTable(0x1400U, 2U, 1U), SdoAbort::kReadOnly);
}

TEST_F(GeneratedServices, SubIndicesAreThoseOfTheTable)
{
    Verifies(req::SRS_GEN_027);
    EXPECT_EQ(Preset().refused, 0U);
    // Then the number of sub-indices is the table's, and takes no other value
    EXPECT_EQ(ReadTable(0x1400U, 0U), 4U);
    EXPECT_EQ(ReadTable(0x1800U, 0U), 2U);
    EXPECT_EQ(WriteTable(0x1016U, 0U, 1U), SdoAbort::kNone);
    EXPECT_EQ(WriteTable(0x1016U, 0U, 2U), SdoAbort::kReadOnly);
    EXPECT_EQ(ReadTable(0x1016U, 0U), 1U);
    // And what no service has is kept here
    EXPECT_EQ(ReadTable(0x1400U, 4U), 9U);
    EXPECT_EQ(WriteTable(0x1400U, 4U, 8U), SdoAbort::kNone);
    EXPECT_EQ(ReadTable(0x1400U, 4U), 8U);
    EXPECT_EQ(WriteTable(0x1400U, 5U, 0U), SdoAbort::kSubUnknown);
    // But for a group that nobody stores
    const Four save{0x73U, 0x61U, 0x76U, 0x65U};
    EXPECT_EQ(table.Write({0x1010U, 5U}, {save.data(), 4U}), SdoAbort::kNotStored);
    const Four load{0x6CU, 0x6FU, 0x61U, 0x64U};
    EXPECT_EQ(table.Write({0x1011U, 5U}, {load.data(), 4U}), SdoAbort::kNotStored);
}

TEST_F(GeneratedServices, TheNumberOfSubIndicesIsTheTablesWhateverHookIsAttached)
{
    Verifies(req::SRS_GEN_027);
    // Given hooks that have none of them, which would say so
    EXPECT_EQ(ReadTable(0x1010U, 0U), 5U);
    const std::pair<std::uint16_t, std::uint8_t> numbers[] = {
        {std::uint16_t{0x1011U}, std::uint8_t{6U}}, {std::uint16_t{0x1028U}, std::uint8_t{3U}},
        {std::uint16_t{0x1029U}, std::uint8_t{2U}}, {std::uint16_t{0x1200U}, std::uint8_t{2U}},
        {std::uint16_t{0x12FFU}, std::uint8_t{3U}}, {std::uint16_t{0x15FFU}, std::uint8_t{5U}},
        {std::uint16_t{0x19FFU}, std::uint8_t{6U}}};
    for (const auto& [index, number] : numbers)
    {
        EXPECT_EQ(ReadTable(index, 0U), number) << std::hex << index;
        EXPECT_EQ(WriteTable(index, 0U, number), SdoAbort::kNone) << std::hex << index;
        EXPECT_EQ(WriteTable(index, 0U, 1U), SdoAbort::kReadOnly) << std::hex << index;
        EXPECT_EQ(ReadTable(index, 0U), number) << std::hex << index;
    }
    // And a sub-index that the hook has not is kept by the table
    EXPECT_EQ(WriteTable(0x1029U, 1U, 0U), SdoAbort::kNone);
    EXPECT_EQ(ReadTable(0x1029U, 1U), 0U);
}
} // namespace
} // namespace counterpoint::generated
