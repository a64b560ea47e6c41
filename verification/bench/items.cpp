// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/bench/items.hpp"

#include "verification/bench/device.hpp"
#include "verification/bench/meter.hpp"

#include <new>

namespace counterpoint::bench
{
namespace
{

constexpr std::uint32_t kRepetitions = 640U;
constexpr std::uint8_t kCounts[] = {1U, 8U, 64U};

// One recheck and one comparator test in 1000 cycles (64 s for 64 SRDOs): an idle cycle is not the place to count them.
constexpr std::uint32_t kRareInterval = 64U * 1000U * kCycleUs;
// Under full load the device diagnoses itself completely once a second.
constexpr std::uint32_t kUsualInterval = 1000000U;

// 128 frames of 8 bytes with the greatest number of stuff bits take 17.3 ms at 1 Mbit/s.
constexpr std::uint32_t kRoundUs = 17300U;
constexpr std::uint32_t kLoadCycles = 1000U;

/// One device at a time in static storage: too large for a stack of a target.
alignas(Device) std::uint8_t storage[sizeof(Device)];

Device& NewDevice() noexcept
{
    return *new (storage) Device();
}

SrdoMask AllOf(const std::uint8_t count) noexcept
{
    return (count == kMaxSrdoCount) ? ~SrdoMask{0U} : ((SrdoMask{1U} << count) - 1U);
}

// What MeterBegin and MeterEnd count of themselves.
void MeasureNothing() noexcept
{
    MeterReset();
    for (std::uint32_t i = 0U; i < kRepetitions; ++i)
    {
        MeterBegin();
        MeterEnd();
    }
    MeterReport({"nothing", 0U, kRepetitions});
}

/// What the items are called with one mapping.
struct ItemNames
{
    MapShape shape;
    const char* idle;
    const char* pair;
    const char* check;
    const char* idle_producers;
    const char* send;
};

constexpr ItemNames kTwoWordNames{kTwoWords, "idle", "pair", "check", "idle_producers", "send"};
constexpr ItemNames kOtherNames[] = {
    {{1U, 8U}, "idle_1x8", "pair_1x8", "check_1x8", "idle_producers_1x8", "send_1x8"},
    {{1U, 32U}, "idle_1x32", "pair_1x32", "check_1x32", "idle_producers_1x32", "send_1x32"},
    {{4U, 16U}, "idle_4x16", "pair_4x16", "check_4x16", "idle_producers_4x16", "send_4x16"},
    {{8U, 8U}, "idle_8x8", "pair_8x8", "check_8x8", "idle_producers_8x8", "send_8x8"},
};

BenchResult MeasureConsumers(const std::uint8_t count, const ItemNames& names) noexcept
{
    Device& device = NewDevice();
    if (!device.Start({DeviceRole::kConsumers, count, kRareInterval, names.shape}))
    {
        return BenchResult::kNotStarted;
    }
    device.ReleaseAll();
    MeterReset();
    for (std::uint32_t i = 0U; i < kRepetitions; ++i)
    {
        device.MeasuredCycle();
    }
    MeterReport({names.idle, count, kRepetitions});
    if (device.Open() != AllOf(count))
    {
        return BenchResult::kNotReleased;
    }
    const std::uint32_t events = device.Events();
    MeterReset();
    for (std::uint32_t i = 0U; i < kRepetitions; ++i)
    {
        device.MeasuredPair(static_cast<SlotIndex>(i % count));
        device.MeasuredCycle();
    }
    MeterReport({names.pair, count, kRepetitions});
    if ((device.Events() - events) != kRepetitions)
    {
        return BenchResult::kNotReleased;
    }
    MeterReset();
    for (std::uint32_t i = 0U; i < kRepetitions; ++i)
    {
        device.MeasuredCheck(static_cast<SlotIndex>(i % count));
    }
    MeterReport({names.check, count, kRepetitions});
    return device.IsWell() ? BenchResult::kDone : BenchResult::kCheckFailed;
}

BenchResult MeasureProducers(const std::uint8_t count, const ItemNames& names) noexcept
{
    Device& device = NewDevice();
    if (!device.Start({DeviceRole::kProducers, count, kRareInterval, names.shape}))
    {
        return BenchResult::kNotStarted;
    }
    MeterReset();
    for (std::uint32_t i = 0U; i < kRepetitions; ++i)
    {
        device.MeasuredCycle();
    }
    MeterReport({names.idle_producers, count, kRepetitions});
    const std::uint32_t events = device.Events();
    MeterReset();
    for (std::uint32_t i = 0U; i < kRepetitions; ++i)
    {
        device.MeasuredSend(static_cast<SlotIndex>(i % count));
    }
    MeterReport({names.send, count, kRepetitions});
    if ((device.Events() - events) != kRepetitions)
    {
        return BenchResult::kNotSent;
    }
    return device.IsWell() ? BenchResult::kDone : BenchResult::kFaulted;
}

BenchResult Measure(const std::uint8_t count, const ItemNames& names) noexcept
{
    const BenchResult consumers = MeasureConsumers(count, names);
    return (consumers == BenchResult::kDone) ? MeasureProducers(count, names) : consumers;
}

} // namespace

BenchResult RunItems() noexcept
{
    MeasureNothing();
    BenchResult result = BenchResult::kDone;
    for (const std::uint8_t count : kCounts)
    {
        result = (result == BenchResult::kDone) ? Measure(count, kTwoWordNames) : result;
    }
    for (const ItemNames& names : kOtherNames)
    {
        result = (result == BenchResult::kDone) ? Measure(kMaxSrdoCount, names) : result;
    }
    return result;
}

BenchResult RunFullLoad() noexcept
{
    Device& device = NewDevice();
    if (!device.Start({DeviceRole::kConsumers, kMaxSrdoCount, kUsualInterval}))
    {
        return BenchResult::kNotStarted;
    }
    device.ReleaseAll();
    const std::uint32_t events = device.Events();
    std::uint32_t pairs = 0U;
    MeterReset();
    for (std::uint32_t cycle = 1U; cycle <= kLoadCycles; ++cycle)
    {
        const std::uint32_t arrived = (cycle * kCycleUs * kMaxSrdoCount) / kRoundUs;
        for (; pairs < arrived; ++pairs)
        {
            device.MeasuredPair(static_cast<SlotIndex>(pairs % kMaxSrdoCount));
        }
        device.MeasuredCycle();
    }
    MeterReport({"full_load", kMaxSrdoCount, pairs});
    if ((device.Events() - events) != pairs)
    {
        return BenchResult::kNotReleased;
    }
    return device.IsWell() ? BenchResult::kDone : BenchResult::kFaulted;
}

const char* NameOf(const BenchResult result) noexcept
{
    switch (result)
    {
    case BenchResult::kDone:
        return "done";
    case BenchResult::kNotStarted:
        return "a device refused its configuration";
    case BenchResult::kNotReleased:
        return "a pair was not released";
    case BenchResult::kNotSent:
        return "a pair was not sent";
    case BenchResult::kCheckFailed:
        return "a check did not hold";
    case BenchResult::kFaulted:
        return "a device met a fault";
    case BenchResult::kInvalid:
        break;
    }
    return "invalid";
}

} // namespace counterpoint::bench
