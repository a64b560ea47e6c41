// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/text/ini_document.hpp"

#include "canopen/cia306/text/input_error.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace counterpoint::cia306
{
namespace
{
IniDocument Parse(const std::string& text)
{
    return IniDocument::Parse("f.eds", text);
}

TEST(IniDocument, ReadsSectionsKeysAndTheirLines)
{
    Verifies(req::SRS_EDS_001);
    const IniDocument document = Parse("[FileInfo]\nFileName=a.eds\n\n[1000]\nDataType=0x0007\n");
    ASSERT_EQ(document.Sections().size(), 2U);
    EXPECT_EQ(document.Sections()[1].name, "1000");
    EXPECT_EQ(document.Sections()[1].place.line, 4U);
    ASSERT_NE(document.Find("1000")->Find("DataType"), nullptr);
    EXPECT_EQ(document.Find("1000")->Find("DataType")->value, "0x0007");
    EXPECT_EQ(document.Find("1000")->Find("DataType")->place.line, 5U);
}

TEST(IniDocument, AcceptsEveryLineEndByteOrderMarkSpacesAndComments)
{
    Verifies(req::SRS_EDS_002);
    const IniDocument document =
        Parse("\xEF\xBB\xBF; head\r\n  [ A ]  \r\n\tKey \t= a value ; not a comment \n;x=1\n[B]\nk=v");
    ASSERT_EQ(document.Sections().size(), 2U);
    EXPECT_EQ(document.Find("A")->Find("Key")->value, "a value ; not a comment");
    EXPECT_EQ(document.Find("A")->Find("x"), nullptr);
    EXPECT_EQ(document.Find("B")->Find("k")->value, "v");
    EXPECT_TRUE(document.Warnings().empty());
}

TEST(IniDocument, ComparesNamesWithoutRegardToCase)
{
    Verifies(req::SRS_EDS_003);
    const IniDocument document = Parse("[DeviceINFO]\nSubNUMBER=1\n");
    ASSERT_NE(document.Find("deviceinfo"), nullptr);
    EXPECT_EQ(document.Find("DEVICEINFO")->Find("subnumber")->value, "1");
}

TEST(IniDocument, WritesBackEveryByte)
{
    Verifies(req::SRS_EDS_004);
    const std::string texts[] = {
        "\xEF\xBB\xBF[A]\r\nk = v \r\n;c\r\n\r\n[Unknown]\r\nOdd Key=\xE4\r\n",
        "[A]\nk=v",
        "",
        "\n\n \t\n[A]\n",
        "[A]\nmixed=1\r\nends=2\n",
    };
    for (const std::string& text : texts)
    {
        EXPECT_EQ(Parse(text).Text(), text);
    }
}

TEST(IniDocument, ReplacesOnlyTheValueOfAKeyThatIsThere)
{
    Verifies(req::SRS_EDS_005);
    const IniDocument before = Parse("[A]\r\n  k =  old  \r\nm=1\r\n");
    const IniDocument after = before.With({{"a", "K", "new", ""}}, {});
    EXPECT_EQ(after.Text(), "[A]\r\n  k =  new  \r\nm=1\r\n");
}

TEST(IniDocument, GivesAnEmptyKeyItsValue)
{
    Verifies(req::SRS_EDS_005);
    EXPECT_EQ(Parse("[A]\nk=\nm= \n").With({{"A", "k", "1", ""}, {"A", "m", "2", ""}}, {}).Text(), "[A]\nk=1\nm=2 \n");
}

TEST(IniDocument, AddsAKeyAfterTheOneThatIsNamedElseAtTheEndOfTheSection)
{
    Verifies(req::SRS_EDS_005);
    const IniDocument before = Parse("[A]\nd=1\ne=2\n\n[B]\nx=3");
    EXPECT_EQ(before.With({{"A", "k", "9", "d"}}, {}).Text(), "[A]\nd=1\nk=9\ne=2\n\n[B]\nx=3");
    EXPECT_EQ(before.With({{"A", "k", "9", "nothing"}}, {}).Text(), "[A]\nd=1\ne=2\nk=9\n\n[B]\nx=3");
    // A last line without an end gets one, because a line follows.
    EXPECT_EQ(before.With({{"B", "k", "9", ""}}, {}).Text(), "[A]\nd=1\ne=2\n\n[B]\nx=3\nk=9\n");
    EXPECT_EQ(Parse("[A]\r\n").With({{"A", "k", "9", ""}}, {}).Text(), "[A]\r\nk=9\r\n");
}

TEST(IniDocument, AddsASectionAfterAnother)
{
    Verifies(req::SRS_EDS_005);
    const IniDocument before = Parse("[A]\nd=1\n\n[B]\nx=3\n");
    const IniDocument after = before.With({}, {{"A", "AValue", {{"NrOfEntries", "1"}, {"1", "0x10"}}}});
    EXPECT_EQ(after.Text(), "[A]\nd=1\n\n[AValue]\nNrOfEntries=1\n1=0x10\n\n[B]\nx=3\n");
    EXPECT_EQ(after.Find("AValue")->Find("1")->value, "0x10");
}

TEST(IniDocument, RefusesToEditASectionThatIsNotThere)
{
    Verifies(req::SRS_EDS_005);
    EXPECT_THROW((void)Parse("[A]\n").With({{"B", "k", "1", ""}}, {}), std::invalid_argument);
}

TEST(IniDocument, WarnsOfOtherComments)
{
    Verifies(req::SRS_EDS_015);
    const IniDocument document = Parse("[A]\n#ParameterValue=0x2\n\x1A");
    ASSERT_EQ(document.Warnings().size(), 2U);
    EXPECT_EQ(FormatFinding("f.eds", document.Warnings()[0]),
              "f.eds:2:1: warning: a comment with '#' is no part of CiA 306, expected ';'; it is ignored");
    EXPECT_EQ(FormatFinding("f.eds", document.Warnings()[1]),
              "f.eds:3:1: warning: end-of-file character 1Ah, expected the end of the file");
    EXPECT_EQ(document.Find("A")->Find("ParameterValue"), nullptr);
}

TEST(IniDocument, NamesTheColumnOfSectionKeyAndValue)
{
    Verifies(req::SRS_EDS_340);
    const IniDocument document = Parse("\xEF\xBB\xBF [A]\n\tKey =\t x y \nlast=\n");
    const IniSection& section = *document.Find("A");
    EXPECT_EQ(section.place.column, 2U); // the byte order mark has none
    EXPECT_EQ(section.Find("Key")->name_place.column, 2U);
    EXPECT_EQ(section.Find("Key")->place.column, 9U);
    EXPECT_EQ(section.Find("last")->place.column, 6U); // where it would begin
}

TEST(IniDocument, LeavesOutACommentBehindTheNameOfASection)
{
    Verifies(req::SRS_EDS_035);
    const IniDocument document = Parse("[A] # one\n [B]; [two]\r\n[C]\t;\nk=v # w\n");
    ASSERT_EQ(document.Sections().size(), 3U);
    EXPECT_EQ(document.Sections()[1].name, "B");
    const std::string own = " behind the section name, expected it in a line of its own; it is ignored";
    ASSERT_EQ(document.Warnings().size(), 3U);
    EXPECT_EQ(FormatFinding("f.eds", document.Warnings()[0]), "f.eds:1:5: warning: a comment '# one'" + own);
    EXPECT_EQ(FormatFinding("f.eds", document.Warnings()[1]), "f.eds:2:5: warning: a comment '; [two]'" + own);
    EXPECT_EQ(FormatFinding("f.eds", document.Warnings()[2]), "f.eds:3:5: warning: a comment ';'" + own);
    // The value of a key may be a text: its reader knows
    EXPECT_EQ(document.Find("C")->Find("k")->value, "v # w");
    EXPECT_EQ(document.Find("C")->Find("k")->Bare(), "v");
    EXPECT_THROW((void)Parse("[A] one\n"), InputError);
    EXPECT_THROW((void)Parse("[A] one # two\n"), InputError);
}

TEST(IniDocument, KeepsTheCommentBehindAValueThatIsSet)
{
    Verifies(req::SRS_EDS_005);
    Verifies(req::SRS_EDS_035);
    const IniDocument before = Parse("[A]\nk= 0x1 \t# one\r\nm=;none\n");
    EXPECT_EQ(before.With({{"A", "k", "0x22", ""}, {"A", "m", "3", ""}}, {}).Text(),
              "[A]\nk= 0x22 \t# one\r\nm=3;none\n");
}

TEST(IniDocument, ShortensAndEscapesTextOfTheFileInMessages)
{
    Verifies(req::SRS_EDS_019);
    EXPECT_EQ(Quoted("plain"), "'plain'");
    EXPECT_EQ(Quoted("\x1B[31m\xC3\xA4"), "'\\x1B[31m\\xC3\\xA4'");
    EXPECT_EQ(Quoted(std::string(100U, 'a')), "'" + std::string(60U, 'a') + "...'");
    EXPECT_EQ(Quoted(std::string(60U, 'a')), "'" + std::string(60U, 'a') + "'");
    EXPECT_EQ(Printable("a\nb\x07"), "a\\x0Ab\\x07");
}

TEST(IniDocumentEdits, WhatIsLeftOutTakesItsLinesAndTheEmptyOneBehind)
{
    Verifies(req::SRS_EDS_004);
    const IniDocument document =
        Parse("[a]\r\nx=1\r\ny=2\r\n\r\n; of b\r\n[b]\r\n; inside\r\nz=3\r\n\r\n\r\n; last\r\n[c]\r\nw=4");
    EXPECT_EQ(document.Without({"B"}, {{"A", "X"}}).Text(), "[a]\r\ny=2\r\n\r\n; of b\r\n\r\n; last\r\n[c]\r\nw=4");
    EXPECT_EQ(document.Without({"c"}, {}).Text(),
              "[a]\r\nx=1\r\ny=2\r\n\r\n; of b\r\n[b]\r\n; inside\r\nz=3\r\n\r\n\r\n; last\r\n");
    EXPECT_EQ(document.Without({}, {}).Text(), document.Text());
    EXPECT_THROW((void)document.Without({"d"}, {}), std::invalid_argument);
    EXPECT_THROW((void)document.Without({}, {{"a", "z"}}), std::invalid_argument);
}
TEST(IniDocument, TextOfTwoBytesIsRefusedInBothOrders)
{
    Verifies(req::SRS_EDS_002);
    for (const char* const mark : {"\xFF\xFE", "\xFE\xFF"})
    {
        try
        {
            (void)IniDocument::Parse("f", mark);
            FAIL() << "no refusal";
        }
        catch (const InputError& error)
        {
            EXPECT_STREQ(error.what(),
                         "f:1:1: error: the text is UTF-16, expected 8-bit text (ASCII, Latin-1 or UTF-8)");
        }
    }
}

TEST(IniDocument, PlacesAndControlsInMessages)
{
    Verifies(req::SRS_EDS_036);
    Verifies(req::SRS_EDS_340);
    EXPECT_EQ(PlaceText("f", Place{0U, 0U}), "f");
    EXPECT_EQ(PlaceText("f", Place{3U, 0U}), "f:3");
    EXPECT_EQ(PlaceText("f", Place{3U, 7U}), "f:3:7");
    EXPECT_EQ(Printable("a\x7F"
                        "b\n"),
              "a\\x7Fb\\x0A");
    EXPECT_TRUE((Place{3U, 7U}) == (Place{3U, 7U}));
    EXPECT_FALSE((Place{3U, 7U}) == (Place{3U, 8U}));
    EXPECT_FALSE((Place{3U, 7U}) == (Place{4U, 7U}));
}

TEST(IniDocumentEdits, AnEmptyFirstLineEndsAsItDoes)
{
    Verifies(req::SRS_EDS_004);
    EXPECT_EQ(IniDocument::Parse("f", "\n[A]\nk=1\n").With({{"A", "m", "2", "k"}}, {}).Text(), "\n[A]\nk=1\nm=2\n");
    EXPECT_EQ(IniDocument::Parse("f", "\r\n[A]\r\nk=1\r\n").With({{"A", "m", "2", "k"}}, {}).Text(),
              "\r\n[A]\r\nk=1\r\nm=2\r\n");
}

TEST(IniDocumentEdits, WhatStandsDirectlyBehindASectionThatIsLeftOutStays)
{
    Verifies(req::SRS_EDS_004);
    EXPECT_EQ(IniDocument::Parse("f", "[A]\nk=1\n[B]\nm=2\n").Without({"A"}, {}).Text(), "[B]\nm=2\n");
    EXPECT_EQ(IniDocument::Parse("f", "[A]\nk=1\n\n[B]\nm=2").Without({"B"}, {}).Text(), "[A]\nk=1\n\n");
    EXPECT_TRUE(IniDocument::Parse("f", "").Sections().empty());
}

} // namespace
} // namespace counterpoint::cia306
