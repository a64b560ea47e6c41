// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/start_check.hpp"

#include "safety_core/comparator/comparator_self_test.hpp"
#include "safety_core/kernel/clock_supervisor.hpp"
#include "safety_core/kernel/limits.hpp"

namespace counterpoint
{
namespace
{

constexpr std::uint8_t kHighestNodeId = 127U;
constexpr std::uint16_t kMostObjects = 1024U;
constexpr std::uint32_t kShortestCycleUs = 100U;
constexpr std::uint32_t kLongestCycleUs = 1000000U;
constexpr std::uint32_t kLongestTimeUs = 0x3FFFFFFFU; // Differences of instants stay valid with room to spare.
constexpr std::uint32_t kGranularities = 1U | 8U | 16U | 32U | 64U;

// The values of options that are not 0.
constexpr std::uint8_t kAutomatic = static_cast<std::uint8_t>(ReleasePolicy::kAutomatic);
constexpr std::uint8_t kProvider = static_cast<std::uint8_t>(ProducerForm::kProviderCalled);
constexpr std::uint8_t kLate = static_cast<std::uint8_t>(SrvtDetection::kLate);
constexpr std::uint8_t kDummies = static_cast<std::uint8_t>(DummyMapping::kAllowed);
constexpr std::uint8_t kGaps = static_cast<std::uint8_t>(NumberGaps::kSearched);
constexpr std::uint8_t kGfc = static_cast<std::uint8_t>(GfcUse::kPresent);

// A guarantee that is missing has its result at the same place of the same order.
constexpr std::uint32_t kFirstMissing = static_cast<std::uint32_t>(hal::MissingGuarantee::kBusOrder);
constexpr std::uint32_t kFirstGuarantee = static_cast<std::uint32_t>(StartResult::kBusOrder);
static_assert(static_cast<std::uint32_t>(hal::MissingGuarantee::kConfirmations) - kFirstMissing ==
                  static_cast<std::uint32_t>(StartResult::kConfirmations) - kFirstGuarantee,
              "as many results as guarantees");

bool IsGranularity(const std::uint32_t bits) noexcept
{
    const bool is_one_bit = (bits & (bits - 1U)) == 0U;
    return is_one_bit && ((bits & kGranularities) != 0U);
}

bool IsPort(const CanPortId port) noexcept
{
    return (port == CanPortId::kFirst) || (port == CanPortId::kSecond);
}

// [SRS_KRN_572]
bool IsAccess(const MapAccess access) noexcept
{
    return (access == MapAccess::kNone) || (access == MapAccess::kProducer) || (access == MapAccess::kConsumer);
}

// The kernel's own range, 1300h to 13FFh. [SRS_KRN_573]
bool IsKernels(const MappableObject& object) noexcept
{
    constexpr std::uint32_t kArea = 0x13U;
    return (static_cast<std::uint32_t>(object.index) >> 8U) == kArea;
}

bool IsObject(const MappableObject& object) noexcept
{
    // 0 - 1 is the greatest value.
    const bool has_place = ((object.length_bits - 1U) < kMaxPayloadBits) && (object.place != nullptr);
    return has_place && IsAccess(object.access) && (!IsKernels(object));
}

// An entry of a mapping that names a data type is a dummy where dummies are allowed, never an object.
bool IsDummyIndex(const MappableObject& object) noexcept
{
    constexpr std::uint16_t kFirst = 0x0001U;
    constexpr std::uint16_t kLast = 0x0007U;
    return (object.index >= kFirst) && (object.index <= kLast);
}

// Ascending, and one after the other where gaps are refused.
bool AreNumbers(const DeviceConfig& config) noexcept
{
    const std::uint32_t longest_step = (config.gaps == NumberGaps::kSearched) ? kMaxSrdoCount : std::uint8_t{1U};
    std::uint32_t highest = 0U;
    for (SlotIndex slot = 0U; slot < config.srdo_count; ++slot)
    {
        const std::uint32_t number = config.srdos[slot].number; // MISRA D-002
        // 0 - 1 is the greatest value: a number that is not above the one before it is too far away as well.
        if (((number - highest) - 1U) >= longest_step)
        {
            return false;
        }
        highest = number;
    }
    return highest <= kMaxSrdoCount;
}

std::uint32_t OrderOf(const MappableObject& object) noexcept
{
    return (static_cast<std::uint32_t>(object.index) << 8U) | object.sub;
}

// [SRS_KRN_574]
bool IsMap(const StaticMap& map) noexcept
{
    return (map.count == 0U) || ((map.entries != nullptr) && (map.count <= kMaxMapEntries));
}

// Of the two values of each option one is 0. [SRS_KRN_572]
bool IsOption(const std::uint8_t value, const std::uint8_t other) noexcept
{
    return (value == 0U) || (value == other);
}

bool IsSetup(const SrdoSetup& setup) noexcept
{
    const bool is_policy = IsOption(static_cast<std::uint8_t>(setup.policy), kAutomatic);
    const bool is_form = IsOption(static_cast<std::uint8_t>(setup.form), kProvider);
    const bool is_detection = IsOption(static_cast<std::uint8_t>(setup.detection), kLate);
    return is_policy && is_form && is_detection && IsMap(setup.map);
}

bool AreOptions(const DeviceConfig& config) noexcept
{
    const bool are_dummies = IsOption(static_cast<std::uint8_t>(config.dummies), kDummies);
    const bool are_gaps = IsOption(static_cast<std::uint8_t>(config.gaps), kGaps);
    bool are_options = are_dummies && are_gaps && IsOption(static_cast<std::uint8_t>(config.gfc), kGfc);
    for (SlotIndex slot = 0U; slot < config.srdo_count; ++slot)
    {
        are_options = are_options && IsSetup(config.srdos[slot]); // MISRA D-002
    }
    return are_options;
}

StartResult CheckNumbers(const DeviceConfig& config) noexcept
{
    // 0 - 1 is the greatest value.
    if (((config.srdo_count - 1U) >= kMaxSrdoCount) || (config.srdos == nullptr))
    {
        return StartResult::kSrdoCount;
    }
    if (!AreNumbers(config))
    {
        return StartResult::kSrdoNumbers;
    }
    if ((config.node_id - 1U) >= kHighestNodeId)
    {
        return StartResult::kNodeId;
    }
    if (!IsGranularity(config.granularity_bits))
    {
        return StartResult::kGranularity;
    }
    if ((!IsPort(config.normal_port)) || (!IsPort(config.inverse_port)))
    {
        return StartResult::kPorts;
    }
    return AreOptions(config) ? StartResult::kStarted : StartResult::kOptions;
}

StartResult CheckObjects(const DeviceConfig& config) noexcept
{
    const bool has_table = (config.objects != nullptr) || (config.object_count == 0U); // [SRS_KRN_571]
    if ((!has_table) || (config.object_count > kMostObjects))
    {
        return StartResult::kObjects;
    }
    const bool has_dummies = config.dummies == DummyMapping::kAllowed;
    std::uint32_t following = 0U; // The least that the next object's order may be.
    for (std::uint16_t number = 0U; number < config.object_count; ++number)
    {
        const MappableObject& object = config.objects[number]; // MISRA D-002
        const std::uint32_t order = OrderOf(object);
        if ((order < following) || (!IsObject(object)) || (has_dummies && IsDummyIndex(object)))
        {
            return StartResult::kObjects;
        }
        following = order + 1U;
    }
    return StartResult::kStarted;
}

StartResult CheckTiming(const DeviceConfig& config) noexcept
{
    const bool is_cycle = (config.cycle_us >= kShortestCycleUs) && (config.cycle_us <= kLongestCycleUs) &&
                          (config.cycle_tolerance_us <= config.cycle_us);
    const std::uint32_t longest_us = config.discrepancy_us | config.acknowledge_window_us |
                                     config.diagnostic_interval_us | config.test_interval_us |
                                     config.clock_interval_us | config.output_time_us;
    const bool is_clock = config.clock_interval_us > config.clock_tolerance_us;
    if (!(is_cycle && is_clock && (longest_us <= kLongestTimeUs)))
    {
        return StartResult::kTiming;
    }
    const bool is_supervised = config.clock_interval_us >= ClockSupervisor::LeastIntervalUs(config);
    // One signature or digest a cycle at the most, one test of the comparator a cycle at the most, however late.
    const bool is_diagnosed = config.diagnostic_interval_us >= (2U * LateCycleUs(config) * config.srdo_count);
    const bool is_tested = config.test_interval_us >= ComparatorSelfTest::LongestRoundUs(config);
    return (is_supervised && is_diagnosed && is_tested) ? StartResult::kStarted : StartResult::kTiming;
}

bool Fits(const DeviceConfig& config, const Channel& channel) noexcept
{
    const ChannelRoom room = channel.Room();
    return (config.srdo_count <= room.slots) && (config.map_entries <= room.map_entries);
}

StartResult CheckRoom(const DeviceConfig& config, const KernelParts& parts) noexcept
{
    const bool fits = Fits(config, parts.channel_a) && Fits(config, parts.channel_b);
    const bool are_pairs = (config.map_entries & 1U) == 0U;
    return (fits && are_pairs) ? StartResult::kStarted : StartResult::kStorage;
}

} // namespace

StartResult CheckStart(const DeviceConfig& config, const KernelParts& parts) noexcept
{
    StartResult result = CheckNumbers(config);
    if (result == StartResult::kStarted)
    {
        result = CheckObjects(config);
    }
    if (result == StartResult::kStarted)
    {
        result = CheckTiming(config);
    }
    if (result == StartResult::kStarted)
    {
        result = CheckRoom(config, parts);
    }
    if (result != StartResult::kStarted)
    {
        return result;
    }
    const hal::MissingGuarantee missing = hal::CheckGuarantees(parts.can.Guarantees());
    if (missing == hal::MissingGuarantee::kNone)
    {
        return StartResult::kStarted;
    }
    const std::uint32_t place = static_cast<std::uint32_t>(missing) - kFirstMissing;
    return static_cast<StartResult>(kFirstGuarantee + place);
}

} // namespace counterpoint
