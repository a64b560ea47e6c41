// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_CHANNEL_A_DEVICE_HPP
#define TESTS_CHANNEL_A_DEVICE_HPP

#include "channel_a/channel.hpp"
#include "channel_a/storage.hpp"

#include <cstddef>
#include <cstdint>

/// A small device for channel A alone: consumer (slot 0, 111h and 112h), producer (slot 1, 101h and 102h). The channel
/// is driven by the contract only.
namespace counterpoint::channel_a_test
{

constexpr SlotIndex kConsumerSlot = 0U;
constexpr SlotIndex kProducerSlot = 1U;
constexpr std::uint8_t kSlotCount = 2U;
constexpr std::uint32_t kCycleUs = 1000U;
constexpr std::uint32_t kSctUs = 50000U;
constexpr std::uint32_t kSrvtUs = 20000U;
constexpr SrdoMask kConsumerBit = 1U;
constexpr SrdoMask kProducerBit = 2U;

/// Entries of two objects of four bytes, normal and inverse one after the other.
constexpr std::uint32_t kConsumed[4] = {0x22000120U, 0x22010120U, 0x22000220U, 0x22010220U};
constexpr std::uint32_t kSent[4] = {0x22100120U, 0x22110120U, 0x22100220U, 0x22110220U};

struct Device
{
    explicit Device(const channel_a::Storage& storage) : channel{storage}
    {
        config.srdos = setups;
        config.objects = objects;
        config.object_count = kObjectCount;
        config.srdo_count = kSlotCount;
        config.node_id = 1U;
        config.granularity_bits = 1U;
        config.map_entries = 16U;
        config.normal_port = CanPortId::kFirst;
        config.inverse_port = CanPortId::kFirst;
        config.cycle_us = kCycleUs;
        config.cycle_tolerance_us = 0xF0000000U;
        config.acknowledge_window_us = 100000U;
    }

    void Store(SlotIndex slot, ConfigField field, std::uint32_t value, std::uint8_t sub = 0U)
    {
        channel.Store(ConfigItem{ConfigAddress{slot, field, sub}, value});
    }

    void Map(SlotIndex slot, const std::uint32_t* entries, std::uint8_t count)
    {
        Store(slot, ConfigField::kMapCount, count);
        for (std::uint8_t entry = 0U; entry < count; ++entry)
        {
            Store(slot, ConfigField::kMapEntry, entries[entry], static_cast<std::uint8_t>(entry + 1U));
        }
    }

    /// @brief Signs what is stored and validates it.
    CheckResult Sign(SlotIndex slot)
    {
        Store(slot, ConfigField::kSignature, channel.Validate(slot).signature);
        return channel.Validate(slot);
    }

    /// @brief Power-on and both SRDOs with two objects of four bytes.
    void Start()
    {
        channel.Restart(config);
        Store(kNoSlot, ConfigField::kConfigurationValid, 0xA5U);
        Configure(kConsumerSlot, kDirectionConsumer, 0x111U, kConsumed);
        Configure(kProducerSlot, kDirectionProducer, 0x101U, kSent);
    }

    void Configure(SlotIndex slot, std::uint8_t direction, std::uint32_t identifier, const std::uint32_t* entries)
    {
        Store(slot, ConfigField::kDirection, direction);
        Store(slot, ConfigField::kSct, 50U);
        Store(slot, ConfigField::kSrvt, 20U);
        Store(slot, ConfigField::kCobId1, identifier);
        Store(slot, ConfigField::kCobId2, identifier + 1U);
        Map(slot, entries, 4U);
        static_cast<void>(Sign(slot));
    }

    CycleOutcome Cycle(std::uint32_t elapsed_us = kCycleUs)
    {
        clock_us += elapsed_us;
        CycleInput input{};
        input.now = Instant{clock_us};
        input.challenge = 0x01020304U;
        input.guard_token = 0x020304'01U ^ 0xA5A5A5A5U;
        input.acknowledge = acknowledge;
        input.request = request;
        input.stand = stand;
        input.nmt = nmt;
        input.queue = QueueState::kIntact;
        return channel.OnCycle(input);
    }

    void Frame(std::uint32_t identifier, std::uint8_t length, std::uint8_t first, bool is_inverse = false)
    {
        channel.OnFrame(FrameOf(identifier, length, first, is_inverse), Instant{clock_us});
    }

    /// @brief Bytes `first`, `first` + 1, and so on.
    static CanFrame FrameOf(std::uint32_t identifier, std::uint8_t length, std::uint8_t first, bool is_inverse)
    {
        CanFrame frame{};
        frame.identifier = identifier;
        frame.kind = FrameKind::kData;
        frame.port = CanPortId::kFirst;
        frame.length_bytes = length;
        for (std::uint8_t place = 0U; place < length; ++place)
        {
            frame.data[place] = static_cast<std::uint8_t>((first + place) ^ (is_inverse ? 0xFFU : 0U));
        }
        return frame;
    }

    /// @brief A valid pair for the consumer.
    void Pair(std::uint8_t length, std::uint8_t first)
    {
        Frame(0x111U, length, first);
        Frame(0x112U, length, first, true);
    }

    /// @brief The held pair is agreed and matched.
    void Commit()
    {
        static_cast<void>(channel.Commit(Agreement{kConsumerBit, kConsumerBit}, 0U));
    }

    static constexpr std::uint16_t kObjectCount = 14U;
    static constexpr std::size_t kWordBytes = 4U;
    std::uint8_t words[8][kWordBytes]{}; ///< 2200h, 2201h, 2210h and 2211h, two each.
    std::uint8_t bits[6][2]{};           ///< 2220h, 2221h: one bit, nine bits; 2230h, 2231h: nine bits to send.
    MappableObject objects[kObjectCount] = {
        {0x2200U, 1U, 32U, MapAccess::kConsumer, words[0]}, {0x2200U, 2U, 32U, MapAccess::kConsumer, words[1]},
        {0x2201U, 1U, 32U, MapAccess::kConsumer, words[2]}, {0x2201U, 2U, 32U, MapAccess::kConsumer, words[3]},
        {0x2210U, 1U, 32U, MapAccess::kProducer, words[4]}, {0x2210U, 2U, 32U, MapAccess::kProducer, words[5]},
        {0x2211U, 1U, 32U, MapAccess::kProducer, words[6]}, {0x2211U, 2U, 32U, MapAccess::kProducer, words[7]},
        {0x2220U, 1U, 1U, MapAccess::kConsumer, bits[0]},   {0x2220U, 2U, 9U, MapAccess::kConsumer, bits[1]},
        {0x2221U, 1U, 1U, MapAccess::kConsumer, bits[2]},   {0x2221U, 2U, 9U, MapAccess::kConsumer, bits[3]},
        {0x2230U, 1U, 9U, MapAccess::kProducer, bits[4]},   {0x2231U, 1U, 9U, MapAccess::kProducer, bits[5]},
    };
    SrdoSetup setups[kSlotCount] = {
        {1U, ReleasePolicy::kAutomatic, ProducerForm::kApplicationSends, Payload{}, SrvtDetection::kEarly, StaticMap{}},
        {2U, ReleasePolicy::kAutomatic, ProducerForm::kApplicationSends, Payload{}, SrvtDetection::kEarly, StaticMap{}},
    };
    DeviceConfig config{};
    channel_a::Channel channel;
    NmtState nmt{NmtState::kOperational};
    SrdoMask acknowledge{0U};
    SrdoMask request{0U};
    SrdoMask stand{0U};
    std::uint32_t clock_us{0U};
};

/// @brief A consumer that is released and committed, 2 ms after 0.
inline void Release(Device& device)
{
    device.clock_us = 0U;
    device.nmt = NmtState::kOperational;
    device.Start();
    static_cast<void>(device.Cycle());
    device.Pair(8U, 0x11U);
    static_cast<void>(device.Cycle());
    device.Commit();
}

/// The device with storage of exactly its size, which lies between bytes that nobody may write.
struct FencedDevice
{
    static constexpr std::uint8_t kCanary = 0xC3U;

    FencedDevice() : device{fence.storage.Handle()}
    {
        for (std::size_t place = 0U; place < sizeof(fence.before); ++place)
        {
            fence.before[place] = kCanary;
            fence.behind[place] = kCanary;
        }
    }

    [[nodiscard]] bool IsIntact() const
    {
        bool is_intact = true;
        for (std::size_t place = 0U; place < sizeof(fence.before); ++place)
        {
            is_intact = is_intact && (fence.before[place] == kCanary) && (fence.behind[place] == kCanary);
        }
        return is_intact;
    }

    std::uint8_t* Bytes()
    {
        return reinterpret_cast<std::uint8_t*>(&fence.storage);
    }

    static constexpr std::size_t kByteCount = sizeof(channel_a::StorageFor<kSlotCount>);

    struct Fence
    {
        std::uint8_t before[64];
        channel_a::StorageFor<kSlotCount> storage;
        std::uint8_t behind[64];
    };
    Fence fence{};
    Device device;
};

} // namespace counterpoint::channel_a_test

#endif
