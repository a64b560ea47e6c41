// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Files that can or cannot become a device, and what of them the kernel gets.
#include "canopen/cia306/text/text_file.hpp"
#include "runtime/device/model.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/canopen/cia306/folder_of_files.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace counterpoint::runtime
{
namespace
{
using cia306::test::FileText;

/// The text with `to` in place of the first `from` behind the head of a section.
std::string InSection(std::string text, const std::string& section, const std::string& from, const std::string& to)
{
    const std::size_t place = text.find(from, text.find("[" + section + "]\n"));
    EXPECT_NE(place, std::string::npos) << section << " has no " << from;
    return place == std::string::npos ? text : text.replace(place, from.size(), to);
}

constexpr const char* kPlain = "[FileInfo]\n\n[DeviceComissioning]\nNodeID=5\n\n[2000]\nParameterName=Speed\n"
                               "ObjectType=0x7\nDataType=5\nAccessType=rw\nDefaultValue=7\nPDOMapping=1\n\n";

class DeviceFile : public cia306::test::FolderTest
{
  protected:
    [[nodiscard]] DeviceModel ModelOf(const std::string& text, const SafetyNeed need = SafetyNeed::kRequired) const
    {
        return DeviceModel(File("a.dcf", text), std::nullopt, need);
    }

    /// What is said behind the name of the file; empty where it becomes a device.
    [[nodiscard]] std::string RefusalOf(const std::string& text, const SafetyNeed need = SafetyNeed::kRequired) const
    {
        try
        {
            const DeviceModel model(File("a.dcf", text), std::nullopt, need);
        }
        catch (const cia306::InputError& error)
        {
            return std::string(error.what()).substr(Path("a.dcf").size());
        }
        return "";
    }
};

TEST_F(DeviceFile, HasANodeIdAndAnSrdo)
{
    Verifies(req::SRS_SIM_002);
    EXPECT_EQ(RefusalOf(FileText("digest")), "");
    EXPECT_EQ(RefusalOf(InSection(FileText("digest"), "DeviceComissioning", "NodeID=127\n", "")),
              ": error: no node-ID, expected NodeID in [DeviceComissioning], --node-id, or node_id in the scenario");
    EXPECT_EQ(RefusalOf(kPlain), ": error: no SRDO, expected objects 0x1301 to 0x1340 with at least one SRDO");
    // Of a file that has a safety object the line of that is named
    EXPECT_EQ(RefusalOf(kPlain + cia306::test::VariableText("13FE", "0x0005", "0xA5"), SafetyNeed::kOptional),
              ":14:1: error: no SRDO, expected objects 0x1301 to 0x1340 with at least one SRDO");
}

TEST_F(DeviceFile, OfAPlainDeviceHasOneSrdoThatIsOffAndNoVariables)
{
    Verifies(req::SRS_NODE_016);
    const DeviceModel model = ModelOf(kPlain, SafetyNeed::kOptional);
    EXPECT_TRUE(model.Srdos().empty());
    EXPECT_TRUE(model.Objects().empty());
    EXPECT_TRUE(model.Writes().empty());
    EXPECT_EQ(model.Config().srdo_count, 1U);
    EXPECT_EQ(model.Config().srdos[0].number, 1U);
    EXPECT_EQ(model.Config().srdos[0].policy, ReleasePolicy::kInterlock);
    EXPECT_EQ(model.NumberOf(0U), 0U);
    EXPECT_FALSE(model.SlotOf(1U).has_value());
    EXPECT_EQ(model.PairOf({0x2000U, 0U}), nullptr);
}

TEST_F(DeviceFile, WithServicesGivesTheKernelWhatIsForSrdos)
{
    Verifies(req::SRS_NODE_016);
    // Given an object for PDOs before the variables, and one for SRDOs that none maps behind them
    std::string text = FileText("digest");
    text += "\n[2100]\nParameterName=P\nObjectType=0x7\nDataType=5\nAccessType=ro\nDefaultValue=1\nPDOMapping=1\n";
    text += "\n[2600]\nParameterName=S\nObjectType=0x7\nDataType=5\nAccessType=ro\nDefaultValue=2\nSRDOMapping=1\n";
    const DeviceModel all = ModelOf(text);
    ASSERT_EQ(all.Objects().size(), 6U);
    EXPECT_EQ(all.Objects()[0].index, 0x2100U);
    const DeviceModel model = ModelOf(text, SafetyNeed::kOptional);
    ASSERT_EQ(model.Objects().size(), 5U);
    EXPECT_EQ(model.Objects()[0].index, 0x2200U);
    EXPECT_EQ(model.Objects()[4].index, 0x2600U);
    EXPECT_EQ(*model.Objects()[4].place, 2U);
    ASSERT_EQ(model.Pairs().size(), 2U);
    EXPECT_EQ(model.Objects()[model.Pairs()[1].normal].index, 0x2400U);
    EXPECT_EQ(model.Objects()[model.Pairs()[1].inverse].index, 0x2500U);
    ASSERT_NE(model.PairOf({0x2400U, 1U}), nullptr);
    EXPECT_EQ(model.PairOf({0x2400U, 1U})->srdo, 5U);
    EXPECT_EQ(model.PairOf({0x2400U, 2U}), nullptr);
    EXPECT_EQ(model.PairOf({0x2500U, 1U}), nullptr);
}

TEST_F(DeviceFile, MapsItsOwnObjects)
{
    Verifies(req::SRS_SIM_002);
    EXPECT_EQ(RefusalOf(InSection(FileText("digest"), "1382sub2", "0x23000120", "0x99990120")),
              ":237:16: error: the mapping names 0x9999:01, expected an object of the file with SRDOMapping=1 and a "
              "length of 1 to 64 bits");
    // A value of one that is mapped has to fit; of one that is not it does not matter
    const std::string bad = InSection(FileText("digest"), "2200sub1", "SRDOMapping=1", "SRDOMapping=1\nDefaultValue=x");
    EXPECT_NE(RefusalOf(bad).find("0x2200:01: "), std::string::npos) << RefusalOf(bad);
    EXPECT_EQ(RefusalOf(FileText("digest") + "\n[2600]\nParameterName=S\nObjectType=0x7\nDataType=5\nAccessType=ro\n"
                                             "DefaultValue=x\nSRDOMapping=1\n"),
              "");
}

TEST_F(DeviceFile, HasAtMost128EntriesInAMapping)
{
    Verifies(req::SRS_SIM_002);
    EXPECT_EQ(RefusalOf(InSection(FileText("digest"), "1382sub0", "ParameterValue=2", "ParameterValue=129")),
              ":219:16: error: 0x1382:00: 129 mapping entries, expected at most 128");
}

TEST_F(DeviceFile, HasVariablesThatAreNumbers)
{
    Verifies(req::SRS_SIM_002);
    const DeviceModel model = ModelOf(FileText("digest") + "\n[2600]\nParameterName=Word\nObjectType=0x7\nDataType=9\n"
                                                           "AccessType=ro\nDefaultValue=x\nSRDOMapping=1\n");
    EXPECT_EQ(model.Objects().size(), 4U);
    EXPECT_EQ(model.NumberOf(0U), 2U);
    EXPECT_EQ(model.NumberOf(1U), 5U);
    EXPECT_EQ(model.NumberOf(2U), 0U);
}

// What a file lacks: 1300h is not written, 13FEh as not valid.
TEST_F(DeviceFile, IsConfiguredWithWhatItHas)
{
    Verifies(req::SRS_SIM_002);
    const DeviceModel whole = ModelOf(FileText("digest"));
    EXPECT_EQ(whole.Writes()[whole.Writes().size() - 2U].object.index, 0x1300U);
    EXPECT_EQ(whole.Writes()[whole.Writes().size() - 2U].value, 1U);
    EXPECT_EQ(whole.Writes().back().value, 0xA5U);
    std::string text = InSection(FileText("digest"), "1300", "[1300]", "[2F00]");
    EXPECT_EQ(RefusalOf(text), ":38:3: error: 0x1300: is listed, expected a section that describes it");
    text = InSection(InSection(text, "OptionalObjects", "0x1300", "0x2F00"), "13FE", "[13FE]", "[2F01]");
    const DeviceModel less = ModelOf(InSection(text, "OptionalObjects", "0x13FE", "0x2F01"));
    EXPECT_EQ(less.Writes()[less.Writes().size() - 2U].object.index, 0x1305U);
    EXPECT_EQ(less.Writes().back().object.index, 0x13FEU);
    EXPECT_EQ(less.Writes().back().value, 0U);
}

TEST_F(DeviceFile, HasAtMost1024Variables)
{
    Verifies(req::SRS_SIM_002);
    // Given the 4 variables of the file, and 1020 more
    std::string text = FileText("digest");
    for (int number = 0; number < 1020; ++number)
    {
        text += "\n[" + cia306::test::HexIndex(0x3000 + number) +
                "]\nParameterName=V\nObjectType=0x7\nDataType=5\nAccessType=ro\nDefaultValue=0\nSRDOMapping=1\n";
    }
    EXPECT_EQ(ModelOf(text).Config().object_count, 1024U);
    text += "\n[4000]\nParameterName=V\nObjectType=0x7\nDataType=5\nAccessType=ro\nDefaultValue=0\nSRDOMapping=1\n";
    EXPECT_EQ(RefusalOf(text), ": error: 1025 mappable objects, expected at most 1024");
}

TEST_F(DeviceFile, GivesVariablesTheDirectionOfTheirAccess)
{
    Verifies(req::SRS_SIM_002);
    const auto access = [this](const std::string& word)
    {
        const std::string text = InSection(FileText("digest"), "2400sub1", "AccessType=ro", word);
        return ModelOf(text).Objects()[2].access;
    };
    EXPECT_EQ(access("AccessType=ro"), MapAccess::kProducer);
    EXPECT_EQ(access("AccessType=rwr"), MapAccess::kProducer);
    EXPECT_EQ(access("AccessType=const"), MapAccess::kProducer);
    EXPECT_EQ(access("AccessType=wo"), MapAccess::kConsumer);
    EXPECT_EQ(access("AccessType=rww"), MapAccess::kConsumer);
    EXPECT_EQ(access("AccessType=rw"), MapAccess::kProducer); // A producer maps it.
    EXPECT_EQ(access(""), MapAccess::kNone);
    const DeviceModel received = ModelOf(InSection(FileText("digest"), "2200sub1", "AccessType=rww", "AccessType=rw"));
    EXPECT_EQ(received.Objects()[0].access, MapAccess::kConsumer); // A consumer maps it.
}

TEST_F(DeviceFile, NamesTheControllersOfAHost)
{
    Verifies(req::SRS_SIM_036);
    const auto refusal = [this](const std::string& normal, const std::string& inverse)
    {
        std::string text = InSection(FileText("digest"), "5F00subF", "ParameterValue=1", "ParameterValue=" + normal);
        text = InSection(text, "5F00sub10", "ParameterValue=2", "ParameterValue=" + inverse);
        return RefusalOf(text);
    };
    EXPECT_EQ(refusal("1", "1"), "");
    EXPECT_EQ(refusal("1", "2"), "");
    EXPECT_EQ(refusal("2", "2"), "");
    EXPECT_EQ(refusal("2", "1"), "");
    EXPECT_EQ(refusal("1", "3"), ":576:16: error: 0x5F00:10: controller 3, expected 1 or 2");
    EXPECT_EQ(refusal("1", "0"), ":576:16: error: 0x5F00:10: controller 0, expected 1 or 2");
    EXPECT_EQ(refusal("3", "1"), ":567:16: error: 0x5F00:0F: controller 3, expected 1 or 2");
}

TEST_F(DeviceFile, HasItsNormalFramesOnTheFirstControllerOfAHost)
{
    Verifies(req::SRS_SIM_490);
    const auto model = [this](const std::string& normal, const std::string& inverse)
    {
        std::string text = InSection(FileText("digest"), "5F00subF", "ParameterValue=1", "ParameterValue=" + normal);
        return ModelOf(InSection(text, "5F00sub10", "ParameterValue=2", "ParameterValue=" + inverse));
    };
    // Given a file with the normal frames on controller 2 and the inverse ones on 1
    const DeviceModel turned = model("2", "1");
    EXPECT_EQ(turned.Config().normal_port, CanPortId::kFirst);
    EXPECT_EQ(turned.Config().inverse_port, CanPortId::kSecond);
    EXPECT_EQ(turned.ControllerCount(), 2U);
    EXPECT_EQ(turned.Config().digest, 0U);
    // and one with all of them on controller 2
    const DeviceModel second = model("2", "2");
    EXPECT_EQ(second.Config().normal_port, CanPortId::kFirst);
    EXPECT_EQ(second.Config().inverse_port, CanPortId::kFirst);
    EXPECT_EQ(second.ControllerCount(), 1U);
    EXPECT_EQ(second.Config().digest, 0U);
    // With those of a host the digest of the file is expected
    EXPECT_EQ(model("1", "2").Config().digest, 0x5F9AFA3DU);
    EXPECT_EQ(model("1", "2").Config().inverse_port, CanPortId::kSecond);
}

TEST_F(DeviceFile, HasACycleThatIsOne)
{
    Verifies(req::SRS_NODE_490);
    Verifies(req::SRS_NODE_711);
    const auto refusal = [this](const std::string& cycle, const std::string& tolerance)
    {
        // Intervals that are long enough for a cycle of a second
        std::string text = InSection(FileText("digest"), "5F00sub1", "=2000\n", "=" + cycle + "\n");
        text = InSection(text, "5F00sub4", "=1234\n", "=4000\n");
        text = InSection(text, "5F00sub5", "=321\n", "=15000\n");
        text = InSection(text, "5F00sub7", "=123456\n", "=4000000\n");
        text = InSection(text, "5F00sub2", "=750\n", "=" + tolerance + "\n");
        const std::string told = RefusalOf(text);
        const std::size_t place = told.find("error: ");
        return place == std::string::npos ? told : told.substr(place);
    };
    EXPECT_EQ(refusal("100", "100"), "");
    EXPECT_EQ(refusal("1000000", "0"), "");
    EXPECT_EQ(refusal("0", "0"), "error: 0x5F00:01: cycle time 0 us, expected 100 us to 1000000 us");
    EXPECT_EQ(refusal("99", "0"), "error: 0x5F00:01: cycle time 99 us, expected 100 us to 1000000 us");
    EXPECT_EQ(refusal("1000001", "0"), "error: 0x5F00:01: cycle time 1000001 us, expected 100 us to 1000000 us");
    EXPECT_EQ(refusal("100", "101"),
              "error: 0x5F00:02: cycle tolerance of 101 us, expected at most the cycle time of 100 us");
    // Of a value that the file leaves out its beginning is named, as check does
    std::string text = InSection(FileText("digest"), "5F00sub1", "=2000\n", "=100\n");
    const std::size_t tolerance = text.find("[5F00sub2]");
    text.erase(tolerance, text.find("[5F00sub3]") - tolerance);
    EXPECT_EQ(RefusalOf(text),
              ":1:1: error: 0x5F00:02: cycle tolerance of 500 us, expected at most the cycle time of 100 us");
    EXPECT_EQ(refusal("100", "4294967196"),
              "error: 0x5F00:02: cycle tolerance of 4294967196 us, expected at most the cycle time of 100 us");
}

TEST_F(DeviceFile, HasNormalDataOnTheNormalSide)
{
    Verifies(req::SRS_NODE_550);
    const std::string file =
        cia306::ReadTextFile(cia306::test::SourceFolder() + "/examples/emergency_stop/controller.dcf");
    const auto with = [&file](const std::string& first, const std::string& second)
    {
        const std::string text = InSection(file, "1381sub1", "=0x22000108\n", "=" + first + "\n");
        return InSection(text, "1381sub2", "=0x23000108\n", "=" + second + "\n");
    };
    ASSERT_EQ(RefusalOf(file), "");
    // Exchanged: the inverse value would be the one that counts, and the pair would hold
    const std::string exchanged = with("0x23000108", "0x22000108");
    EXPECT_EQ(RefusalOf(exchanged), ":345:16: error: 0x1381:01: normal entry 0x2300:01 is the InvertedSRAD of "
                                    "0x2200:01 (line 550), expected normal data here and 0x2300:01 behind it");
    EXPECT_EQ(RefusalOf(exchanged, SafetyNeed::kOptional), RefusalOf(exchanged));
    // Normal data as the inverse of others, and the inverse of others
    const std::string other = ", expected 0x2300:01, the InvertedSRAD of 0x2200:01 (line 550)";
    EXPECT_EQ(RefusalOf(with("0x22000108", "0x22000208")),
              ":354:16: error: 0x1381:02: inverse entry 0x2200:02" + other);
    EXPECT_EQ(RefusalOf(with("0x22000108", "0x23000208")),
              ":354:16: error: 0x1381:02: inverse entry 0x2300:02" + other);
    const std::string unnamed = InSection(with("0x22000108", "0x22000208"), "2200sub1", "InvertedSRAD=0x230001\n", "");
    EXPECT_EQ(RefusalOf(unnamed), ":354:16: error: 0x1381:02: inverse entry 0x2200:02 has an InvertedSRAD of its own "
                                  "(line 559), as normal data has, expected inverse data of 0x2200:01");
    // What is off has no value; what the file does not tell, nobody knows
    EXPECT_EQ(RefusalOf(InSection(exchanged, "1301sub1", "ParameterValue=2\n", "ParameterValue=0\n")), "");
    EXPECT_EQ(RefusalOf(InSection(exchanged, "2200sub1", "InvertedSRAD=0x230001\n", "")), "");
    // Normal data of one SRDO and inverse data of another
    std::string both = InSection(file, "2200sub1", "InvertedSRAD=0x230001\n", "");
    both = InSection(both, "1382sub1", "=0x20000108\n", "=0x23000108\n");
    both = InSection(both, "1382sub2", "=0x21000108\n", "=0x22000108\n");
    EXPECT_EQ(RefusalOf(InSection(both, "2000sub1", "InvertedSRAD=0x210001\n", "")),
              ":395:16: error: 0x1382:01: normal entry 0x2300:01 is inverse data of SRDO 1, expected an object of one "
              "side");
}

// Node 33 has COB-IDs 103h and 104h, node 35 105h and 106h
TEST_F(DeviceFile, HasTheSignaturesOfItsNodeId)
{
    Verifies(req::SRS_NODE_551);
    const std::string file =
        cia306::ReadTextFile(cia306::test::SourceFolder() + "/examples/emergency_stop/actuator.dcf");
    std::string follows = InSection(file, "1301sub5", "ParameterValue=0x00000103", "ParameterValue=$NODEID+0xE2");
    follows = InSection(follows, "1301sub6", "ParameterValue=0x00000104", "ParameterValue=$NODEID+0xE3");
    const auto signature_of = [this](const std::string& text, const std::optional<std::uint8_t> node_id)
    {
        const DeviceModel model(File("a.dcf", text), node_id);
        const auto& writes = model.Writes();
        const auto found = std::find_if(writes.begin(), writes.end(), [](const ConfigurationWrite& write)
                                        { return write.object.index == 0x13FFU && write.object.sub == 1U; });
        return found == writes.end() ? 0U : found->value;
    };
    EXPECT_EQ(signature_of(follows, std::nullopt), 0x9FCBU);
    EXPECT_EQ(signature_of(follows, 33U), 0x9FCBU);
    EXPECT_EQ(signature_of(follows, 35U), 0x16B5U);
    EXPECT_EQ(signature_of(file, 35U), 0x9FCBU);
    // A wrong one stays wrong, as one that nobody can compute or whose node-ID the file does not tell
    const std::string wrong = InSection(follows, "13FFsub1", "0x9FCB", "0x9FCC");
    EXPECT_EQ(signature_of(wrong, 35U), 0x9FCCU);
    EXPECT_EQ(signature_of(InSection(follows, "1301sub2", "ParameterValue=50", "ParameterValue=$NODEID+65503"), 32U),
              0x9FCBU);
    EXPECT_EQ(signature_of(InSection(follows, "DeviceComissioning", "NodeID=33\n", ""), 35U), 0x9FCBU);
}

TEST_F(DeviceFile, WithASecondControllerIsAnotherDevice)
{
    Verifies(req::SRS_SIM_009);
    Verifies(req::SRS_SIM_036);
    // Given one controller, and a digest
    DeviceModel one = ModelOf(InSection(FileText("digest"), "5F00sub10", "ParameterValue=2", "ParameterValue=1"));
    EXPECT_EQ(one.ControllerCount(), 1U);
    EXPECT_EQ(one.Config().digest, 0x5F9AFA3DU);
    one.UseTwoControllers();
    EXPECT_EQ(one.ControllerCount(), 2U);
    EXPECT_EQ(one.Config().digest, 0U);
    // Given two, then nothing changes
    DeviceModel two = ModelOf(FileText("digest"));
    two.UseTwoControllers();
    EXPECT_EQ(two.ControllerCount(), 2U);
    EXPECT_EQ(two.Config().digest, 0x5F9AFA3DU);
    // With another node-ID it is another device, too
    EXPECT_EQ(DeviceModel(File("b.dcf", FileText("digest")), std::uint8_t{9U}).Config().digest, 0U);
}

TEST_F(DeviceFile, WithAStaticMappingHasItsFieldsInOrder)
{
    Verifies(req::SRS_SIM_009);
    DeviceModel model = ModelOf(FileText("static"));
    ASSERT_EQ(model.StaticTables().size(), 2U);
    EXPECT_EQ(model.StaticTables()[0].count, 16U);
    EXPECT_EQ(model.StaticTables()[0].entries[1], 0x23000108U);
    EXPECT_EQ(model.FieldsOf(model.StaticTables()[0]).normal, model.Memory().data());
    EXPECT_EQ(model.FieldsOf(model.StaticTables()[0]).inverse, model.Memory().data() + 8);
    ASSERT_NE(model.StaticTableOf(3U), nullptr);
    EXPECT_EQ(model.StaticTableOf(3U)->normal, 16U);
    EXPECT_EQ(model.StaticTableOf(2U), nullptr);
    EXPECT_EQ(model.Config().srdos[1].map.count, 6U);
    // And nobody writes it
    for (const ConfigurationWrite& write : model.Writes())
    {
        EXPECT_FALSE(write.object.index >= 0x1381U && write.object.index <= 0x13C0U) << write.object.index;
    }
}

TEST_F(DeviceFile, IsNamedWhereTheKernelRefusesIt)
{
    Verifies(req::SRS_SIM_002);
    const DeviceModel model = ModelOf(FileText("digest"));
    const std::string end = "), expected a configuration that it accepts; 'counterpoint check' tells more";
    const auto text = [this, &model](const AbortCode code)
    {
        const ConfigurationWrite write{{0x1302U, 2U}, 80U, 2U, {104U, 16U}};
        return std::string(runtime::RefusalOf(model, write, code).what()).substr(Path("a.dcf").size());
    };
    const std::string begin = ":104:16: error: 0x1302:02: the device refuses 0x0050 with abort code ";
    EXPECT_EQ(text(AbortCode::kValueRange),
              begin + "0609 0030h (value out of range, or identifiers that are in use or no pair" + end);
    EXPECT_EQ(text(AbortCode::kNone), begin + "0000 0000h (no error" + end);
    EXPECT_EQ(text(AbortCode::kUnsupportedAccess), begin + "0601 0000h (mapping in use" + end);
    EXPECT_EQ(text(AbortCode::kReadOnly), begin + "0601 0002h (read only" + end);
    EXPECT_EQ(text(AbortCode::kObjectUnknown), begin + "0602 0000h (unknown object" + end);
    EXPECT_EQ(text(AbortCode::kNotMappable), begin + "0604 0041h (not mappable, or another length" + end);
    EXPECT_EQ(text(AbortCode::kMapTooLong), begin + "0604 0042h (odd count, or more than 64 bits" + end);
    EXPECT_EQ(text(AbortCode::kIncompatible),
              begin + "0604 0043h (the configuration does not hold: signature, timing, identifiers or mapping" + end);
    EXPECT_EQ(text(AbortCode::kLengthMismatch), begin + "0607 0010h (wrong size" + end);
    EXPECT_EQ(text(AbortCode::kSubUnknown), begin + "0609 0011h (unknown sub-index" + end);
    EXPECT_EQ(text(AbortCode::kGeneral), begin + "0800 0000h (the channels differ" + end);
    EXPECT_EQ(text(AbortCode::kDeviceState), begin + "0800 0022h (not in this state" + end);
    EXPECT_EQ(text(static_cast<AbortCode>(0x12345678U)), begin + "1234 5678h (unknown abort code" + end);
}
} // namespace
} // namespace counterpoint::runtime
