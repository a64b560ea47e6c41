// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Process data of a manager with the EL6751 profile.
#include "runtime/manager/report/status.hpp"
#include "tests/runtime/manager/rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/verifies.hpp"

#include <algorithm>

namespace counterpoint::tools
{
namespace
{
using test::Lines;

using ManagerPdosTest = test::ManagerRig;

/// A slave with an RxPDO of two bytes and a TxPDO of one, of which nothing is asked before its start.
std::string PdoDcf()
{
    const auto number = [](const std::string& object, const std::string& type, const std::string& value)
    {
        return "[" + object + "]\nParameterName=x\nObjectType=0x7\nDataType=" + type +
               "\nAccessType=rw\nPDOMapping=1\nParameterValue=" + value + "\n";
    };
    const auto record = [](const std::string& object, const std::string& subs)
    { return "[" + object + "]\nParameterName=x\nObjectType=0x9\nSubNumber=" + subs + "\n"; };
    return "[FileInfo]\nFileName=x\nFileVersion=1\nFileRevision=1\n[DeviceInfo]\nVendorName=x\n"
           "[DeviceComissioning]\nNodeID=10\n[MandatoryObjects]\nSupportedObjects=3\n1=0x1000\n2=0x1001\n3=0x1018\n"
           "[1000]\nParameterName=x\nObjectType=0x7\nDataType=0x7\nAccessType=ro\nDefaultValue=0\n"
           "[1001]\nParameterName=x\nObjectType=0x7\nDataType=0x5\nAccessType=ro\nDefaultValue=0\n" +
           record("1018", "2") +
           "[1018sub0]\nParameterName=x\nObjectType=0x7\nDataType=0x5\nAccessType=ro\nDefaultValue=1\n"
           "[1018sub1]\nParameterName=x\nObjectType=0x7\nDataType=0x7\nAccessType=ro\nDefaultValue=0\n"
           "[OptionalObjects]\nSupportedObjects=4\n1=0x1400\n2=0x1600\n3=0x1800\n4=0x1A00\n" +
           record("1400", "3") + number("1400sub0", "0x5", "2") + number("1400sub1", "0x7", "0x20A") +
           number("1400sub2", "0x5", "255") + record("1600", "2") + number("1600sub0", "0x5", "1") +
           number("1600sub1", "0x7", "0x20000010") + record("1800", "3") + number("1800sub0", "0x5", "2") +
           number("1800sub1", "0x7", "0x18A") + number("1800sub2", "0x5", "255") + record("1A00", "2") +
           number("1A00sub0", "0x5", "1") + number("1A00sub1", "0x7", "0x20010008") +
           "[ManufacturerObjects]\nSupportedObjects=2\n1=0x2000\n2=0x2001\n" + number("2000", "0x6", "0") +
           number("2001", "0x5", "0");
}

std::string PdoNetwork(const std::string& more, const std::string& profile = "el6751")
{
    return "manager: {node: 127, profile: " + profile +
           "}\nslaves:\n  - {node: 10, dcf: pdo.dcf, configure: false, el6751: {check_device_type: false, "
           "write_cob_ids: false, write_types: false}" +
           more + "}\n";
}

TEST_F(ManagerPdosTest, OutputsGoOutAndInputsAreTold)
{
    Verifies(req::SRS_MGR_022);
    static_cast<void>(File("pdo.dcf", PdoDcf()));
    Make(PdoNetwork(",\n     outputs: [{pdo: 1, data: 01 FE}]"));
    // Given a started slave, then 1 s later its RxPDO has what the file says
    Run(900U);
    EXPECT_EQ(Count(0x20AU), 0U);
    Run(200U);
    ASSERT_EQ(Count(0x20AU), 1U);
    EXPECT_EQ(sent.back().identifier, 0x20AU);
    EXPECT_EQ(sent.back().length_bytes, 2U);
    EXPECT_EQ(sent.back().data[0], 0x01U);
    EXPECT_EQ(sent.back().data[1], 0xFEU);
    // When an order changes it, then it is sent again
    EXPECT_EQ(Order("output 10 1 0203"), "taken");
    Run(2U);
    ASSERT_EQ(Count(0x20AU), 2U);
    EXPECT_EQ(sent.back().data[1], 0x03U);
    EXPECT_EQ(Order("output 10 1 02"), "RxPDO 1 of node 10 with 1 bytes, expected 2");
    EXPECT_EQ(Order("output 10 2 02"), "no RxPDO 2 of node 10, expected one that its DCF switches on and maps");
    EXPECT_EQ(Order("output 11 1 02"), "RxPDO 1 of node 11, expected a slave of a network with the profile el6751");
    for (const char* const wrong : {"output", "output 10", "output 10 1", "output 10 1 0", "output 10 1 0x12",
                                    "output 10 1 0 1", "output 10 513 00", "output 10 1 000102030405060708"})
    {
        EXPECT_EQ(runtime::ParseManagerOrder(wrong).kind, runtime::ManagerOrderKind::kProblem) << wrong;
    }
}

TEST_F(ManagerPdosTest, WaitingForTxPdosIsNoFailureOfTheRun)
{
    Verifies(req::SRS_MGR_004);
    static_cast<void>(File("pdo.dcf", PdoDcf()));
    Make(PdoNetwork(""));
    EXPECT_FALSE(station->Assembly().HasStarted());
    // Given a mandatory slave that runs, and whose TxPDO did not come yet
    Run(1100U);
    EXPECT_EQ(runtime::StatusJson(*station, now_us)["slaves"][0]["code"], 23);
    EXPECT_FALSE(station->Assembly().IsGood(cia302::NodeId{10U}));
    EXPECT_TRUE(station->Assembly().HasStarted());
    // When it is stopped, then that is no waiting
    EXPECT_EQ(Order("stop 10"), "taken");
    Run(2U);
    EXPECT_FALSE(station->Assembly().HasStarted());
}

TEST_F(ManagerPdosTest, InputsAreToldAndShown)
{
    Verifies(req::SRS_MGR_158);
    Verifies(req::SRS_MGR_159);
    static_cast<void>(File("pdo.dcf", PdoDcf()));
    Make(PdoNetwork(""));
    Run(10U);
    EXPECT_NE(runtime::StatusTable(*station, now_us).find("10    TxPDO 1     -\n"), std::string::npos);
    // When 50 other values come in as many milliseconds, then one is told at once and the last one 100 ms later
    for (std::uint8_t value = 1U; value <= 50U; ++value)
    {
        Hear(0x18AU, {value});
        Run(1U);
    }
    Run(100U);
    Lines told;
    for (const runtime::ManagerEvent& event : events)
    {
        if (event.kind == "pdo")
        {
            told.push_back(std::to_string(event.node) + " " + event.text);
        }
    }
    EXPECT_EQ(told, (Lines{"10 TxPDO 1: 01", "10 TxPDO 1: 32"}));
    const std::string table = runtime::StatusTable(*station, now_us);
    EXPECT_NE(table.find("10    RxPDO 1     00 00\n"), std::string::npos) << table;
    EXPECT_NE(table.find("10    TxPDO 1     32                        101 ms\n"), std::string::npos) << table;
    const auto json = runtime::StatusJson(*station, now_us);
    EXPECT_EQ(json["event"], "table");
    EXPECT_EQ(json["pdos"][0]["data"], "00 00");
    EXPECT_EQ(json["pdos"][1]["data"], "32");
    // A frame that is too short is no value
    Hear(0x18AU, {});
    EXPECT_EQ(station->Pdos().Values()[1].bytes, (std::vector<std::uint8_t>{0x32U}));
}

TEST_F(ManagerPdosTest, OutputsThatNobodySendsAreRefused)
{
    Verifies(req::SRS_MGR_022);
    static_cast<void>(File("pdo.dcf", PdoDcf()));
    const auto problem = [this](const std::string& text)
    {
        try
        {
            Make(text);
        }
        catch (const std::exception& error)
        {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    const std::string file = Path("net.yaml");
    EXPECT_EQ(problem(PdoNetwork(",\n     outputs: [{pdo: 2, data: 01}]")),
              file + ":4:16: error: no RxPDO 2 of node 10, expected one that its DCF switches on and maps");
    EXPECT_EQ(problem(PdoNetwork(",\n     outputs: [{pdo: 1, data: 01}]")),
              file + ":4:16: error: RxPDO 1 of node 10 with 1 bytes, expected 2 as its mapping has");
    EXPECT_EQ(problem(PdoNetwork(",\n     outputs: [{pdo: 1, data: 01 02}, {pdo: 1, data: 01 02}]")),
              file + ":4:39: error: RxPDO 1 of node 10 a second time, expected each RxPDO once");
    EXPECT_EQ(problem(PdoNetwork(",\n     outputs: [{pdo: 1, data: 0g}]")),
              file + ":4:31: error: '0g', expected 1 to 8 bytes as hexadecimal digits, such as 01 FF");
    EXPECT_NE(problem(PdoNetwork(",\n     outputs: {pdo: 1}")).find(":4:"), std::string::npos);
    EXPECT_EQ(problem(PdoNetwork(",\n     outputs: [{pdo: 1, data: 01 02}]", "cia302")),
              file + ":4:16: error: outputs of node 10 with another profile, expected the profile el6751, which sends "
                     "RxPDOs");
}

TEST_F(ManagerPdosTest, AValueThatComesAgainIsNoNews)
{
    Verifies(req::SRS_MGR_159);
    static_cast<void>(File("pdo.dcf", PdoDcf()));
    Make(PdoNetwork(""));
    Run(10U);
    Hear(0x18AU, {0x07U});
    Run(200U);
    Hear(0x18AU, {0x07U});
    CanFrame remote{0x18AU, FrameKind::kRemote, CanPortId::kFirst, 1U, {}};
    station->OnFrame(remote, now_us);
    Run(200U);
    EXPECT_EQ(std::count_if(events.begin(), events.end(), [](const auto& event) { return event.kind == "pdo"; }), 1);
    EXPECT_EQ(station->Pdos().Values()[1].bytes, (std::vector<std::uint8_t>{0x07U}));
    // Though its age is that of the last one
    EXPECT_NE(runtime::StatusTable(*station, now_us).find("10    TxPDO 1     07                        200 ms\n"),
              std::string::npos)
        << runtime::StatusTable(*station, now_us);
}

TEST_F(ManagerPdosTest, WhoWaitsForTxPdosAndDoesNotRunOrMayBeTwoHasNotStarted)
{
    Verifies(req::SRS_MGR_004);
    static_cast<void>(File("pdo.dcf", PdoDcf()));
    const auto code = [this] { return runtime::StatusJson(*station, now_us)["slaves"][0]["code"]; };
    // Given a slave that waits for its TxPDO, and says twice that it is PRE-OPERATIONAL
    Make(PdoNetwork(""));
    Run(1100U);
    ASSERT_EQ(code(), 23);
    EXPECT_TRUE(station->Assembly().HasStarted());
    Hear(0x70AU, {0x7FU});
    EXPECT_TRUE(station->Assembly().HasStarted()); // One may have been under way when it was started.
    Hear(0x70AU, {0x7FU});
    ASSERT_EQ(code(), 23);
    EXPECT_FALSE(station->Assembly().HasStarted());
    // And one that may be two devices
    Make(PdoNetwork(""));
    Run(1100U);
    for (const std::uint8_t sub : {std::uint8_t{1U}, std::uint8_t{2U}, std::uint8_t{3U}})
    {
        Hear(0x60AU, {0x40U, 0x18U, 0x10U, sub, 0U, 0U, 0U, 0U});
        Hear(0x58AU, {0x43U, 0x18U, 0x10U, sub, 1U, 0U, 0U, 0U});
        Hear(0x58AU, {0x43U, 0x18U, 0x10U, sub, 2U, 0U, 0U, 0U});
    }
    ASSERT_EQ(code(), 23);
    EXPECT_FALSE(station->Assembly().HasStarted());
}

TEST_F(ManagerPdosTest, WhoseStartUpFailedHasNotStartedThoughItWaitsForTxPdosAlone)
{
    Verifies(req::SRS_MGR_004);
    // Given another device, which was started by an order
    static_cast<void>(File("pdo.dcf", PdoDcf()));
    Make("manager: {node: 127, profile: el6751}\nslaves:\n  - {node: 10, dcf: pdo.dcf, configure: false, device_type: "
         "0x191, el6751: {write_cob_ids: false, write_types: false}}\n");
    Run(10U);
    Hear(0x70AU, {0U});
    Answer(10U, {0x43U, 0x00U, 0x10U, 0x00U, 0x92U, 0x01U, 0x00U, 0x00U}, 600);
    EXPECT_EQ(Order("start 10").rfind("taken; started all the same", 0U), 0U);
    Run(1100U);
    EXPECT_EQ(runtime::StatusJson(*station, now_us)["slaves"][0]["code"], 23);
    EXPECT_FALSE(station->Assembly().HasStarted());
}
} // namespace
} // namespace counterpoint::tools
