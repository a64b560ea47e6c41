// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/safety/contradictions.hpp"

#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/monitor.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::cia306
{
namespace
{
constexpr std::uint64_t kOff = 0U;
constexpr std::uint64_t kProducer = 1U;
constexpr std::uint64_t kConsumer = 2U;

/// SRDO 2 with the pair 101h and 102h, a time of 50 ms and one object of 8 bits, normal and inverse; each number has a
/// line of its own.
SrdoConfiguration Srdo(const std::uint64_t direction)
{
    SrdoConfiguration srdo;
    srdo.number = 2U;
    srdo.direction = {direction, {11U, 1U}};
    srdo.sct_ms = {50U, {12U, 1U}};
    srdo.cob_id_1 = {0x101U, {15U, 1U}};
    srdo.cob_id_2 = {0x102U, {16U, 1U}};
    srdo.entry_count = {2U, {20U, 1U}};
    srdo.mapping = {{1U, 0x20000108U, {21U, 1U}}, {2U, 0x21000108U, {22U, 1U}}};
    return srdo;
}

SrdoConfiguration WithTime(SrdoConfiguration srdo, const std::uint64_t time_ms)
{
    srdo.sct_ms.value = time_ms;
    return srdo;
}

SrdoConfiguration WithPair(SrdoConfiguration srdo, const std::uint64_t first, const std::uint64_t second)
{
    srdo.cob_id_1.value = first;
    srdo.cob_id_2.value = second;
    return srdo;
}

/// What an SRDO of device a and one of device b say differently.
std::vector<std::string> Between(const SrdoConfiguration& a, const SrdoConfiguration& b)
{
    std::vector<std::string> lines;
    for (const Contradiction& each : ContradictionsOf({{0U, "a", "a.dcf", &a}, {1U, "b", "b.dcf", &b}}))
    {
        lines.push_back(FormatFinding(each.file, each.finding));
    }
    return lines;
}

using Lines = std::vector<std::string>;

TEST(Contradictions, AProducerAndAConsumerThatFitSayNothing)
{
    Verifies(req::SRS_MON_020);
    Verifies(req::SRS_NET_060);
    EXPECT_EQ(Between(Srdo(kProducer), WithTime(Srdo(kConsumer), 51U)), Lines{});
    EXPECT_EQ(Between(WithTime(Srdo(kConsumer), 51U), Srdo(kProducer)), Lines{});
    // Two that receive the same pair
    EXPECT_EQ(Between(Srdo(kConsumer), Srdo(kConsumer)), Lines{});
}

TEST(Contradictions, OnlyDevicesThatShareAnIdentifierAreCompared)
{
    Verifies(req::SRS_MON_020);
    Verifies(req::SRS_NET_060);
    EXPECT_EQ(Between(Srdo(kProducer), WithPair(Srdo(kProducer), 0x103U, 0x104U)), Lines{});
    // Two SRDOs of one device are the matter of its own check
    const SrdoConfiguration one = Srdo(kProducer);
    EXPECT_TRUE(ContradictionsOf({{7U, "a", "a.dcf", &one}, {7U, "a", "a.dcf", &one}}).empty());
    EXPECT_TRUE(ContradictionsOf({}).empty());
}

TEST(Contradictions, PairsThatShareOneIdentifierAreTold)
{
    Verifies(req::SRS_MON_020);
    // Whatever else differs: the pair alone
    EXPECT_EQ(Between(Srdo(kProducer), WithPair(WithTime(Srdo(kConsumer), 1U), 0x101U, 0x104U)),
              Lines{"b.dcf:15:1: warning: 0x1302:05: identifiers 0x101 and 0x104, while a SRDO 2 has 0x101 and 0x102, "
                    "expected the same pair, or none of its identifiers"});
    EXPECT_EQ(Between(Srdo(kProducer), WithPair(Srdo(kConsumer), 0x102U, 0x101U)),
              Lines{"b.dcf:15:1: warning: 0x1302:05: identifiers 0x102 and 0x101, while a SRDO 2 has 0x101 and 0x102, "
                    "expected the same pair, or none of its identifiers"});
}

TEST(Contradictions, ASecondProducerIsTold)
{
    Verifies(req::SRS_MON_020);
    Verifies(req::SRS_NET_060);
    EXPECT_EQ(Between(Srdo(kProducer), Srdo(kProducer)),
              Lines{"b.dcf:11:1: warning: 0x1302:01: sends 0x101 and 0x102, which a SRDO 2 sends, too, expected one "
                    "producer"});
    EXPECT_EQ(Between(Srdo(kProducer), Srdo(kOff)), Lines{});
}

TEST(Contradictions, OtherMappedLengthsAreToldByTheNormalData)
{
    Verifies(req::SRS_MON_020);
    Verifies(req::SRS_NET_060);
    SrdoConfiguration longer = WithTime(Srdo(kConsumer), 51U);
    longer.mapping.push_back({3U, 0x20000210U, {23U, 1U}});
    EXPECT_EQ(Between(Srdo(kProducer), longer), Lines{"b.dcf:20:1: warning: 0x1382:00: 24 bits mapped, while a SRDO 2 "
                                                      "maps 8, expected the same length"});
    SrdoConfiguration inverse = WithTime(Srdo(kConsumer), 51U);
    inverse.mapping.push_back({4U, 0x21000210U, {24U, 1U}});
    EXPECT_EQ(Between(Srdo(kProducer), inverse), Lines{});
}

TEST(Contradictions, AnSctThatIsNotAboveTheRefreshTimeIsToldAtTheConsumer)
{
    Verifies(req::SRS_MON_020);
    Verifies(req::SRS_NET_060);
    EXPECT_EQ(
        Between(Srdo(kProducer), Srdo(kConsumer)),
        Lines{"b.dcf:12:1: warning: 0x1302:02: SCT 50 ms, while a SRDO 2 has a refresh time of 50 ms, expected an "
              "SCT above it"});
    EXPECT_EQ(
        Between(WithTime(Srdo(kConsumer), 49U), Srdo(kProducer)),
        Lines{"a.dcf:12:1: warning: 0x1302:02: SCT 49 ms, while b SRDO 2 has a refresh time of 50 ms, expected an "
              "SCT above it"});
}

TEST(Contradictions, EachDeviceIsComparedWithEachBeforeItInTheOrderOfTheEnds)
{
    Verifies(req::SRS_MON_020);
    const SrdoConfiguration one = Srdo(kProducer);
    const SrdoConfiguration other = WithPair(Srdo(kProducer), 0x103U, 0x104U);
    Lines found;
    for (const Contradiction& each : ContradictionsOf({{0U, "a", "a.dcf", &one},
                                                       {1U, "b", "b.dcf", &one},
                                                       {2U, "c", "c.dcf", &other},
                                                       {3U, "d", "d.dcf", &one}}))
    {
        EXPECT_EQ(each.finding.severity, Severity::kWarning);
        found.push_back(each.file + " " + each.finding.text);
    }
    EXPECT_EQ(found, (Lines{"b.dcf sends 0x101 and 0x102, which a SRDO 2 sends, too, expected one producer",
                            "d.dcf sends 0x101 and 0x102, which a SRDO 2 sends, too, expected one producer",
                            "d.dcf sends 0x101 and 0x102, which b SRDO 2 sends, too, expected one producer"}));
}
} // namespace
} // namespace counterpoint::cia306
