// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What an experiment leaves behind outside of the memory that is brought back spoils no other one.
#include "verification/campaign/campaign_rig.hpp"
#include "verification/campaign/crew.hpp"
#include "verification/campaign/replay.hpp"

#include <algorithm>
#include <csignal>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace counterpoint::campaign::test
{
namespace
{
constexpr const char* kSmall = "at: [500 ms]\nparts: [latch]\nsample: 10\n";

/// Memory of the process that the device reaches by a wild access: from then on each run ends by an exception.
class Spoilt final : public CycleWatcher
{
  public:
    /// The `run`-th run of a process, from 1 on, leaves it behind.
    Spoilt(Runner& runner, const std::uint64_t run) : runner_(runner), left_(run)
    {
        runner_.Follow(this);
    }
    ~Spoilt()
    {
        runner_.Follow(nullptr);
    }
    void OnCycle(const std::size_t cycle, const Sight& /*sight*/) override
    {
        const bool is_first = cycle <= last_;
        last_ = cycle;
        if (is_first && left_ == 0U)
        {
            raise(SIGSEGV);
        }
        left_ -= is_first ? 1U : 0U;
    }

  private:
    Runner& runner_;
    std::uint64_t left_;
    std::size_t last_{~std::size_t{0U}};
};

using SoundTest = CampaignTest;

std::vector<Outcome> OutcomesOf(const Results& results)
{
    std::vector<Outcome> outcomes;
    for (std::uint64_t index = 0U; index < results.Size(); ++index)
    {
        outcomes.push_back(results.At(index));
    }
    return outcomes;
}

bool AreEqual(const std::vector<Outcome>& left, const std::vector<Outcome>& right)
{
    const auto same = [](const Outcome& one, const Outcome& other)
    {
        return one.result == other.result && one.detector == other.detector && one.detail == other.detail &&
               one.marks == other.marks && one.us == other.us;
    };
    return std::equal(left.begin(), left.end(), right.begin(), right.end(), same);
}

TEST_F(SoundTest, ProcessIsSoundUntilItsRunWithoutFaultIsAnotherOne)
{
    Verifies(req::SRS_CMG_500);
    const Trap trap;
    Session session(PlanFile("plan.yaml", "actuator", kSmall));
    // Given a process that has tried every fault of a plan
    for (std::uint64_t number = 0U; number < session.Faults().Size(); ++number)
    {
        static_cast<void>(session.Runs().Run(session.Faults().At(number)));
    }
    EXPECT_TRUE(session.Runs().IsSound());
    EXPECT_TRUE(session.Runs().IsSound());
    // When something outside of the device ends its run without fault, then it is not
    {
        const Spoilt spoilt(session.Runs(), 1U);
        EXPECT_TRUE(session.Runs().IsSound());
        EXPECT_FALSE(session.Runs().IsSound());
    }
    EXPECT_TRUE(session.Runs().IsSound());
}

// Three bytes behind the last member of an answer were kept of the stack: campaigns over calls of a sensor ended before
// their first fault.
TEST_F(SoundTest, ProcessIsSoundBeforeAnyFaultWhateverIsHit)
{
    Verifies(req::SRS_CMG_540);
    for (const char* const device : {"actuator", "sensor"})
    {
        for (const char* const parts :
             {"a_calls", "b_calls", "kernel_calls", "steps", "a_calls, b_calls, kernel_calls, steps, cycle",
              "channel_a, channel_b", "bus", "clocks, inputs"})
        {
            // Given a plan of such parts
            const Trap trap;
            Session session(
                PlanFile("plan.yaml", device, "at: [500 ms]\ncycles: 50\nparts: [" + std::string(parts) + "]\n"));
            // When its device runs again without a fault, then it does the same
            EXPECT_TRUE(session.Runs().IsSound()) << device << ", " << parts;
        }
    }
}

TEST_F(SoundTest, WhatAnExperimentLeavesBehindSpoilsNoOtherOne)
{
    Verifies(req::SRS_CMG_500);
    Session session(PlanFile("plan.yaml", "actuator", kSmall));
    // Given the outcomes of a plan whose processes stay sound
    Results whole("", session.Identity(Shard{}));
    Crew(session.Runs(), session.Faults(), whole, 1U).Work([](const std::uint64_t) {});
    ASSERT_EQ(whole.OpenCount(), 0U);
    for (const std::uint32_t jobs : {1U, 3U})
    {
        // When each run of a process behind its tenth ends by an exception
        Results results("", session.Identity(Shard{}));
        {
            const Spoilt spoilt(session.Runs(), 10U);
            Crew crew(session.Runs(), session.Faults(), results, jobs);
            crew.Work([](const std::uint64_t) {});
        }
        // Then the outcomes are the same
        EXPECT_TRUE(AreEqual(OutcomesOf(results), OutcomesOf(whole))) << jobs;
    }
}

// A look at a channel whose address was wrong ended the run earlier than the fault did.
TEST_F(SoundTest, ReplayTellsTheOutcomeOfTheCampaignWhateverItLooksAt)
{
    Verifies(req::SRS_CMG_541);
    // Given bits of addresses that a replay follows, some of which end in an exception
    Session session(PlanFile("plan.yaml", "actuator",
                             "at: [500 ms]\ncycles: 25\nparts: [channel_a]\nmembers: [channel_a.object]\n"
                             "kinds: [flip, intermittent]\nsample: 60\nseed: 9\n"));
    std::size_t exceptions = 0U;
    std::size_t blind = 0U;
    for (std::uint64_t number = 0U; number < session.Faults().Size(); ++number)
    {
        const Outcome outcome = [&session, number]()
        {
            const Trap trap;
            return session.Runs().Run(session.Faults().At(number));
        }();
        // When each is replayed
        const Replay replay(session, number);
        // Then it has the same outcome
        EXPECT_TRUE(AreEqual({replay.Found()}, {outcome})) << number;
        exceptions += (outcome.detector == Detector::kException) ? 1U : 0U;
        blind +=
            (replay.Text().find("sees no more of it: what is hit is what it looks at") != std::string::npos) ? 1U : 0U;
    }
    EXPECT_GT(exceptions, 5U);
    EXPECT_GT(blind, 0U);
}

// Bits of an address that channel B keeps, stuck at 1, led the march through the memory of the program.
TEST_F(SoundTest, BitsStuckInAnAddressLeaveNothingToTheNextOne)
{
    Verifies(req::SRS_CMG_500);
    // Given bits 8 to 15 of the address that lies at byte 144 today, stuck at 1 in 60 phases, with self tests
    const std::string plan =
        PlanFile("plan.yaml", "actuator",
                 "at: [500 ms]\ncycles: 25\nparts: [channel_b]\nmembers: [channel_b.object+145]\nkinds: [stuck_at_1]\n"
                 "self_test: true\nsample: 60\n");
    Session session(plan);
    Results results("", session.Identity(Shard{}));
    Crew(session.Runs(), session.Faults(), results, 1U).Work([](const std::uint64_t) {});
    // When each is tried by a process of its own, then its outcome is the same
    Results alone("", session.Identity(Shard{}));
    for (std::uint64_t index = 0U; index < alone.Size(); ++index)
    {
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0)
        {
            const Trap trap;
            alone.Put(index, session.Runs().Run(session.Faults().At(index)));
            _exit(0);
        }
        waitpid(child, nullptr, 0);
    }
    EXPECT_EQ(alone.OpenCount(), 0U);
    EXPECT_TRUE(AreEqual(OutcomesOf(results), OutcomesOf(alone)));
}
} // namespace
} // namespace counterpoint::campaign::test
