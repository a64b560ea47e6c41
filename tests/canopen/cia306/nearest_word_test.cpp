// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/text/nearest_word.hpp"
#include "verification/trace/ids/comfort.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::cia306
{
namespace
{
TEST(NearestWord, OneSlipInAShortWordIsNear)
{
    Verifies(req::SRS_EASE_001);
    EXPECT_EQ(DidYouMean("chck", {"sign", "check"}), " (did you mean 'check'?)");  // One missing.
    EXPECT_EQ(DidYouMean("signn", {"sign", "check"}), " (did you mean 'sign'?)");  // One too many.
    EXPECT_EQ(DidYouMean("chack", {"sign", "check"}), " (did you mean 'check'?)"); // Another one.
    EXPECT_EQ(DidYouMean("sgin", {"sign", "check"}), " (did you mean 'sign'?)");   // Two changed places.
    EXPECT_EQ(DidYouMean("sg", {"sig"}), " (did you mean 'sig'?)");
    EXPECT_EQ(DidYouMean("CHCK", {"sign", "check"}), " (did you mean 'check'?)");
}

TEST(NearestWord, TwoSlipsAreNearFromSixLettersOn)
{
    Verifies(req::SRS_EASE_001);
    EXPECT_EQ(DidYouMean("chekk", {"check"}), " (did you mean 'check'?)");
    EXPECT_EQ(DidYouMean("chakk", {"check"}), "");
    EXPECT_EQ(DidYouMean("mnitr", {"monitor"}), "");
    EXPECT_EQ(DidYouMean("monito", {"monitoring"}), "");
    EXPECT_EQ(DidYouMean("mnotor", {"monitor"}), " (did you mean 'monitor'?)");
    EXPECT_EQ(DidYouMean("simulat", {"simulate"}), " (did you mean 'simulate'?)");
    EXPECT_EQ(DidYouMean("smulat", {"simulate"}), " (did you mean 'simulate'?)");
    EXPECT_EQ(DidYouMean("smulet", {"simulate"}), "");
}

TEST(NearestWord, TheNearestOneIsNamedAndOfEquallyNearOnesTheFirst)
{
    Verifies(req::SRS_EASE_001);
    EXPECT_EQ(DidYouMean("granularty", {"granulary", "granularity"}), " (did you mean 'granulary'?)");
    EXPECT_EQ(DidYouMean("seconds_", {"second", "seconds"}), " (did you mean 'seconds'?)");
}

TEST(NearestWord, NothingIsMeantByWhatIsFarAwayEmptyOrEndless)
{
    Verifies(req::SRS_EASE_001);
    EXPECT_EQ(DidYouMean("frobnicate", {"sign", "check"}), "");
    EXPECT_EQ(DidYouMean("", {"sign", "a"}), "");
    EXPECT_EQ(DidYouMean("x", {"y"}), "");
    EXPECT_EQ(DidYouMean(std::string(100000U, 'a'), {"check"}), "");
    EXPECT_EQ(DidYouMean("sign", {}), "");
}
} // namespace
} // namespace counterpoint::cia306
