// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The conformance machinery itself: it counts, names what failed, and sees what a channel does otherwise.
#include "verification/conformance/cases.hpp"
#include "verification/conformance/flip_rig.hpp"
#include "verification/conformance/forwarding.hpp"
#include "verification/conformance/runner.hpp"
#include "verification/conformance/twisting.hpp"
#include "verification/trace/ids/conformance.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace counterpoint::conformance
{
namespace
{

class Listener final : public Reporter
{
  public:
    void OnFailure(const Failure& failure) noexcept override
    {
        ++count;
        if (count == 1U)
        {
            first = failure;
        }
        cases.insert({failure.case_name, failure.origin});
    }

    Failure first{};
    std::uint32_t count{0U};
    std::set<std::pair<std::string, std::uint32_t>> cases{};
};

/// Takes one microsecond more than SCT and SRVT allow: it shows every stamp of a frame to be a microsecond earlier.
class Generous final : public Forwarding
{
  public:
    using Forwarding::Forwarding;

    void OnFrame(const CanFrame& frame, Instant stamp) noexcept override
    {
        const bool is_inverse = (frame.identifier & 1U) == 0U;
        Forwarding::OnFrame(frame, Instant{stamp.us - (is_inverse ? 1U : 0U)});
    }
};

/// Treats time as if it never wrapped.
class Unwrapped final : public Forwarding
{
  public:
    using Forwarding::Forwarding;

    void OnFrame(const CanFrame& frame, Instant stamp) noexcept override
    {
        Forwarding::OnFrame(frame, Instant{(stamp.us < 0x10000000U) ? (stamp.us + 7U) : stamp.us});
    }
};

/// Treats time beyond half the range of the counter as a later one.
class Halved final : public Forwarding
{
  public:
    using Forwarding::Forwarding;

    void OnFrame(const CanFrame& frame, Instant stamp) noexcept override
    {
        const bool is_beyond = (stamp.us >= 0x80000000U) && (stamp.us < 0x90000000U);
        Forwarding::OnFrame(frame, Instant{stamp.us + (is_beyond ? 7U : 0U)});
    }
};

struct Parts
{
    channel_a::StorageFor<kMaxSrdoCount, kMaxMapEntries> storage{};
    channel_a::Channel channel{storage.Handle()};
    Listener listener{};
};

std::uint32_t CaseCount()
{
    std::uint32_t count = 0U;
    for (std::uint32_t table = 0U; table < kTableCount; ++table)
    {
        count += kAllTables[table]->count;
    }
    return count;
}

const Case& Find(const std::string& name)
{
    for (std::uint32_t table = 0U; table < kTableCount; ++table)
    {
        for (std::uint32_t i = 0U; i < kAllTables[table]->count; ++i)
        {
            if (name == kAllTables[table]->cases[i].name)
            {
                return kAllTables[table]->cases[i];
            }
        }
    }
    ADD_FAILURE() << "no case " << name;
    return kAllTables[0]->cases[0];
}

TEST(ConformanceRun, CountsEveryCaseAtEveryOriginAndRepeatsItsHash)
{
    Verifies(req::SRS_CNF_002);
    Verifies(req::SRS_CNF_004);
    // Given channel A
    const auto parts = std::make_unique<Parts>();
    const auto first = std::make_unique<Runner>(parts->channel, Party::kA, parts->listener);
    const auto second = std::make_unique<Runner>(parts->channel, Party::kA, parts->listener);
    // When the whole table runs twice
    const RunResult one = RunConformance(*first);
    const RunResult two = RunConformance(*second);
    // Then every case ran at three origins, without a failure, with the same hash
    EXPECT_EQ(one.cases, 3U * CaseCount());
    EXPECT_GT(one.cases, 1300U);
    EXPECT_EQ(one.failures, 0U);
    EXPECT_EQ(one.hash, two.hash);
}

TEST(ConformanceRun, HashSeesAnObjectThatNoExpectationNames)
{
    Verifies(req::SRS_CNF_002);
    const auto parts = std::make_unique<Parts>();
    const Case& whole = Find("PairIsTakenAndReleased");
    const auto runner = std::make_unique<Runner>(parts->channel, Party::kA, parts->listener);
    ASSERT_TRUE(runner->Run(whole, 0U));
    // When a channel also changes the last object of the device, which the case does not look at
    class Scribbling final : public Forwarding
    {
      public:
        using Forwarding::Forwarding;
        void Restart(const DeviceConfig& config) noexcept override
        {
            last_ = config.objects[config.object_count - 1U].place;
            Forwarding::Restart(config);
        }
        [[nodiscard]] CycleOutcome OnCycle(const CycleInput& input) noexcept override
        {
            *last_ = 0x42U;
            return Forwarding::OnCycle(input);
        }

      private:
        std::uint8_t* last_{nullptr};
    };
    Scribbling scribbling{parts->channel};
    const auto other = std::make_unique<Runner>(scribbling, Party::kA, parts->listener);
    // Then the case still passes, but the hash differs
    EXPECT_TRUE(other->Run(whole, 0U));
    EXPECT_NE(runner->HashValue(), other->HashValue());
}

TEST(ConformanceRun, HashSeesWhatNoExpectationNames)
{
    Verifies(req::SRS_CNF_002);
    // Given a case, once as it is and once without its expectations on masks
    const auto parts = std::make_unique<Parts>();
    const Case& whole = Find("PairIsTakenAndReleased");
    const auto runner = std::make_unique<Runner>(parts->channel, Party::kA, parts->listener);
    ASSERT_TRUE(runner->Run(whole, 0U));
    // When a channel behaves otherwise in a way that this case does not check
    class Noisy final : public Forwarding
    {
      public:
        using Forwarding::Forwarding;
        [[nodiscard]] CycleOutcome OnCycle(const CycleInput& input) noexcept override
        {
            CycleOutcome outcome = Forwarding::OnCycle(input);
            outcome.due |= SrdoMask{1U} << 40U;
            return outcome;
        }
    };
    Noisy noisy{parts->channel};
    const auto other = std::make_unique<Runner>(noisy, Party::kA, parts->listener);
    // Then the case still passes, but the hash differs
    EXPECT_TRUE(other->Run(whole, 0U));
    EXPECT_NE(runner->HashValue(), other->HashValue());
}

std::uint32_t HashBehind(std::uint32_t place)
{
    const auto parts = std::make_unique<Parts>();
    Twisting twisting{parts->channel, place};
    const auto runner = std::make_unique<Runner>(twisting, Party::kA, parts->listener);
    for (const char* const name :
         {"DefaultsOfNode1", "DigestOfABareDevice", "RuleDirection", "StaticMapping", "NumbersWithGaps", "PairIsSent"})
    {
        static_cast<void>(runner->Run(Find(name), 0U));
    }
    return runner->HashValue();
}

TEST(ConformanceRun, HashSeesEachNumberThatTheChannelReturns)
{
    Verifies(req::SRS_CNF_002);
    // Given cases with every call, when one number of all that the channel returns is another one, so is the hash
    const std::uint32_t sound = HashBehind(Twisting::kPlaces);
    for (std::uint32_t place = 0U; place < Twisting::kPlaces; ++place)
    {
        EXPECT_NE(HashBehind(place), sound) << place;
    }
    EXPECT_EQ(HashBehind(Twisting::kPlaces), sound);
}

TEST(ConformanceRun, RefreshOfWhatCannotRefreshIsTold)
{
    Verifies(req::SRS_CNF_003);
    // Given a channel that shows a refresh of a consumer, and a case that expects nothing of that mask
    class Eager final : public Forwarding
    {
      public:
        using Forwarding::Forwarding;
        [[nodiscard]] CycleOutcome OnCycle(const CycleInput& input) noexcept override
        {
            CycleOutcome outcome = Forwarding::OnCycle(input);
            outcome.refresh |= 1U;
            return outcome;
        }
    };
    const auto parts = std::make_unique<Parts>();
    Eager eager{parts->channel};
    const auto runner = std::make_unique<Runner>(eager, Party::kA, parts->listener);
    // Then the case fails by its views
    EXPECT_FALSE(runner->Run(Find("PairIsTakenAndReleased"), 0U));
    EXPECT_STREQ(parts->listener.first.field, "refresh of no active producer whose provider is called");
}

TEST(ConformanceRun, NamesTheFailedExpectation)
{
    Verifies(req::SRS_CNF_003);
    // Given a channel that allows a microsecond too much
    const auto parts = std::make_unique<Parts>();
    Generous generous{parts->channel};
    const auto runner = std::make_unique<Runner>(generous, Party::kA, parts->listener);
    // When SRVT is over by one microsecond
    EXPECT_FALSE(runner->Run(Find("SrvtOneMicrosecondOver"), 0U));
    // Then the first failure is the state of the slot in step 5
    EXPECT_STREQ(parts->listener.first.case_name, "SrvtOneMicrosecondOver");
    EXPECT_STREQ(parts->listener.first.field, "state");
    EXPECT_EQ(parts->listener.first.step, 5U);
    EXPECT_EQ(parts->listener.first.expected, 0x48U);
    EXPECT_EQ(parts->listener.first.got, 0x24U);
}

TEST(ConformanceRun, OneCaseIsOneFailure)
{
    Verifies(req::SRS_CNF_002);
    Verifies(req::SRS_CNF_003);
    const auto parts = std::make_unique<Parts>();
    Generous generous{parts->channel};
    const auto runner = std::make_unique<Runner>(generous, Party::kA, parts->listener);
    const RunResult result = RunConformance(*runner);
    EXPECT_GT(result.failures, 0U);
    EXPECT_LT(result.failures, parts->listener.count);
    EXPECT_EQ(result.failures, parts->listener.cases.size());
}

TEST(ConformanceRun, OriginsFindTimeThatDoesNotWrap)
{
    Verifies(req::SRS_CNF_004);
    // Given a channel that sees stamps otherwise once the counter has wrapped
    const auto parts = std::make_unique<Parts>();
    Unwrapped unwrapped{parts->channel};
    const auto runner = std::make_unique<Runner>(unwrapped, Party::kA, parts->listener);
    // Then the same case passes where all stamps are alike, and fails across the wrap
    const Case& on_limit = Find("SctOnTheLimitAtNormalFrame");
    EXPECT_TRUE(runner->Run(on_limit, kOrigins[2]));
    EXPECT_FALSE(runner->Run(on_limit, kOrigins[1]));
}

TEST(ConformanceRun, OriginsFindTimeThatChangesAtHalfTheRange)
{
    Verifies(req::SRS_CNF_004);
    // Given a channel that sees stamps otherwise beyond half the range of the counter
    const auto parts = std::make_unique<Parts>();
    Halved halved{parts->channel};
    const auto runner = std::make_unique<Runner>(halved, Party::kA, parts->listener);
    // Then the same case passes where all stamps are alike, the wrap included, and fails across the half
    const Case& on_limit = Find("SctOnTheLimitAtNormalFrame");
    EXPECT_TRUE(runner->Run(on_limit, kOrigins[0]));
    EXPECT_TRUE(runner->Run(on_limit, kOrigins[1]));
    EXPECT_FALSE(runner->Run(on_limit, kOrigins[2]));
}

TEST(ConformanceTable, NamesAreUniqueAndEveryCaseNamesARequirement)
{
    Verifies(req::SRS_CNF_001);
    std::set<std::string> names;
    for (std::uint32_t table = 0U; table < kTableCount; ++table)
    {
        for (std::uint32_t i = 0U; i < kAllTables[table]->count; ++i)
        {
            const Case& test = kAllTables[table]->cases[i];
            EXPECT_TRUE(names.insert(test.name).second) << test.name;
            EXPECT_NE(test.requirements[0].text, nullptr) << test.name;
            EXPECT_GE(test.step_count, 2U) << test.name;
        }
    }
}

TEST(ConformanceTable, HoldsTheKnownDefectsAndNoOthers)
{
    Verifies(req::SRS_CNF_007);
    std::set<std::string> names;
    for (std::uint32_t i = 0U; i < kDefectCases.count; ++i)
    {
        names.insert(kDefectCases.cases[i].name);
    }
    EXPECT_EQ(names, (std::set<std::string>{
                         "T2_SrvtAboveSct", "T3_DuplicateNormalFrame", "T4_InverseFrameFirstIsSilent",
                         "T5_LatchedUntilNmt", "T6_ShortFrameLatched", "T7_SctMaskedByALateCall",
                         "T8_LastValueAfterATimeOut", "T9_DummyMappingHalfAccepted", "T10_OnlyTotalsCompared",
                         "T11_SameObjectNormalAndInverse", "T12_RefreshDrifts", "T13_OneFullQueueLatches",
                         "T14_CorruptionInOperational", "T15_Direction3", "T19_SrvtMaskedByALateCall",
                         "Ovf_MapCountAboveTheMemory", "IdentifiersNotUnique", "CauseReplacedByATimeOut"}));
}

TEST(ConformanceTable, HoldsTheVectors)
{
    Verifies(req::SRS_CNF_006);
    for (const char* const name :
         {"VectorGold", "VectorA", "VectorB", "VectorC", "VectorD", "VectorE", "VectorF", "NegativeVectorsOfGold"})
    {
        EXPECT_STREQ(Find(name).name, name);
    }
}

/// Each limit of the channels, and the cases that stand just inside, on and just outside of it.
struct LimitCases
{
    const char* limit;
    std::vector<const char*> cases;
};

const LimitCases kLimits[] = {
    {"SCT at a frame", {"SctInsideAtNormalFrame", "SctOnTheLimitAtNormalFrame", "SctOneMicrosecondOverAtNormalFrame"}},
    {"SCT in the cycle", {"SctInTheCycle"}},
    {"SRVT at a frame", {"SrvtInside", "SrvtOnTheLimit", "SrvtOneMicrosecondOver"}},
    {"SRVT in the cycle", {"SrvtInTheCycle", "PairIsValidForSctPlusSrvt"}},
    {"longest and shortest limits", {"LongestLimits", "ShortestLimits"}},
    {"call supervision", {"LateCall", "FirstCallIsNeverLate"}},
    {"acknowledge window", {"AcknowledgeWindowOnTheLimit", "AcknowledgeWindowOver"}},
    {"waiting past SCT", {"WaitingPastSct"}},
    {"first transmission", {"PairIsSent", "FirstTransmissionOfNode127", "FirstTransmissionAfterReentering"}},
    {"refresh", {"RefreshKeepsItsPhase", "RefreshWaitsUntilPrepare"}},
    {"shortest and longest refresh time", {"ShortestRefreshTime", "LongestRefreshTime"}},
    {"silence of the application", {"SilentApplication", "SilenceAfterPrepare", "SilenceByEachOfItsTimes"}},
    {"shortest and longest SRVT of a producer",
     {"ConfirmationWithoutSrvt", "ConfirmationWithSrvtOfOneMillisecond", "ConfirmationWithTheLongestSrvt"}},
    {"confirmation of the normal frame",
     {"NormalFrameIsNotConfirmed", "ConfirmationsOnTheirLimits", "NormalFrameConfirmedTooLate"}},
    {"confirmation of the inverse frame",
     {"InverseFrameIsNotConfirmed", "InverseFrameConfirmedOnTheLimit", "InverseFrameConfirmedTooLate"}},
    {"length of a frame", {"LengthOfNormalFrame", "LengthOfInverseFrame", "LengthOfEightBytes"}},
    {"identifier of a frame", {"OtherIdentifiersNeverCount"}},
    {"error count", {"ErrorCountStaysAt65535", "ErrorCountOfAProducerStaysAt65535"}},
    {"number of SRDOs", {"SixtyFourPairsAtOnce", "FirstAndLastOfSixtyFour", "AddressesThatDoNotExist"}},
    {"direction", {"RuleDirection"}},
    {"transmission type", {"RuleTransmissionType"}},
    {"COB-IDs", {"RuleIdentifierRange", "RuleIdentifierPair"}},
    {"timing of a consumer", {"RuleTimingOfAConsumer"}},
    {"timing of a producer", {"RuleTimingOfAProducer", "RuleTimingOfAProducerInASlowCycle"}},
    {"map count", {"RuleMapCount", "RuleMapCountAtSixteen", "MapCountAt128", "RoomForFourEntries"}},
    {"entries of a mapping", {"Entries1To128", "RoomForTwoAndForSixEntries", "RoomForNoEntry"}},
    {"entries of a static mapping", {"StaticEntriesAreReadOnly", "StaticMappingOf130Entries"}},
    {"length of an entry",
     {"RuleEntryLength", "GranularityOfSixteenBits", "GranularityOfThirtyTwoBits", "GranularityOfSixtyFourBits",
      "GranularityOfOneBit", "GranularityOfEightBitsAndOddLengths", "CoarseGranularityAndOddLengths"}},
    {"length of a dummy", {"DummyTypes", "DummyTypesOfWrongLength", "DummyIndicesAndSubIndices"}},
    {"total length", {"RuleTotalLength", "GranularityOfOneBit", "DummyTotalLength", "StaticMappingTooLong"}},
    {"bits above the mapped length", {"BitsAboveTheLengthInTheNormalFrame", "BitsAboveTheLengthInTheInverseFrame"}},
    {"SRVT, late", {"LateSrvtInside", "LateSrvtOnTheLimit", "LateSrvtOneMicrosecondBehind"}},
    {"SCT at an inverse frame, late",
     {"LateSctInsideAtInverseFrame", "LateSctOnTheLimitAtInverseFrame", "LateSctBehindAtInverseFrame"}},
    {"SCT in the cycle, late", {"LateSctInTheCycleWithAPendingFrame", "LateSctRunsFromTheNormalFrame"}},
    {"earlier deadline, late",
     {"LateTieIsSrvt", "LateTieOnTheLimit", "LateSctIsEarlierOfBoth", "LateSrvtIsEarlierOfBoth"}},
    {"age of a pending frame", {"LatePendingForHalfARound", "LatePendingForAWholeRound"}},
    {"default COB-IDs by node-ID",
     {"DefaultsOfNode1", "DefaultsOfNode32", "DefaultsOfNode33", "DefaultsOfNode64", "DefaultsOfNode65",
      "DefaultsOfNode127"}},
    {"values of 13FEh and 1300h", {"NotActiveWithout13FEh", "GlobalFailsafeCommandNeeds1300h"}},
};

TEST(ConformanceTable, EveryLimitHasItsThreePoints)
{
    Verifies(req::SRS_CNF_005);
    for (const LimitCases& limit : kLimits)
    {
        for (const char* const name : limit.cases)
        {
            EXPECT_STREQ(Find(name).name, name) << limit.limit;
        }
    }
}

TEST(ConformanceTable, EveryObjectOfTheDictionaryHasItsPlace)
{
    Verifies(req::SRS_CNF_001);
    const auto dictionary = std::make_unique<Dictionary>();
    EXPECT_EQ(dictionary->Count(), Dictionary::kObjectCount);
    for (std::uint16_t i = 1U; i < Dictionary::kObjectCount; ++i)
    {
        const MappableObject& before = dictionary->Objects()[i - 1U];
        const MappableObject& object = dictionary->Objects()[i];
        EXPECT_TRUE((before.index < object.index) || ((before.index == object.index) && (before.sub < object.sub)))
            << i;
    }
}

TEST(FlipRig, GrantsInEveryKindOfDevice)
{
    Verifies(req::SRS_CNF_030);
    for (const RigKind kind : {RigKind::kBytes, RigKind::kFixed, RigKind::kBits})
    {
        FlipRig rig{ReleasePolicy::kAutomatic, kind};
        rig.Start();
        rig.Enter();
        rig.Pair(0xA5C3U, true);
        rig.Cycle(1000U);
        EXPECT_TRUE(rig.IsGranted()) << static_cast<int>(kind);
        EXPECT_TRUE(rig.Complaints().empty()) << rig.Complaints();
    }
}

TEST(FlipRig, ComplainsAboutDataThatNobodySent)
{
    Verifies(req::SRS_CNF_030);
    // Given a pair that both channels hold
    FlipRig rig{ReleasePolicy::kAutomatic};
    rig.Start();
    rig.Enter();
    rig.Pair(0x1111U, true);
    rig.Cycle(1000U);
    EXPECT_TRUE(rig.IsGranted());
    EXPECT_TRUE(rig.Complaints().empty());
    // When the rig is told that another pair was valid, while both channels still grant the first
    rig.WrongPair(0x2222U);
    rig.InverseOf(0x3333U);
    // Then nothing is granted, since both found the fault
    rig.Cycle(1000U);
    EXPECT_FALSE(rig.IsGranted());
    EXPECT_TRUE(rig.Complaints().empty());
    // When both are handed a valid pair of which the rig knows nothing, then it is granted, and the rig complains
    for (const Party party : {Party::kA, Party::kB})
    {
        const CanFrame normal{0x111U, FrameKind::kData, CanPortId::kFirst, 2U, {0x44U, 0x44U}};
        const CanFrame inverse{0x112U, FrameKind::kData, CanPortId::kFirst, 2U, {0xBBU, 0xBBU}};
        rig.Of(party).OnFrame(normal, Instant{5000U});
        rig.Of(party).OnFrame(inverse, Instant{5001U});
    }
    rig.Cycle(1000U);
    EXPECT_TRUE(rig.IsGranted());
    EXPECT_FALSE(rig.Complaints().empty());
}

TEST(FlipRig, ComplainsAboutAByteBesideAStorage)
{
    Verifies(req::SRS_CNF_030);
    for (const Party party : {Party::kA, Party::kB})
    {
        // Given the byte behind the storage of a channel, when it is written
        FlipRig rig{ReleasePolicy::kAutomatic};
        rig.Start();
        EXPECT_TRUE(rig.Complaints().empty()) << rig.Complaints();
        rig.Bytes(party)[FlipRig::ByteCount(party)] = 1U;
        // Then the next cycle tells it
        rig.Cycle(1000U);
        EXPECT_FALSE(rig.Complaints().empty());
    }
}

} // namespace
} // namespace counterpoint::conformance
