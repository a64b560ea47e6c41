// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// From when the time of a detection counts, and whose word is one.
#include "verification/campaign/campaign_rig.hpp"
#include "verification/campaign/two_cpus.hpp"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <tuple>

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
            return std::make_unique<Device>(region, scenario.Model(), scenario.Record(), OutputKind::kGate);
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
                                                 {"kernel.config", 5U, Detector::kException},
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
} // namespace
} // namespace counterpoint::campaign::test
