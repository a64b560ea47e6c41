// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/text/text_file.hpp"
#include "runtime/node/device.hpp"
#include "tests/canopen/cia306/folder_of_files.hpp"
#include "tests/tools/echo_bus.hpp"
#include "verification/trace/ids/cia301.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

// A node that is configured by a client, saves and starts anew: it has to be the device that was saved.
namespace counterpoint::runtime
{
namespace
{
using cia301::SdoAbort;

constexpr std::uint64_t kNsPerMs = 1000000U;
constexpr std::uint32_t kSave = 0x65766173U;
constexpr std::uint32_t kOff = 0x80000000U;

/// Object and value of four bytes at most.
struct Row
{
    ObjectAddress object;
    std::uint32_t value;
    std::uint8_t size_bytes;
};

std::string Hex(const std::uint32_t number)
{
    std::ostringstream text;
    text << std::hex << number;
    return text.str();
}

/// A device with SYNC, TIME, EMCY, heartbeat consumer, a second SDO server and an SDO client; a value for each object.
std::string TextOf(const std::vector<Row>& rows)
{
    std::string text = "[DeviceInfo]\nVendorName=test\n[DeviceComissioning]\nNodeID=5\n"
                       "[1000]\nDataType=7\nAccessType=ro\nDefaultValue=0\n"
                       "[1001]\nDataType=5\nAccessType=ro\n"
                       "[1010]\nObjectType=8\nSubNumber=2\n[1010sub0]\nDataType=5\nAccessType=ro\nDefaultValue=1\n"
                       "[1010sub1]\nDataType=7\nAccessType=rw\n";
    const std::map<std::uint8_t, std::string> types{{1U, "5"}, {2U, "6"}, {4U, "7"}};
    std::map<std::uint16_t, bool> has_head;
    for (const Row& row : rows)
    {
        const std::string name = Hex(row.object.index);
        if (row.object.sub != 0U && !has_head[row.object.index])
        {
            text += "[" + name + "]\nObjectType=9\n[" + name +
                    "sub0]\nDataType=5\nAccessType=const\nDefaultValue=" + (row.object.index >= 0x1200U ? "3" : "2") +
                    "\n";
            has_head[row.object.index] = true;
        }
        const std::string section = row.object.sub == 0U ? name : name + "sub" + Hex(row.object.sub);
        text += "[" + section + "]\nDataType=" + types.at(row.size_bytes) +
                "\nAccessType=rw\nDefaultValue=" + std::to_string(row.value) + "\n";
    }
    return text;
}

const std::vector<Row> kFile{
    {{0x1005U, 0U}, 0x40000080U, 4U}, {{0x1006U, 0U}, 10000U, 4U},      {{0x1007U, 0U}, 5000U, 4U},
    {{0x1012U, 0U}, 0x80000100U, 4U}, {{0x1014U, 0U}, 0x00000085U, 4U}, {{0x1015U, 0U}, 10U, 2U},
    {{0x1016U, 1U}, 0x00060064U, 4U}, {{0x1016U, 2U}, 0x000700C8U, 4U}, {{0x1017U, 0U}, 100U, 2U},
    {{0x1019U, 0U}, 8U, 1U},          {{0x1028U, 1U}, 0x00000081U, 4U}, {{0x1028U, 2U}, 0x00000082U, 4U},
    {{0x1201U, 1U}, 0x00000690U, 4U}, {{0x1201U, 2U}, 0x00000691U, 4U}, {{0x1201U, 3U}, 9U, 1U},
    {{0x1280U, 1U}, 0x00000606U, 4U}, {{0x1280U, 2U}, 0x00000586U, 4U}, {{0x1280U, 3U}, 6U, 1U},
};

class LoadedTest : public cia306::test::FolderTest
{
  protected:
    /// A node of the file, switched on.
    void Start(const std::vector<Row>& rows, const std::string& store)
    {
        device.reset();
        NodeSettings settings;
        settings.dcf = File("node.dcf", TextOf(rows));
        settings.store = store;
        settings.has_self_tests = false;
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
    /// An NMT command of the manager, and what follows until the device has booted.
    void Reset(const std::uint8_t command)
    {
        device->OnFrame(tools::test::FrameOf(0U, {command, 5U}, now_ns), CanPortId::kFirst, {Instant{0U}, Instant{0U}});
        for (int i = 0; i < 100000; ++i)
        {
            now_ns += kNsPerMs;
            device->Serve({Instant{0U}, Instant{0U}}, now_ns);
            if (device->Assembly().Device().State() == cia301::NodeState::kPreOperational)
            {
                return;
            }
            std::this_thread::sleep_for(std::chrono::microseconds(10));
        }
        ADD_FAILURE() << "no boot";
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

// 1019h stands behind 1006h, which is not 0
TEST_F(LoadedTest, TheDeviceHasEveryValueOfTheFile)
{
    Verifies(req::SRS_NODE_030);
    Verifies(req::SRS_OBD_016);
    Start(kFile, "");
    for (const Row& row : kFile)
    {
        EXPECT_EQ(Read(row.object), row.value) << Hex(row.object.index) << ":" << int{row.object.sub};
    }
    device.reset();
    EXPECT_EQ(Told().find("warning"), std::string::npos) << out.str();
}

// The client's way: off, other values, on. Each of them is one that the values of the file stand in the way of.
TEST_F(LoadedTest, TheDeviceThatWasSavedIsTheOneThatStarts)
{
    Verifies(req::SRS_NODE_030);
    Verifies(req::SRS_OBD_016);
    const std::vector<Row> saved{
        {{0x1005U, 0U}, 0x40000090U, 4U}, {{0x1006U, 0U}, 20000U, 4U},      {{0x1007U, 0U}, 4000U, 4U},
        {{0x1012U, 0U}, 0x400006A0U, 4U}, {{0x1014U, 0U}, 0x00000086U, 4U}, {{0x1015U, 0U}, 20U, 2U},
        {{0x1016U, 1U}, 0x00070064U, 4U}, {{0x1016U, 2U}, 0x000600C8U, 4U}, {{0x1017U, 0U}, 200U, 2U},
        {{0x1019U, 0U}, 16U, 1U},         {{0x1028U, 1U}, 0x00000083U, 4U}, {{0x1028U, 2U}, 0x00000084U, 4U},
        {{0x1201U, 1U}, 0x00000692U, 4U}, {{0x1201U, 2U}, 0x00000693U, 4U}, {{0x1201U, 3U}, 10U, 1U},
        {{0x1280U, 1U}, 0x00000607U, 4U}, {{0x1280U, 2U}, 0x00000587U, 4U}, {{0x1280U, 3U}, 7U, 1U},
    };
    const std::vector<Row> off{
        {{0x1005U, 0U}, 0x80U, 4U},        {{0x1006U, 0U}, 0U, 4U},   {{0x1012U, 0U}, 0x100U, 4U},
        {{0x1014U, 0U}, kOff | 0x85U, 4U}, {{0x1016U, 1U}, 0U, 4U},   {{0x1016U, 2U}, 0U, 4U},
        {{0x1019U, 0U}, 16U, 1U},          {{0x1028U, 1U}, kOff, 4U}, {{0x1028U, 2U}, kOff, 4U},
        {{0x1201U, 1U}, kOff, 4U},         {{0x1201U, 2U}, kOff, 4U}, {{0x1280U, 1U}, kOff, 4U},
        {{0x1280U, 2U}, kOff, 4U}};
    Start(kFile, Path("node.store"));
    for (const std::vector<Row>& rows : {off, saved})
    {
        for (const Row& row : rows)
        {
            EXPECT_EQ(Write(row.object, row.value, row.size_bytes), SdoAbort::kNone)
                << Hex(row.object.index) << ":" << int{row.object.sub};
        }
    }
    Save();
    Start(kFile, Path("node.store"));
    for (const Row& row : saved)
    {
        EXPECT_EQ(Read(row.object), row.value) << Hex(row.object.index) << ":" << int{row.object.sub};
    }
    // And a client is bound by the present values again
    EXPECT_EQ(Write({0x1019U, 0U}, 8U, 1U), SdoAbort::kDeviceState);
    EXPECT_EQ(Write({0x1014U, 0U}, 0x85U, 4U), SdoAbort::kValueRange);
    EXPECT_EQ(Write({0x1005U, 0U}, 0x40000080U, 4U), SdoAbort::kValueRange);
    EXPECT_EQ(Write({0x1012U, 0U}, 0x40000100U, 4U), SdoAbort::kValueRange);
    EXPECT_EQ(Write({0x1016U, 1U}, 0x00060064U, 4U), SdoAbort::kIncompatible);
    EXPECT_EQ(Write({0x1028U, 1U}, 0x00000081U, 4U), SdoAbort::kValueRange);
    EXPECT_EQ(Write({0x1201U, 1U}, 0x00000690U, 4U), SdoAbort::kValueRange);
    EXPECT_EQ(Write({0x1280U, 1U}, 0x00000606U, 4U), SdoAbort::kValueRange);
    device.reset();
    EXPECT_EQ(Told().find("warning"), std::string::npos) << out.str();
}

// 1017h and 1015h of the file are 100 and 10, those of the set before 50 and 20
TEST_F(LoadedTest, AResetDuringASaveKeepsWhatIsSaved)
{
    Verifies(req::SRS_DEV_025);
    for (const std::uint8_t command : {std::uint8_t{129U}, std::uint8_t{130U}})
    {
        for (int steps = 0; steps < 60; steps += 3)
        {
            SCOPED_TRACE(testing::Message() << int{command} << " behind " << steps);
            const std::string store = Path("save" + std::to_string(command) + std::to_string(steps));
            Start(kFile, store);
            EXPECT_EQ(Write({0x1017U, 0U}, 50U, 2U), SdoAbort::kNone);
            EXPECT_EQ(Write({0x1015U, 0U}, 20U, 2U), SdoAbort::kNone);
            Save();
            EXPECT_EQ(Write({0x1017U, 0U}, 51U, 2U), SdoAbort::kNone);
            EXPECT_EQ(Write({0x1015U, 0U}, 21U, 2U), SdoAbort::kNone);
            // When a save has gone so far, and its client asks no more because of the reset
            EXPECT_EQ(Write({0x1010U, 1U}, kSave, 4U), SdoAbort::kPending);
            for (int i = 0; i < steps; ++i)
            {
                now_ns += kNsPerMs;
                device->Serve({Instant{0U}, Instant{0U}}, now_ns);
                std::this_thread::sleep_for(std::chrono::microseconds(10));
            }
            Reset(command);
            // Then the device has it, and after another start, too
            EXPECT_EQ(Read({0x1017U, 0U}), 51U);
            EXPECT_EQ(Read({0x1015U, 0U}), 21U);
            Start(kFile, store);
            EXPECT_EQ(Read({0x1017U, 0U}), 51U);
            EXPECT_EQ(Read({0x1015U, 0U}), 21U);
        }
    }
    device.reset();
    EXPECT_EQ(Told().find("warning"), std::string::npos) << out.str();
}

TEST_F(LoadedTest, WhatDoesNotGoWithTheOthersIsNamed)
{
    Verifies(req::SRS_NODE_030);
    Verifies(req::SRS_OBD_016);
    std::vector<Row> rows = kFile;
    rows[7].value = 0x00060001U; // 1016h:02, the node of 1016h:01
    rows[9].value = 241U;        // 1019h
    Start(rows, "");
    EXPECT_EQ(Read({0x1016U, 1U}), 0x00060064U);
    EXPECT_EQ(Read({0x1016U, 2U}), 0U);
    EXPECT_EQ(Read({0x1019U, 0U}), 0U);
    device.reset();
    const std::string told = Told();
    EXPECT_NE(told.find(Path("node.dcf") +
                        ":59:14: warning: 0x1016:02: the device does without this value, expected one "
                        "that goes with the others"),
              std::string::npos)
        << told;
    EXPECT_NE(told.find(Path("node.dcf") +
                        ":67:14: warning: 0x1019:00: the device refuses this value with abort code 0x06090030"),
              std::string::npos)
        << told;
}

// The order of a file that was written by a tool, or by hand: none is that in which the services need them.
TEST_F(LoadedTest, TheOrderOfTheFileMeansNothing)
{
    Verifies(req::SRS_NODE_030);
    std::vector<Row> rows(kFile.rbegin(), kFile.rend());
    for (std::size_t turn = 0U; turn < rows.size(); ++turn)
    {
        std::rotate(rows.begin(), rows.begin() + 1, rows.end());
        Start(rows, "");
        for (const Row& row : kFile)
        {
            EXPECT_EQ(Read(row.object), row.value) << turn << Hex(row.object.index) << ":" << int{row.object.sub};
        }
    }
    // A reset brings back what was changed and not saved
    EXPECT_EQ(Write({0x1017U, 0U}, 55U, 2U), SdoAbort::kNone);
    for (const std::uint8_t command : {std::uint8_t{130U}, std::uint8_t{129U}})
    {
        Reset(command);
        for (const Row& row : kFile)
        {
            EXPECT_EQ(Read(row.object), row.value) << int{command} << " " << Hex(row.object.index);
        }
    }
    device.reset();
    EXPECT_EQ(Told().find("warning"), std::string::npos) << out.str();
}

// Saved with 1016h:02, started by a file without it and with a limit below the saved 1017h
TEST_F(LoadedTest, SavedValuesThatTheDeviceRefusesAreNamed)
{
    Verifies(req::SRS_NODE_030);
    Verifies(req::SRS_NODE_450);
    Start(kFile, Path("node.store"));
    Save();
    std::vector<Row> rows = kFile;
    rows.erase(rows.begin() + 7);
    Start(rows, Path("node.store"));
    device.reset();
    EXPECT_NE(Told().find(Path("node.store") +
                          ": warning: 1 of 22 saved values are refused (0x1016:02), expected those of this device\n"),
              std::string::npos)
        << out.str();
}
} // namespace
} // namespace counterpoint::runtime
