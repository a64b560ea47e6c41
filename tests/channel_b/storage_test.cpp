// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What the storage of channel B has room for.
#include "channel_b/channel.hpp"
#include "channel_b/storage.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/ids/kernel.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <memory>
#include <vector>

namespace counterpoint
{
namespace
{

template <std::uint8_t kSlots, std::uint8_t kEntries> ChannelRoom RoomOf()
{
    const auto storage = std::make_unique<channel_b::StorageFor<kSlots, kEntries>>();
    const channel_b::Channel channel{storage->Handle()};
    return channel.Room();
}

TEST(ChannelBStorage, TellsSlotsAndEntries)
{
    Verifies(req::SRS_KRN_020);
    // Given storage of several sizes, then Room tells each
    EXPECT_EQ((RoomOf<1U, 16U>().slots), 1U);
    EXPECT_EQ((RoomOf<1U, 16U>().map_entries), 16U);
    EXPECT_EQ((RoomOf<64U, 128U>().slots), 64U);
    EXPECT_EQ((RoomOf<64U, 128U>().map_entries), 128U);
    EXPECT_EQ((RoomOf<2U, 0U>().slots), 2U);
    EXPECT_EQ((RoomOf<2U, 0U>().map_entries), 0U);
    EXPECT_EQ((RoomOf<3U, 2U>().slots), 3U);
    EXPECT_EQ((RoomOf<3U, 2U>().map_entries), 2U);
    EXPECT_EQ((RoomOf<63U, 126U>().slots), 63U);
    EXPECT_EQ((RoomOf<63U, 126U>().map_entries), 126U);
}

TEST(ChannelBStorage, IsForSixteenEntriesUnlessToldOtherwise)
{
    Verifies(req::SRS_KRN_020);
    const auto storage = std::make_unique<channel_b::StorageFor<2U>>();
    const channel_b::Channel channel{storage->Handle()};
    EXPECT_EQ(channel.Room().slots, 2U);
    EXPECT_EQ(channel.Room().map_entries, 16U);
}

TEST(ChannelBStorage, OfADeviceWithoutDynamicEntriesTakesNoneOfItsOwn)
{
    Verifies(req::SRS_CFG_032);
    // Given storage for static mappings alone, then it is smaller by what the entries take
    EXPECT_LT(sizeof(channel_b::StorageFor<8U, 0U>), sizeof(channel_b::StorageFor<8U, 16U>));
    EXPECT_GE(sizeof(channel_b::StorageFor<8U, 16U>) - sizeof(channel_b::StorageFor<8U, 0U>), (8U * 16U * 4U) - 4U);
}

TEST(ChannelBStorage, OfADeviceWithoutDynamicEntriesHasTheLeastColumnsOfEntries)
{
    Verifies(req::SRS_CFG_032);
    // Given storage for static mappings alone, then its columns of entries have the one element that an array must have
    using OfStaticMappings = channel_b::StorageFor<8U, 0U>;
    EXPECT_EQ(sizeof(OfStaticMappings::entries), 4U);
    EXPECT_EQ(sizeof(OfStaticMappings::places), 2U);
}

constexpr std::uint8_t kPattern = 0x66U;
constexpr std::uint32_t kChallenge = 0x01020304U;
constexpr std::uint32_t kToken = 0x02030401U ^ 0xA5A5A5A5U;

/// A device of one object on each side, and storage in which there is more than the channel is told of.
template <std::uint8_t kSlots, std::uint8_t kEntries> class Device
{
  public:
    Device(std::uint8_t told_slots, std::uint8_t srdo_count) : channel_(Handle(told_slots))
    {
        for (std::uint8_t slot = 0U; slot < kSlots; ++slot)
        {
            setups_[slot].number = static_cast<std::uint8_t>(slot + 1U);
            setups_[slot].policy = ReleasePolicy::kAutomatic;
        }
        config_.srdos = setups_;
        config_.objects = objects_;
        config_.object_count = 2U;
        config_.srdo_count = srdo_count;
        config_.node_id = 1U;
        config_.granularity_bits = 8U;
        config_.map_entries = 2U * kEntries; // More than there is room for.
        config_.normal_port = CanPortId::kFirst;
        config_.inverse_port = CanPortId::kFirst;
        config_.cycle_us = 1000U;
        config_.acknowledge_window_us = 100000U;
    }

    void Store(SlotIndex slot, ConfigField field, std::uint32_t value, std::uint8_t sub = 0U)
    {
        channel_.Store(ConfigItem{ConfigAddress{slot, field, sub}, value});
    }

    std::uint32_t Load(SlotIndex slot, ConfigField field, std::uint8_t sub = 0U)
    {
        return channel_.Load(ConfigAddress{slot, field, sub}).value;
    }

    /// @brief Slot 0 in this direction, the others off, and OPERATIONAL.
    void Start(std::uint8_t direction)
    {
        const MapAccess access = (direction == 1U) ? MapAccess::kProducer : MapAccess::kConsumer;
        objects_[0U] = MappableObject{0x6000U, 1U, 8U, access, &places_[0U]};
        objects_[1U] = MappableObject{0x6001U, 1U, 8U, access, &places_[1U]};
        channel_.Restart(config_);
        Store(0U, ConfigField::kSct, 50U);
        Store(0U, ConfigField::kCobId1, 0x101U);
        Store(0U, ConfigField::kCobId2, 0x102U);
        Store(0U, ConfigField::kMapEntry, 0x60000108U, 1U);
        Store(0U, ConfigField::kMapEntry, 0x60010108U, 2U);
        Store(0U, ConfigField::kMapCount, 2U);
        Store(0U, ConfigField::kDirection, direction);
        Store(0U, ConfigField::kSignature, channel_.Validate(0U).signature);
        EXPECT_EQ(channel_.Validate(0U).fault, ConfigFault::kNone);
        Store(0U, ConfigField::kConfigurationValid, kConfigurationValidValue);
        static_cast<void>(Cycle(0U));
    }

    CycleOutcome Cycle(SrdoMask request)
    {
        now_us_ += 1000U;
        return channel_.OnCycle(CycleInput{Instant{now_us_}, kChallenge, kToken, 0U, request, 0U,
                                           NmtState::kOperational, QueueState::kIntact});
    }

    void Frame(std::uint32_t identifier, std::uint8_t data)
    {
        channel_.OnFrame(CanFrame{identifier, FrameKind::kData, CanPortId::kFirst, 1U, {data}}, Instant{now_us_});
    }

    Confirmation Confirm(const CanFrame& frame)
    {
        return channel_.OnConfirm(frame, Instant{now_us_});
    }

    channel_b::StorageFor<kSlots, kEntries>& Memory()
    {
        return storage_;
    }

    channel_b::Channel& Voice()
    {
        return channel_;
    }

    /// Behind the last slot there is one more of these.
    channel_b::Stage stage[kSlots + 1U];
    std::uint8_t image[(kSlots + 1U) * std::size_t{channel_b::kImageBytes}];
    std::uint8_t device[channel_b::kDeviceBytes + 1U];

  private:
    channel_b::Storage Handle(std::uint8_t told_slots)
    {
        std::memset(&storage_, kPattern, sizeof(storage_));
        std::memset(stage, kPattern, sizeof(stage));
        std::memset(image, kPattern, sizeof(image));
        std::memset(device, kPattern, sizeof(device));
        channel_b::Storage handle = storage_.Handle();
        handle.pairs.stage = {stage};
        handle.settings.image = {image};
        handle.settings.device = {device};
        handle.room.slots = told_slots;
        return handle;
    }

    channel_b::StorageFor<kSlots, kEntries> storage_;
    std::uint8_t places_[2U]{};
    MappableObject objects_[2U]{};
    SrdoSetup setups_[kSlots]{};
    DeviceConfig config_{};
    channel_b::Channel channel_;
    std::uint32_t now_us_{0U};
};

template <typename T> void ExpectUntouched(const T* first, std::size_t count, const char* column)
{
    std::vector<std::uint8_t> bytes(count * sizeof(T));
    std::memcpy(bytes.data(), first, bytes.size());
    EXPECT_EQ(bytes, std::vector<std::uint8_t>(bytes.size(), kPattern)) << column;
}

/// What the fourth of four slots has, of a channel that knows three.
void ExpectFourthUntouched(Device<4U, 4U>& of)
{
    const channel_b::StorageFor<4U, 4U>& memory = of.Memory();
    ExpectUntouched(&memory.data[3U], 1U, "data");
    ExpectUntouched(&memory.pending[3U], 1U, "pending");
    ExpectUntouched(&memory.mapped[3U], 1U, "mapped");
    ExpectUntouched(&memory.fields[3U], 1U, "fields");
    ExpectUntouched(&memory.entries[12U], 4U, "entries");
    ExpectUntouched(&memory.places[12U], 4U, "places");
    ExpectUntouched(&memory.left[3U], 1U, "left");
    ExpectUntouched(&memory.limit[3U], 1U, "limit");
    ExpectUntouched(&memory.ordinal[3U], 1U, "ordinal");
    ExpectUntouched(&memory.causes[3U], 1U, "causes");
    ExpectUntouched(&memory.signals[3U], 1U, "signals");
    ExpectUntouched(&memory.error_count[3U], 1U, "error_count");
    ExpectUntouched(&memory.length_bytes[3U], 1U, "length_bytes");
    ExpectUntouched(&memory.first_cause[3U], 1U, "first_cause");
    ExpectUntouched(&memory.held[3U], 1U, "held");
    ExpectUntouched(&memory.granted[3U], 1U, "granted");
    ExpectUntouched(&memory.edge[3U], 1U, "edge");
    ExpectUntouched(&memory.valid[3U], 1U, "valid");
    ExpectUntouched(&memory.resolved[3U], 1U, "resolved");
    ExpectUntouched(&memory.policy[3U], 1U, "policy");
    ExpectUntouched(&memory.form[3U], 1U, "form");
    ExpectUntouched(&memory.detection[3U], 1U, "detection");
    ExpectUntouched(&of.stage[3U], 2U, "stage");
    ExpectUntouched(&of.image[3U * 16U], 32U, "image");
    ExpectUntouched(&of.device[2U], 1U, "device");
}

TEST(ChannelBStorage, NoColumnIsWrittenBehindItsLastSlot)
{
    Verifies(req::SRS_KRN_020);
    // Given columns of four slots and a device of four, when the channel is told of three
    const auto device = std::make_unique<Device<4U, 4U>>(std::uint8_t{3U}, std::uint8_t{4U});
    device->Start(2U);
    device->Frame(0x101U, 0x5AU);
    device->Frame(0x102U, 0xA5U);
    EXPECT_EQ(device->Cycle(0U).released, 1U);
    // and somebody stores into the fourth
    for (std::uint8_t sub = 1U; sub <= 4U; ++sub)
    {
        device->Store(3U, ConfigField::kMapEntry, 0x60000108U, sub);
        EXPECT_EQ(device->Load(3U, ConfigField::kMapEntry, sub), 0U);
    }
    device->Store(3U, ConfigField::kDirection, 2U);
    device->Store(3U, ConfigField::kSct, 50U);
    EXPECT_EQ(device->Load(3U, ConfigField::kDirection), 0U);
    EXPECT_EQ(device->Load(3U, ConfigField::kSct), 0U);
    // then nothing that belongs to it changes
    ExpectFourthUntouched(*device);
}

TEST(ChannelBStorage, OfTheDeviceIsWrittenWhollyByRestart)
{
    Verifies(req::SRS_CFG_002);
    // Given storage that is filled with a pattern, when the channel restarts
    channel_b::StorageFor<1U, 2U> storage{};
    std::memset(&storage, kPattern, sizeof(storage));
    channel_b::Channel channel{storage.Handle()};
    const SrdoSetup setup{};
    DeviceConfig config{};
    config.srdos = &setup;
    config.srdo_count = 1U;
    config.node_id = 1U;
    channel.Restart(config);
    // then 1300h and 13FEh are 0, and there is no byte beside them
    const std::vector<std::uint8_t> device(std::begin(storage.device), std::end(storage.device));
    EXPECT_EQ(device, (std::vector<std::uint8_t>{0U, 0U}));
}

TEST(ChannelBStorage, MapEntriesAreThoseThatThereIsRoomFor)
{
    Verifies(req::SRS_KRN_020);
    Verifies(req::SRS_CFG_003);
    // Given room for four entries and a device of eight, when the fifth of slot 0 is stored
    const auto device = std::make_unique<Device<4U, 4U>>(std::uint8_t{4U}, std::uint8_t{4U});
    device->Start(2U);
    device->Store(0U, ConfigField::kMapEntry, 0x12345678U, 4U);
    device->Store(0U, ConfigField::kMapEntry, 0x12345678U, 5U);
    // then there is none, and the first of slot 1 stays
    EXPECT_EQ(device->Load(0U, ConfigField::kMapEntry, 4U), 0x12345678U);
    EXPECT_EQ(device->Load(0U, ConfigField::kMapEntry, 5U), 0U);
    EXPECT_EQ(device->Load(1U, ConfigField::kMapEntry, 1U), 0U);
}

TEST(ChannelBStorage, FrameLedBehindTheLastSlotIsNotTaken)
{
    Verifies(req::SRS_CONS_024);
    // Given 64 SRDOs with a released consumer in slot 0, when a bit of the look-up flips so that it tells slot 64
    const auto device = std::make_unique<Device<64U, 2U>>(std::uint8_t{64U}, std::uint8_t{64U});
    device->Start(2U);
    device->Frame(0x101U, 0x5AU);
    device->Frame(0x102U, 0xA5U);
    ASSERT_EQ(device->Cycle(0U).released, 1U);
    ASSERT_EQ(device->Memory().slot_of[0U], 0U);
    device->Memory().slot_of[0U] = 64U;
    device->Frame(0x101U, 0x5AU);
    // then no slot takes the frame, slot 0 neither, which has the bit of the 64th in a mask
    EXPECT_EQ(device->Voice().View(0U).state, SrdoState::kReleased);
    EXPECT_EQ(device->Voice().View(0U).error_count, 0U);
    const CycleOutcome outcome = device->Cycle(0U);
    EXPECT_EQ(outcome.released, 1U);
    EXPECT_EQ(outcome.signalled, 0U);
}

TEST(ChannelBStorage, ConfirmationLedBehindTheLastSlotConfirmsNothing)
{
    Verifies(req::SRS_PROD_007);
    Verifies(req::SRS_CONS_024);
    // Given a producer in slot 0 of 64 that awaits its normal frame, and memory behind the last slot that looks like it
    const auto device = std::make_unique<Device<64U, 2U>>(std::uint8_t{64U}, std::uint8_t{64U});
    device->Start(1U);
    ASSERT_EQ(device->Cycle(1U).due, 1U);
    const PreparedPair pair = device->Voice().Prepare(0U);
    ASSERT_EQ(pair.status, PrepareStatus::kReady);
    std::memcpy(&device->image[64U * 16U], &device->image[0U], 16U);
    device->stage[64U] = channel_b::Stage::kNormal;
    // when a bit of the look-up flips so that it tells slot 64
    device->Memory().slot_of[0U] = 64U;
    EXPECT_EQ(device->Confirm(pair.normal).step, ConfirmStep::kNone);
    // then nothing behind the last slot was awaited
    EXPECT_EQ(device->stage[64U], channel_b::Stage::kNormal);
    EXPECT_EQ(device->Cycle(0U).signalled, 0U);
}

} // namespace
} // namespace counterpoint
