// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/text/html_text.hpp"
#include "verification/trace/ids/monitor.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::cia306
{
namespace
{
// Given text with what a page would take for its own, letters of UTF-8, and bytes that are none, then the page shows
// the text, and a question mark for each such byte.
TEST(HtmlText, ShowsTextAsItIs)
{
    Verifies(req::SRS_MON_011);
    Verifies(req::SRS_SIM_043);
    EXPECT_EQ(HtmlText("<b>a & \"b\"</b>"), "&lt;b&gt;a &amp; &quot;b&quot;&lt;/b&gt;");
    EXPECT_EQ(HtmlText("T\xC3\xBCr \xE2\x82\xAC \xF0\x9F\x9A\xAA"), "T\xC3\xBCr \xE2\x82\xAC \xF0\x9F\x9A\xAA");
    EXPECT_EQ(HtmlText("T\xFCr\xE2\x82"), "T?r??");
    EXPECT_EQ(HtmlText(""), "");
}
} // namespace
} // namespace counterpoint::cia306
