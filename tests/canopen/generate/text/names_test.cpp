// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/generate/generate.hpp"
#include "canopen/generate/names.hpp"
#include "tests/canopen/generate/random_device.hpp"
#include "verification/trace/ids/generate.hpp"
#include "verification/trace/verifies.hpp"

#include "canopen/cia306/file/device_reader.hpp"

#include <gtest/gtest.h>

#include <set>

namespace counterpoint::generate
{
namespace
{
TEST(Names, WordsBecomePascalCase)
{
    Verifies(req::SRS_GEN_012);
    EXPECT_EQ(PascalCase("Producer heartbeat time [ms]"), "ProducerHeartbeatTimeMs");
    EXPECT_EQ(PascalCase("COB-ID 1 (normal data)"), "CobId1NormalData");
    EXPECT_EQ(PascalCase("motorSpeed"), "MotorSpeed");
    EXPECT_EQ(PascalCase("SRDO"), "Srdo");
    EXPECT_EQ(PascalCase("\xC4rger"), "Rger");
    EXPECT_EQ(PascalCase("+-%"), "");
    EXPECT_EQ(PascalCase(""), "");
}

TEST(Names, TextOfAFileCannotLeaveItsComment)
{
    Verifies(req::SRS_GEN_012);
    EXPECT_EQ(CommentText("back\\"), "back_");
    EXPECT_EQ(CommentText("what?\?/"), "what?_/");
    EXPECT_EQ(CommentText("a\nb\x80"), "a_b_");
    EXPECT_EQ(CommentText("*/ plain"), "*/ plain"); // In // comments that ends nothing.
}

TEST(Names, NamespacesAreChecked)
{
    Verifies(req::SRS_GEN_003);
    for (const char* name : {"a", "my_device", "company::device2", "counterpoint::x"})
    {
        EXPECT_EQ(ProblemOfNamespace(name), "") << name;
    }
    for (const char* name : {"", "2a", "_a", "a__b", "a-b", "a::", "::a", "a::class", "std", "a::std", "counterpoint",
                             "a::counterpoint", "linux", "a:b", "a b"})
    {
        EXPECT_NE(ProblemOfNamespace(name), "") << name;
    }
}

TEST(Names, ANamespaceIsNoNameOfWhatTheCodeIncludes)
{
    Verifies(req::SRS_GEN_490);
    // Types and macros of <cstdint>, guards of headers, names of counterpoint
    for (const char* name : {"uint8_t",
                             "int64_t",
                             "int_least16_t",
                             "uint_fast32_t",
                             "uintmax_t",
                             "intptr_t",
                             "size_t",
                             "ptrdiff_t",
                             "UINT8_MAX",
                             "INT8_MAX",
                             "INT64_MIN",
                             "UINT_LEAST16_MAX",
                             "INT_FAST8_MIN",
                             "UINT32_C",
                             "INTMAX_C",
                             "UINTPTR_MAX",
                             "INT16_WIDTH",
                             "SIZE_MAX",
                             "PTRDIFF_MIN",
                             "WCHAR_MAX",
                             "SIG_ATOMIC_MIN",
                             "WINT_MAX",
                             "a::UINT8_MAX",
                             "SAFETY_CORE_KERNEL_KERNEL_HPP",
                             "CANOPEN_CIA301_DICTIONARY_DICTIONARY_HPP",
                             "CANOPEN_GENERATED_STORED_OBJECTS_HPP",
                             "HAL_API_CAN_PORTS_HPP",
                             "counterpoint::Kernel",
                             "counterpoint::x::kMost",
                             "counterpoint::cia301",
                             "counterpoint::generated"})
    {
        EXPECT_NE(ProblemOfNamespace(name), "") << name;
    }
    EXPECT_EQ(ProblemOfNamespace("uint8_t"), "'uint8_t' is taken, expected another name of a namespace");
    EXPECT_EQ(ProblemOfNamespace("counterpoint::Kernel"),
              "'Kernel' may be a name of counterpoint, expected small letters, digits and _");
    EXPECT_EQ(ProblemOfNamespace("counterpoint::generated"),
              "'counterpoint::generated' alone is taken, expected counterpoint::generated::name");
    // Near misses
    for (const char* name : {"uint8", "int9_t", "integer_t", "UINT8", "INT_MAXIMUM", "SENSOR_MAX", "DOOR_HPP", "Kernel",
                             "counterpoint::generated::door", "counterpoint::cia301x"})
    {
        EXPECT_EQ(ProblemOfNamespace(name), "") << name;
    }
    // A file with such a name gives another one
    EXPECT_EQ(NamespaceOf("uint8_t.dcf"), "device_uint8_t");
    EXPECT_EQ(ProblemOfNamespace("device_uint8_t"), "");
}

TEST(Names, ANamespaceComesFromTheFile)
{
    Verifies(req::SRS_GEN_012);
    EXPECT_EQ(NamespaceOf("/some/where/First-Device v2.dcf"), "first_device_v2");
    EXPECT_EQ(NamespaceOf("class.eds"), "device_class");
    EXPECT_EQ(NamespaceOf("linux.eds"), "device_linux");
    EXPECT_EQ(NamespaceOf("3.eds"), "device_3");
    EXPECT_EQ(NamespaceOf("\xE4.dcf"), "device");
    for (const char* file : {"a.dcf", "x/-.-.eds", ".eds", "A__B.dcf", "std.dcf"})
    {
        EXPECT_EQ(ProblemOfNamespace(NamespaceOf(file)), "") << file;
    }
}

TEST(Names, EachElementHasItsOwn)
{
    Verifies(req::SRS_GEN_012);
    // Given objects that are called alike, like words of the generated file, or not at all
    std::string text = "[FileInfo]\n\n";
    text += test::Section("2000", "Speed", 5U, "rw", "1") + test::Section("2001", "Speed", 5U, "rw", "1");
    text += test::Section("2002", "SpeedAt2000Sub00", 5U, "rw", "1") + test::Section("2003", "Node ID", 5U, "rw", "1");
    text += test::Section("2004", "", 5U, "rw", "1") + test::Section("2005", "1st", 5U, "rw", "1");
    text += test::Section("2006", "Srdo1", 5U, "rw", "1");
    const cia306::Device device = cia306::ReadDevice(cia306::IniDocument::Parse("a.eds", text));
    std::vector<Element> elements;
    for (const auto& [index, object] : device.objects)
    {
        static_cast<void>(index);
        Element element;
        element.entry = &object.entries.at(0U);
        element.object_name = object.name;
        elements.push_back(element);
    }
    // When they are named
    NameElements(elements);
    // Then all names differ, and none is taken
    std::vector<std::string> names;
    for (const Element& element : elements)
    {
        names.push_back(element.name);
    }
    EXPECT_EQ(names, (std::vector<std::string>{"SpeedAt2000Sub00", "SpeedAt2001Sub00", "SpeedAt2000Sub00X",
                                               "NodeIdAt2003Sub00", "Object2004Sub00", "Object2005Sub001st",
                                               "Srdo1At2006Sub00"}));
}
} // namespace
} // namespace counterpoint::generate
