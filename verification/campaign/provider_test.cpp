// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// A producer whose provider is called before each refresh: what it has, and what comes of it when nobody asks. With it
// what is later than without a fault, and what closes by its own time.
#include "verification/campaign/campaign_rig.hpp"
#include "verification/campaign/variants.hpp"

#include <map>
#include <string>

namespace counterpoint::campaign::test
{
namespace
{
/// Both values change at 690 ms, and 170 ms before and behind that.
constexpr const char* kChanging = "title: A test\nscenario: " COUNTERPOINT_SOURCE_FOLDER
                                  "/examples/campaigns/complement_at_work.yaml\ndevice: sensor\nat: [600 ms]\n"
                                  "cycles: 120\nsample: 10\nparts: [kernel_calls]\n";

class ProviderTest : public CampaignTest
{
  protected:
    /// How often each outcome comes, of faults of the first call of the provider in each of the 45 cycles before this
    /// one.
    [[nodiscard]] static std::map<Class, std::uint64_t> Tried(Session& session, const FaultKind kind,
                                                              const std::uint32_t variant, const std::size_t end)
    {
        std::map<Class, std::uint64_t> classes;
        for (std::size_t cycle = end - 45U; cycle < end; ++cycle)
        {
            Experiment fault;
            fault.part = Part::kKernelCalls;
            fault.kind = kind;
            fault.subject = static_cast<std::size_t>(KernelCall::kOnRefresh) * kTurns;
            fault.variant = variant;
            fault.cycle = cycle;
            ++classes[session.Runs().Run(fault).result];
        }
        return classes;
    }
};

TEST_F(ProviderTest, NobodyAskedIsOldDataSent)
{
    Verifies(req::SRS_CMG_810);
    Verifies(req::SRS_CMG_812);
    const Trap trap;
    Session session(PlanFile("plan.yaml", "sensor", "at: [500 ms]\ncycles: 5\nsample: 10\n"));
    // When each bit of the form is wrong, so that the provider is no longer called
    for (std::uint8_t bit = 0U; bit < 8U; ++bit)
    {
        const Outcome outcome = session.Runs().Run(FaultIn(session, "setups", 2U, bit));
        // Then it is not benign: old data are sent, for good or until somebody found why
        ASSERT_TRUE(IsDangerous(outcome.result)) << int{bit} << OutcomeText(outcome);
        EXPECT_NE(ReasonOf(outcome).find("old data"), std::string::npos) << OutcomeText(outcome);
    }
}

TEST_F(ProviderTest, CallOfTheProviderIsHitAsOthers)
{
    Verifies(req::SRS_CMG_811);
    Verifies(req::SRS_CMG_812);
    const Trap trap;
    Session session(File("changing.yaml", kChanging));
    // When it does not come any more, old data are sent.
    EXPECT_EQ(Tried(session, FaultKind::kSkipped, kAlways, 689U)[Class::kSilent], 45U);
    // Once, or late, what is sent is no older than a refresh: something else was sent, and nothing wrong
    for (const FaultKind kind : {FaultKind::kSkipped, FaultKind::kLate})
    {
        auto classes = Tried(session, kind, 0U, 720U);
        EXPECT_GT(classes[Class::kBenign], 0U) << WordOf(kind);
        EXPECT_EQ(classes[Class::kBenign] + classes[Class::kMasked], 45U) << WordOf(kind);
    }
    // Twice is as once.
    EXPECT_EQ(Tried(session, FaultKind::kDoubled, 0U, 720U)[Class::kMasked], 45U);
    // And it has a name.
    Experiment fault;
    fault.part = Part::kKernelCalls;
    fault.subject = static_cast<std::size_t>(KernelCall::kOnRefresh) * kTurns;
    EXPECT_EQ(SubjectName(fault, session.Scenario().Record()), "kernel.OnRefresh");
}

TEST_F(ProviderTest, OldDataThatSomebodyFindsInTimeAreExposed)
{
    Verifies(req::SRS_CMG_812);
    Outcome outcome{Class::kExposed, Detector::kGuard, 0U, kMarkOldPair, 1000U};
    EXPECT_EQ(ReasonOf(outcome), "valid pairs sent with old data until the guard found it");
    outcome.marks = 0U;
    EXPECT_EQ(ReasonOf(outcome), "open with wrong data until the guard found it");
}

TEST_F(ProviderTest, PairThatIsReleasedLaterIsNotMasked)
{
    Verifies(req::SRS_CMG_816);
    const Trap trap;
    Session session(PlanFile("plan.yaml", "actuator", "at: [500 ms]\ncycles: 120\nsample: 10\nparts: [bus]\n"));
    const Recording& recording = session.Scenario().Record();
    std::map<bool, Outcome> outcomes;
    for (std::size_t pair = 1U; pair < recording.pairs.size(); ++pair)
    {
        const auto data = [&recording](const std::size_t each)
        { return NumberIn(recording.frames[recording.pairs[each].normal].stamped.frame); };
        Experiment fault;
        fault.part = Part::kBus;
        fault.kind = FaultKind::kPairDelayed;
        fault.subject = pair;
        fault.variant = 199U; // 10 ms.
        fault.cycle = CycleOf(recording, recording.frames[recording.pairs[pair].normal].at);
        if (fault.cycle > 500U && fault.cycle < 600U)
        {
            outcomes[data(pair) != data(pair - 1U)] = session.Runs().Run(fault);
        }
    }
    // When a pair with another value comes 10 ms later than it should, then that value is there later.
    EXPECT_EQ(outcomes.at(true).result, Class::kBenign);
    // With the same value nobody sees it.
    EXPECT_EQ(outcomes.at(false).result, Class::kMasked);
}

TEST_F(ProviderTest, OutputMayCloseByItsTimeInTheCycleThatObeysAStop)
{
    Verifies(req::SRS_CMG_814);
    const Trap trap;
    Session session(File("stop.yaml", "title: A test\nscenario: " COUNTERPOINT_SOURCE_FOLDER
                                      "/examples/campaigns/commanded.yaml\ndevice: actuator\nat: [695 ms]\n"
                                      "cycles: 10\nsample: 10\n"));
    for (std::size_t cycle = 696U; cycle < 703U; ++cycle)
    {
        // When an address of a part of the kernel is wrong, also in the cycle in which the device stops
        Experiment fault = FaultIn(session, "kernel.parts", 0U, 0U);
        fault.cycle = cycle;
        const Outcome outcome = session.Runs().Run(fault);
        // then it is found, by the kernel or as an exception, and nothing was wrong
        EXPECT_TRUE(outcome.result == Class::kDetected || outcome.detector == Detector::kException)
            << cycle << OutcomeText(outcome);
    }
}
} // namespace
} // namespace counterpoint::campaign::test
