// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// From when the time of a detection counts, and whose word is one.
#include "verification/campaign/campaign_rig.hpp"
#include "verification/campaign/read_bytes.hpp"
#include "verification/campaign/two_cpus.hpp"
#include "verification/campaign/variants.hpp"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace counterpoint::campaign::test
{
namespace
{
constexpr std::size_t kCycle = 499U;

class LatenessTest : public CampaignTest
{
  protected:
    /// A device of one or two CPUs for which each limit is the same.
    struct Rig
    {
        explicit Rig(const std::string& plan_file, const std::uint32_t limit_us = 5000U)
            : plan(ReadPlan(plan_file)), scenario(plan.scenario, runtime::YamlValue(plan.file, plan.device_node)),
              region(1U << 20U), device(MakeDevice()), judge(scenario.Record(), scenario.Model(), *device),
              limits(LimitsOfAll(limit_us)),
              space(plan, scenario.Record(), *device, HorizonOf(limits, device->Config())),
              runner(*device, judge, scenario.Record(), space, limits)
        {
        }
        [[nodiscard]] std::unique_ptr<Device> MakeDevice()
        {
            if (scenario.HasTwoCpus())
            {
                return std::make_unique<TwoCpus>(region, scenario, false);
            }
            DeviceSetup setup;
            setup.has_call_faults = true;
            return std::make_unique<Device>(region, scenario.Model(), scenario.Record(), OutputKind::kGate, setup);
        }
        [[nodiscard]] static Limits LimitsOfAll(const std::uint32_t us)
        {
            Limits limits;
            limits.us.fill(us);
            limits.wrong_frame_us = us;
            limits.wrong_channel_us = us;
            limits.drift_us = us;
            return limits;
        }

        Plan plan;
        RecordedScenario scenario;
        Region region;
        std::unique_ptr<Device> device;
        Judge judge;
        Limits limits;
        Space space;
        Runner runner;
    };
    /// A plan for the actuator, of one CPU or of two.
    [[nodiscard]] std::string PlanOf(const bool has_two_cpus, const std::string& more) const
    {
        return File("plan.yaml",
                    std::string("title: A test\nscenario: " COUNTERPOINT_SOURCE_FOLDER "/examples/campaigns/") +
                        (has_two_cpus ? "two_cpus_at_work" : "at_work") + ".yaml\ndevice: actuator\nat: [500 ms]\n" +
                        more);
    }
};

// A frame, a message that is missing, and a CPU that stands still, do nothing that is seen outside until SCT,
// SRVT or the time-out of the link are over: late from the first byte that differs.
TEST_F(LatenessTest, OfWhatIsNoMemoryCountsFromTheFirstByteThatDiffers)
{
    Verifies(req::SRS_CMG_153);
    const Trap trap;
    struct Row
    {
        bool has_two_cpus;
        const char* kind;
    };
    for (const Row& row : {Row{false, "parts: [bus]\nkinds: [lost]\ncycles: 25\nsample: 8\n"},
                           Row{true, "parts: [link]\nkinds: [lost]\nsample: 20\n"},
                           Row{true, "parts: [cpu]\nkinds: [stopped]\nsample: 4\n"}})
    {
        Rig rig(PlanOf(row.has_two_cpus, row.kind));
        std::uint64_t late = 0U;
        for (std::uint64_t number = 0U; number < rig.space.Size(); ++number)
        {
            const Outcome outcome = rig.runner.Run(rig.space.At(number));
            if (outcome.result == Class::kDetected)
            {
                // Beside the limit lies the cycle in which the first byte differs, and the one before
                const bool is_far = outcome.us > 7000U;
                const bool is_near = outcome.us <= 5000U;
                EXPECT_TRUE(is_far ? IsLate(outcome) : !(is_near && IsLate(outcome))) << row.kind << outcome.us;
                late += IsLate(outcome) ? 1U : 0U;
            }
        }
        EXPECT_GT(late, 0U) << row.kind;
    }
}
// A write into variables is found by the pair check, one into an address by the processor.
TEST_F(LatenessTest, WhatOthersMakeSafeHasNoLimit)
{
    Verifies(req::SRS_CMG_007);
    const Trap trap;
    // Given limits of nothing
    Rig rig(PlanOf(false, "sample: 10\n"), 0U);
    const std::vector<Place>& places = rig.device->Places();
    for (const auto& [member, byte, detector] : {std::tuple("variables", 0U, Detector::kPairCheck),
                                                 {"config", 5U, Detector::kException},
                                                 {"latch", 0U, Detector::kLatch}})
    {
        const auto found = std::find_if(places.begin(), places.end(), [name = std::string(member)](const Place& place)
                                        { return place.name == name; });
        ASSERT_NE(found, places.end());
        const Outcome outcome =
            rig.runner.Run({found->part, FaultKind::kFlip, static_cast<std::size_t>(found - places.begin()),
                            found->offset + byte, 4U, kCycle, Phase::kAfterFrames});
        // Then what the kernel detects is late, and what others make safe is not
        EXPECT_EQ(outcome.detector, detector) << member;
        EXPECT_GT(outcome.us, 0U) << member;
        EXPECT_EQ(IsLate(outcome), detector == Detector::kLatch) << member;
    }
}

/// A fault of the sensor, what the device does otherwise first, and how long before the fault is found.
struct Effect
{
    const char* member; ///< Null: a call of channel A.
    std::size_t byte;
    std::size_t cycle;
    std::uint32_t us;     ///< From the fault to the closed output.
    std::uint32_t effect; ///< From the cycle before the first effect.
};

// t [cycle]   499 the fault   510 an error is told, or 513 a pair is overdue   516 found by the comparator
TEST_F(LatenessTest, OfMemoryAndCallsCountsFromTheFirstThingThatTheDeviceDoesOtherwise)
{
    Verifies(req::SRS_CMG_060);
    const Trap trap;
    Rig rig(File("sensor.yaml",
                 "title: A test\nscenario: " COUNTERPOINT_SOURCE_FOLDER
                 "/examples/campaigns/at_work.yaml\ndevice: sensor\nat: [500 ms]\ncycles: 60\nsample: 10\n"),
            100000U);
    const std::vector<Place>& places = rig.device->Places();
    for (const Effect& each : {
             Effect{"channel_b.form", 0U, 499U, 16999U, 6000U},     // An error is told.
             Effect{"channel_a.records", 28U, 499U, 16999U, 5000U}, // Likewise, a cycle later.
             Effect{"channel_a.records", 0U, 499U, 16999U, 3000U},  // A pair is overdue.
             Effect{nullptr, 0U, 510U, 6999U, 6000U},               // A call that is left out: an error is told.
         })
    {
        Experiment fault;
        fault.part = Part::kCallsOfA;
        fault.kind = FaultKind::kSkipped;
        fault.cycle = each.cycle;
        fault.subject = static_cast<std::size_t>(ChannelCall::kPrepare) * kTurns;
        if (each.member != nullptr)
        {
            const auto found = std::find_if(places.begin(), places.end(), [&each](const Place& place)
                                            { return place.name == std::string(each.member); });
            ASSERT_NE(found, places.end());
            fault = {found->part,
                     FaultKind::kFlip,
                     static_cast<std::size_t>(found - places.begin()),
                     found->offset + each.byte,
                     0U,
                     each.cycle,
                     Phase::kAfterFrames};
        }
        // When the limit is the time since the effect, or shorter by 1 us, then that is late and this is not
        for (const std::uint32_t less : {0U, 1U})
        {
            rig.limits = Rig::LimitsOfAll(each.effect - less);
            const Outcome outcome = rig.runner.Run(fault);
            EXPECT_EQ(outcome.result, Class::kDetected);
            EXPECT_EQ(outcome.us, each.us) << each.byte;
            EXPECT_EQ(IsLate(outcome), less == 1U) << each.byte << " " << each.effect;
        }
    }
}

TEST_F(LatenessTest, WhatTheApplicationReadsAreThePairsOfConsumers)
{
    Verifies(req::SRS_CMG_060);
    for (const auto& [name, variables] : {std::pair("actuator", 4U), {"sensor", 0U}})
    {
        // Given an actuator with one SRDO of two pairs, or a sensor, whose pairs it senses
        Rig rig(File("plan.yaml", std::string("title: A test\nscenario: " COUNTERPOINT_SOURCE_FOLDER
                                              "/examples/campaigns/at_work.yaml\ndevice: ") +
                                      name + "\nat: [500 ms]\nsample: 10\n"));
        // Then all of the consumer are looked at, each with its inverse, and none of the producer
        const std::vector<ReadBytes> read = WhatIsRead(*rig.device);
        EXPECT_EQ(read.size(), variables) << name;
        std::set<std::size_t> places;
        for (const ReadBytes& each : read)
        {
            EXPECT_EQ(each.size, 1U);
            places.insert(each.offset);
        }
        EXPECT_EQ(places.size(), variables);
    }
}
} // namespace
} // namespace counterpoint::campaign::test
