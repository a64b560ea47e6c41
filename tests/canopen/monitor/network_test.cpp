// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What the files of a bus say: names, node-IDs, what is active, where they contradict each other.
#include "canopen/monitor/contradictions.hpp"
#include "canopen/monitor/decoder.hpp"
#include "canopen/monitor/report.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/canopen/monitor/recordings.hpp"
#include "verification/trace/ids/monitor.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::monitor
{
namespace
{
using cia306::test::ExampleText;
using test::Frame;
using test::ViolationsOf;
using test::Written;
using Texts = std::vector<std::string>;

std::string Example(const std::string& name)
{
    return cia306::test::SourceFolder() + "/examples/emergency_stop/" + name + ".dcf";
}

/// The example with its 13FEh as it is before it was declared valid.
std::string NotValid(const std::string& example, const std::string& value)
{
    std::string text = ExampleText(example);
    const std::size_t place = text.find("ParameterValue=0xA5", text.find("[13FE]"));
    return text.replace(place, 19U, value.empty() ? "" : "ParameterValue=" + value);
}

std::string RefusalOf(const std::vector<NodeFile>& files)
{
    try
    {
        static_cast<void>(Network(files, std::nullopt));
    }
    catch (const cia306::InputError& error)
    {
        return error.what();
    }
    return "";
}

const std::string kNameless = "[DeviceInfo]\nVendorName=test\n\n[1000]\nParameterName=Type\nObjectType=7\nDataType=7\n"
                              "AccessType=ro\nDefaultValue=0\n\n";

// A node is named by NodeName in either spelling of the section; without one, or with an empty one, by its file.
TEST(NameOfANode, IsNodeNameElseThatOfTheFile)
{
    Verifies(req::SRS_MON_004);
    const auto name = [](const std::string& text)
    { return Network({{Written("network_named.dcf", text), std::uint8_t{7U}}}, std::nullopt).NameOf(7U); };
    EXPECT_EQ(name(kNameless + "[DeviceComissioning]\nNodeID=7\nNodeName=Door\n"), "Door");
    EXPECT_EQ(name(kNameless + "[DeviceCommissioning]\nNodeID=7\nNodeName=Gate\n"), "Gate");
    EXPECT_EQ(name(kNameless + "[DeviceComissioning]\nNodeID=7\nNodeName=\n"), "network_named");
    EXPECT_EQ(name(kNameless + "[DeviceComissioning]\nNodeID=7\n"), "network_named");
    EXPECT_EQ(name(kNameless), "network_named");
}

TEST(NodeIds, AreGivenAndEachOnce)
{
    Verifies(req::SRS_MON_004);
    const std::string path = Written("network_no_id.dcf", kNameless);
    EXPECT_EQ(RefusalOf({{path, std::nullopt}}),
              path + ": error: no node-ID, expected NodeID in [DeviceComissioning], or --dcf FILE=NODE_ID");
    EXPECT_EQ(RefusalOf({{path, std::uint8_t{7U}}}), "");
    EXPECT_EQ(RefusalOf({{Example("sensor"), std::nullopt}, {path, std::uint8_t{1U}}}),
              path + ": error: node-ID 1, which " + Example("sensor") +
                  " has already, expected a node-ID of its own for each file");
}

// Given a sensor with other identifiers, which is declared valid or not.
TEST(IdentifiersOfAnActiveSrdo, AreThoseOfSrdos)
{
    Verifies(req::SRS_MON_332);
    const auto refusal = [](const std::string& first, const std::string& second, const std::string& valid)
    {
        std::string text = NotValid("sensor", valid);
        const auto set = [&text](const std::string& section, const std::string& value)
        {
            const std::size_t place = text.find("ParameterValue=", text.find("[" + section + "]"));
            text.replace(place, text.find_first_of("\r\n", place) - place, "ParameterValue=" + value);
        };
        set("1301sub5", first);
        set("1301sub6", second);
        // With the file and the place of the value in it
        const std::string path = Written("network_cob_ids.dcf", text);
        const std::string told = RefusalOf({{path, std::nullopt}});
        return told.rfind(path, 0U) == 0U ? told.substr(path.size()) : told;
    };
    const std::string at_first = ":241:16: error: 0x1301:05: ";
    const std::string at_second = ":250:16: error: 0x1301:06: ";
    const std::string odd = " of an SRDO that is on, expected an odd one from 0x101 to 0x17F";
    EXPECT_EQ(refusal("0x101", "0x102", "0xA5"), "");
    EXPECT_EQ(refusal("0x17F", "0x180", "0xA5"), "");
    EXPECT_EQ(refusal("0x181", "0x182", "0xA5"), at_first + "COB-ID 0x181" + odd);
    EXPECT_EQ(refusal("0x0FF", "0x100", "0xA5"), at_first + "COB-ID 0x0FF" + odd);
    EXPECT_EQ(refusal("0", "1", "0xA5"), at_first + "COB-ID 0x000" + odd);
    EXPECT_EQ(refusal("0x102", "0x103", "0xA5"), at_first + "COB-ID 0x102" + odd);
    EXPECT_EQ(refusal("0x80000101", "0x102", "0xA5"), at_first + "COB-ID 0x80000101" + odd);
    const std::string next = " of an SRDO that is on, expected 0x104 (COB-ID 1 + 1)";
    EXPECT_EQ(refusal("0x103", "0x106", "0xA5"), at_second + "COB-ID 2 0x106" + next);
    EXPECT_EQ(refusal("0x103", "0x102", "0xA5"), at_second + "COB-ID 2 0x102" + next);
    // What is not active is not watched
    EXPECT_EQ(refusal("0x181", "0x182", "0x00"), "");
}

// Given PDOs that are off, at 0, or without a value, then their frames are not taken for them.
TEST(PdosOfAFile, AreThoseThatAreOn)
{
    Verifies(req::SRS_MON_004);
    const auto pdo = [](const std::string& value)
    {
        return kNameless +
               "[1800]\nParameterName=TPDO\nSubNumber=1\nObjectType=9\n\n[1800sub1]\nParameterName=COB-ID\n"
               "DataType=7\nAccessType=rw\n" +
               value + "\n\n";
    };
    const auto words = [&pdo](const std::string& value)
    {
        const Network network({{Written("network_pdo.dcf", pdo(value)), std::uint8_t{7U}}}, std::nullopt);
        const Analysis analysis(network, [](const Violation&) {});
        return Decoder(network, analysis).Decode(Frame(0, 0x187U, {}));
    };
    EXPECT_EQ(words("DefaultValue=0x187"), "187h [0]  PDO network_pdo TPDO 1: ");
    EXPECT_EQ(words("DefaultValue=0x80000187"), "187h [0]  other TPDO 1 of network_pdo, by its identifier");
    EXPECT_EQ(words("DefaultValue=0"), "187h [0]  other TPDO 1 of network_pdo, by its identifier");
    EXPECT_EQ(words("DefaultValue=0x40000187"), "187h [0]  PDO network_pdo TPDO 1: ");
    EXPECT_EQ(words("DefaultValue=0x20000187"), "187h [0]  other TPDO 1 of network_pdo, by its identifier");
    EXPECT_EQ(words(""), "187h [0]  other TPDO 1 of network_pdo, by its identifier");
}

// Given a PDO with an identifier of NMT or error control, then these frames are what they are.
TEST(PdosOfAFile, HaveNoIdentifierOfAnotherService)
{
    Verifies(req::SRS_MON_711);
    const std::string pdo = "\n[1800]\nParameterName=TPDO\nSubNumber=1\nObjectType=9\n\n[1800sub1]\n"
                            "ParameterName=COB-ID\nDataType=7\nAccessType=rw\nDefaultValue=";
    for (const std::string value : {"0x40000000", "0x701", "0x40000701"})
    {
        const std::string path = Written("network_pdo.dcf", kNameless + pdo + value + "\n");
        const Network network({{path, std::uint8_t{1U}}}, std::nullopt);
        EXPECT_TRUE(network.Pdos().empty()) << value;
        const Analysis analysis(network, [](const Violation&) {});
        Decoder decoder(network, analysis);
        EXPECT_EQ(decoder.Decode(Frame(0, 0x000U, {1U, 0U})), "000h [2] 01 00  NMT start, all nodes") << value;
        EXPECT_EQ(decoder.Decode(Frame(0, 0x701U, {5U})), "701h [1] 05  error control network_pdo is OPERATIONAL");
    }
}

// Given a sensor that is not declared valid, then none of its SRDOs is watched, it may send no GFC, and it is told.
TEST(AConfigurationThatIsNotValid, HasNoActiveSrdo)
{
    Verifies(req::SRS_MON_021);
    for (const std::string value : {"0x00", ""})
    {
        const std::string path = Written("network_not_valid.dcf", NotValid("sensor", value));
        const Network network({{path, std::nullopt}}, std::nullopt);
        EXPECT_TRUE(network.Watches().empty());
        // Nobody may have sent the GFC
        EXPECT_EQ(ViolationsOf(network, {Frame(0, 0x001U, {})}, 1000000), Texts{});
        const std::vector<Contradiction> found = ContradictionsOf(network);
        ASSERT_EQ(found.size(), 1U);
        EXPECT_EQ(found[0].file, path);
        EXPECT_EQ(found[0].finding.text.rfind("0x00, so that no SRDO of Sensor is active and none is watched, expected "
                                              "0xA5 where the device was declared valid",
                                              0U),
                  0U)
            << found[0].finding.text;
        EXPECT_GT(found[0].finding.place.line, 0U);
        // Its frames have its name all the same
        const Analysis analysis(network, [](const Violation&) {});
        Decoder decoder(network, analysis);
        EXPECT_EQ(decoder.Decode(Frame(0, 0x101U, {1U, 2U})),
                  "101h [2] 01 02  SRDO normal, of Sensor SRDO 1, which is not active");
        EXPECT_EQ(decoder.Decode(Frame(0, 0x102U, {1U, 2U})),
                  "102h [2] 01 02  SRDO inverse, of Sensor SRDO 1, which is not active");
        EXPECT_EQ(decoder.Decode(Frame(0, 0x103U, {1U, 2U})), "103h [2] 01 02  SRDO normal, of no file");
    }
}

// It is told in the document, too; a file whose SRDOs are all off contradicts nobody, nor does one without SRDOs.
TEST(AConfigurationThatIsNotValid, IsAWarningOfTheDocument)
{
    Verifies(req::SRS_MON_020);
    Verifies(req::SRS_MON_021);
    const std::string path = Written("network_not_valid.dcf", NotValid("sensor", "0x00"));
    const Network network({{path, std::nullopt}}, std::nullopt);
    const Analysis analysis(network, [](const Violation&) {});
    const std::vector<Violation> none;
    EXPECT_NE(
        JsonReport({network, analysis, none, "x.log"}).find("\"message\": \"0x00, so that no SRDO of Sensor is active"),
        std::string::npos);
    const Network without({{Written("network_no_srdo.dcf", kNameless), std::uint8_t{7U}}}, std::nullopt);
    EXPECT_TRUE(ContradictionsOf(without).empty());
    std::string all_off = NotValid("sensor", "0x00");
    all_off.replace(all_off.find("ParameterValue=1", all_off.find("[1301sub1]")), 16U, "ParameterValue=0");
    EXPECT_TRUE(ContradictionsOf(Network({{Written("network_off.dcf", all_off), std::nullopt}}, std::nullopt)).empty());
}

// A file without 13FEh at all is not valid, either: the place is that of the SRDO.
TEST(AConfigurationThatIsNotValid, MayHaveNoObjectThatTells)
{
    Verifies(req::SRS_MON_021);
    const std::string text =
        cia306::test::SrdoFileText({{1, "2", "50", "20", "0x101", "0x102", {"0x20000108", "0x21000108"}}});
    const Network network({{Written("network_no_13fe.dcf", text), std::uint8_t{7U}}}, std::nullopt);
    EXPECT_TRUE(network.Watches().empty());
    const std::vector<Contradiction> found = ContradictionsOf(network);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(
        found[0].finding.text,
        "is missing, so that no SRDO of network_no_13fe is active and none is watched, expected 0xA5 where the device "
        "was declared valid");
    EXPECT_EQ(found[0].finding.place.line, 4U); // [1301]
}

/// The example with another ParameterValue of an object.
std::string WithValue(const std::string& example, const std::string& section, const std::string& value)
{
    std::string text = ExampleText(example);
    const std::size_t place = text.find("ParameterValue=", text.find("[" + section + "]"));
    return text.replace(place, text.find_first_of("\r\n", place) - place, value);
}

/// Object and text of each finding of one file.
Texts ContradictionsOfText(const std::string& text)
{
    const Network network({{Written("network_signature.dcf", text), std::uint8_t{7U}}}, std::nullopt);
    Texts texts;
    for (const Contradiction& found : ContradictionsOf(network))
    {
        EXPECT_EQ(found.finding.severity, cia306::Severity::kWarning);
        EXPECT_GT(found.finding.place.line, 0U);
        texts.push_back(found.finding.object + ": " + found.finding.text);
    }
    return texts;
}

// Given a controller with two SRDOs, then each whose signature is that of other parameters is told, and no other.
TEST(SignatureOfOtherParameters, IsAWarningOfEachSrdoThatHasOne)
{
    Verifies(req::SRS_MON_400);
    const std::string why = ": a device refuses this file, so that the one on the bus may have another";
    EXPECT_EQ(ContradictionsOfText(ExampleText("controller")), Texts{});
    EXPECT_EQ(ContradictionsOfText(WithValue("controller", "13FFsub2", "ParameterValue=0x1234")),
              Texts{"0x13FF:02: signature 0x1234 of SRDO 2 of Controller, expected 0xCA45" + why});
    EXPECT_EQ(ContradictionsOfText(WithValue("controller", "1301sub2", "ParameterValue=26")),
              Texts{"0x13FF:01: signature 0xE3BF of SRDO 1 of Controller, expected 0x9066" + why});
}

// Given a file without a signature, without 13FFh, or with an SRDO that is off or not active, then nothing is told of a
// signature: no signature is none of other parameters, and what is not watched is judged by nothing.
TEST(SignatureOfOtherParameters, IsNotThatOfASrdoWithoutOneOrNotActive)
{
    Verifies(req::SRS_MON_400);
    const std::vector<cia306::test::SrdoText> srdos{
        {1, "2", "50", "20", "0x101", "0x102", {"0x20000108", "0x21000108"}}};
    const std::string valid = cia306::test::VariableText("13FE", "0x0005", "0xA5");
    const std::string with = cia306::test::SrdoFileText(srdos);
    // The file of this test has a signature of 0
    EXPECT_EQ(ContradictionsOfText(with + valid).size(), 1U);
    EXPECT_EQ(ContradictionsOfText(with.substr(0U, with.find("[13FFsub1]")) + valid), Texts{});
    EXPECT_EQ(ContradictionsOfText(with.substr(0U, with.find("[13FF]")) + valid), Texts{});
    std::string off = WithValue("controller", "13FFsub2", "ParameterValue=0x1234");
    off.replace(off.find("ParameterValue=1", off.find("[1302sub1]")), 16U, "ParameterValue=0");
    EXPECT_EQ(ContradictionsOfText(off), Texts{});
    std::string wrong = NotValid("sensor", "0x00");
    wrong.replace(wrong.find("ParameterValue=", wrong.find("[13FFsub1]")), 21U, "ParameterValue=0x1234");
    ASSERT_EQ(ContradictionsOfText(wrong).size(), 1U);
    EXPECT_EQ(ContradictionsOfText(wrong)[0].rfind("0x13FE:00: ", 0U), 0U);
}

// Given a file whose signature cannot be computed, then it is refused, before anything is compared.
TEST(SignatureOfOtherParameters, IsNotAskedOfAFileThatHasNoSum)
{
    Verifies(req::SRS_MON_400);
    const std::string path = Written("network_no_sum.dcf", WithValue("controller", "1301sub2", "ParameterValue=x"));
    EXPECT_NE(RefusalOf({{path, std::nullopt}}).find("0x1301:02: "), std::string::npos);
}

// Given two consumers of one pair that map another length, then each tells what it expected.
TEST(ViolationsOfSeveralSrdos, AreToldEachWhereTheyExpectSomethingElse)
{
    Verifies(req::SRS_MON_008);
    const auto consumer = [](const std::string& name, const std::vector<std::string>& mapping)
    {
        return Written(name + ".dcf", cia306::test::SrdoFileText({{1, "2", "50", "20", "0x101", "0x102", mapping}}) +
                                          cia306::test::VariableText("13FE", "0x0005", "0xA5"));
    };
    const Network network({{consumer("network_one", {"0x20000108", "0x21000108"}), std::uint8_t{7U}},
                           {consumer("network_two", {"0x20000110", "0x21000110"}), std::uint8_t{8U}}},
                          std::nullopt);
    std::vector<std::string> texts;
    Analysis analysis(network, [&](const Violation& violation)
                      { texts.push_back(Watchers(network, violation) + ": " + violation.breach.details); });
    analysis.Take(Frame(0, 0x101U, {1U, 2U, 3U}));
    EXPECT_EQ(texts, (Texts{"nobody here -> network_one SRDO 1: normal frame of 3 bytes, expected 1 byte",
                            "nobody here -> network_two SRDO 1: normal frame of 3 bytes, expected 2 bytes"}));
}

// Given a producer with identifiers that no SRDO has, then no frame can be taken for its pair, nor for what follows a
// GFC.
TEST(IdentifiersThatNoSrdoHas, AreNobodysFrames)
{
    Verifies(req::SRS_MON_016);
    Verifies(req::SRS_MON_332);
    const auto producer = [](const std::string& first, const std::string& second)
    {
        return Network({{Written("network_identifier.dcf",
                                 cia306::test::VariableText("1300", "0x0005", "1") +
                                     cia306::test::SrdoFileText(
                                         {{1, "1", "25", "20", first, second, {"0x20000108", "0x21000108"}}}) +
                                     cia306::test::VariableText("13FE", "0x0005", "0xA5")),
                         std::uint8_t{7U}}},
                       std::nullopt);
    };
    EXPECT_EQ(ViolationsOf(producer("0x101", "0x102"), {Frame(0, 0x001U, {})}, 1000000),
              Texts{"25000 GFC not followed"});
    EXPECT_THROW(producer("0x100", "0x102"), cia306::InputError);
    EXPECT_THROW(producer("0x181", "0x182"), cia306::InputError);
    EXPECT_THROW(producer("0x801", "0x802"), cia306::InputError); // 801h is not 001h with a bit above it.
}

// Given an SRDO that is off in a valid file, then it is not watched.
TEST(AnSrdoThatIsOff, IsNotWatched)
{
    Verifies(req::SRS_MON_005);
    std::string text = ExampleText("controller");
    text.replace(text.find("ParameterValue=1", text.find("[1302sub1]")), 16U, "ParameterValue=0");
    text.replace(text.find("ParameterValue=0xCA45", text.find("[13FFsub2]")), 21U, "ParameterValue=0x0000");
    const Network network({{Written("network_one_off.dcf", text), std::nullopt}}, std::nullopt);
    ASSERT_EQ(network.Watches().size(), 1U);
    EXPECT_EQ(network.Watches()[0].setup.normal_id, 0x101U);
}

// Given devices that may not send GFC, then one that nothing follows is nobody's.
TEST(AGfc, IsThatOfADeviceThatMaySendIt)
{
    Verifies(req::SRS_MON_016);
    std::string text = ExampleText("sensor");
    text.replace(text.find("ParameterValue=1", text.find("[1300]")), 16U, "ParameterValue=0");
    const Network silent({{Written("network_no_gfc.dcf", text), std::nullopt}}, std::nullopt);
    EXPECT_EQ(ViolationsOf(silent, {Frame(0, 0x001U, {})}, 1000000), Texts{});
    const Network may({{Example("sensor"), std::nullopt}}, std::nullopt);
    EXPECT_EQ(ViolationsOf(may, {Frame(0, 0x001U, {})}, 1000000), Texts{"25000 GFC not followed"});
}

// Given frames with the stamp of the GFC, then only a normal frame of a sender follows it; the inverse frame of the
// pair before it, and a frame of 101h to 180h that nobody sends, counted too.
TEST(AGfc, IsFollowedByNoOtherFrameOfItsInstant)
{
    Verifies(req::SRS_MON_016);
    const Network may({{Example("sensor"), std::nullopt}}, std::nullopt);
    const LogFrame gfc = Frame(100, 0x001U, {});
    const Texts told{"25100 GFC not followed"};
    for (const Time us : {100, 101})
    {
        EXPECT_EQ(ViolationsOf(may, {Frame(0, 0x101U, {1U, 2U}), gfc, Frame(us, 0x102U, {0xFEU, 0xFDU})}, 40000), told);
        EXPECT_EQ(ViolationsOf(may, {gfc, Frame(us, 0x17FU, {0U})}, 40000), told);
        EXPECT_EQ(ViolationsOf(may, {gfc, Frame(us, 0x180U, {0U})}, 40000), told);
        EXPECT_EQ(ViolationsOf(may, {gfc, Frame(us, 0x101U, {1U, 2U}), Frame(us, 0x102U, {0xFEU, 0xFDU})}, 40000),
                  Texts{});
    }
    // The pair before the GFC does not follow it, whatever its stamp is
    EXPECT_EQ(ViolationsOf(may, {Frame(100, 0x101U, {1U, 2U}), Frame(100, 0x102U, {0xFEU, 0xFDU}), gfc}, 40000), told);
}

/// A sensor with another COB-ID of emergencies.
std::string WithEmergency(const std::string& value)
{
    std::string text = ExampleText("sensor");
    const std::size_t place = text.find("DefaultValue=", text.find("[1014]"));
    return text.replace(place, text.find_first_of("\r\n", place) - place, "DefaultValue=" + value);
}

// Given a COB-ID of emergencies that no device takes, then NMT commands are what they are, and stop the supervision;
// they were taken for emergencies. Emergencies are those of the default.
TEST(IdentifiersThatNoEmergencyHas, LeaveFramesToTheirService)
{
    Verifies(req::SRS_MON_711);
    for (const std::string value : {"0", "0x80000000", "0x80000081", "0x07F", "0x101", "0x180", "0x581", "0x67F",
                                    "0x6E0", "0x701", "0x7FF", "0x20000090", "0x40000090", "0x800"})
    {
        const Network network({{Written("network_emergency.dcf", WithEmergency(value)), std::nullopt},
                               {Example("controller"), std::nullopt}},
                              std::nullopt);
        EXPECT_EQ(
            ViolationsOf(network,
                         {Frame(0, 0x101U, {1U, 2U}), Frame(100, 0x102U, {0xFEU, 0xFDU}), Frame(200, 0x000U, {2U, 0U})},
                         200000),
            Texts{})
            << value;
        const Analysis analysis(network, [](const Violation&) {});
        Decoder decoder(network, analysis);
        EXPECT_EQ(decoder.Decode(Frame(0, 0x000U, {1U, 0U})), "000h [2] 01 00  NMT start, all nodes") << value;
        EXPECT_EQ(decoder.Decode(Frame(0, 0x701U, {5U})), "701h [1] 05  error control Sensor is OPERATIONAL") << value;
        EXPECT_EQ(decoder.Decode(Frame(0, 0x081U, {0U, 0U, 0U, 0U, 0U, 0U, 0U, 0U})),
                  "081h [8] 00 00 00 00 00 00 00 00  EMCY Sensor no error, register 00h")
            << value;
    }
    for (const std::string value : {"0x090", "0x181", "0x580", "0x600", "0x680", "0x6DF", "0x700"})
    {
        const Network network({{Written("network_emergency.dcf", WithEmergency(value)), std::nullopt}}, std::nullopt);
        EXPECT_EQ(network.Nodes().front().emergency_id, std::stoul(value, nullptr, 16)) << value;
    }
}

// Two pairs whose consumers see the same at the same time are two violations; of several limits the earlier one first.
TEST(ViolationsOfSeveralSrdos, AreToldEachAndInTheirOrder)
{
    Verifies(req::SRS_MON_008);
    std::string text = ExampleText("controller");
    text.replace(text.find("ParameterValue=50", text.find("[1301sub2]")), 17U, "ParameterValue=60");
    const Network network(
        {{Example("sensor"), std::nullopt}, {Example("controller"), std::nullopt}, {Example("actuator"), std::nullopt}},
        std::nullopt);
    const std::vector<std::uint8_t> plain{1U, 2U};
    const std::vector<std::uint8_t> turned{0xFEU, 0xFDU};
    EXPECT_EQ(ViolationsOf(network,
                           {Frame(0, 0x101U, plain), Frame(0, 0x102U, turned), Frame(0, 0x103U, plain),
                            Frame(0, 0x104U, turned)},
                           200000),
              (Texts{"50000 SCT expired", "50000 SCT expired"}));
    EXPECT_EQ(ViolationsOf(network,
                           {Frame(0, 0x103U, plain), Frame(0, 0x104U, turned), Frame(1000, 0x101U, plain),
                            Frame(1000, 0x102U, turned)},
                           200000),
              (Texts{"50000 SCT expired", "51000 SCT expired"}));
    // At one time a pair that never was complete, and one that did not come again
    EXPECT_EQ(
        ViolationsOf(network, {Frame(0, 0x103U, plain), Frame(0, 0x104U, turned), Frame(30000, 0x101U, plain)}, 200000),
        (Texts{"50000 SRVT expired", "50000 SCT expired"}));
    // At one time and for one cause, of other frames
    EXPECT_EQ(ViolationsOf(network, {Frame(0, 0x101U, plain), Frame(0, 0x103U, plain)}, 200000),
              (Texts{"20000 SRVT expired", "20000 SRVT expired"}));
}

TEST(StateOfTheNodes, IsThatOfCommandsAndOfMessagesOfOneByte)
{
    Verifies(req::SRS_MON_009);
    const Network network({{Example("sensor"), std::nullopt}, {Example("controller"), std::nullopt}}, std::nullopt);
    const auto violations = [&network](const LogFrame& frame)
    {
        return ViolationsOf(network, {Frame(0, 0x101U, {1U, 2U}), Frame(100, 0x102U, {0xFEU, 0xFDU}), frame}, 200000)
            .size();
    };
    // It leaves OPERATIONAL
    for (const std::uint8_t command : {std::uint8_t{2U}, std::uint8_t{128U}, std::uint8_t{129U}, std::uint8_t{130U}})
    {
        EXPECT_EQ(violations(Frame(200, 0x000U, {command, 1U})), 0U) << int{command};
    }
    EXPECT_EQ(violations(Frame(200, 0x701U, {0U})), 0U);
    // and with the next valid pair, SCT 50 ms behind it, it is watched again
    EXPECT_EQ(
        ViolationsOf(network,
                     {Frame(0, 0x101U, {1U, 2U}), Frame(100, 0x102U, {0xFEU, 0xFDU}), Frame(200, 0x000U, {2U, 1U}),
                      Frame(900000, 0x101U, {1U, 2U}), Frame(900100, 0x102U, {0xFEU, 0xFDU})},
                     1000000),
        Texts{"950000 SCT expired"});
    // It does not: the pair is awaited
    LogFrame remote = Frame(200, 0x000U, {});
    remote.is_remote = true;
    remote.length = 2U;
    EXPECT_EQ(violations(remote), 1U);
    remote.identifier = 0x701U;
    remote.length = 1U;
    EXPECT_EQ(violations(remote), 1U);
    EXPECT_EQ(violations(Frame(200, 0x000U, {1U, 1U})), 1U);
    EXPECT_EQ(violations(Frame(200, 0x000U, {3U, 1U})), 1U);
    EXPECT_EQ(violations(Frame(200, 0x000U, {2U})), 1U);
    EXPECT_EQ(violations(Frame(200, 0x701U, {0U, 0U})), 1U);
    EXPECT_EQ(violations(Frame(200, 0x701U, {5U})), 1U);
}

// Given a chain whose producer falls silent behind an error control frame that is marked INVALID, then that frame has
// stopped nothing: SCT is told. It was taken for the end of OPERATIONAL, and the silence was told by nobody.
TEST(StateOfTheNodes, IsNotThatOfAFrameThatIsInvalid)
{
    Verifies(req::SRS_MON_009);
    Verifies(req::SRS_MON_710);
    const Network network({{Example("sensor"), std::nullopt}, {Example("controller"), std::nullopt}}, std::nullopt);
    const std::vector<LogFrame> pair{Frame(0, 0x101U, {1U, 2U}), Frame(100, 0x102U, {0xFEU, 0xFDU})};
    const auto violations = [&network, &pair](const std::vector<LogFrame>& behind)
    {
        std::vector<LogFrame> frames = pair;
        frames.insert(frames.end(), behind.begin(), behind.end());
        return ViolationsOf(network, frames, 200000);
    };
    const Texts told{"50000 SCT expired"};
    for (const std::uint8_t byte : std::vector<std::uint8_t>{3U, 1U, 6U, 126U, 0x80U, 0x83U})
    {
        EXPECT_EQ(violations({Frame(200, 0x701U, {byte})}), told) << int{byte};
    }
    for (const std::uint8_t byte : std::vector<std::uint8_t>{0U, 4U, 127U, 0x84U, 0xFFU})
    {
        EXPECT_EQ(violations({Frame(200, 0x701U, {byte})}), Texts{}) << int{byte};
    }
    // A guarding answer whose toggle bit did not alternate tells nothing, one that did tells its state
    LogFrame request = Frame(200, 0x701U, {});
    request.is_remote = true;
    request.length = 1U;
    const LogFrame running = Frame(200, 0x701U, {0x85U});
    EXPECT_EQ(violations({request, running, request, Frame(300, 0x701U, {0x84U})}), told);
    EXPECT_EQ(violations({request, running, request, Frame(300, 0x701U, {0x04U})}), Texts{});
    // A boot-up is no answer, and begins the toggle bit anew; what nobody asked for is a heartbeat
    EXPECT_EQ(violations({request, running, request, Frame(300, 0x701U, {0U}), pair[0], pair[1], request,
                          Frame(400, 0x701U, {0x84U})}),
              Texts{});
    EXPECT_EQ(violations({request, running, Frame(300, 0x701U, {0x84U})}), Texts{});
    // A frame of another length does not answer, and the answer is still due
    EXPECT_EQ(violations({request, running, request, Frame(250, 0x701U, {4U, 4U}), Frame(300, 0x701U, {0x84U})}), told);
    // What was before a time that was not seen tells nothing of toggle bits
    Texts texts;
    Analysis analysis(network,
                      [&texts](const Violation& violation) { texts.push_back(CauseName(violation.breach.cause)); });
    analysis.Take(request);
    analysis.Take(running);
    analysis.Interrupt();
    for (const LogFrame& frame :
         {Frame(1000, 0x101U, {1U, 2U}), Frame(1100, 0x102U, {0xFEU, 0xFDU}), request, Frame(1300, 0x701U, {0x84U})})
    {
        analysis.Take(frame);
    }
    analysis.Advance(200 * kMillisecond);
    EXPECT_EQ(texts, Texts{});
}
} // namespace
} // namespace counterpoint::monitor
