// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/yaml/document.hpp"
#include "tests/runtime/yaml/refusal.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace counterpoint::runtime
{
namespace
{
using test::RefusalOf;

/// A folder of its own for the files of a test.
class YamlFile : public ::testing::Test
{
  public:
    ~YamlFile() override
    {
        std::filesystem::remove_all(folder_);
    }

    [[nodiscard]] std::string With(const std::string& bytes) const
    {
        std::filesystem::create_directories(folder_);
        const std::string path = (folder_ / "a.yaml").string();
        std::ofstream(path, std::ios::binary) << bytes;
        return path;
    }

    /// The refusal of a file with these bytes, behind its path.
    [[nodiscard]] std::string RefusalOfBytes(const std::string& bytes) const
    {
        const std::string path = With(bytes);
        const std::string refusal = RefusalOf([&path] { return ReadYamlText(path); });
        return refusal.empty() ? "" : refusal.substr(path.size());
    }

    const std::filesystem::path folder_{std::filesystem::temp_directory_path() /
                                        ("yaml_file_test_" + std::to_string(::getpid()))};
};

std::string RefusalOfText(const std::string& text)
{
    return RefusalOf([&text] { return ParseYaml("a.yaml", text); });
}

TEST_F(YamlFile, IsReadWithLineEndsAndMarksOfAllEditors)
{
    Verifies(req::SRS_SIM_011);
    EXPECT_EQ(ReadYamlText(With("a: 1\nb: 2\n")), "a: 1\nb: 2\n");
    EXPECT_EQ(ReadYamlText(With("a: 1\r\nb: 2\r\n")), "a: 1\nb: 2\n");
    EXPECT_EQ(ReadYamlText(With("\xEF\xBB\xBF"
                                "a: 1\n")),
              "a: 1\n");
    EXPECT_EQ(ReadYamlText(With("")), "");
    // A return that ends no line is none of a text, nor is a mark that is not at the begin a special one
    EXPECT_EQ(RefusalOfBytes("a\rb"), ":1:2: error: byte 0xd, expected UTF-8 text");
    EXPECT_EQ(RefusalOfBytes("a: 1\r"), ":1:5: error: byte 0xd, expected UTF-8 text");
}

TEST_F(YamlFile, IsText)
{
    Verifies(req::SRS_SIM_010);
    // Characters of one to four bytes, tabulators
    const std::string text = "a\t~ \xC2\xA0 \xDF\xBF \xE0\xA0\x80 \xEF\xBF\xBD \xF0\x90\x80\x80 \xF4\x8F\xBF\xBF\n";
    EXPECT_EQ(ReadYamlText(With(text)), text);
    // Controls, and bytes that begin no character
    EXPECT_EQ(RefusalOfBytes("a\nbc\x01"), ":2:3: error: byte 0x1, expected UTF-8 text");
    EXPECT_EQ(RefusalOfBytes("\x7F"), ":1:1: error: byte 0x7f, expected UTF-8 text");
    EXPECT_EQ(RefusalOfBytes("\x80"), ":1:1: error: byte 0x80, expected UTF-8 text");
    EXPECT_EQ(RefusalOfBytes("\xC1\x80"), ":1:1: error: byte 0xc1, expected UTF-8 text");
    EXPECT_EQ(RefusalOfBytes("\xF5\x80\x80\x80"), ":1:1: error: byte 0xf5, expected UTF-8 text");
    // Characters that end too early, by the end of the file and by another one
    EXPECT_EQ(RefusalOfBytes("\xC3\xA4\xC3"), ":1:2: error: byte 0xc3, expected UTF-8 text");
    EXPECT_EQ(RefusalOfBytes("\xE2\x82"), ":1:1: error: byte 0xe2, expected UTF-8 text");
    EXPECT_EQ(RefusalOfBytes("\xF0\x9F\x98"), ":1:1: error: byte 0xf0, expected UTF-8 text");
    EXPECT_EQ(RefusalOfBytes("\xC3zz"), ":1:1: error: byte 0xc3, expected UTF-8 text");
    EXPECT_EQ(RefusalOfBytes("\xE2\x82z"), ":1:1: error: byte 0xe2, expected UTF-8 text");
}

TEST_F(YamlFile, IsARegularOneOfAtMostAMebibyte)
{
    Verifies(req::SRS_SIM_010);
    EXPECT_EQ(RefusalOf([] { return ReadYamlText("/no/such/file.yaml"); }),
              "/no/such/file.yaml: error: no such file, expected a YAML file");
    const std::string folder = std::filesystem::path(With("")).parent_path().string();
    EXPECT_EQ(RefusalOf([&folder] { return ReadYamlText(folder); }),
              folder + ": error: not a regular file, expected a YAML file");
    // A name of which no system has a file
    const std::string name = folder + "/" + std::string(300U, 'a');
    EXPECT_EQ(RefusalOf([&name] { return ReadYamlText(name); }),
              name + ": error: cannot be opened (File name too long), expected a readable file");
    EXPECT_EQ(ReadYamlText(With(std::string(1048576U, 'a'))).size(), 1048576U);
    EXPECT_EQ(RefusalOfBytes(std::string(1048577U, 'a')), ": error: 1048577 bytes, expected at most 1048576");
}

TEST(YamlDocument, HasNodesWithTheirPlaces)
{
    Verifies(req::SRS_SIM_010);
    const YamlNode root = ParseYaml("a.yaml", "a: 1\nlist:\n  - 'b'\n  - {c: d}\n  -\n");
    ASSERT_EQ(root.kind, YamlKind::kMap);
    ASSERT_EQ(root.items.size(), 4U);
    EXPECT_EQ(root.items[0].scalar, "a");
    EXPECT_EQ(root.items[1].scalar, "1");
    EXPECT_EQ(root.items[1].place.line, 1U);
    EXPECT_EQ(root.items[1].place.column, 4U);
    EXPECT_FALSE(root.items[1].is_quoted);
    const YamlNode& list = root.items[3];
    ASSERT_EQ(list.kind, YamlKind::kSequence);
    ASSERT_EQ(list.items.size(), 3U);
    EXPECT_TRUE(list.items[0].is_quoted);
    EXPECT_EQ(list.items[0].scalar, "b");
    EXPECT_EQ(list.items[1].kind, YamlKind::kMap);
    EXPECT_EQ(list.items[2].kind, YamlKind::kNull);
}

TEST(YamlDocument, IsOneWithoutAliasesAndTags)
{
    Verifies(req::SRS_SIM_010);
    EXPECT_EQ(RefusalOfText(""), "a.yaml:1:1: error: no document, expected a map of keys and values");
    EXPECT_EQ(RefusalOfText("a: 1\n---\nb: 2\n"), "a.yaml:3:1: error: a second document, expected one document");
    EXPECT_EQ(RefusalOfText("a: &x 1\nb: *x\n"),
              "a.yaml:2:4: error: alias, expected the value itself; aliases are not allowed");
    EXPECT_EQ(RefusalOfText("a: !!str 1\n"),
              "a.yaml:1:4: error: tag 'tag:yaml.org,2002:str', expected a value without a tag");
    EXPECT_EQ(RefusalOfText("a: !own [1]\n"), "a.yaml:1:4: error: tag '!own', expected a value without a tag");
    EXPECT_EQ(RefusalOfText("a: [1\n").find("a.yaml:2:1: error: not YAML: "), 0U) << RefusalOfText("a: [1\n");
}

TEST(YamlDocument, HasAtMost50000NodesIn12Levels)
{
    Verifies(req::SRS_SIM_012);
    // Given a list with 49999 values, which is a node too
    std::string list = "[1";
    for (int count = 1; count < 49999; ++count)
    {
        list += ",1";
    }
    EXPECT_EQ(RefusalOfText(list + "]"), "");
    EXPECT_EQ(RefusalOfText(list + ",1]"), "a.yaml:1:100000: error: too many values, expected at most 50000");
    // Given lists in lists
    EXPECT_EQ(RefusalOfText(std::string(12U, '[') + std::string(12U, ']')), "");
    EXPECT_EQ(RefusalOfText(std::string(13U, '[') + std::string(13U, ']')),
              "a.yaml:1:13: error: nested too deeply, expected at most 12 levels");
}

TEST(YamlDocument, HasPrintableText)
{
    Verifies(req::SRS_SIM_010);
    const std::string refusal =
        "a.yaml:1:4: error: text with a character that is not printable, expected printable text";
    EXPECT_EQ(RefusalOfText("a: \"b\\x01\"\n"), refusal);
    EXPECT_EQ(RefusalOfText("a: \"b\\x85\"\n"), refusal);
    EXPECT_EQ(RefusalOfText("a: \"b\\x9F\"\n"), refusal);
    EXPECT_EQ(ParseYaml("a.yaml", "a: \"b\\xA0\\u00E4\\u0100\\u20AC\\n\"\n").items[1].scalar,
              "b\xC2\xA0\xC3\xA4\xC4\x80\xE2\x82\xAC\n");
}

TEST(YamlDocument, HasTextsThatEnd)
{
    Verifies(req::SRS_SIM_010);
    EXPECT_EQ(RefusalOfText("a: \"b\n"), "a.yaml:1:4: error: quoted text without an end, expected a closing \"");
    EXPECT_EQ(RefusalOfText("a: 'b\n"), "a.yaml:1:4: error: quoted text without an end, expected a closing '");
    EXPECT_EQ(RefusalOfText("a: \"b\\\"\n"), "a.yaml:1:4: error: quoted text without an end, expected a closing \"");
    EXPECT_EQ(ParseYaml("a.yaml", "a: \"b\\\"\"\n").items[1].scalar, "b\"");
    EXPECT_EQ(ParseYaml("a.yaml", "a: 'b\\'\n").items[1].scalar, "b\\");
    // Two apostrophes are one of the text
    EXPECT_EQ(ParseYaml("a.yaml", "a: 'b''c'\n").items[1].scalar, "b'c");
    EXPECT_EQ(RefusalOfText("a: 'b''\n"), "a.yaml:1:4: error: quoted text without an end, expected a closing '");
}

/// Line and column of each value that is nothing.
std::string PlacesOfNothing(const YamlNode& node)
{
    std::string places;
    if (node.kind == YamlKind::kNull)
    {
        places = std::to_string(node.place.line) + "." + std::to_string(node.place.column) + " ";
    }
    for (const YamlNode& item : node.items)
    {
        places += PlacesOfNothing(item);
    }
    return places;
}

std::string PlacesOfNothing(const std::string& text)
{
    return PlacesOfNothing(ParseYaml("a.yaml", text));
}

// Given a key, or an item of a list, without a value, then its place is behind what was written there, and not at what
// follows empty lines and comments later.
TEST(YamlDocument, PlacesAValueThatIsNotWrittenWhereItIsMissing)
{
    Verifies(req::SRS_SIM_400);
    EXPECT_EQ(PlacesOfNothing("a:"), "1.3 ");
    EXPECT_EQ(PlacesOfNothing("a:\n"), "1.3 ");
    EXPECT_EQ(PlacesOfNothing("a:\n\n\nb: 1\n"), "1.3 ");
    EXPECT_EQ(PlacesOfNothing("a: # why: 'x'\n  # and - more\nb: 1\n"), "1.3 ");
    EXPECT_EQ(PlacesOfNothing("c: 1\na:\t# why\nb: 1\n"), "2.3 ");
    EXPECT_EQ(PlacesOfNothing("a:\nb:\n\nc:\n"), "1.3 2.3 4.3 ");
    EXPECT_EQ(PlacesOfNothing("a:\n  -\n  - 2\n"), "2.4 ");
    EXPECT_EQ(PlacesOfNothing("a:\n  - 1\n  - # none\n"), "3.4 ");
    EXPECT_EQ(PlacesOfNothing("-\n-\n# none\n-\n"), "1.2 2.2 4.2 ");
    EXPECT_EQ(PlacesOfNothing("- {a: 1}\n- [2]\n-\n\n"), "3.2 ");
    EXPECT_EQ(PlacesOfNothing("a: {b: , c: 1}\n"), "1.7 ");
    EXPECT_EQ(PlacesOfNothing("a: {b:\n     , c: 1}\n"), "1.7 ");
    EXPECT_EQ(PlacesOfNothing("a: {bb, c: 1}\n"), "1.7 ");
    EXPECT_EQ(PlacesOfNothing("---\n# none\n"), "1.4 ");
    EXPECT_EQ(PlacesOfNothing("a: 1\n"), "");
}

// What looks like a comment, a quoted text, or like a word for nothing, and is part of a key or of what stands before
// it, is none.
TEST(YamlDocument, PlacesAMissingValueBehindAnyKey)
{
    Verifies(req::SRS_SIM_400);
    EXPECT_EQ(PlacesOfNothing("a#b:\n\nc: 1\n"), "1.5 ");
    EXPECT_EQ(PlacesOfNothing("\"a\":\n\nc: 1\n"), "1.5 ");
    EXPECT_EQ(PlacesOfNothing("'a # b': \t# why\nc: 1\n"), "1.9 ");
    EXPECT_EQ(PlacesOfNothing("'a''s # b':\n\n"), "1.12 ");
    EXPECT_EQ(PlacesOfNothing("\"a\\\" # b\": # why\n"), "1.11 ");
    EXPECT_EQ(PlacesOfNothing("don't: # isn't\n\nc: 1\n"), "1.7 ");
    EXPECT_EQ(PlacesOfNothing("a: |\n  # text\n  more\nb:\n\nc: 1\n"), "4.3 ");
    EXPECT_EQ(PlacesOfNothing("- one\n  two\n- # three\n"), "3.2 ");
    EXPECT_EQ(PlacesOfNothing("a:\n\nnull_b: 1\n"), "1.3 ");
    EXPECT_EQ(PlacesOfNothing("a:\n\nNull: 1\n").substr(0U, 4U), "1.3 ");
}

// A value that says that it is nothing stands where it is written.
TEST(YamlDocument, PlacesAWordForNothingWhereItStands)
{
    Verifies(req::SRS_SIM_400);
    EXPECT_EQ(PlacesOfNothing("a: 1\nb:\n  ~\n"), "3.3 ");
    EXPECT_EQ(PlacesOfNothing("b: null\n"), "1.4 ");
    EXPECT_EQ(PlacesOfNothing("b: Null # why\n"), "1.4 ");
    EXPECT_EQ(PlacesOfNothing("b: NULL"), "1.4 ");
    EXPECT_EQ(PlacesOfNothing("[null, ~, NULL]\n"), "1.2 1.8 1.11 ");
    EXPECT_EQ(PlacesOfNothing("{a: null}\n"), "1.5 ");
    EXPECT_EQ(PlacesOfNothing("- null\n-\n"), "1.3 2.2 ");
}

TEST(YamlDocument, IsShownPrintableAndShort)
{
    Verifies(req::SRS_SIM_010);
    EXPECT_EQ(Shown("a b~"), "'a b~'");
    EXPECT_EQ(Shown("\x1F\x7F\xC3"), "'?\?\?'");
    EXPECT_EQ(Shown(std::string(60U, 'a')), "'" + std::string(60U, 'a') + "'");
    EXPECT_EQ(Shown(std::string(61U, 'a')), "'" + std::string(60U, 'a') + "...'");
}
} // namespace
} // namespace counterpoint::runtime
