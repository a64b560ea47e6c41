// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// CPJ files of CiA 306-3, key by key.
#include "canopen/network_plan/cpj_reader.hpp"
#include "tests/canopen/network_plan/plan_rig.hpp"

namespace counterpoint::network_plan
{
namespace
{
using Texts = std::vector<std::string>;

class CpjTest : public cia306::test::FolderTest
{
  protected:
    /// A network of node 5, whose DCF has this section.
    [[nodiscard]] std::string Cpj(const std::string& keys, const std::string& dcf) const
    {
        static_cast<void>(File("five.dcf", "[DeviceInfo]\nVendorName=test\n\n" + dcf));
        return File("net.cpj", "[Topology]\nNodes=1\nNode5Present=1\n" + keys);
    }
    [[nodiscard]] std::string Refusal(const std::string& keys, const std::string& dcf = "",
                                      const std::uint8_t manager = 127U) const
    {
        try
        {
            static_cast<void>(ReadCpj(Cpj(keys, dcf), manager));
        }
        catch (const cia306::InputError& error)
        {
            return std::string(error.what()).substr(Path("net.cpj").size());
        }
        return "";
    }
};

// CANopenManager of the DCF, in either spelling of its section; without it, or without a value, the device is none.
TEST_F(CpjTest, TheManagerIsWhoseDcfSaysSo)
{
    Verifies(req::SRS_NET_001);
    const std::string name = "Node5DCFName=five.dcf\n";
    const std::string none =
        ":1:1: error: no node is the manager, expected CANopenManager=1 in [DeviceComissioning] of one DCF, or the "
        "option --node-id";
    EXPECT_EQ(ReadCpj(Cpj(name, "[DeviceComissioning]\nCANopenManager=1\n"), 0U).manager.node, std::uint8_t{5U});
    EXPECT_EQ(ReadCpj(Cpj(name, "[DeviceCommissioning]\nCANopenManager=1\n"), 0U).manager.node, std::uint8_t{5U});
    EXPECT_EQ(Refusal(name, "[DeviceComissioning]\nCANopenManager=0\n", 0U), none);
    EXPECT_EQ(Refusal(name, "[DeviceComissioning]\nCANopenManager=\n", 0U), none);
    EXPECT_EQ(Refusal(name, "[DeviceComissioning]\nNodeID=5\n", 0U), none);
    EXPECT_EQ(Refusal(name, "", 0U), none);
}

// The option --node-id names no other one than the file.
TEST_F(CpjTest, AnotherManagerThanThatOfTheFileIsRefused)
{
    Verifies(req::SRS_NET_750);
    const std::string name = "Node5DCFName=five.dcf\n";
    const std::string says_so = "[DeviceComissioning]\nCANopenManager=1\n";
    EXPECT_EQ(Refusal(name, says_so, 6U),
              ":4:14: error: node 5 is the manager by CANopenManager=1, and another node-ID is asked for, 6, expected "
              "node-ID 5, or CANopenManager=0");
    const NetworkPlan same = ReadCpj(Cpj(name, says_so), 5U);
    EXPECT_EQ(same.manager.node, std::uint8_t{5U});
    EXPECT_EQ(same.manager.dcf, Path("five.dcf"));
    EXPECT_TRUE(same.slaves.empty());
    // A slave stays one, whoever the manager is said to be
    EXPECT_EQ(ReadCpj(Cpj(name, ""), 5U).slaves.size(), 1U);
    EXPECT_EQ(ReadCpj(Cpj(name, ""), 6U).manager.node, std::uint8_t{6U});
}

TEST_F(CpjTest, AKeyOfANodeHasItsNumberWithoutAZeroBeforeIt)
{
    Verifies(req::SRS_NET_001);
    const std::string name = "Node5DCFName=five.dcf\n";
    for (const std::string key : {"Node05Name", "Node0Name", "Node128Name", "Node1000Name"})
    {
        EXPECT_EQ(Refusal(name + key + "=x\n"),
                  ":5:1: error: key '" + key + "', expected a node-ID from 1 to 127 after Node");
    }
    // A number alone is a key that the format does not know
    const NetworkPlan plan = ReadCpj(Cpj(name + "Node5=x\n", ""), 127U);
    EXPECT_EQ(plan.warnings, Texts{Path("net.cpj") + ":5:1: warning: key 'Node5' is ignored, expected NetName, Nodes, "
                                                     "NodeNPresent, NodeNName or NodeNDCFName"});
    // So is the folder of other people's EDS files: names are those of files beside this one
    const NetworkPlan base = ReadCpj(Cpj(name + "EDSBaseName=eds\n", ""), 127U);
    EXPECT_EQ(base.warnings, Texts{Path("net.cpj") + ":5:1: warning: key 'EDSBaseName' is ignored, expected NetName, "
                                                     "Nodes, NodeNPresent, NodeNName or NodeNDCFName"});
}

// Relative to the folder of the network file; node 127 is the last one.
TEST_F(CpjTest, NumbersMayBeDecimalOctalOrHexadecimalAndKeysInEitherCase)
{
    Verifies(req::SRS_NET_001);
    static_cast<void>(File("five.dcf", "[DeviceInfo]\nVendorName=test\n"));
    for (const std::string one : {"1", "01", "0x1", "0X01"})
    {
        const NetworkPlan plan =
            ReadCpj(File("net.cpj", "[TOPOLOGY]\nNETNAME=Cell\nnodes=" + one + "\nnode1present=" + one +
                                        "\nNODE1NAME=Door\nNode1DcfName=five.dcf\n"),
                    127U);
        EXPECT_EQ(plan.name, "Cell") << one;
        EXPECT_EQ(plan.manager.node, std::uint8_t{127U}) << one;
        EXPECT_EQ(plan.warnings, Texts{}) << one;
        ASSERT_EQ(plan.slaves.size(), 1U) << one;
        EXPECT_EQ(plan.slaves[0].node, 1U) << one;
        EXPECT_EQ(plan.slaves[0].name, "Door") << one;
    }
}

TEST_F(CpjTest, ADcfNameMayHaveFoldersAfterEitherFashion)
{
    Verifies(req::SRS_NET_001);
    std::filesystem::create_directory(Path("devices"));
    static_cast<void>(File("devices/last.dcf", "[DeviceInfo]\nVendorName=test\n"));
    for (const std::string name : {"devices/last.dcf", "devices\\last.dcf", ".\\devices/last.dcf"})
    {
        const NetworkPlan plan =
            ReadCpj(File("net.cpj", "[Topology]\nNodes=1\nNode127Present=1\nNode127DCFName=" + name + "\n"), 1U);
        ASSERT_EQ(plan.slaves.size(), 1U) << name;
        EXPECT_EQ(plan.slaves[0].node, 127U) << name;
        EXPECT_EQ(std::filesystem::canonical(plan.slaves[0].dcf), std::filesystem::canonical(Path("devices/last.dcf")))
            << name;
    }
    // And no other folder
    EXPECT_NE(Refusal("Node5DCFName=devices/five.dcf\n").find(":4:14: error: "), std::string::npos);
}

TEST_F(CpjTest, ANodeIsNamedByItsNumberWhereItsNameIsEmpty)
{
    Verifies(req::SRS_NET_001);
    const std::string name = "Node5DCFName=five.dcf\n";
    EXPECT_EQ(ReadCpj(Cpj(name, ""), 127U).slaves.at(0).name, "node 5");
    EXPECT_EQ(ReadCpj(Cpj(name + "Node5Name=\n", ""), 127U).slaves.at(0).name, "node 5");
    EXPECT_EQ(ReadCpj(Cpj(name + "Node5Name=Door ; left\n", ""), 127U).slaves.at(0).name, "Door ; left");
}

TEST_F(CpjTest, ANodeThatIsPresentHasADcf)
{
    Verifies(req::SRS_NET_004);
    const std::string expected = ":3:14: error: node 5 is present and has no DCF, expected Node5DCFName=FILE";
    EXPECT_EQ(Refusal(""), expected);
    EXPECT_EQ(Refusal("Node5DCFName=\n"), expected);
    // One of 2 GB is no DCF; it is a hole and takes no room
    static_cast<void>(File("large.dcf", ""));
    std::filesystem::resize_file(Path("large.dcf"), 2147483648U);
    const std::string refusal = Refusal("Node5DCFName=large.dcf\n");
    EXPECT_EQ(refusal.find(":4:14: error: '" + Path("large.dcf") + "' has 2147483648 bytes, and "), 0U) << refusal;
    EXPECT_NE(refusal.find(" are the most, expected the DCF of node 5"), std::string::npos) << refusal;
}

// What stands behind a number is no part of it, and is told.
TEST_F(CpjTest, ACommentBehindAValueIsTold)
{
    Verifies(req::SRS_NET_001);
    const NetworkPlan plan = ReadCpj(Cpj("Node5DCFName=five.dcf\nNode6Present=0 ; not yet\n", ""), 127U);
    ASSERT_EQ(plan.warnings.size(), 1U);
    EXPECT_EQ(plan.warnings[0].find(Path("net.cpj") + ":5:16: warning: "), 0U) << plan.warnings[0];
    EXPECT_EQ(plan.slaves.size(), 1U);
}
} // namespace
} // namespace counterpoint::network_plan
