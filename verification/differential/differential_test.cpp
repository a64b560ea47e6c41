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

/// What a channel does otherwise than the other one.
enum class Slip
{
    kNone,
    kDigest,
    kOutcome,
    kPrepared,
    kInverseOfTheSecondCall,
    kOwnObject,
    kForeignObject,
    kByteBehind,
};

/// Channel B with one slip; those of memory are made behind each commit.
class Slipping final : public conformance::Forwarding
{
  public:
    Slipping(Channel& inner, const Slip slip) noexcept : Forwarding(inner), slip_(slip)
    {
    }
    void Meet(Memory& memory) noexcept
    {
        memory_ = &memory;
    }
    [[nodiscard]] DeviceDigest Digest(SlotIndex slot, DeviceDigest before) const noexcept override
    {
        DeviceDigest digest = Forwarding::Digest(slot, before);
        digest.value ^= (slip_ == Slip::kDigest) ? 1U : 0U;
        return digest;
    }
    [[nodiscard]] CycleOutcome OnCycle(const CycleInput& input) noexcept override
    {
        CycleOutcome outcome = Forwarding::OnCycle(input);
        outcome.fresh ^= (slip_ == Slip::kOutcome) ? 1U : 0U;
        return outcome;
    }
    [[nodiscard]] PreparedPair Prepare(SlotIndex slot) noexcept override
    {
        PreparedPair pair = Forwarding::Prepare(slot);
        pair.normal.data[0] ^= (slip_ == Slip::kPrepared && pair.status == PrepareStatus::kReady) ? 1U : 0U;
        return pair;
    }
    [[nodiscard]] CanFrame InverseFrame(SlotIndex slot) const noexcept override
    {
        CanFrame frame = Forwarding::InverseFrame(slot);
        ++asked_;
        const bool is_second = (asked_ % 2U) == 0U && frame.kind == FrameKind::kData;
        frame.data[0] ^= (slip_ == Slip::kInverseOfTheSecondCall && is_second) ? 1U : 0U;
        return frame;
    }
    [[nodiscard]] SrdoMask Commit(const Agreement& agreement, SrdoMask examine) noexcept override
    {
        const SrdoMask found = Forwarding::Commit(agreement, examine);
        memory_->bytes[Memory::kInverseAt] ^= (slip_ == Slip::kOwnObject) ? 1U : 0U;
        memory_->bytes[0U] ^= (slip_ == Slip::kForeignObject) ? 1U : 0U;
        memory_->bytes[Memory::kSlotBytes - 1U] ^= (slip_ == Slip::kByteBehind) ? 1U : 0U;
        return found;
    }

  private:
    Slip slip_;
    Memory* memory_{nullptr};
    mutable std::uint32_t asked_{0U};
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

TEST(DifferentialRun, FindsEachKindOfDifferenceByItsName)
{
    Verifies(req::SRS_CNF_010);
    struct Row
    {
        Slip slip;
        const char* field;
    };
    constexpr Row kRows[] = {{Slip::kDigest, "digest"},
                             {Slip::kOutcome, "fresh"},
                             {Slip::kPrepared, "data of the frame"},
                             {Slip::kInverseOfTheSecondCall, "data of the frame"},
                             {Slip::kOwnObject, "object of A, complement of B's"},
                             {Slip::kForeignObject, "normal object in B's memory"},
                             {Slip::kByteBehind, "byte behind the objects in B's memory"}};
    for (const Row& row : kRows)
    {
        // Given a channel with one slip, when sequences are fed, then the first difference is that
        const auto parts = std::make_unique<Parts>();
        Slipping slipping{parts->b, row.slip};
        const auto run = std::make_unique<Differential>(parts->a, slipping, parts->listener);
        slipping.Meet(run->Driven().memory_b);
        EXPECT_EQ(RunDifferential(*run, 1U, 0U, kSequences, 1U).failures, 1U) << row.field;
        ASSERT_EQ(parts->listener.count, 1U) << row.field;
        EXPECT_STREQ(parts->listener.last.field, row.field);
    }
    // and the same channel without one agrees
    const auto parts = std::make_unique<Parts>();
    Slipping none{parts->b, Slip::kNone};
    const auto run = std::make_unique<Differential>(parts->a, none, parts->listener);
    none.Meet(run->Driven().memory_b);
    EXPECT_EQ(RunDifferential(*run, 1U, 0U, 300U, 1U).failures, 0U);
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
