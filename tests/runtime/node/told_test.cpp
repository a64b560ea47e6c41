// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/runtime/node/bench.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// What a node tells of its SRDOs and their values: what was told last has to hold.
namespace counterpoint::tools::test
{
namespace
{
/// What was told of SRDOs and configuration, line by line.
std::vector<std::string> SrdoLines(const std::string& told)
{
    std::vector<std::string> lines;
    std::istringstream text(told);
    for (std::string line; std::getline(text, line);)
    {
        const std::size_t srdo = line.find(" s  SRDO ");
        const std::size_t place = (srdo == std::string::npos) ? line.find(" s  configuration") : srdo;
        const bool is_error = line.find("SRDO 1: ") != std::string::npos;
        if (place != std::string::npos && !is_error)
        {
            lines.push_back(line.substr(place + 4U));
        }
    }
    return lines;
}
/// The file with 1010h and 1011h.
std::string WithStoreObjects(const std::string& file)
{
    std::ofstream(file, std::ios::app) << "\n[1010]\nObjectType=8\nSubNumber=2\n"
                                          "[1010sub0]\nDataType=5\nAccessType=ro\nDefaultValue=1\n"
                                          "[1010sub1]\nDataType=7\nAccessType=rw\n"
                                          "[1011]\nObjectType=8\nSubNumber=2\n"
                                          "[1011sub0]\nDataType=5\nAccessType=ro\nDefaultValue=1\n"
                                          "[1011sub1]\nDataType=7\nAccessType=rw\n";
    return file;
}
using Lines = std::vector<std::string>;

const char* const kOfTheFile = "SRDO 1 consumer 0x103, safe within 81.5 ms of the last good normal frame";

// Cycle 5 ms and 5 ms late, output 1 ms, SRVT 20 ms; the clocks 0.5 ms apart in each 100 ms that begin.
TEST(NodeToldTest, TimesThatGoBackToThoseOfTheFileAreToldAgain)
{
    Verifies(req::SRS_NODE_052);
    Bench bench(FileWith("actuator", {{"1301sub2", "500"}, {"13FFsub1", "0"}, {"13FE", "0"}, {"5F04", "0"}}));
    bench.Change(2U, 500U, 2U);
    bench.Start(); // As was told at the start
    bench.Change(2U, 50U, 2U);
    bench.Start();
    bench.Change(2U, 500U, 2U);
    bench.Start();
    bench.Command(128U);
    bench.Start(); // Nothing new
    bench.Change(3U, 10U, 1U);
    bench.Start();
    EXPECT_EQ(SrdoLines(bench.Told()),
              (Lines{"SRDO 1 consumer 0x103, safe within 534 ms of the last good normal frame",
                     "SRDO 1 consumer 0x103, safe within 81.5 ms of the last good normal frame",
                     "SRDO 1 consumer 0x103, safe within 534 ms of the last good normal frame",
                     "SRDO 1 consumer 0x103, safe within 524 ms of the last good normal frame"}));
}

TEST(NodeToldTest, AnSrdoThatGoesOffAndOnAgainIsToldEachTime)
{
    Verifies(req::SRS_NODE_052);
    Bench bench(FileWith("actuator", {{"5F04", "0"}}));
    bench.Start();
    bench.Change(1U, 0U, 1U);
    bench.Start();
    bench.Command(128U);
    bench.Start();
    bench.Change(1U, 2U, 1U);
    bench.Start();
    EXPECT_EQ(SrdoLines(bench.Told()), (Lines{kOfTheFile, "SRDO 1 off", kOfTheFile}));
}

TEST(NodeToldTest, ARefreshTimeThatGoesBackIsToldAgain)
{
    Verifies(req::SRS_NODE_052);
    Bench bench(FileWith("sensor", {{"5F04", "0"}}), "", runtime::ReportForm::kJson);
    bench.Start();
    bench.Change(2U, 50U, 2U);
    bench.Start();
    bench.Change(2U, 25U, 2U);
    bench.Start();
    bench.Change(1U, 0U, 1U);
    bench.Start();
    std::vector<unsigned> refresh_ms;
    std::istringstream told(bench.Told());
    for (std::string line; std::getline(told, line);)
    {
        const nlohmann::json event = nlohmann::json::parse(line);
        if (event["event"] == "srdo")
        {
            refresh_ms.push_back(event["refresh_ms"].get<unsigned>());
        }
    }
    EXPECT_EQ(refresh_ms, (std::vector<unsigned>{25U, 50U, 25U, 0U}));
}

// The limit is the same, the partner another one.
TEST(NodeToldTest, AnotherIdentifierIsTold)
{
    Verifies(req::SRS_NODE_052);
    Bench bench(FileWith("actuator", {{"5F04", "0"}}));
    bench.Start();
    bench.Change(1U, 0U, 1U, false);
    EXPECT_EQ(bench.Download(0x1301U, 5U, 0x105U, 4U), 0U);
    EXPECT_EQ(bench.Download(0x1301U, 6U, 0x106U, 4U), 0U);
    bench.Change(1U, 2U, 1U);
    bench.Start();
    EXPECT_EQ(SrdoLines(bench.Told()),
              (Lines{kOfTheFile, "SRDO 1 consumer 0x105, safe within 81.5 ms of the last good normal frame"}));
    // A producer likewise
    Bench sensor(FileWith("sensor", {{"5F04", "0"}}));
    sensor.Change(1U, 0U, 1U, false);
    EXPECT_EQ(sensor.Download(0x1301U, 5U, 0x105U, 4U), 0U);
    EXPECT_EQ(sensor.Download(0x1301U, 6U, 0x106U, 4U), 0U);
    sensor.Change(1U, 1U, 1U);
    sensor.Start();
    EXPECT_EQ(SrdoLines(sensor.Told()),
              (Lines{"SRDO 1 producer 0x101, every 25 ms", "SRDO 1 producer 0x105, every 25 ms"}));
}

// Also where reset and start are carried out in one go: OPERATIONAL before and behind it.
TEST(NodeToldTest, WhatAResetBringsBackIsTold)
{
    Verifies(req::SRS_NODE_052);
    for (const std::uint8_t reset : {std::uint8_t{129U}, std::uint8_t{130U}})
    {
        Bench bench(FileWith("actuator", {{"5F04", "0"}}));
        for (int round = 0; round < 2; ++round)
        {
            bench.Change(2U, 100U, 2U);
            bench.Start();
            bench.Receive(0x000U, {reset, bench.Device().Assembly().NodeId()});
            bench.Start();
        }
        const std::string changed = "SRDO 1 consumer 0x103, safe within 132 ms of the last good normal frame";
        EXPECT_EQ(SrdoLines(bench.Told()), (Lines{kOfTheFile, changed, kOfTheFile, changed, kOfTheFile}));
    }
}

TEST(NodeToldTest, WhatAStoreLoadsOrGivesUpIsTold)
{
    Verifies(req::SRS_NODE_052);
    const std::string file = WithStoreObjects(FileWith("actuator", {{"5F04", "0"}}));
    const std::string store = ::testing::TempDir() + "told_limits.store";
    std::remove(store.c_str());
    const std::string saved = "SRDO 1 consumer 0x103, safe within 132 ms of the last good normal frame";
    {
        Bench bench(file, store);
        bench.Change(2U, 100U, 2U);
        bench.Store(0x1010U, 0x65766173U);
        bench.Start();
        EXPECT_EQ(SrdoLines(bench.Told()), (Lines{kOfTheFile, saved}));
    }
    Bench bench(file, store);
    bench.Start();
    bench.Command(128U);
    bench.Store(0x1011U, 0x64616F6CU);
    bench.Command(129U);
    bench.Start();
    EXPECT_EQ(SrdoLines(bench.Told()), (Lines{kOfTheFile, saved, kOfTheFile}));
}

// Saved with an SCT of 100 ms, then 50 ms as in the file, which is not saved.
TEST(NodeToldTest, WhatAResetLoadsIsToldBeforeTheDeviceMayRun)
{
    Verifies(req::SRS_NODE_330);
    for (const std::uint8_t reset : {std::uint8_t{129U}, std::uint8_t{130U}})
    {
        const std::string store = ::testing::TempDir() + "told_reset.store";
        std::remove(store.c_str());
        Bench bench(WithStoreObjects(FileWith("actuator", {{"5F04", "0"}})), store);
        bench.Change(2U, 100U, 2U);
        bench.Store(0x1010U, 0x65766173U);
        bench.Change(2U, 50U, 2U);
        bench.Start();
        // When it is reset, then the saved limit is told, and the device is PRE-OPERATIONAL behind that
        bench.Command(reset);
        const std::string told = bench.Told();
        const std::string saved = "SRDO 1 consumer 0x103, safe within 132 ms of the last good normal frame";
        EXPECT_EQ(SrdoLines(told), (Lines{kOfTheFile, saved}));
        EXPECT_GT(told.find(saved), told.find("NMT operational")) << told;
        EXPECT_LT(told.find(saved), told.rfind("NMT pre_operational")) << told;
        std::remove(store.c_str());
    }
}

// What was saved as node 33 is refused as a whole by node 9: no limit of the file holds until it is given up.
TEST(NodeToldTest, AConfigurationOfAStoreThatIsRefusedTakesTheLimitsOfTheFileBack)
{
    Verifies(req::SRS_NODE_532);
    const std::string file = WithStoreObjects(FileWith("actuator", {{"5F04", "0"}}));
    const std::string store = ::testing::TempDir() + "told_refused.store";
    std::remove(store.c_str());
    {
        Bench bench(file, store);
        bench.Store(0x1010U, 0x65766173U);
        EXPECT_EQ(SrdoLines(bench.Told()), (Lines{kOfTheFile}));
    }
    std::ifstream whole(file);
    std::ostringstream text;
    for (std::string line; std::getline(whole, line);)
    {
        text << (line == "NodeID=33" ? "NodeID=9" : line) << "\n";
    }
    whole.close();
    std::ofstream(file) << text.str();
    Bench bench(file, store);
    EXPECT_EQ(bench.Device().Assembly().NodeId(), 9U);
    bench.Start();
    bench.Command(128U);
    bench.Command(129U); // Off as before: nothing is told.
    bench.Store(0x1011U, 0x64616F6CU);
    bench.Command(129U);
    bench.Start();
    const std::string told = bench.Told();
    EXPECT_EQ(SrdoLines(told),
              (Lines{kOfTheFile, "SRDO 1 off", "configuration does not hold, 0x13FE:00 is not 0xA5: SRDOs are off",
                     kOfTheFile}));
    const std::size_t refused = told.find("the saved safety configuration is refused");
    EXPECT_LT(refused, told.find("SRDO 1 off")) << told;
    EXPECT_LT(told.find("SRDO 1 off"), told.find("NMT pre_operational")) << told;
    std::remove(store.c_str());
}

TEST(NodeToldTest, EachSrdoThatWasOnInTheFileIsToldToBeOffWhereAStoreDoesNotMakeItValid)
{
    Verifies(req::SRS_NODE_532);
    const std::string store = ::testing::TempDir() + "told_each.store";
    const std::string of_both[] = {"SRDO 1 consumer 0x101, safe within 81.5 ms of the last good normal frame",
                                   "SRDO 2 producer 0x103, every 25 ms"};
    const std::map<std::string, std::string> not_valid{{"13FE", "0"}, {"5F04", "0"}};
    std::remove(store.c_str());
    // Given two SRDOs that are on; one that is off in the file, of which nothing was said; and no store
    std::map<std::string, std::string> one_off = not_valid;
    one_off["1302sub1"] = "0";
    const auto lines = [](const std::map<std::string, std::string>& values, const std::string& kept)
    { return SrdoLines(Bench(WithStoreObjects(FileWith("controller", values)), kept).Told()); };
    EXPECT_EQ(lines(not_valid, store), (Lines{of_both[0], of_both[1], "SRDO 1 off", "SRDO 2 off"}));
    EXPECT_EQ(lines(one_off, store), (Lines{of_both[0], "SRDO 1 off"}));
    EXPECT_EQ(lines(not_valid, ""), (Lines{of_both[0], of_both[1]}));
    std::remove(store.c_str());
}

// Saved while 13FEh was not A5h: what a reset loads is not valid, which the file was.
TEST(NodeToldTest, WhatAResetLoadsThatIsNotValidIsToldBeforeTheDeviceMayRun)
{
    Verifies(req::SRS_NODE_532);
    for (const std::uint8_t reset : {std::uint8_t{129U}, std::uint8_t{130U}})
    {
        const std::string store = ::testing::TempDir() + "told_not_valid.store";
        std::remove(store.c_str());
        Bench bench(WithStoreObjects(FileWith("actuator", {{"5F04", "0"}})), store);
        bench.Start();
        bench.Change(2U, 100U, 2U, false);
        bench.Store(0x1010U, 0x65766173U);
        bench.Command(reset);
        const std::string told = bench.Told();
        EXPECT_EQ(SrdoLines(told), (Lines{kOfTheFile, "SRDO 1 off"})) << told;
        EXPECT_LT(told.find("SRDO 1 off"), told.rfind("NMT pre_operational")) << told;
        EXPECT_GT(told.find("SRDO 1 off"), told.find("NMT operational")) << told;
        std::remove(store.c_str());
    }
}

// The limit of an SRDO that is off is none that holds, and when it is on again it is news.
TEST(NodeToldTest, AConfigurationThatDoesNotHoldIsToldInPlaceOfLimits)
{
    Verifies(req::SRS_NODE_053);
    Bench bench(FileWith("actuator", {{"5F04", "0"}}));
    bench.Start();
    bench.Change(2U, 1000U, 2U, false);
    bench.Start();
    bench.Change(2U, 50U, 2U);
    bench.Start();
    EXPECT_EQ(SrdoLines(bench.Told()),
              (Lines{kOfTheFile, "configuration does not hold, 0x13FE:00 is not 0xA5: SRDOs are off", kOfTheFile}));
    // A file that was never declared valid
    Bench other(FileWith("actuator", {{"13FE", "0"}, {"5F04", "0"}}), "", runtime::ReportForm::kJson);
    other.Start();
    const std::string told = other.Told();
    EXPECT_NE(told.find("\"event\":\"configuration_invalid\",\"srdo\":0}"), std::string::npos) << told;
}

TEST(NodeToldTest, SignedObjectsOfSrdosAreToldWithTheirSign)
{
    Verifies(req::SRS_NODE_054);
    const auto receive = [](Bench& bench)
    {
        bench.Start();
        for (int cycle = 0; cycle < 6; ++cycle)
        {
            bench.Receive(0x103U, {0xF9U, 0xF9U});
            bench.Receive(0x104U, {0x06U, 0x06U});
            bench.Cycle();
            EXPECT_TRUE(cycle != 2 || bench.Device().Acknowledge(1U, bench.NowNs()));
        }
    };
    const std::string file = FileOfSigned("actuator", {"2200sub1", "2300sub1"});
    Bench as_json(file, "", runtime::ReportForm::kJson);
    receive(as_json);
    const std::string objects = as_json.Told();
    EXPECT_NE(objects.find("\"object\":\"0x2200:01\",\"value\":-7}"), std::string::npos) << objects;
    Bench bench(file);
    receive(bench);
    EXPECT_EQ(bench.Device().App().Values(), "0x2200:01=-7 0x2200:02=249");
    bench.Order("get 0x2200:01");
    bench.Order("get 0x2200:02");
    const std::string told = bench.Told();
    EXPECT_NE(told.find("value 0x2200:01 = -7\n"), std::string::npos) << told;
    EXPECT_NE(told.find("value 0x2200:02 = 249\n"), std::string::npos) << told;
    EXPECT_NE(told.find(" s  0x2200:01 = -7\n"), std::string::npos) << told;
    EXPECT_NE(told.find(" s  0x2200:02 = 249\n"), std::string::npos) << told;
}

TEST(NodeToldTest, SetTakesWhatGetTells)
{
    Verifies(req::SRS_NODE_054);
    Bench bench(FileOfSigned("sensor", {"2000sub1", "2100sub1"}), "", runtime::ReportForm::kJson);
    bench.Start();
    bench.Order("set 0x2000:01 -7");
    for (int cycle = 0; cycle < 20; ++cycle)
    {
        bench.Cycle();
    }
    ASSERT_FALSE(bench.SentWith(0x101U).empty());
    EXPECT_EQ(bench.SentWith(0x101U).back() & 0xFFU, 0xF9U);
    bench.Order("get 0x2000:01");
    bench.Order("set 0x2000:01 128");
    bench.Order("set 0x2000:01 -129");
    bench.Order("set 0x2000:02 -1");
    EXPECT_EQ(bench.Device().App().Values(), "0x2000:01=-7 0x2000:02=0");
    bench.Order("set 0x2000:01 0x80");
    EXPECT_EQ(bench.Device().App().Values(), "0x2000:01=-128 0x2000:02=0");
    bench.Order("state");
    const std::string told = bench.Told();
    EXPECT_NE(told.find("\"values\":\"0x2000:01=-128 0x2000:02=0\"}"), std::string::npos) << told;
    EXPECT_NE(told.find("\"object\":\"0x2000:01\",\"value\":-7}"), std::string::npos) << told;
    EXPECT_NE(told.find("set: 0x2000:01 = 128 refused with 0609 0031h"), std::string::npos) << told;
    EXPECT_NE(told.find("set: 0x2000:01 = -129 refused with 0609 0032h"), std::string::npos) << told;
    EXPECT_NE(told.find("set: 0x2000:02 = -1 refused with 0609 0032h"), std::string::npos) << told;
}

/// What an order is refused with; empty: it was taken.
std::string RefusalOf(const std::string& file, const std::string& order)
{
    Bench bench(std::string(COUNTERPOINT_SOURCE) + "/tests/" + file);
    bench.Order(order);
    const std::string told = bench.Told();
    const std::size_t place = told.find(" refused with ");
    return place == std::string::npos ? "" : told.substr(place + 14U, 10U);
}

// SRDO 2 sends 2100h: a BOOLEAN, one of 3 bits, an UNSIGNED8. None of them is read only, whatever is wrong.
TEST(NodeToldTest, AnInputAboveItsBitsIsTooHigh)
{
    Verifies(req::SRS_NODE_531);
    const std::string bits = "canopen/cia306/data/bits.dcf";
    const std::vector<std::pair<const char*, const char*>> inputs{{"0x2100:01 1", ""},
                                                                  {"0x2100:01 2", "0609 0030h"},
                                                                  {"0x2100:01 -1", "0609 0030h"},
                                                                  {"0x2100:01 256", "0609 0030h"},
                                                                  {"0x2100:02 7", ""},
                                                                  {"0x2100:02 8", "0609 0031h"},
                                                                  {"0x2100:02 255", "0609 0031h"},
                                                                  {"0x2100:02 256", "0609 0031h"},
                                                                  {"0x2100:02 -1", "0609 0032h"},
                                                                  {"0x2100:03 255", ""},
                                                                  {"0x2100:03 256", "0609 0031h"},
                                                                  // What an SRDO receives is nobody's to set.
                                                                  {"0x6020:01 1", "0601 0002h"}};
    for (const auto& [set, refusal] : inputs)
    {
        EXPECT_EQ(RefusalOf(bits, std::string("set ") + set), refusal) << set;
    }
    // An object of the device itself
    for (const char* const value : {"2", "-1", "256"})
    {
        EXPECT_EQ(RefusalOf("runtime/data/everything.dcf", std::string("set 0x4001:00 ") + value), "0609 0030h")
            << value;
    }
    EXPECT_EQ(RefusalOf("runtime/data/everything.dcf", "set 0x4001:00 1"), "");
    // An input that was refused stays as it was
    Bench bench(std::string(COUNTERPOINT_SOURCE) + "/tests/" + bits);
    bench.Order("set 0x2100:02 5");
    bench.Order("set 0x2100:02 8");
    EXPECT_NE(bench.Device().App().Values().find("0x2100:02=5 "), std::string::npos) << bench.Device().App().Values();
}
} // namespace
} // namespace counterpoint::tools::test
