// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/cia306/device_text.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace counterpoint::cia306
{
namespace
{
/// The collection of real files stands beside the source tree, where it is; else the look-alikes of the tests are read.
std::vector<std::string> DeviceFiles(const std::filesystem::path& folder)
{
    std::vector<std::string> files;
    if (std::filesystem::is_directory(folder))
    {
        for (const auto& entry : std::filesystem::directory_iterator(folder))
        {
            const std::string kind = entry.path().extension().string();
            const bool is_device_file = kind == ".eds" || kind == ".dcf";
            if (is_device_file)
            {
                files.push_back(entry.path().string());
            }
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<std::string> AllDeviceFiles()
{
    std::vector<std::string> files = DeviceFiles(test::SourceFolder() + "/tests/canopen/cia306/data");
    const std::vector<std::string> real = DeviceFiles(test::SourceFolder() + "/../shared/corpus/eds");
    std::cout << (real.empty() ? "no collection of real files beside the source tree: only look-alikes are read\n"
                               : std::to_string(real.size()) + " real files are read besides the look-alikes\n");
    files.insert(files.end(), real.begin(), real.end());
    return files;
}

TEST(RealFiles, EveryOneIsReadAndWrittenBackByteByByte)
{
    Verifies(req::SRS_EDS_026);
    Verifies(req::SRS_EDS_004);
    const std::vector<std::string> files = AllDeviceFiles();
    EXPECT_GE(files.size(), 4U);
    for (const std::string& file : files)
    {
        const std::string text = ReadTextFile(file);
        const IniDocument document = IniDocument::Parse(file, text);
        EXPECT_EQ(document.Text(), text) << file;
        const Device device = ReadDevice(document);
        EXPECT_GE(device.objects.size(), 3U) << file;
        EXPECT_NE(device.Find(0x1000U, 0U), nullptr) << file;
    }
}

TEST(RealFiles, ALookAlikeWithEverythingUnusualIsReadAsMeant)
{
    Verifies(req::SRS_EDS_026);
    const Device device = ReadDeviceFile(test::SourceFolder() + "/tests/canopen/cia306/data/unusual.dcf");
    EXPECT_EQ(device.node_id, 5U);
    EXPECT_EQ(device.Find(0x1018U, 4U)->Configured().text, "0x00000004");
    EXPECT_EQ(device.Find(0x1600U, 1U)->Configured().text, "0x20000120");
    EXPECT_EQ(device.Find(0x1028U)->entries.size(), 128U);
    EXPECT_EQ(device.Find(0x1028U, 3U)->Configured().text, "0x00000083");
    EXPECT_EQ(ConfiguredValue(*device.Find(0x1800U, 1U), device.node_id).value->bits, 0x185U);
    EXPECT_EQ(ConfiguredValue(*device.Find(0x1801U, 1U), device.node_id).value->bits, 0x285U);
    EXPECT_EQ(device.Find(0x3000U, 0U)->data_type, 0x000FU);
    EXPECT_EQ(device.Find(0x3001U, 0U)->data_type, 0x0040U);
    EXPECT_EQ(device.Find(0x3002U, 0U)->name, "Temperature [\xB0"
                                              "C]");
    EXPECT_EQ(device.warnings.size(), 6U);
}
} // namespace
} // namespace counterpoint::cia306
