// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// In which ways frames, counters, inputs and messages are hit, and by which limits that is judged.
#include "verification/campaign/campaign_rig.hpp"
#include "verification/campaign/variants.hpp"

#include "hal/api/cross_link.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <string>

namespace counterpoint::campaign::test
{
namespace
{
constexpr const char* kSmall = "at: [500 ms]\nsample: 10\n";

using VariantsTest = CampaignTest;

TEST(Variants, OfAFrameAreAllThatTheBusCanMakeOfIt)
{
    Verifies(req::SRS_CMG_020);
    // Given a reach of 3 ms, which are 60 steps of 50 us, and three identifiers
    const auto of = [](const FaultKind kind) { return VariantsOf(Part::kBus, kind, 60U, 3U); };
    EXPECT_EQ(of(FaultKind::kLost), 6U); // One to four, all of its identifier, all of the bus.
    EXPECT_EQ(of(FaultKind::kRepeated), 60U);
    EXPECT_EQ(of(FaultKind::kInserted), 60U);
    EXPECT_EQ(of(FaultKind::kDelayed), 60U);
    EXPECT_EQ(of(FaultKind::kWrongOrder), 4U);
    EXPECT_EQ(of(FaultKind::kWrongLength), 8U);                // 0 to 8 but its own.
    EXPECT_EQ(of(FaultKind::kWrongIdentifier), 11U + 2U + 3U); // Bits, other identifiers, kinds of frames.
    // When 101h is masqueraded
    Recording recording;
    recording.identifiers = {0x101U, 0x102U, 0x103U};
    std::set<std::uint32_t> identifiers;
    std::set<FrameKind> kinds;
    for (std::uint32_t variant = 0U; variant < 16U; ++variant)
    {
        CanFrame frame{0x101U, FrameKind::kData, CanPortId::kFirst, 1U, {0x10U}};
        Masquerade(recording, variant, frame);
        EXPECT_NE(frame.identifier != 0x101U, frame.kind != FrameKind::kData) << variant;
        identifiers.insert(frame.identifier);
        kinds.insert(frame.kind);
    }
    // Then each identifier that differs in one bit comes, each other one of the recording, and each other kind
    for (std::uint32_t bit = 0U; bit < 11U; ++bit)
    {
        EXPECT_EQ(identifiers.count(0x101U ^ (1U << bit)), 1U) << bit;
    }
    EXPECT_EQ(identifiers.count(0x102U) + identifiers.count(0x103U), 2U);
    EXPECT_EQ(kinds, (std::set<FrameKind>{FrameKind::kData, FrameKind::kRemote, FrameKind::kExtended,
                                          FrameKind::kFlexibleDataRate}));
}

// SCT of 50 ms, SRVT of 20 ms, a cycle of 1.5 ms at the latest, output of 1 ms, a clock interval of 100 ms, and a drift
// of 0.5 ms in each begun one.
TEST_F(VariantsTest, FramesAndClocksHaveLimitsOfTheirOwn)
{
    Verifies(req::SRS_CMG_020);
    Verifies(req::SRS_CMG_023);
    const Limits limits = Session(PlanFile("plan.yaml", "actuator", kSmall)).Parts().limits;
    for (const FaultKind kind :
         {FaultKind::kLost, FaultKind::kRepeated, FaultKind::kInserted, FaultKind::kWrongOrder, FaultKind::kDelayed,
          FaultKind::kCorrupted, FaultKind::kWrongIdentifier, FaultKind::kPairForged})
    {
        EXPECT_EQ(limits.Of(Part::kBus, kind), 73000U) << WordOf(kind);
    }
    EXPECT_EQ(limits.Of(Part::kBus, FaultKind::kWrongLength), 3000U);
    for (const FaultKind kind : {FaultKind::kStopped, FaultKind::kFast, FaultKind::kSlow, FaultKind::kJump})
    {
        EXPECT_EQ(limits.Of(Part::kCounters, kind), 103500U) << WordOf(kind);
    }
}

// The same SRDO; both frames of a pair come within a millisecond.
TEST_F(VariantsTest, FrameIsJudgedByTheLimitOfItsOwnSrdoAndOfWhatIsWrongWithIt)
{
    Verifies(req::SRS_CMG_817);
    const Session session(PlanFile("plan.yaml", "actuator", kSmall));
    const Recording& recording = session.Scenario().Record();
    const RecordedPair& pair = recording.pairs[20U];
    const auto limit =
        [&session, &recording](const FaultKind kind, const std::size_t frame, const std::uint32_t variant)
    {
        Experiment fault;
        fault.part = Part::kBus;
        fault.kind = kind;
        fault.subject = frame;
        fault.variant = variant;
        return session.Parts().limits.Of(fault, recording);
    };
    // Where no normal frame comes any more SRVT does not count
    for (const std::uint32_t variant : {kLosesIdentifier, kLosesIdentifier + 1U})
    {
        EXPECT_EQ(limit(FaultKind::kLost, pair.normal, variant), 53000U) << variant;
        EXPECT_EQ(limit(FaultKind::kLost, pair.inverse, variant), 73000U) << variant;
    }
    EXPECT_EQ(limit(FaultKind::kLost, pair.normal, 0U), 73000U);
    // What comes later does something when it comes.
    EXPECT_EQ(limit(FaultKind::kDelayed, pair.normal, 199U), 83000U);
    // A frame that is wrong in itself is found when it comes, a normal one with its inverse one
    EXPECT_EQ(limit(FaultKind::kWrongLength, pair.normal, 0U), 3000U);
    EXPECT_EQ(limit(FaultKind::kCorrupted, pair.inverse, 0U), 3000U);
    EXPECT_GT(limit(FaultKind::kCorrupted, pair.normal, 0U), 3000U);
    EXPECT_LT(limit(FaultKind::kCorrupted, pair.normal, 0U), 4500U);
}

// Of two SRDOs each has its own limit, and whoever waits least has to close first.
TEST_F(VariantsTest, LongestSrdoIsNotTheLimitOfAll)
{
    Verifies(req::SRS_CMG_817);
    Limits limits;
    limits.bus = {{0x101U, 0x102U, 28000U, 30000U}, {0x103U, 0x104U, 304500U, 310000U}};
    Recording recording;
    for (const std::uint32_t identifier : {0x101U, 0x102U, 0x103U, 0x104U, 0x101U})
    {
        RecordedFrame frame;
        frame.stamped.frame = {identifier, FrameKind::kData, CanPortId::kFirst, 1U, {}};
        recording.frames.push_back(frame);
    }
    recording.identifiers = {0x101U, 0x102U, 0x103U, 0x104U};
    const auto limit = [&limits, &recording](const FaultKind kind, const std::size_t frame, const std::uint32_t variant)
    {
        Experiment fault;
        fault.part = Part::kBus;
        fault.kind = kind;
        fault.subject = frame;
        fault.variant = variant;
        return limits.Of(fault, recording);
    };
    EXPECT_EQ(limit(FaultKind::kRepeated, 0U, 0U), 30000U);
    EXPECT_EQ(limit(FaultKind::kRepeated, 2U, 0U), 310000U);
    EXPECT_EQ(limit(FaultKind::kLost, 0U, 1U), 30000U);  // Both frames of the first one,
    EXPECT_EQ(limit(FaultKind::kLost, 0U, 2U), 310000U); // and one of the second.
    EXPECT_EQ(limit(FaultKind::kLost, 2U, kLosesIdentifier), 304500U);
    EXPECT_EQ(limit(FaultKind::kLost, 2U, kLosesIdentifier + 1U), 28000U);
    EXPECT_EQ(limit(FaultKind::kLost, 1U, kLosesIdentifier + 1U), 30000U);
    EXPECT_EQ(limit(FaultKind::kWrongOrder, 1U, 0U), 310000U);
    EXPECT_EQ(limit(FaultKind::kWrongIdentifier, 0U, 1U), 310000U); // Bit 1: 103h.
}

TEST_F(VariantsTest, ReportTellsTheLimitsByWhichARowWasJudged)
{
    Verifies(req::SRS_CMG_818);
    // Given calls of channel A, of which what guard and comparator read is found by their own checks
    const Session session(PlanFile("plan.yaml", "actuator", "at: [500 ms]\nparts: [a_calls]\nkinds: [doubled]\n"));
    const Results results("", session.Identity(Shard{}));
    // When none is tried yet, the limit is that of the part;
    const Tally before = Summarise(session.Parts(), results).tallies.at(0U);
    EXPECT_EQ(before.least_limit_us, before.limit_us);
    EXPECT_EQ(LimitText(before), MsText(before.limit_us));
    // when all are, the report tells both.
    Results tried("", session.Identity(Shard{}));
    for (std::uint64_t number = 0U; number < session.Faults().Size(); ++number)
    {
        tried.Put(number, Outcome{Class::kMasked, Detector::kNobody, 0U, 0U, 0U});
    }
    const Tally behind = Summarise(session.Parts(), tried).tallies.at(0U);
    EXPECT_LT(behind.least_limit_us, behind.limit_us);
    EXPECT_EQ(LimitText(behind), MsText(behind.least_limit_us) + " to " + MsText(behind.limit_us));
}

TEST(Variants, OfACounterAreEachRateAndJumpBothWays)
{
    Verifies(req::SRS_CMG_023);
    const auto of = [](const FaultKind kind, const std::uint32_t variant)
    {
        Experiment fault;
        fault.part = Part::kCounters;
        fault.kind = kind;
        fault.variant = variant;
        return CounterFaultOf(fault);
    };
    // 100 ppm to 90 %
    ASSERT_EQ(VariantsOf(Part::kCounters, FaultKind::kFast, 0U, 0U), 13U);
    ASSERT_EQ(VariantsOf(Part::kCounters, FaultKind::kSlow, 0U, 0U), 13U);
    EXPECT_EQ(of(FaultKind::kFast, 0U).rate_ppm, 100);
    EXPECT_EQ(of(FaultKind::kFast, 12U).rate_ppm, 900000);
    EXPECT_EQ(of(FaultKind::kSlow, 0U).rate_ppm, -100);
    EXPECT_EQ(of(FaultKind::kSlow, 12U).rate_ppm, -900000);
    // 50 us to half of 2^32
    ASSERT_EQ(VariantsOf(Part::kCounters, FaultKind::kJump, 0U, 0U), 40U);
    EXPECT_EQ(of(FaultKind::kJump, 0U).jump_us, 50);
    EXPECT_EQ(of(FaultKind::kJump, 1U).jump_us, -50);
    EXPECT_EQ(of(FaultKind::kJump, 38U).jump_us, 2147483647);
    EXPECT_EQ(of(FaultKind::kJump, 39U).jump_us, -2147483647);
}

TEST_F(VariantsTest, InputsAreEachBitOfEitherSideAndTheAcknowledgeOfEachPath)
{
    Verifies(req::SRS_CMG_025);
    // Given the sensor, with two objects of 8 bits on two sides, and the actuator, which produces nothing
    const auto size = [this](const std::string& device)
    { return Session(PlanFile("plan.yaml", device, "at: [500 ms]\ncycles: 1\nparts: [inputs]\n")).Faults().Size(); };
    // Then each is held at 0 and at 1, and so is the acknowledge of each of two paths
    EXPECT_EQ(size("actuator"), 2U * 2U);
    EXPECT_EQ(size("sensor"), 2U * 8U * 2U * 2U);
}

TEST(Variants, OfAMessageAreAllThatTheLinkCanMakeOfIt)
{
    Verifies(req::SRS_CMG_062);
    const auto of = [](const FaultKind kind) { return VariantsOf(Part::kLink, kind, 60U, 0U); };
    EXPECT_EQ(of(FaultKind::kLost), 5U); // One to four, all.
    EXPECT_EQ(of(FaultKind::kRepeated), 60U);
    EXPECT_EQ(of(FaultKind::kDelayed), 60U);
    EXPECT_EQ(of(FaultKind::kWrongOrder), 4U);
    EXPECT_EQ(of(FaultKind::kCorrupted), std::uint64_t{hal::kLinkFrameBytes} * 8U);
}

TEST_F(VariantsTest, EachByteOfTheKernelIsInAPlace)
{
    Verifies(req::SRS_CMG_003);
    // Given the places of the kernel's members, by their offsets
    const Session session(PlanFile("plan.yaml", "actuator", kSmall));
    constexpr Part kOfKernel[] = {Part::kComparator, Part::kGuard, Part::kLatch, Part::kClocks, Part::kKernel};
    std::map<std::size_t, std::size_t> ends;
    for (const Place& place : session.Parts().device.Places())
    {
        const bool is_of_kernel =
            std::find(std::begin(kOfKernel), std::end(kOfKernel), place.part) != std::end(kOfKernel);
        if (is_of_kernel && place.name != "kernel.windows") // Which the kernel is handed.
        {
            ends[place.offset] = place.offset + place.size;
        }
    }
    // Then between two of them is no more than what the compiler fills up, and together they are all of it; the flow
    // monitor inside is not in use, as the kernel was handed another one
    std::size_t end = ends.begin()->first;
    std::size_t unused = 0U;
    for (const auto& [begin, behind] : ends)
    {
        const bool is_unused = (begin - end) >= sizeof(FlowMonitor);
        unused += is_unused ? 1U : 0U;
        EXPECT_LT(begin - end - (is_unused ? sizeof(FlowMonitor) : 0U), 8U) << begin;
        end = behind;
    }
    EXPECT_EQ(unused, 1U);
    EXPECT_LT(sizeof(Kernel) - (end - ends.begin()->first), 8U);
}

TEST_F(VariantsTest, PlacesOfADeviceAreAllPartsThatHaveMemory)
{
    Verifies(req::SRS_CMG_003);
    const Session session(PlanFile("plan.yaml", "actuator", kSmall));
    std::set<Part> parts;
    std::set<std::size_t> bytes;
    for (const Place& place : session.Parts().device.Places())
    {
        EXPECT_GT(place.size, 0U) << place.name;
        parts.insert(place.part);
        // Then no byte is in two of them
        for (std::size_t byte = 0U; byte < place.size; ++byte)
        {
            EXPECT_TRUE(bytes.insert(place.offset + byte).second) << place.name << "+" << byte;
        }
    }
    EXPECT_EQ(parts,
              (std::set<Part>{Part::kChannelA, Part::kChannelB, Part::kComparator, Part::kFlowMonitor, Part::kGuard,
                              Part::kLatch, Part::kClocks, Part::kKernel, Part::kTables, Part::kVariables}));
}

TEST_F(VariantsTest, PinsAreHitWhereTheyAreTheOutput)
{
    Verifies(req::SRS_CMG_042);
    const std::string lines = "at: [550 ms]\nparts: [pins]\nkinds: [flip]\nphases: [permits]\nmembers: [pins.live]\n";
    // 32 bits, each of which is found at the pins' next look
    const auto pins = Campaign({PlanFile("pins.yaml", "actuator", lines + "output: pins\ndetectors: [pins]\n")});
    EXPECT_EQ(pins.status, 0) << pins.out;
    EXPECT_NE(pins.out.find("found first by: pins 32\n"), std::string::npos) << pins.out;
    // and a device with the gate alone has none
    EXPECT_EQ(Campaign({PlanFile("gate.yaml", "actuator", lines)}).status, 2);
}

TEST_F(VariantsTest, CycleIsDelayedUpToTheReachAndAdvancedByLessThanACycle)
{
    Verifies(req::SRS_CMG_561);
    // Given one cycle of 1 ms, and a reach of 2 ms
    const auto size = [this](const std::string& kind, const std::string& reach)
    {
        return Session(PlanFile("plan.yaml", "actuator",
                                "at: [500 ms]\ncycles: 1\nparts: [cycle]\nkinds: [" + kind + "]\n" + reach))
            .Faults()
            .Size();
    };
    EXPECT_EQ(size("skipped", ""), 5U);
    EXPECT_EQ(size("doubled", ""), 1U);
    EXPECT_EQ(size("late", "reach: 2 ms\n"), 40U);
    EXPECT_EQ(size("early", ""), 19U); // 50 us to 950 us.
}

TEST_F(VariantsTest, CallsAreTheFirstFourOfEachFunctionInACycle)
{
    Verifies(req::SRS_CMG_022);
    // Given one cycle, two functions of the kernel and eleven of a channel
    const auto size = [this](const std::string& part, const std::string& kind)
    {
        return Session(PlanFile("plan.yaml", "actuator",
                                "at: [500 ms]\ncycles: 1\nparts: [" + part + "]\nkinds: [" + kind + "]\n"))
            .Faults()
            .Size();
    };
    // Then each of four calls is hit once and from then on; one that is left out answers what it did last, or nothing
    for (const char* const kind : {"doubled", "reordered", "late"})
    {
        EXPECT_EQ(size("kernel_calls", kind), 3U * 4U * 2U) << kind;
        EXPECT_EQ(size("a_calls", kind), 11U * 4U * 2U) << kind;
        EXPECT_EQ(size("b_calls", kind), 11U * 4U * 2U) << kind;
    }
    EXPECT_EQ(size("kernel_calls", "skipped"), 3U * 4U * 2U);
    EXPECT_EQ(size("a_calls", "skipped"), 11U * 4U * 2U * 2U);
    EXPECT_EQ(size("b_calls", "skipped"), 11U * 4U * 2U * 2U);
}
} // namespace
} // namespace counterpoint::campaign::test
