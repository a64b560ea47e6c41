// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// A short differential run, and proof that it finds a difference, counts what it reached and repeats itself.
#include "verification/differential/differential.hpp"

#include "channel_a/channel.hpp"
#include "channel_b/channel.hpp"
#include "verification/conformance/forwarding.hpp"
#include "verification/trace/ids/conformance.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace counterpoint::differential
{
namespace
{

constexpr std::uint32_t kSequences = 4000U;

class Listener final : public Observer
{
  public:
    void OnStep(const StepRecord& record) noexcept override
    {
        steps.emplace_back(record.name);
    }

    void OnDifference(const Difference& difference) noexcept override
    {
        ++count;
        last = difference;
    }

    std::vector<std::string> steps{};
    Difference last{};
    std::uint32_t count{0U};
};

/// Forgets one fault in a hundred.
class Forgetful final : public conformance::Forwarding
{
  public:
    using Forwarding::Forwarding;

    void Demote(SlotIndex slot) noexcept override
    {
        ++calls_;
        if ((calls_ % 100U) != 0U)
        {
            Forwarding::Demote(slot);
        }
    }

  private:
    std::uint32_t calls_{0U};
};

/// Rejects every frame: equal to another one that does, but nothing is ever released.
class Deaf final : public conformance::Forwarding
{
  public:
    using Forwarding::Forwarding;

    void OnFrame(const CanFrame& /*frame*/, Instant /*stamp*/) noexcept override
    {
    }
};

struct Parts
{
    channel_a::StorageFor<kMaxSrdoCount, kMaxMapEntries> storage_a{};
    channel_b::StorageFor<kMaxSrdoCount, kMaxMapEntries> storage_b{};
    channel_a::Channel a{storage_a.Handle()};
    channel_b::Channel b{storage_b.Handle()};
    Listener listener{};
};

TEST(DifferentialRun, ChannelsAgreeInEveryStepAndEverythingIsReached)
{
    Verifies(req::SRS_CNF_010);
    Verifies(req::SRS_CNF_011);
    Verifies(req::SRS_CNF_340);
    const auto parts = std::make_unique<Parts>();
    const auto run = std::make_unique<Differential>(parts->a, parts->b, parts->listener);
    const DifferentialResult result = RunDifferential(*run, 1U, 0U, kSequences, 1U);
    EXPECT_EQ(result.sequences, kSequences);
    EXPECT_EQ(result.failures, 0U);
    for (std::uint8_t item = 0U; item < kItemCount; ++item)
    {
        EXPECT_GT(run->Seen().Count(static_cast<Item>(item)), 0U) << NameOf(static_cast<Item>(item));
    }
}

TEST(DifferentialRun, SameSeedSameHash)
{
    Verifies(req::SRS_CNF_012);
    const auto parts = std::make_unique<Parts>();
    const auto first = std::make_unique<Differential>(parts->a, parts->b, parts->listener);
    const auto second = std::make_unique<Differential>(parts->a, parts->b, parts->listener);
    const auto other = std::make_unique<Differential>(parts->a, parts->b, parts->listener);
    const DifferentialResult one = RunDifferential(*first, 7U, 0U, 100U, 1U);
    const DifferentialResult two = RunDifferential(*second, 7U, 0U, 100U, 1U);
    const DifferentialResult three = RunDifferential(*other, 8U, 0U, 100U, 1U);
    EXPECT_EQ(one.hash, two.hash);
    EXPECT_EQ(one.steps, two.steps);
    EXPECT_NE(one.hash, three.hash);
}

TEST(DifferentialRun, FindsARareDifferenceAndRepeatsItBySeedAndNumber)
{
    Verifies(req::SRS_CNF_010);
    Verifies(req::SRS_CNF_012);
    // Given a channel that forgets a fault now and then
    const auto parts = std::make_unique<Parts>();
    Forgetful forgetful{parts->b};
    const auto run = std::make_unique<Differential>(parts->a, forgetful, parts->listener);
    // When sequences are fed until they differ
    const DifferentialResult result = RunDifferential(*run, 3U, 0U, kSequences, 1U);
    // Then one difference is reported, with seed, sequence and step
    ASSERT_EQ(result.failures, 1U);
    ASSERT_EQ(parts->listener.count, 1U);
    EXPECT_EQ(parts->listener.last.seed, 3U);
    EXPECT_GT(parts->listener.last.step, 0U);
    EXPECT_NE(parts->listener.last.a, parts->listener.last.b);
    // and told again, the sequence shows its steps
    run->Tell(true);
    static_cast<void>(run->RunSequence(3U, parts->listener.last.sequence));
    EXPECT_GE(parts->listener.steps.size(), parts->listener.last.step);
}

TEST(DifferentialRun, EqualChannelsThatRejectEverythingDoNotPass)
{
    Verifies(req::SRS_CNF_011);
    const auto parts = std::make_unique<Parts>();
    Deaf deaf_a{parts->a};
    Deaf deaf_b{parts->b};
    const auto run = std::make_unique<Differential>(deaf_a, deaf_b, parts->listener);
    const DifferentialResult result = RunDifferential(*run, 1U, 0U, 300U, 1U);
    EXPECT_EQ(result.failures, 0U);
    EXPECT_EQ(run->Seen().Count(Item::kAcceptedPair), 0U);
    EXPECT_GT(run->Seen().Missing(), 0U);
}

} // namespace
} // namespace counterpoint::differential
