// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/text/text_file.hpp"
#include "runtime/node/device.hpp"
#include "tests/canopen/cia306/folder_of_files.hpp"
#include "tests/tools/echo_bus.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <chrono>
#include <cstdint>
#include <memory>
#include <sstream>
#include <string>
#include <thread>

// A node that is saved with one node-ID and starts with another one. The file writes 1014h, 1400h:01 and 1800h:01 with
// $NODEID.
namespace counterpoint::runtime
{
namespace
{
using cia301::SdoAbort;

constexpr std::uint64_t kNsPerMs = 1000000U;
constexpr std::uint32_t kSave = 0x65766173U;

class SavedNodeIdTest : public cia306::test::FolderTest
{
  protected:
    [[nodiscard]] NodeSettings SettingsOf(const std::uint8_t node_id) const
    {
        NodeSettings settings;
        settings.dcf = std::string(COUNTERPOINT_SOURCE) + "/tests/runtime/data/everything.dcf";
        settings.store = Path("node.store");
        settings.cycle_us = 5000U;
        settings.node_id = node_id;
        settings.has_self_tests = false;
        return settings;
    }
    void Start(const NodeSettings& settings)
    {
        device.reset();
        device = std::make_unique<NodeDevice>(settings, ports, report);
        now_ns += kNsPerMs;
        EXPECT_TRUE(device->PowerOn({Instant{0U}, Instant{0U}}, now_ns));
    }
    [[nodiscard]] std::uint64_t Read(const ObjectAddress& object)
    {
        return device->Assembly().Dictionary().ReadNumber(object).value;
    }
    SdoAbort Write(const ObjectAddress& object, const std::uint32_t value, const std::uint8_t size_bytes)
    {
        return device->Assembly().Dictionary().WriteNumber(object, value, size_bytes);
    }
    void Save()
    {
        SdoAbort abort = Write({0x1010U, 1U}, kSave, 4U);
        for (int i = 0; i < 100000 && abort == SdoAbort::kPending; ++i)
        {
            now_ns += kNsPerMs;
            device->Serve({Instant{0U}, Instant{0U}}, now_ns);
            std::this_thread::sleep_for(std::chrono::microseconds(10));
            abort = device->Assembly().Dictionary().WriteNumberAgain({0x1010U, 1U}, kSave, 4U);
        }
        ASSERT_EQ(abort, SdoAbort::kNone);
    }
    [[nodiscard]] std::string Told()
    {
        static_cast<void>(report.Finish());
        return out.str();
    }

    std::ostringstream out{};
    NodeReport report{out, ReportForm::kText, 0U};
    NodePorts ports{std::make_unique<tools::test::EchoBus>(false, 0U),
                    std::make_unique<tools::test::EchoBus>(false, 0U)};
    std::unique_ptr<NodeDevice> device{};
    std::uint64_t now_ns{kNsPerMs};
};

TEST_F(SavedNodeIdTest, WhatNobodyChangedFollowsTheNodeId)
{
    Verifies(req::SRS_NODE_240);
    // Given node 5, of which 1017h and the identifier of TPDO 1 were changed, and saved
    Start(SettingsOf(5U));
    EXPECT_EQ(Read({0x1014U, 0U}), 0x85U);
    EXPECT_EQ(Write({0x1017U, 0U}, 777U, 2U), SdoAbort::kNone);
    EXPECT_EQ(Write({0x1800U, 1U}, 0xC0000185U, 4U), SdoAbort::kNone);
    EXPECT_EQ(Write({0x1800U, 1U}, 0x400001A5U, 4U), SdoAbort::kNone);
    Save();
    // When it becomes node 9, by the command line or by LSS
    NodeSettings by_lss = SettingsOf(5U);
    by_lss.has_lss = true;
    by_lss.lss_node_id = 9U;
    for (const NodeSettings& settings : {SettingsOf(9U), by_lss})
    {
        Start(settings);
        // Then its emergencies and RPDO 1 are those of node 9
        EXPECT_EQ(device->Assembly().NodeId(), 9U);
        EXPECT_EQ(Read({0x1014U, 0U}), 0x89U);
        EXPECT_EQ(Read({0x1400U, 1U}), 0x209U);
        // and what somebody changed is as it was saved
        EXPECT_EQ(Read({0x1017U, 0U}), 777U);
        EXPECT_EQ(Read({0x1800U, 1U}), 0x400001A5U);
    }
    // And saved as node 9 it is node 5 again
    Save();
    Start(SettingsOf(5U));
    EXPECT_EQ(Read({0x1014U, 0U}), 0x85U);
    EXPECT_EQ(Read({0x1400U, 1U}), 0x205U);
    EXPECT_EQ(Read({0x1800U, 1U}), 0x400001A5U);
}

TEST_F(SavedNodeIdTest, TheSavedSafetyConfigurationIsThatOfItsNodeId)
{
    Verifies(req::SRS_NODE_240);
    Start(SettingsOf(5U));
    EXPECT_EQ(Read({0x13FEU, 0U}), 0xA5U);
    Save();
    Start(SettingsOf(5U));
    EXPECT_EQ(Read({0x13FEU, 0U}), 0xA5U);
    EXPECT_EQ(Read({0x1301U, 1U}), 2U);
    // When it becomes node 9
    Start(SettingsOf(9U));
    // Then its SRDOs are off, which is told
    EXPECT_EQ(Read({0x13FEU, 0U}), 0U);
    EXPECT_EQ(Read({0x1301U, 1U}), 0U);
    // and as node 5 it is what was saved
    Start(SettingsOf(5U));
    EXPECT_EQ(Read({0x13FEU, 0U}), 0xA5U);
    device.reset();
    const std::string told = Told();
    const std::string refused = "the saved safety configuration is refused, expected that of this device and node-ID; "
                                "13FEh is not A5h";
    EXPECT_NE(told.find(refused), std::string::npos) << told;
    EXPECT_EQ(told.find(refused), told.rfind(refused)) << told;
}

// Given what another device saved, then a line tells that the safety configuration is refused, also beside the values.
TEST_F(SavedNodeIdTest, TheSafetyConfigurationOfAnotherDeviceIsToldBesideItsValues)
{
    Verifies(req::SRS_NODE_450);
    Start(SettingsOf(5U));
    Save();
    NodeSettings other = SettingsOf(5U);
    other.dcf = std::string(COUNTERPOINT_SOURCE) + "/examples/emergency_stop/sensor.dcf";
    Start(other);
    EXPECT_EQ(Read({0x13FEU, 0U}), 0U);
    device.reset();
    const std::string told = Told();
    EXPECT_NE(told.find(" saved values are refused ("), std::string::npos) << told;
    EXPECT_NE(told.find(", expected those of this device; so is the saved safety configuration, and 13FEh is not A5h"),
              std::string::npos)
        << told;
}

// Given a consumer that was saved with an SCT of 900 ms and whose file has 400 ms by now.
TEST_F(SavedNodeIdTest, TheLimitOfASavedConfigurationIsToldBeforeTheDeviceRuns)
{
    Verifies(req::SRS_NODE_330);
    std::string text = cia306::ReadTextFile(SettingsOf(5U).dcf);
    const auto set = [&text](const std::string& section, const std::string& from, const std::string& to)
    { text.replace(text.find(from, text.find("[" + section + "]")), from.size(), to); };
    set("1301sub2", "ParameterValue=400", "ParameterValue=900");
    set("13FFsub1", "ParameterValue=0x40D9", "ParameterValue=0xE113");
    cia306::WriteTextFile(Path("longer.dcf"), text);
    NodeSettings longer = SettingsOf(5U);
    longer.dcf = Path("longer.dcf");
    Start(longer);
    EXPECT_EQ(Read({0x13FEU, 0U}), 0xA5U);
    Save();
    // When it starts with its file again
    device.reset();
    device = std::make_unique<NodeDevice>(SettingsOf(5U), ports, report);
    now_ns += kNsPerMs;
    device->TellStart("a bus", now_ns);
    EXPECT_TRUE(device->PowerOn({Instant{0U}, Instant{0U}}, now_ns));
    device->Serve({Instant{0U}, Instant{0U}}, now_ns);
    EXPECT_EQ(Read({0x1301U, 2U}), 900U);
    device.reset();
    // Then the limit that holds is the last one that is told, and the producer is not told again
    const std::string all = Told();
    const std::string told = all.substr(all.find(" on a bus, "));
    const std::size_t of_file = told.find("SRDO 1 consumer 0x101, safe within 433.5 ms of the last good normal frame");
    const std::size_t saved = told.find("SRDO 1 consumer 0x101, safe within 936 ms of the last good normal frame");
    EXPECT_LT(of_file, saved) << told;
    EXPECT_NE(saved, std::string::npos) << told;
    const std::string producer = "SRDO 2 producer 0x103, every 100 ms";
    EXPECT_EQ(told.find(producer), told.rfind(producer)) << told;
}
} // namespace
} // namespace counterpoint::runtime
