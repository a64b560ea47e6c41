// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The greatest and the least that Start accepts, each with the neighbour that it refuses.
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"

namespace counterpoint
{
namespace
{

class StartLimits : public Rig
{
  public:
    StartResult With(const std::function<void(DeviceConfig&)>& change)
    {
        const DeviceConfig good = config;
        change(config);
        const StartResult result = kernel.Start(config, FlowCallback::kOff);
        config = good;
        return result;
    }
    /// `member` at its limit starts, one more does not.
    void HasUpperLimit(std::uint32_t DeviceConfig::* member, const std::uint32_t limit)
    {
        EXPECT_EQ(With([&](DeviceConfig& c) { c.*member = limit; }), StartResult::kStarted);
        EXPECT_EQ(With([&](DeviceConfig& c) { c.*member = limit + 1U; }), StartResult::kTiming);
        EXPECT_EQ(With([&](DeviceConfig& c) { c.*member = 0xFFFFFFFFU; }), StartResult::kTiming);
    }
    /// `member` at its limit starts, one less does not.
    void HasLowerLimit(std::uint32_t DeviceConfig::* member, const std::uint32_t limit)
    {
        EXPECT_EQ(With([&](DeviceConfig& c) { c.*member = limit; }), StartResult::kStarted);
        EXPECT_EQ(With([&](DeviceConfig& c) { c.*member = limit - 1U; }), StartResult::kTiming);
    }
};

TEST_F(StartLimits, EveryTimeHasItsGreatestValue)
{
    Verifies(req::SRS_KRN_001);
    HasUpperLimit(&DeviceConfig::cycle_tolerance_us, 1000U);
    HasUpperLimit(&DeviceConfig::discrepancy_us, 0x3FFFFFFFU);
    HasUpperLimit(&DeviceConfig::acknowledge_window_us, 0x3FFFFFFFU);
    HasUpperLimit(&DeviceConfig::diagnostic_interval_us, 0x3FFFFFFFU);
    HasUpperLimit(&DeviceConfig::test_interval_us, 0x3FFFFFFFU);
    HasUpperLimit(&DeviceConfig::clock_interval_us, 0x3FFFFFFFU);
    HasUpperLimit(&DeviceConfig::output_time_us, 0x3FFFFFFFU);
    HasUpperLimit(&DeviceConfig::clock_tolerance_us, 99999U); // Below the interval of 100 ms.
    config.diagnostic_interval_us = 6003000U;
    config.test_interval_us = 15007500U;
    config.clock_interval_us = 4002000U;
    HasUpperLimit(&DeviceConfig::cycle_us, 1000000U);
}

TEST_F(StartLimits, TwoTimesThatAreTooLongAreRefusedAsOneIs)
{
    Verifies(req::SRS_KRN_001);
    constexpr std::uint32_t DeviceConfig::* kTimes[] = {
        &DeviceConfig::discrepancy_us,   &DeviceConfig::acknowledge_window_us, &DeviceConfig::diagnostic_interval_us,
        &DeviceConfig::test_interval_us, &DeviceConfig::clock_interval_us,     &DeviceConfig::output_time_us};
    for (const auto first : kTimes)
    {
        for (const auto second : kTimes)
        {
            EXPECT_EQ(With(
                          [first, second](DeviceConfig& c)
                          {
                              c.*first = 0x40000000U;
                              c.*second = 0x40000000U;
                          }),
                      StartResult::kTiming);
        }
    }
}

TEST_F(StartLimits, EveryTimeHasItsLeastValue)
{
    Verifies(req::SRS_KRN_001);
    Verifies(req::SRS_CLK_213);
    Verifies(req::SRS_LIM_214);
    Verifies(req::SRS_CMP_213);
    HasLowerLimit(&DeviceConfig::clock_interval_us, 6000U); // Four late cycles.
    config.clock_tolerance_us = 6000U;
    HasLowerLimit(&DeviceConfig::clock_interval_us, 6001U); // Above the tolerance.
    config.clock_tolerance_us = 200U;
    HasLowerLimit(&DeviceConfig::diagnostic_interval_us, 9000U); // Two late cycles for each of three SRDOs.
    config.srdo_count = 2U;
    HasLowerLimit(&DeviceConfig::diagnostic_interval_us, 6000U);
    config.srdo_count = 1U;
    HasLowerLimit(&DeviceConfig::diagnostic_interval_us, 3000U);
    config.srdo_count = 3U;
    HasLowerLimit(&DeviceConfig::test_interval_us, 22500U); // 15 cycles of 1.5 ms.
    config.cycle_tolerance_us = 50U;
    HasLowerLimit(&DeviceConfig::cycle_us, 100U);
    EXPECT_EQ(With(
                  [](DeviceConfig& c)
                  {
                      c.discrepancy_us = 0U;
                      c.acknowledge_window_us = 0U;
                      c.cycle_tolerance_us = 0U;
                      c.output_time_us = 0U;
                      c.clock_tolerance_us = 0U;
                      c.clock_interval_us = 4000U; // Four cycles.
                  }),
              StartResult::kStarted);
}

TEST_F(StartLimits, ToleranceMayBeAWholeCycleOfAnyLength)
{
    Verifies(req::SRS_KRN_001);
    const auto with_cycle = [this](const std::uint32_t cycle_us, const std::uint32_t tolerance_us)
    {
        return With(
            [&](DeviceConfig& c)
            {
                c.cycle_us = cycle_us;
                c.cycle_tolerance_us = tolerance_us;
                c.diagnostic_interval_us = 12000000U;
                c.test_interval_us = 30000000U;
                c.clock_interval_us = 8000000U;
            });
    };
    EXPECT_EQ(with_cycle(100U, 100U), StartResult::kStarted);
    EXPECT_EQ(with_cycle(100U, 101U), StartResult::kTiming);
    EXPECT_EQ(with_cycle(1000000U, 1000000U), StartResult::kStarted);
    EXPECT_EQ(with_cycle(1000000U, 1000001U), StartResult::kTiming);
    EXPECT_EQ(with_cycle(1000001U, 0U), StartResult::kTiming);
}

TEST_F(StartLimits, ObjectsAreAtMostOneThousandTwentyFour)
{
    Verifies(req::SRS_KRN_001);
    std::array<std::uint8_t, 8> place{};
    std::vector<MappableObject> many(1025U, MappableObject{0U, 0U, 64U, MapAccess::kConsumer, place.data()});
    for (std::uint32_t number = 0U; number < 1025U; ++number)
    {
        many[number].index = static_cast<std::uint16_t>(0xF000U + number);
    }
    config.objects = many.data();
    config.object_count = 1024U;
    EXPECT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    // The last of them is looked at as well
    many[1023].length_bits = 65U;
    EXPECT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kObjects);
    many[1023].length_bits = 64U;
    config.object_count = 1025U;
    EXPECT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kObjects);
}

TEST_F(StartLimits, ObjectsBesideDummiesAreNotDataTypes)
{
    Verifies(req::SRS_KRN_001);
    const auto with = [this](const std::uint16_t index)
    {
        objects[0].index = index;
        return kernel.Start(config, FlowCallback::kOff);
    };
    for (std::uint16_t index = 1U; index <= 7U; ++index)
    {
        config.dummies = DummyMapping::kAllowed;
        EXPECT_EQ(with(index), StartResult::kObjects) << index;
        config.dummies = DummyMapping::kRefused;
        EXPECT_EQ(with(index), StartResult::kStarted) << index;
    }
    config.dummies = DummyMapping::kAllowed;
    EXPECT_EQ(with(0U), StartResult::kStarted);
    EXPECT_EQ(with(8U), StartResult::kStarted);
}

TEST_F(StartLimits, ObjectsAscendBySubIndexAsWell)
{
    Verifies(req::SRS_KRN_001);
    const auto with = [this](const std::uint16_t index, const std::uint8_t sub)
    {
        objects[1].index = index;
        objects[1].sub = sub;
        return kernel.Start(config, FlowCallback::kOff);
    };
    // Between 2000h:01 and 2200h:01
    EXPECT_EQ(with(0x2000U, 0U), StartResult::kObjects);
    EXPECT_EQ(with(0x2000U, 1U), StartResult::kObjects);
    EXPECT_EQ(with(0x2000U, 2U), StartResult::kStarted);
    EXPECT_EQ(with(0x2000U, 255U), StartResult::kStarted);
    EXPECT_EQ(with(0x1FFFU, 255U), StartResult::kObjects);
    EXPECT_EQ(with(0x2200U, 0U), StartResult::kStarted);
    EXPECT_EQ(with(0x2200U, 1U), StartResult::kObjects);
    // Behind the greatest sub-index of 2000h
    objects[0].sub = 0xFFU;
    EXPECT_EQ(with(0x2001U, 0U), StartResult::kStarted);
    objects[0].sub = 1U;
    objects[1].index = 0x2100U;
    objects[1].sub = 1U;
    // The first may be 0000h:00, the last FFFFh:FF
    objects[0].index = 0U;
    objects[0].sub = 0U;
    objects[4].index = 0xFFFFU;
    objects[4].sub = 0xFFU;
    EXPECT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
}

TEST_F(StartLimits, NumbersMayHaveTheWidestGap)
{
    Verifies(req::SRS_KRN_018);
    const auto with = [this](const std::uint8_t first, const std::uint8_t second)
    {
        setups[0].number = first;
        setups[1].number = second;
        config.srdo_count = 2U;
        return kernel.Start(config, FlowCallback::kOff);
    };
    EXPECT_EQ(with(1U, 64U), StartResult::kStarted);
    EXPECT_EQ(with(63U, 64U), StartResult::kStarted);
    EXPECT_EQ(with(64U, 64U), StartResult::kSrdoNumbers);
    EXPECT_EQ(with(64U, 65U), StartResult::kSrdoNumbers);
    EXPECT_EQ(with(1U, 255U), StartResult::kSrdoNumbers);
    EXPECT_EQ(with(1U, 0U), StartResult::kSrdoNumbers);
    EXPECT_EQ(with(2U, 1U), StartResult::kSrdoNumbers);
    config.gaps = NumberGaps::kRefused;
    EXPECT_EQ(with(1U, 2U), StartResult::kStarted);
    EXPECT_EQ(with(1U, 3U), StartResult::kSrdoNumbers);
}

TEST_F(StartLimits, MapEntriesMayBeAllThatAChannelHasRoomForOrNone)
{
    Verifies(req::SRS_KRN_020);
    EXPECT_EQ(With([](DeviceConfig& c) { c.map_entries = 0U; }), StartResult::kStarted);
    EXPECT_EQ(With([](DeviceConfig& c) { c.map_entries = 16U; }), StartResult::kStarted);
    EXPECT_EQ(With([](DeviceConfig& c) { c.map_entries = 18U; }), StartResult::kStorage);
    EXPECT_EQ(With([](DeviceConfig& c) { c.map_entries = 1U; }), StartResult::kStorage);
    EXPECT_EQ(With([](DeviceConfig& c) { c.map_entries = 254U; }), StartResult::kStorage);
}

TEST_F(StartLimits, FirstOfSeveralReasonsIsNamed)
{
    Verifies(req::SRS_KRN_001);
    Verifies(req::SRS_KRN_020);
    // Given a device and a platform in which everything is wrong
    config.srdo_count = 65U;
    setups[0].number = 0U;
    config.node_id = 128U;
    config.granularity_bits = 3U;
    config.inverse_port = CanPortId::kInvalid;
    objects[1].index = 0x2000U;
    config.cycle_us = 99U;
    config.map_entries = 18U;
    ports.guarantees = hal::CanGuarantees{hal::Guarantee::kAbsent, hal::Guarantee::kAbsent, hal::Guarantee::kAbsent};
    const auto names = [this](const StartResult reason)
    { EXPECT_EQ(kernel.Start(config, FlowCallback::kOff), reason) << static_cast<int>(reason); };
    // When one after the other is put right, then it is the next one that is named
    names(StartResult::kSrdoCount);
    config.srdo_count = 3U;
    names(StartResult::kSrdoNumbers);
    setups[0].number = 1U;
    names(StartResult::kNodeId);
    config.node_id = 2U;
    names(StartResult::kGranularity);
    config.granularity_bits = 8U;
    names(StartResult::kPorts);
    config.inverse_port = CanPortId::kFirst;
    names(StartResult::kObjects);
    objects[1].index = 0x2100U;
    names(StartResult::kTiming);
    config.cycle_us = 1000U;
    names(StartResult::kStorage);
    config.map_entries = 16U;
    names(StartResult::kBusOrder);
    ports.guarantees.bus_order = hal::Guarantee::kGiven;
    names(StartResult::kStamps);
    ports.guarantees.stamps = hal::Guarantee::kGiven;
    names(StartResult::kConfirmations);
    ports.guarantees.confirmations = hal::Guarantee::kGiven;
    names(StartResult::kStarted);
}

} // namespace
} // namespace counterpoint
