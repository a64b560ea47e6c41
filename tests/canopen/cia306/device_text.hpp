// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_CANOPEN_CIA306_DEVICE_TEXT_HPP
#define TESTS_CANOPEN_CIA306_DEVICE_TEXT_HPP

#include "canopen/cia306/file/device_reader.hpp"
#include "canopen/cia306/text/ini_document.hpp"
#include "canopen/cia306/text/input_error.hpp"
#include "canopen/cia306/text/text_file.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

/// Texts of device files for tests: shipped examples with a change, or the least file that holds what a test needs.
namespace counterpoint::cia306::test
{
/// A change of a text: `from` has to stand in it exactly once.
struct Change
{
    std::string from;
    std::string to;
};

inline std::string Changed(std::string text, const std::vector<Change>& changes)
{
    for (const Change& change : changes)
    {
        const std::size_t place = text.find(change.from);
        const bool is_once = place != std::string::npos && text.find(change.from, place + 1U) == std::string::npos;
        EXPECT_TRUE(is_once) << "stands not exactly once: " << change.from;
        if (is_once)
        {
            text.replace(place, change.from.size(), change.to);
        }
    }
    return text;
}

inline std::string SourceFolder()
{
    return COUNTERPOINT_SOURCE_FOLDER;
}

inline std::string ExampleText(const std::string& name)
{
    return ReadTextFile(SourceFolder() + "/examples/emergency_stop/" + name + ".dcf");
}

/// A file of tests/canopen/cia306/data.
inline std::string FileText(const std::string& name)
{
    return ReadTextFile(SourceFolder() + "/tests/canopen/cia306/data/" + name + ".dcf");
}

/// A scenario of a network, or what it names: of the examples, else of the tests alone.
inline std::string NetworkFile(const std::string& name)
{
    const std::string example = SourceFolder() + "/examples/networks/" + name;
    const bool is_example = std::filesystem::exists(example);
    return is_example ? example : SourceFolder() + "/tests/simulator/scenarios/networks/" + name;
}

inline Device DeviceOf(const std::string& text)
{
    return ReadDevice(IniDocument::Parse("test.dcf", text));
}

/// What the reader says when it refuses the text; empty where it does not.
inline std::string RefusalOf(const std::string& text)
{
    try
    {
        (void)DeviceOf(text);
    }
    catch (const InputError& error)
    {
        return error.what();
    }
    return "";
}

/// One SRDO of a least file. Texts are written into the file as they are.
struct SrdoText
{
    int number{1};
    std::string direction;
    std::string sct;
    std::string srvt;
    std::string cob_id_1;
    std::string cob_id_2;
    std::vector<std::string> mapping;
};

inline std::string VariableText(const std::string& section, const std::string& type, const std::string& value)
{
    return "[" + section + "]\nParameterName=x\nObjectType=0x7\nDataType=" + type +
           "\nAccessType=rw\nDefaultValue=" + value + "\nPDOMapping=0\n\n";
}

inline std::string HexIndex(const int index)
{
    return Hex(static_cast<std::uint64_t>(index), 4).substr(2U);
}

inline std::string SrdoSections(const SrdoText& srdo)
{
    const std::string communication = HexIndex(0x1300 + srdo.number);
    const std::string mapping = HexIndex(0x1380 + srdo.number);
    std::string text = "[" + communication + "]\nParameterName=c\nObjectType=0x9\nSubNumber=7\n\n";
    text += VariableText(communication + "sub0", "0x0005", "6");
    text += VariableText(communication + "sub1", "0x0005", srdo.direction);
    text += VariableText(communication + "sub2", "0x0006", srdo.sct);
    text += VariableText(communication + "sub3", "0x0005", srdo.srvt);
    text += VariableText(communication + "sub4", "0x0005", "254");
    text += VariableText(communication + "sub5", "0x0007", srdo.cob_id_1);
    text += VariableText(communication + "sub6", "0x0007", srdo.cob_id_2);
    text += "[" + mapping + "]\nParameterName=m\nObjectType=0x8\n\n";
    text += VariableText(mapping + "sub0", "0x0005", std::to_string(srdo.mapping.size()));
    int sub = 1;
    for (const std::string& entry : srdo.mapping)
    {
        text += VariableText(mapping + "sub" + Hex(static_cast<std::uint64_t>(sub), 1).substr(2U), "0x0007", entry);
        ++sub;
    }
    return text;
}

/// A file with these SRDOs and 13FFh, and nothing else.
inline std::string SrdoFileText(const std::vector<SrdoText>& srdos)
{
    std::string text = "[DeviceInfo]\nVendorName=test\n\n";
    for (const SrdoText& srdo : srdos)
    {
        text += SrdoSections(srdo);
    }
    text += "[13FF]\nParameterName=s\nObjectType=0x8\n\n" + VariableText("13FFsub0", "0x0005", "64");
    for (const SrdoText& srdo : srdos)
    {
        const std::string sub = Hex(static_cast<std::uint64_t>(srdo.number), 1).substr(2U);
        text += VariableText("13FFsub" + sub, "0x0006", "0");
    }
    return text;
}

/// GOLD: the published example of a certified device; the others are the project's vectors A to F.
struct Vector
{
    std::string name;
    SrdoText srdo;
    std::string bytes;
    std::uint16_t signature{0U};
};

inline std::vector<std::string> SixteenEntries()
{
    std::vector<std::string> entries;
    for (int sub = 1; sub <= 8; ++sub)
    {
        entries.push_back("0x6621" + Hex(static_cast<std::uint64_t>(sub), 2).substr(2U) + "08");
        entries.push_back("0x6623" + Hex(static_cast<std::uint64_t>(sub), 2).substr(2U) + "08");
    }
    return entries;
}

inline std::vector<Vector> Vectors()
{
    return {
        {"GOLD",
         {1, "2", "50", "20", "0x111", "0x112", {"0x60100108", "0x60110108", "0x60100208", "0x60110208"}},
         "02 32 00 14 11 01 00 00 12 01 00 00 04 01 08 01 10 60 02 08 01 11 60 03 08 02 10 60 04 08 02 11 60",
         0x4370U},
        {"A",
         {1, "1", "25", "20", "0x101", "0x102", {"0x20000008", "0x20010008"}},
         "01 19 00 14 01 01 00 00 02 01 00 00 02 01 08 00 00 20 02 08 00 01 20",
         0x4B2DU},
        {"B",
         {1, "2", "50", "20", "0x103", "0x104", {"0x62000120", "0x62010120"}},
         "02 32 00 14 03 01 00 00 04 01 00 00 02 01 20 01 00 62 02 20 01 01 62",
         0xD999U},
        {"C",
         {1, "1", "10", "5", "0x17F", "0x180", SixteenEntries()},
         "01 0A 00 05 7F 01 00 00 80 01 00 00 10 01 08 01 21 66 02 08 01 23 66 03 08 02 21 66 04 08 02 23 66 "
         "05 08 03 21 66 06 08 03 23 66 07 08 04 21 66 08 08 04 23 66 09 08 05 21 66 0A 08 05 23 66 "
         "0B 08 06 21 66 0C 08 06 23 66 0D 08 07 21 66 0E 08 07 23 66 0F 08 08 21 66 10 08 08 23 66",
         0xB825U},
        {"D", {1, "1", "25", "20", "0x101", "0x102", {}}, "01 19 00 14 01 01 00 00 02 01 00 00 00", 0xCD8AU},
        {"E",
         {1, "1", "25", "20", "0x101", "0x102", {"0x62100108", "0x62110108", "0x62100208", "0x62110208"}},
         "01 19 00 14 01 01 00 00 02 01 00 00 04 01 08 01 10 62 02 08 01 11 62 03 08 02 10 62 04 08 02 11 62",
         0xF2B5U},
        {"F", {1, "0", "25", "20", "0x101", "0x102", {}}, "00 19 00 14 01 01 00 00 02 01 00 00 00", 0x88E9U},
    };
}
} // namespace counterpoint::cia306::test

#endif // TESTS_CANOPEN_CIA306_DEVICE_TEXT_HPP
