// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_CHANNEL_B_RIG_HPP
#define TESTS_CHANNEL_B_RIG_HPP

#include "channel_b/channel.hpp"
#include "channel_b/storage.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

/// Channel B alone on a device of three SRDOs, in storage of exactly its size between two rows of canaries. It knows
/// the storage as bytes only.
namespace counterpoint
{

constexpr std::uint8_t kRigSlots = 3U;
constexpr std::uint8_t kRigEntries = 4U;
constexpr std::uint8_t kCanary = 0xC5U;
constexpr std::size_t kCanaryBytes = 64U;
constexpr std::uint8_t kUntouched = 0x66U;

/// Objects 6000h and 6001h (consumer, two of 32 bits), 6100h and 6101h (producer, two of 32 bits), 6200h and 6201h
/// (consumer, one of 8 bits), 6300h and 6301h (consumer, one of 32 bits that nobody maps).
constexpr std::uint32_t kRigMaps[kRigSlots][kRigEntries] = {
    {0x60000120U, 0x60010120U, 0x60000220U, 0x60010220U},
    {0x61000120U, 0x61010120U, 0x61000220U, 0x61010220U},
    {0x62000108U, 0x62010108U, 0U, 0U},
};
constexpr std::uint8_t kRigCounts[kRigSlots] = {4U, 4U, 2U};
constexpr std::uint8_t kRigDirections[kRigSlots] = {2U, 1U, 2U};

class Rig
{
  public:
    explicit Rig(ReleasePolicy policy = ReleasePolicy::kInterlock)
    {
        std::memset(room_.before, kCanary, kCanaryBytes);
        std::memset(room_.after, kCanary, kCanaryBytes);
        Fill(0U);
        std::uint16_t count = 0U;
        static constexpr std::uint16_t kIndices[] = {0x6000U, 0x6001U, 0x6100U, 0x6101U,
                                                     0x6200U, 0x6201U, 0x6300U, 0x6301U};
        for (const std::uint16_t index : kIndices)
        {
            const std::uint8_t last = (index < 0x6200U) ? 2U : 1U;
            for (std::uint8_t sub = 1U; sub <= last; ++sub)
            {
                const bool is_sent = (index & 0xFF00U) == 0x6100U;
                const std::uint8_t bits = ((index & 0xFF00U) == 0x6200U) ? 8U : 32U;
                objects_[count] = MappableObject{index, sub, bits,
                                                 is_sent ? MapAccess::kProducer : MapAccess::kConsumer, places_[count]};
                ++count;
            }
        }
        for (std::uint8_t slot = 0U; slot < kRigSlots; ++slot)
        {
            setups_[slot].number = static_cast<std::uint8_t>(slot + 1U);
            setups_[slot].policy = policy;
        }
        config_.srdos = setups_;
        config_.objects = objects_;
        config_.object_count = count;
        config_.srdo_count = kRigSlots;
        config_.node_id = 1U;
        config_.granularity_bits = 8U;
        config_.map_entries = kRigEntries;
        config_.normal_port = CanPortId::kFirst;
        config_.inverse_port = CanPortId::kFirst;
        config_.cycle_us = 1000U;
        config_.cycle_tolerance_us = 500U;
        config_.acknowledge_window_us = 100000U;
    }

    /// @brief Power-on, the whole configuration and one call in PRE-OPERATIONAL, then OPERATIONAL.
    void Start()
    {
        std::memset(places_, kUntouched, sizeof(places_));
        channel_.Restart(config_);
        clock_us_ = 0xFFFF0000U;
        acknowledge_ = 0U;
        nmt_ = NmtState::kPreOperational;
        for (SlotIndex slot = 0U; slot < kRigSlots; ++slot)
        {
            Store(slot, ConfigField::kSct, 50U);
            Store(slot, ConfigField::kSrvt, 20U);
            Store(slot, ConfigField::kCobId1, 0x101U + (2U * slot));
            Store(slot, ConfigField::kCobId2, 0x102U + (2U * slot));
            for (std::uint8_t sub = 1U; sub <= kRigCounts[slot]; ++sub)
            {
                Store(slot, ConfigField::kMapEntry, kRigMaps[slot][sub - 1U], sub);
            }
            Store(slot, ConfigField::kMapCount, kRigCounts[slot]);
            Store(slot, ConfigField::kDirection, kRigDirections[slot]);
            Store(slot, ConfigField::kSignature, channel_.Validate(slot).signature);
            static_cast<void>(channel_.Validate(slot));
        }
        Store(0U, ConfigField::kConfigurationValid, kConfigurationValidValue);
        static_cast<void>(Cycle());
    }

    void Store(SlotIndex slot, ConfigField field, std::uint32_t value, std::uint8_t sub = 0U)
    {
        channel_.Store(ConfigItem{ConfigAddress{slot, field, sub}, value});
    }

    CycleOutcome Cycle(std::uint32_t elapsed_us = 1000U)
    {
        clock_us_ += elapsed_us;
        const CycleInput input{
            Instant{clock_us_}, 0x01020304U, 0x02030401U ^ 0xA5A5A5A5U, acknowledge_, request_, stand_, nmt_,
            QueueState::kIntact};
        request_ = 0U;
        stand_ = 0U;
        return channel_.OnCycle(input);
    }

    CycleOutcome Enter()
    {
        nmt_ = NmtState::kOperational;
        return Cycle();
    }

    CycleOutcome Leave()
    {
        nmt_ = NmtState::kPreOperational;
        return Cycle();
    }

    static CanFrame Frame(std::uint32_t identifier, std::uint64_t data, std::uint8_t length)
    {
        CanFrame frame{identifier, FrameKind::kData, CanPortId::kFirst, length, {}};
        for (std::uint8_t at = 0U; at < length; ++at)
        {
            frame.data[at] = static_cast<std::uint8_t>((data >> (8U * at)) & 0xFFU);
        }
        return frame;
    }

    /// @brief The first half of a pair.
    void Normal(SlotIndex slot, std::uint64_t data)
    {
        clock_us_ += 10U;
        channel_.OnFrame(Frame(0x101U + (2U * slot), data, Length(slot)), Instant{clock_us_});
    }

    void Inverse(SlotIndex slot, std::uint64_t data)
    {
        clock_us_ += 10U;
        channel_.OnFrame(Frame(0x102U + (2U * slot), ~data, Length(slot)), Instant{clock_us_});
    }

    void Pair(SlotIndex slot, std::uint64_t data)
    {
        Normal(slot, data);
        Inverse(slot, data);
    }

    /// @brief What the acknowledge inputs read from now on.
    void Read(SrdoMask inputs)
    {
        acknowledge_ = inputs;
    }

    /// @brief An acknowledge edge for all slots in the last of the calls that this makes.
    CycleOutcome Acknowledged()
    {
        acknowledge_ = 0U;
        static_cast<void>(Cycle());
        static_cast<void>(Cycle());
        acknowledge_ = 7U;
        static_cast<void>(Cycle());
        return Cycle();
    }

    void Confirm(const CanFrame& frame)
    {
        clock_us_ += 10U;
        static_cast<void>(channel_.OnConfirm(frame, Instant{clock_us_}));
    }

    void Request()
    {
        request_ = 2U;
    }

    /// @brief The producer's phase stood until the next call.
    void Stand()
    {
        stand_ = 2U;
    }

    void Fill(std::uint8_t value)
    {
        std::memset(Bytes(), value, sizeof(room_.storage));
    }

    std::uint8_t* Bytes()
    {
        return reinterpret_cast<std::uint8_t*>(&room_.storage);
    }

    static constexpr std::size_t kByteCount = sizeof(channel_b::StorageFor<kRigSlots, kRigEntries>);

    [[nodiscard]] bool AreCanariesAlive() const
    {
        bool is_alive = true;
        for (std::size_t at = 0U; at < kCanaryBytes; ++at)
        {
            is_alive = is_alive && (room_.before[at] == kCanary) && (room_.after[at] == kCanary);
        }
        return is_alive;
    }

    /// @brief What object number `object` of the device holds.
    [[nodiscard]] std::uint32_t Value(std::size_t object) const
    {
        std::uint32_t value = 0U;
        for (std::uint32_t at = 0U; at < 4U; ++at)
        {
            value |= static_cast<std::uint32_t>(places_[object][at]) << (8U * at);
        }
        return value;
    }

    void Put(std::size_t object, std::uint32_t value)
    {
        for (std::uint32_t at = 0U; at < 4U; ++at)
        {
            places_[object][at] = static_cast<std::uint8_t>((value >> (8U * at)) & 0xFFU);
        }
    }

    /// @brief The object lies where the other one does: what is written there last is what both hold.
    void Share(std::size_t object, std::size_t other)
    {
        objects_[object].place = places_[other];
    }

    /// @brief Of the two objects that nobody maps.
    void SetFree(std::uint8_t bits, MapAccess access)
    {
        for (const std::size_t object : {10U, 11U})
        {
            objects_[object].length_bits = bits;
            objects_[object].access = access;
        }
    }

    /// @brief Another mapping, signed; what Validate finds.
    ConfigFault Map(SlotIndex slot, const std::vector<std::uint32_t>& entries)
    {
        for (std::size_t at = 0U; at < entries.size(); ++at)
        {
            Store(slot, ConfigField::kMapEntry, entries[at], static_cast<std::uint8_t>(at + 1U));
        }
        Store(slot, ConfigField::kMapCount, static_cast<std::uint32_t>(entries.size()));
        return Validated(slot);
    }

    /// @brief What Validate finds once the SRDO is signed.
    ConfigFault Validated(SlotIndex slot)
    {
        Store(slot, ConfigField::kSignature, channel_.Validate(slot).signature);
        return channel_.Validate(slot).fault;
    }

    [[nodiscard]] StaticFields FreeFields()
    {
        return StaticFields{places_[10U], places_[11U]};
    }

    Channel& Voice()
    {
        return channel_;
    }

    /// @brief Of the last call.
    [[nodiscard]] std::uint32_t Now() const
    {
        return clock_us_;
    }

    DeviceConfig& Config()
    {
        return config_;
    }

    SrdoSetup& Setup(SlotIndex slot)
    {
        return setups_[slot];
    }

  private:
    static std::uint8_t Length(SlotIndex slot)
    {
        return (slot == 2U) ? 1U : 8U;
    }

    /// Canaries directly before and behind.
    struct Room
    {
        std::uint8_t before[kCanaryBytes];
        channel_b::StorageFor<kRigSlots, kRigEntries> storage;
        std::uint8_t after[kCanaryBytes];
    };

    Room room_{};
    std::uint8_t places_[12U][4U]{};
    MappableObject objects_[12U]{};
    SrdoSetup setups_[kRigSlots]{};
    DeviceConfig config_{};
    channel_b::Channel channel_{room_.storage.Handle()};
    std::uint32_t clock_us_{0U};
    SrdoMask acknowledge_{0U};
    SrdoMask request_{0U};
    SrdoMask stand_{0U};
    NmtState nmt_{NmtState::kPreOperational};
};

} // namespace counterpoint

#endif
