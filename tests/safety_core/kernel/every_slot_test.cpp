// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Devices of 1, 2, 33 and 64 consumers on real channels, whose storage has room for exactly so many, with something
// behind and before it that nobody may write to; and the permits of slots in every quarter of a mask.
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <utility>

namespace counterpoint
{
namespace
{

/// Asks always the same, and keeps the answer.
class FixedOutput final : public hal::SafetyOutput
{
  public:
    std::uint32_t Challenge() noexcept override
    {
        return 0x89ABCDEFU;
    }
    void Drive(const hal::PermitSet& permits) noexcept override
    {
        last = permits;
    }
    hal::PermitSet last{};
};

class QuietWatchdog final : public hal::Watchdog
{
  public:
    hal::WatchdogQuestion Question() noexcept override
    {
        return hal::WatchdogQuestion{1U};
    }
    void Answer(const hal::WatchdogAnswer& /*answer*/) noexcept override
    {
    }
};

/// An item between two fences.
template <typename Item> struct Fenced
{
    static constexpr std::uint8_t kFence = 0xC5U;

    std::array<std::uint8_t, 64> before{};
    Item item{};
    std::array<std::uint8_t, 64> behind{};

    Fenced()
    {
        before.fill(kFence);
        behind.fill(kFence);
    }
    [[nodiscard]] bool IsWhole() const
    {
        const auto is_fence = [](const std::uint8_t byte) { return byte == kFence; };
        return std::all_of(before.begin(), before.end(), is_fence) &&
               std::all_of(behind.begin(), behind.end(), is_fence);
    }
};

/// Slot n is the consumer SRDO n + 1 with the identifiers 101h + 2n and the next one, one byte each side (2200h + n and
/// 2300h + n, sub 1), SCT 50 ms, SRVT 20 ms, automatic.
template <std::uint8_t kCount> class Device
{
  public:
    Device()
    {
        for (std::uint8_t slot = 0U; slot < kCount; ++slot)
        {
            setups[slot].number = static_cast<std::uint8_t>(slot + 1U);
            setups[slot].policy = ReleasePolicy::kAutomatic;
            objects[slot] = MappableObject{static_cast<std::uint16_t>(0x2200U + slot), 1U, 8U, MapAccess::kConsumer,
                                           &normal.item[slot]};
            objects[kCount + slot] = MappableObject{static_cast<std::uint16_t>(0x2300U + slot), 1U, 8U,
                                                    MapAccess::kConsumer, &inverse.item[slot]};
        }
        config.srdos = setups.data();
        config.srdo_count = kCount;
        config.objects = objects.data();
        config.object_count = 2U * kCount;
        config.node_id = 127U;
        config.granularity_bits = 8U;
        config.map_entries = 16U;
        config.normal_port = CanPortId::kFirst;
        config.inverse_port = CanPortId::kFirst;
        config.cycle_us = 1000U;
        config.cycle_tolerance_us = 500U;
        config.discrepancy_us = 5000U;
        config.diagnostic_interval_us = 200000U;
        config.test_interval_us = 45000U;
        config.clock_tolerance_us = 200U;
        config.clock_interval_us = 100000U;
    }

    AbortCode Write(const std::uint32_t index, const std::uint32_t sub, const std::uint32_t value,
                    const std::uint8_t size)
    {
        ObjectData data{};
        data.size_bytes = size;
        for (std::uint32_t byte = 0U; byte < size; ++byte)
        {
            data.bytes[byte] = static_cast<std::uint8_t>(value >> (8U * byte));
        }
        return kernel.WriteObject(ObjectAddress{static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(sub)},
                                  data);
    }
    void Operate()
    {
        ASSERT_EQ(kernel.Start(config, FlowCallback::kOn), StartResult::kStarted);
        for (std::uint32_t slot = 0U; slot < kCount; ++slot)
        {
            ASSERT_EQ(Write(0x1381U + slot, 1U, 0x22000108U + (slot << 16U), 4U), AbortCode::kNone);
            ASSERT_EQ(Write(0x1381U + slot, 2U, 0x23000108U + (slot << 16U), 4U), AbortCode::kNone);
            ASSERT_EQ(Write(0x1381U + slot, 0U, 2U, 1U), AbortCode::kNone);
            ASSERT_EQ(Write(0x1301U + slot, 2U, 50U, 2U), AbortCode::kNone);
            ASSERT_EQ(Write(0x1301U + slot, 5U, 0x101U + (2U * slot), 4U), AbortCode::kNone);
            ASSERT_EQ(Write(0x1301U + slot, 6U, 0x102U + (2U * slot), 4U), AbortCode::kNone);
            ASSERT_EQ(Write(0x1301U + slot, 1U, 2U, 1U), AbortCode::kNone);
            const SignReply reply = kernel.Sign(CommunicationIndex{static_cast<std::uint16_t>(0x1301U + slot)});
            ASSERT_EQ(Write(0x13FFU, slot + 1U, reply.signature, 2U), AbortCode::kNone);
        }
        ASSERT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
        kernel.SetNmtState(NmtState::kOperational);
        Cycle();
    }
    void Cycle()
    {
        now_us += 1000U - (now_us % 1000U);
        kernel.Cycle(CycleCall{InstantPair{{now_us}, {now_us}}, 0U, 0U});
    }
    void Receive(const std::uint32_t identifier, const std::uint8_t byte)
    {
        ++now_us;
        const CanFrame frame{identifier, FrameKind::kData, CanPortId::kFirst, 1U, {byte}};
        kernel.OnFrame(StampedFrame{frame, InstantPair{{now_us}, {now_us}}});
    }
    void ReceivePair(const std::uint32_t slot)
    {
        Receive(0x101U + (2U * slot), static_cast<std::uint8_t>(0x80U + slot));
        Receive(0x102U + (2U * slot), static_cast<std::uint8_t>(0x7FU - slot));
    }
    [[nodiscard]] bool IsWhole() const
    {
        return storage_a.IsWhole() && storage_b.IsWhole() && normal.IsWhole() && inverse.IsWhole();
    }

    Fenced<std::array<std::uint8_t, kCount>> normal{};
    Fenced<std::array<std::uint8_t, kCount>> inverse{};
    std::array<MappableObject, 2U * std::size_t{kCount}> objects{};
    std::array<SrdoSetup, kCount> setups{};
    DeviceConfig config{};
    Fenced<channel_a::StorageFor<kCount>> storage_a{};
    Fenced<channel_b::StorageFor<kCount>> storage_b{};
    channel_a::Channel a{storage_a.item.Handle()};
    channel_b::Channel b{storage_b.item.Handle()};
    RecordingPorts ports{};
    FixedOutput output{};
    QuietWatchdog watchdog{};
    RecordingApplication application{};
    Kernel kernel{KernelParts{a, b, ports, output, watchdog, application}};
    std::uint32_t now_us{5000U};
};

template <std::uint8_t kCount> void LivesWithinItsStorage(const SrdoMask all)
{
    const std::unique_ptr<Device<kCount>> device = std::make_unique<Device<kCount>>();
    constexpr std::uint32_t kLast = kCount - 1U;
    device->Operate();
    for (std::uint32_t slot = 0U; slot < kCount; ++slot)
    {
        device->ReceivePair(slot);
    }
    device->ReceivePair(kCount); // Of no slot.
    device->Cycle();
    EXPECT_EQ(device->kernel.DeviceState().fault, DeviceFault::kNone);
    EXPECT_EQ(device->output.last.a.mask, all);
    EXPECT_EQ(device->output.last.b.mask, all);
    EXPECT_EQ(device->output.last.kernel.mask, all);
    EXPECT_EQ(device->normal.item[kLast], 0x80U + kLast);
    EXPECT_EQ(device->inverse.item[kLast], 0x7FU - kLast);
    EXPECT_EQ(device->normal.item[0], 0x80U);
    // A whole diagnostic interval, with a pair of the last slot that is wrong on the way
    device->Receive(0x101U + (2U * kLast), 0x01U);
    device->Receive(0x102U + (2U * kLast), 0x01U);
    for (std::uint32_t cycle = 0U; cycle < 201U; ++cycle)
    {
        for (std::uint32_t slot = 0U; slot < kLast; ++slot)
        {
            device->ReceivePair(slot);
        }
        device->Cycle();
        ASSERT_EQ(device->kernel.DeviceState().fault, DeviceFault::kNone);
    }
    EXPECT_EQ(device->output.last.kernel.mask, all ^ (SrdoMask{1U} << kLast));
    EXPECT_EQ(device->kernel.CheckConfiguration().result, Result::kSuccessful);
    EXPECT_EQ(device->kernel.Image().RestoreDefaults(), Result::kNmtError);
    device->kernel.SetNmtState(NmtState::kPreOperational);
    EXPECT_EQ(device->kernel.Image().RestoreDefaults(), Result::kSuccessful);
    device->Cycle();
    EXPECT_EQ(device->output.last.kernel.mask, 0U);
    device->kernel.Stop();
    EXPECT_TRUE(device->IsWhole());
}

TEST(EverySlot, DeviceOfOneConsumerStaysWithinItsStorage)
{
    Verifies(req::SRS_KRN_020);
    LivesWithinItsStorage<1U>(0x1U);
}

TEST(EverySlot, DeviceOfTwoConsumersStaysWithinItsStorage)
{
    Verifies(req::SRS_KRN_020);
    LivesWithinItsStorage<2U>(0x3U);
}

TEST(EverySlot, DeviceOfThirtyThreeConsumersStaysWithinItsStorage)
{
    Verifies(req::SRS_KRN_020);
    LivesWithinItsStorage<33U>(0x1FFFFFFFFU);
}

TEST(EverySlot, DeviceOfSixtyFourConsumersStaysWithinItsStorage)
{
    Verifies(req::SRS_KRN_001);
    Verifies(req::SRS_KRN_020);
    LivesWithinItsStorage<64U>(0xFFFFFFFFFFFFFFFFU);
}

// Given pairs of three consumers before one cycle, then its flow event counts three.
TEST(EverySlot, FlowEventCountsThePairsReleasedInOneCycle)
{
    Verifies(req::SRS_FLOW_340);
    Verifies(req::SRS_FLOW_004);
    const std::unique_ptr<Device<33U>> device = std::make_unique<Device<33U>>();
    device->Operate();
    for (const std::uint32_t slot : {0U, 16U, 32U})
    {
        device->ReceivePair(slot);
    }
    device->application.flow.clear();
    device->Cycle();
    ASSERT_FALSE(device->application.flow.empty());
    EXPECT_EQ(device->application.flow.front(), std::make_pair(FlowEvent::kSctChecked, std::uint16_t{33U}));
    EXPECT_EQ(device->application.flow.back(), std::make_pair(FlowEvent::kSrdoReceived, std::uint16_t{3U}));
}

// Given one released slot at a time, then the three permits are those of the slot: its mask, and the answers of channel
// A, channel B and kernel to challenge 89ABCDEFh.
TEST(EverySlot, PermitsOfEachQuarterOfTheMask)
{
    Verifies(req::SRS_KRN_005);
    struct Case
    {
        std::uint8_t slot;
        std::uint32_t a;
        std::uint32_t b;
        std::uint32_t kernel;
    };
    const std::unique_ptr<Device<64U>> device = std::make_unique<Device<64U>>();
    device->Operate();
    for (const Case& given :
         {Case{0U, 0xC2AFD2F0U, 0x4AAC1A90U, 0xA4C93230U}, Case{15U, 0xE150D93FU, 0xA9FBD019U, 0x393503F3U},
          Case{16U, 0x9E29593FU, 0x8F375019U, 0x905383F3U}, Case{31U, 0xA478593FU, 0x44C05019U, 0x621683F3U},
          Case{32U, 0xAAC7593FU, 0xFA495019U, 0x33D983F3U}, Case{47U, 0xA478593FU, 0x44C05019U, 0x621683F3U},
          Case{48U, 0x8640DF8EU, 0x3ED485A2U, 0x1F63D5B6U}, Case{63U, 0x679FD93FU, 0xDF84D019U, 0x8AF803F3U}})
    {
        device->ReceivePair(given.slot);
        device->Cycle();
        const hal::PermitSet permits = device->output.last;
        const SrdoMask mask = SrdoMask{1U} << given.slot;
        EXPECT_EQ(permits.a.mask, mask);
        EXPECT_EQ(permits.b.mask, mask);
        EXPECT_EQ(permits.kernel.mask, mask);
        EXPECT_EQ(permits.a.response, given.a) << static_cast<int>(given.slot);
        EXPECT_EQ(permits.b.response, given.b) << static_cast<int>(given.slot);
        EXPECT_EQ(permits.kernel.response, given.kernel) << static_cast<int>(given.slot);
        // Until its next pair is wrong
        device->Receive(0x102U + (2U * given.slot), 0U);
        device->Cycle();
        EXPECT_EQ(device->output.last.kernel.mask, 0U);
    }
}

} // namespace
} // namespace counterpoint
