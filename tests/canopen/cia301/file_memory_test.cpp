// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/file_parameter_memory.hpp"
#include "verification/trace/ids/store.hpp"
#include "verification/trace/verifies.hpp"

#include <array>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace counterpoint::host
{
namespace
{

using hal::MemoryBank;
using hal::MemoryStatus;

class FileMemoryTest : public ::testing::Test
{
  public:
    FileMemoryTest() : path((std::filesystem::path(::testing::TempDir()) / "counterpoint_parameters.bin").string())
    {
        std::filesystem::remove(path);
    }
    ~FileMemoryTest() override
    {
        std::filesystem::remove(path);
    }
    /// What the constructor says about it; empty: nothing.
    static std::string Refusal(const std::string& file, std::uint32_t bank_bytes)
    {
        std::string text{};
        try
        {
            const FileParameterMemory memory{file, bank_bytes};
        }
        catch (const std::runtime_error& error)
        {
            text = error.what();
        }
        return text;
    }

    std::string path;
};

TEST_F(FileMemoryTest, BytesOutliveTheProgram)
{
    Verifies(req::SRS_STO_010);
    Verifies(req::SRS_STO_013);
    const std::array<std::uint8_t, 8> bytes{1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U};
    std::array<std::uint8_t, 8> got{};
    {
        FileParameterMemory memory{path, 8192U};
        EXPECT_EQ(memory.BankBytes(), 8192U);
        EXPECT_TRUE(memory.Read({MemoryBank::kSecond, 8184U, 8U}, got.data()));
        EXPECT_EQ(got, (std::array<std::uint8_t, 8>{255U, 255U, 255U, 255U, 255U, 255U, 255U, 255U}));
        memory.Program({MemoryBank::kFirst, 16U, 8U}, bytes.data());
        EXPECT_EQ(memory.Status(), MemoryStatus::kReady);
        memory.Program({MemoryBank::kSecond, 8184U, 8U}, bytes.data());
        EXPECT_EQ(memory.Status(), MemoryStatus::kReady);
    }
    EXPECT_EQ(std::filesystem::file_size(path), 16384U);
    FileParameterMemory memory{path, 8192U};
    EXPECT_TRUE(memory.Read({MemoryBank::kFirst, 16U, 8U}, got.data()));
    EXPECT_EQ(got, bytes);
    memory.Erase(MemoryBank::kFirst);
    EXPECT_EQ(memory.Status(), MemoryStatus::kReady);
    EXPECT_TRUE(memory.Read({MemoryBank::kFirst, 16U, 8U}, got.data()));
    EXPECT_EQ(got[0], 0xFFU);
    EXPECT_TRUE(memory.Read({MemoryBank::kSecond, 8184U, 8U}, got.data()));
    EXPECT_EQ(got, bytes);
}

TEST_F(FileMemoryTest, WhatIsNoSectionFails)
{
    Verifies(req::SRS_STO_010);
    FileParameterMemory memory{path, 64U};
    std::array<std::uint8_t, 64> bytes{};
    EXPECT_FALSE(memory.Read({MemoryBank::kFirst, 60U, 8U}, bytes.data()));
    EXPECT_FALSE(memory.Read({MemoryBank::kInvalid, 0U, 8U}, bytes.data()));
    EXPECT_TRUE(memory.Read({MemoryBank::kFirst, 56U, 8U}, bytes.data()));
    for (const hal::MemorySection& wrong :
         {hal::MemorySection{MemoryBank::kFirst, 4U, 8U}, hal::MemorySection{MemoryBank::kFirst, 0U, 7U},
          hal::MemorySection{MemoryBank::kFirst, 64U, 8U}, hal::MemorySection{MemoryBank::kInvalid, 0U, 8U}})
    {
        memory.Program(wrong, bytes.data());
        EXPECT_EQ(memory.Status(), MemoryStatus::kFailed);
        memory.Program({MemoryBank::kFirst, 0U, 8U}, bytes.data());
        EXPECT_EQ(memory.Status(), MemoryStatus::kReady);
    }
    memory.Erase(MemoryBank::kInvalid);
    EXPECT_EQ(memory.Status(), MemoryStatus::kFailed);
}

TEST_F(FileMemoryTest, AFileThatIsNoneIsRefusedWithOneLine)
{
    Verifies(req::SRS_STO_013);
    std::ofstream(path) << "0123456789";
    EXPECT_EQ(Refusal(path, 64U), path + ": has 10 bytes, expected two banks of 64");
    EXPECT_EQ(Refusal(path, 60U), path + ": a bank of 60 bytes, expected a multiple of 8 above 0");
    EXPECT_EQ(Refusal("/", 64U),
              "/: cannot be opened for reading and writing: Is a directory, expected a file for parameters");
    EXPECT_EQ(Refusal("/dev/zero", 64U), "/dev/zero: cannot be written, expected a regular file with room");
}

// An empty file is what a full disk or a wrong copy leaves: it is not a store that was never written.
TEST_F(FileMemoryTest, AnEmptyOrShortenedFileIsNoNewOne)
{
    Verifies(req::SRS_STO_013);
    std::ofstream{path}.flush();
    EXPECT_EQ(Refusal(path, 64U), path + ": has 0 bytes, expected two banks of 64");
    EXPECT_EQ(std::filesystem::file_size(path), 0U);
    std::filesystem::resize_file(path, 127U);
    EXPECT_EQ(Refusal(path, 64U), path + ": has 127 bytes, expected two banks of 64");
    std::filesystem::remove(path);
    // Given a creation that broke off: it left nothing under the name of the store
    std::ofstream{path + ".new"} << "0123";
    EXPECT_EQ(Refusal(path, 64U), "");
    EXPECT_EQ(std::filesystem::file_size(path), 128U);
    std::filesystem::remove(path + ".new");
}

TEST_F(FileMemoryTest, FilesOfOthersBesideTheNewOneStayAsTheyAre)
{
    Verifies(req::SRS_STO_013);
    // Given a file and a link to one of the user, with the names of the part
    std::ofstream{path + ".new"} << "mine";
    std::ofstream{path + ".notes"} << "notes";
    std::filesystem::create_symlink(path + ".notes", path + ".new2");
    EXPECT_EQ(Refusal(path, 64U), "");
    EXPECT_EQ(std::filesystem::file_size(path), 128U);
    EXPECT_EQ(std::filesystem::file_size(path + ".new"), 4U);
    EXPECT_EQ(std::filesystem::file_size(path + ".notes"), 5U);
    EXPECT_TRUE(std::filesystem::is_symlink(path + ".new2"));
    EXPECT_FALSE(std::filesystem::exists(path + ".new3")); // That of the store, while it was made.
    for (const char* const name : {".new", ".new2", ".notes"})
    {
        std::filesystem::remove(path + name);
    }
}

TEST_F(FileMemoryTest, AFileThatIsNoLongerThereTakesNothing)
{
    Verifies(req::SRS_STO_018);
    const std::array<std::uint8_t, 8> bytes{1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U};
    const std::string aside = path + ".aside";
    FileParameterMemory memory{path, 64U};
    const auto program = [&](std::uint32_t offset)
    {
        memory.Program({MemoryBank::kSecond, offset, 8U}, bytes.data());
        return memory.Status();
    };
    EXPECT_EQ(program(0U), MemoryStatus::kReady);
    // Renamed, replaced by another file, back again
    std::filesystem::rename(path, aside);
    EXPECT_EQ(program(8U), MemoryStatus::kFailed);
    std::ofstream(path) << std::string(128U, 'x');
    EXPECT_EQ(program(16U), MemoryStatus::kFailed);
    memory.Erase(MemoryBank::kFirst);
    EXPECT_EQ(memory.Status(), MemoryStatus::kFailed);
    std::filesystem::rename(aside, path);
    EXPECT_EQ(program(24U), MemoryStatus::kReady);
    // Shortened, though what is written would lengthen it again
    std::filesystem::resize_file(path, 16U);
    EXPECT_EQ(program(56U), MemoryStatus::kFailed);
    std::filesystem::resize_file(path, 128U);
    EXPECT_EQ(program(40U), MemoryStatus::kReady);
    std::filesystem::remove(path);
    EXPECT_EQ(program(48U), MemoryStatus::kFailed);
}

TEST_F(FileMemoryTest, AFileOfAnotherDeviceIsRefused)
{
    Verifies(req::SRS_STO_013);
    {
        const FileParameterMemory memory{path, 64U};
        EXPECT_EQ(Refusal(path, 64U), path + ": is in use by another device, expected a file of its own");
    }
    EXPECT_EQ(Refusal(path, 64U), "");
}

} // namespace
} // namespace counterpoint::host
