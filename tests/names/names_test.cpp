// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "names/canopen/cia301/base/abort_code.hpp"
#include "names/canopen/start_up/el6751/rows.hpp"
#include "names/hal/api/exception_record.hpp"
#include "names/safety_core/contract/device_fault.hpp"
#include "names/safety_core/contract/srdo.hpp"
#include "names/safety_core/kernel/start_check.hpp"
#include "runtime/device/names.hpp"
#include "verification/trace/ids/comfort.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint
{
namespace
{
static_assert(NameOf(SrdoCause::kSct)[0] == 's', "names are constants");

TEST(Names, AreTheEnumeratorsInLowerCase)
{
    Verifies(req::SRS_EASE_006);
    EXPECT_STREQ(NameOf(SrdoCause::kNone), "none");
    EXPECT_STREQ(NameOf(SrdoCause::kNotInverse), "not_inverse");
    EXPECT_STREQ(NameOf(SrdoCause::kSct), "sct");
    EXPECT_STREQ(NameOf(SrdoState::kReleased), "released");
    EXPECT_STREQ(NameOf(DeviceFault::kCrossLink), "cross_link");
    EXPECT_STREQ(NameOf(DeviceFault::kOutput), "output");
    EXPECT_STREQ(NameOf(cia301::SdoAbort::kNone), "none");
    EXPECT_STREQ(NameOf(hal::ExceptionCause::kDataAccess), "data_access");
}

TEST(Names, MeaningIsTheCommentOfTheEnumerator)
{
    Verifies(req::SRS_EASE_006);
    EXPECT_STREQ(MeaningOf(StartResult::kPorts), "Not kFirst or kSecond.");
    EXPECT_STREQ(MeaningOf(StartResult::kObjects), // Of two lines.
                 "Out of order, a length not 1 to 64, an access that there is not, no place, no table, more than 1024, "
                 "at 1300h to "
                 "13FFh, or at 0001h to 0007h beside dummy entries.");
    EXPECT_STREQ(MeaningOf(StartResult::kStarted), "");
    EXPECT_STREQ(MeaningOf(DeviceFault::kCrossLink), "The link to the other CPU is lost or wrong.");
}

TEST(Names, ValueThatNoEnumeratorHasIsUnknown)
{
    Verifies(req::SRS_EASE_006);
    EXPECT_STREQ(NameOf(static_cast<StartResult>(0xFFU)), "unknown");
    EXPECT_STREQ(MeaningOf(static_cast<StartResult>(0xFFU)), "");
}

TEST(Names, WordsOfFilesAreTheNames)
{
    Verifies(req::SRS_EASE_006);
    for (const runtime::Word<SrdoCause>& word : runtime::kCauseWords)
    {
        EXPECT_STREQ(word.text, NameOf(word.meaning));
    }
    for (const runtime::Word<SrdoState>& word : runtime::kStateWords)
    {
        EXPECT_STREQ(word.text, NameOf(word.meaning));
    }
}

TEST(NoStart, ReasonIsToldInWords)
{
    Verifies(req::SRS_EASE_007);
    EXPECT_EQ(runtime::NoStartText(StartResult::kSrdoCount),
              "the kernel refuses this device: srdo count (Not 1 to 64, or no setups)");
    EXPECT_EQ(runtime::NoStartText(StartResult::kStamps),
              "the kernel refuses this device: stamps (The HAL does not guarantee stamps)");
    EXPECT_EQ(runtime::NoStartText(StartResult::kInvalid), "the kernel refuses this device: invalid");
}
} // namespace
} // namespace counterpoint
