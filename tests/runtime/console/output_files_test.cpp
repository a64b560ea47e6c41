// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/console/output_files.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include "canopen/cia306/text/input_error.hpp"
#include "runtime/yaml/document.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <unistd.h>

namespace counterpoint::runtime
{
namespace
{
class OutputFilesTest : public ::testing::Test
{
  public:
    OutputFilesTest()
    {
        std::filesystem::create_directories(folder_ / "inner");
    }
    ~OutputFilesTest() override
    {
        std::filesystem::remove_all(folder_);
    }

    [[nodiscard]] std::string At(const std::string& name) const
    {
        return (folder_ / name).string();
    }

    /// What an output is refused with; empty where it is not.
    static std::string RefusalOf(OutputFiles& files, const std::string& option, const std::string& file)
    {
        try
        {
            files.Write(option, file);
        }
        catch (const std::exception& error)
        {
            return error.what();
        }
        return "";
    }

    const std::filesystem::path folder_{std::filesystem::temp_directory_path() / ("of" + std::to_string(::getpid()))};
};

TEST_F(OutputFilesTest, AreNoneThatIsRead)
{
    Verifies(req::SRS_SIM_049);
    OutputFiles files;
    files.Read(At("a.yaml"));
    files.Read("");
    EXPECT_EQ(RefusalOf(files, "--html", At("inner/../a.yaml")),
              "--html: error: " + Shown(At("inner/../a.yaml")) +
                  ", which is named already or read by the run, expected a file of its own for each output");
    EXPECT_EQ(RefusalOf(files, "--html", At("b.html")), "");
    EXPECT_EQ(RefusalOf(files, "--html", ""), "");
}

TEST_F(OutputFilesTest, DifferFromEachOther)
{
    Verifies(req::SRS_SIM_049);
    // Given a link to a file that the run will make
    std::filesystem::create_symlink("a.json", At("link.json"));
    OutputFiles files;
    EXPECT_EQ(RefusalOf(files, "--json", At("a.json")), "");
    EXPECT_EQ(RefusalOf(files, "--html", At("link.json")),
              "--html: error: " + Shown(At("link.json")) +
                  ", which is named already or read by the run, expected a file of its own for each output");
    EXPECT_EQ(RefusalOf(files, "--html", At("a.html")), "");
}

TEST_F(OutputFilesTest, CanBeWritten)
{
    Verifies(req::SRS_SIM_049);
    // Given a folder that is not there, and a link to itself, which leads to no name
    std::filesystem::create_symlink("loop", At("loop"));
    OutputFiles files;
    EXPECT_THROW(files.Write("--json", At("no_folder/a.json")), cia306::InputError);
    EXPECT_EQ(RefusalOf(files, "--json", At("loop")),
              At("loop") + ": error: it is a link in a circle, expected a file, or a link to one");
    EXPECT_THROW(files.Write("--json", At("loop/a.json")), cia306::InputError);
    EXPECT_EQ(RefusalOf(files, "--html", At("loop/a.json")),
              "--html: error: " + Shown(At("loop/a.json")) +
                  ", which is named already or read by the run, expected a file of its own for each output");
}
} // namespace
} // namespace counterpoint::runtime
