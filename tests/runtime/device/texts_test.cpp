// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Numbers and names as outputs tell them.
#include "runtime/device/model.hpp"
#include "runtime/device/names.hpp"
#include "runtime/device/time_text.hpp"
#include "verification/trace/ids/comfort.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::runtime
{
namespace
{
TEST(TimeTexts, TellTheMicrosecondsThatHavePassedInFull)
{
    Verifies(req::SRS_SIM_083);
    EXPECT_EQ(MillisecondsDigits(12345999), "12.345");
    EXPECT_EQ(MillisecondsDigits(999), "0.000");
    EXPECT_EQ(MillisecondsDigits(1000), "0.001");
    EXPECT_EQ(MillisecondsDigits(-999), "0.000");
    EXPECT_EQ(MillisecondsDigits(-1000), "-0.001");
    EXPECT_EQ(MillisecondsDigits(-12345678), "-12.345");
    EXPECT_EQ(MillisecondsText(12345999), "12.345 ms");
    EXPECT_EQ(MillisecondsText(12300000), "12.3 ms");
    EXPECT_EQ(MillisecondsText(12000000), "12 ms");
    EXPECT_EQ(MillisecondsText(100000000), "100 ms");
    EXPECT_EQ(MillisecondsColumn(12345999, 8U), "  12.345 ms");
    EXPECT_EQ(MillisecondsColumn(12345999, 6U), "12.345 ms");
    EXPECT_EQ(MillisecondsColumn(12345999, 5U), "12.345 ms");
}

TEST(TimeTexts, TellATimeThatIsRefusedAsItIs)
{
    Verifies(req::SRS_SIM_491);
    EXPECT_EQ(ExactText(100), "100 ns");
    EXPECT_EQ(ExactText(100000000), "100 ms");
    EXPECT_EQ(ExactText(100000001), "100000001 ns");
    EXPECT_EQ(ExactText(1000), "0.001 ms");
    EXPECT_EQ(ExactText(0), "0 ms");
}

TEST(NameTexts, AreThoseOfFilesAndOutputs)
{
    Verifies(req::SRS_SIM_040);
    EXPECT_STREQ(Name(SrdoCause::kNotInverse), "not_inverse");
    EXPECT_STREQ(Name(DeviceFault::kInvalid), "latch_corrupted");
    EXPECT_STREQ(Name(NmtState::kOperational), "operational");
    EXPECT_STREQ(Name(static_cast<SrdoCause>(0xEEU)), "invalid");
    EXPECT_STREQ(NameOf(kStateWords, static_cast<SrdoState>(0xEEU), "none of them"), "none of them");
    EXPECT_EQ(ObjectText({0x2000U, 1U}), "0x2000:01");
    EXPECT_EQ(IdentifierText(0x101U), "0x101");
}

TEST(NameTexts, SayWhyAKernelDoesNotStart)
{
    Verifies(req::SRS_EASE_007);
    EXPECT_EQ(NoStartText(StartResult::kSrdoNumbers),
              "the kernel refuses this device: srdo numbers (Not 1 to 64 in ascending order, or with a gap where gaps "
              "are refused)");
    EXPECT_EQ(NoStartText(StartResult::kInvalid).find("the kernel refuses this device: invalid"), 0U);
    EXPECT_EQ(Words("queue_overflow"), "queue overflow");
}

TEST(AbortTexts, HaveTheNumberOfTheStandardAndAMeaning)
{
    Verifies(req::SRS_SIM_002);
    EXPECT_EQ(AbortText(AbortCode::kValueRange), "0609 0030h");
    EXPECT_EQ(AbortText(AbortCode::kNone), "0000 0000h");
}

TEST(WritesOfAMaster, AreLittleEndian)
{
    Verifies(req::SRS_SIM_002);
    const ObjectData data = DataOf({{0x1301U, 5U}, 0x12345678U, 4U, {}});
    EXPECT_EQ(data.size_bytes, 4U);
    EXPECT_EQ(data.bytes[0], 0x78U);
    EXPECT_EQ(data.bytes[3], 0x12U);
    EXPECT_EQ(DataOf({{0x1301U, 2U}, 0x12345678U, 2U, {}}).bytes[2], 0x00U);
}
} // namespace
} // namespace counterpoint::runtime
