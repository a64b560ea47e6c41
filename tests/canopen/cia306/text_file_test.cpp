// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/text/text_file.hpp"

#include "canopen/cia306/text/input_error.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/ids/generate.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <functional>
#include <grp.h>
#include <iterator>
#include <map>
#include <string>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

namespace counterpoint::cia306
{
namespace
{
/// As somebody else without groups, while it lives; only who may give files away becomes that.
class AsSomebody
{
  public:
    static constexpr uid_t kId = 12345U;

    AsSomebody()
        : count_(::getgroups(static_cast<int>(groups_.size()), groups_.data())),
          is_one_(count_ >= 0 && ::setgroups(0U, nullptr) == 0 && ::setegid(kId) == 0 && ::seteuid(kId) == 0)
    {
    }
    AsSomebody(const AsSomebody&) = delete;
    AsSomebody& operator=(const AsSomebody&) = delete;
    ~AsSomebody()
    {
        static_cast<void>(::seteuid(user_));
        static_cast<void>(::setegid(group_));
        static_cast<void>(::setgroups(is_one_ ? static_cast<std::size_t>(count_) : 0U, groups_.data()));
    }
    [[nodiscard]] bool IsOne() const
    {
        return is_one_;
    }

  private:
    std::array<gid_t, 256> groups_{};
    uid_t user_{::geteuid()};
    gid_t group_{::getegid()};
    int count_;
    bool is_one_;
};

class TextFile : public ::testing::Test
{
  protected:
    TextFile()
    {
        folder_ = std::filesystem::temp_directory_path() / ("cia306_" + std::to_string(::getpid()));
        std::filesystem::create_directories(folder_);
    }
    ~TextFile() override
    {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    [[nodiscard]] std::string Path(const std::string& name) const
    {
        return (folder_ / name).string();
    }
    static std::string RefusalOf(const std::function<void()>& action)
    {
        try
        {
            action();
        }
        catch (const InputError& error)
        {
            return error.what();
        }
        return "";
    }
    static std::string RefusalOf(const std::string& path)
    {
        return RefusalOf([&path] { static_cast<void>(ReadTextFile(path)); });
    }

    std::filesystem::path folder_;
};

TEST_F(TextFile, GivesBackWhatWasWritten)
{
    Verifies(req::SRS_EDS_004);
    const std::string text("[A]\r\nk=\xE4\0v", 11U);
    WriteTextFile(Path("a"), text);
    EXPECT_EQ(ReadTextFile(Path("a")), text);
}

TEST_F(TextFile, WhatIsNoRegularFileIsRefusedWithoutWaiting)
{
    Verifies(req::SRS_EDS_017);
    ASSERT_EQ(::mkfifo(Path("pipe").c_str(), 0600), 0);
    EXPECT_EQ(RefusalOf(Path("pipe")), Path("pipe") + ": error: it is a pipe, expected a regular file");
    EXPECT_EQ(RefusalOf("/dev/zero"), "/dev/zero: error: it is a device, expected a regular file");
    EXPECT_EQ(RefusalOf(folder_.string()), folder_.string() + ": error: it is a directory, expected a regular file");
    EXPECT_EQ(RefusalOf(Path("none")), Path("none") + ": error: it cannot be opened (No such file or directory), "
                                                      "expected a readable EDS or DCF file");
    EXPECT_EQ(RefusalOf(""), ": error: it cannot be opened (No such file or directory), expected a readable EDS or "
                             "DCF file");
}

TEST_F(TextFile, ALargeFileIsRefusedBeforeItIsRead)
{
    Verifies(req::SRS_EDS_017);
    WriteTextFile(Path("large"), "x");
    std::filesystem::resize_file(Path("large"), 16U * 1024U * 1024U);
    EXPECT_EQ(ReadTextFile(Path("large")).size(), 16777216U);
    // Sparse: reading all of it would take long and much memory.
    std::filesystem::resize_file(Path("large"), 16777217U);
    EXPECT_EQ(RefusalOf(Path("large")),
              Path("large") + ": error: it has 16777217 bytes, expected at most 16777216 bytes");
    std::filesystem::resize_file(Path("large"), std::uintmax_t{1} << 40U);
    EXPECT_EQ(RefusalOf(Path("large")),
              Path("large") + ": error: it has 1099511627776 bytes, expected at most 16777216 bytes");
}

TEST_F(TextFile, ATextInPiecesIsOneFileOrNone)
{
    Verifies(req::SRS_CLI_035);
    WriteTextFile(Path("a"), "old");
    // Given a writer that ends by an exception behind 100 000 bytes: the file is what it was, and nothing lies beside
    // it
    EXPECT_THROW(WriteTextInPieces(Path("a"),
                                   [](const TextPiece& write)
                                   {
                                       write(std::string(100000U, 'x'));
                                       throw InputError("b", {}, {"wrong", "right"});
                                   }),
                 InputError);
    EXPECT_EQ(ReadTextFile(Path("a")), "old");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), std::filesystem::directory_iterator()), 1);
    // And one that ends well
    std::string whole;
    WriteTextInPieces(Path("a"),
                      [&whole, this](const TextPiece& write)
                      {
                          for (int line = 0; line < 30000; ++line)
                          {
                              const std::string piece = std::to_string(line) + "\n";
                              write(piece);
                              whole += piece;
                          }
                          EXPECT_EQ(ReadTextFile(Path("a")), "old");
                      });
    EXPECT_EQ(ReadTextFile(Path("a")), whole);
    WriteTextInPieces(Path("none"), [](const TextPiece& /*write*/) {});
    EXPECT_EQ(ReadTextFile(Path("none")), "");
}

TEST_F(TextFile, AFileIsReplacedInOneStepAndKeepsItsMode)
{
    Verifies(req::SRS_CLI_120);
    Verifies(req::SRS_CLI_035);
    WriteTextFile(Path("a"), "old");
    std::filesystem::permissions(Path("a"), std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    std::filesystem::create_symlink(Path("a"), Path("link"));
    WriteTextFile(Path("link"), "new");
    EXPECT_EQ(ReadTextFile(Path("a")), "new");
    EXPECT_TRUE(std::filesystem::is_symlink(Path("link")));
    EXPECT_EQ(std::filesystem::status(Path("a")).permissions(),
              std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    std::size_t files = 0U;
    for (const auto& entry : std::filesystem::directory_iterator(folder_))
    {
        files += entry.exists() ? 1U : 0U;
    }
    EXPECT_EQ(files, 2U) << "no temporary file stays";
}

TEST_F(TextFile, AFileKeepsItsOwnerAndALinkIsFollowedWhereverItLeads)
{
    Verifies(req::SRS_CLI_035);
    WriteTextFile(Path("a"), "old");
    constexpr uid_t kSomebody = 12345U;
    const bool may_give = ::chown(Path("a").c_str(), kSomebody, kSomebody) == 0; // Not everybody may.
    ASSERT_EQ(::chmod(Path("a").c_str(), 0640), 0);
    WriteTextFile(Path("a"), "new");
    struct stat status{};
    ASSERT_EQ(::stat(Path("a").c_str(), &status), 0);
    EXPECT_EQ(status.st_uid, may_give ? kSomebody : ::geteuid());
    EXPECT_EQ(status.st_gid, may_give ? kSomebody : ::getegid());
    EXPECT_EQ(status.st_mode & 07777U, 0640U);
    // Links that lead nowhere, one to the other: the file is made at their end
    std::filesystem::create_directory(Path("deep"));
    std::filesystem::create_symlink("deep/second", Path("first"));
    std::filesystem::create_symlink("end", Path("deep/second"));
    WriteTextFile(Path("first"), "made");
    EXPECT_TRUE(std::filesystem::is_symlink(Path("first")));
    EXPECT_TRUE(std::filesystem::is_symlink(Path("deep/second")));
    EXPECT_EQ(ReadTextFile(Path("deep/end")), "made");
    // Links in a circle lead to nothing
    std::filesystem::create_symlink("circle", Path("circle"));
    EXPECT_THROW(WriteTextFile(Path("circle"), "x"), InputError);
    EXPECT_TRUE(std::filesystem::is_symlink(Path("circle")));
}

TEST_F(TextFile, AFileWhoseOwnerCannotBeKeptIsNotReplaced)
{
    Verifies(req::SRS_CLI_035);
    // Given a file of somebody else in a folder where everybody may write: one who may give files away takes that off
    WriteTextFile(Path("a"), "old");
    std::filesystem::permissions(folder_, std::filesystem::perms::all);
    constexpr uid_t kSomebody = 12345U;
    const uid_t own = ::geteuid();
    const bool is_somebody = ::seteuid(kSomebody) == 0;
    const std::string expected =
        Path("a") + ": error: its owner cannot be kept (Operation not permitted), expected a file of your own, or none";
    const std::string of_writing = RefusalOf([this] { WriteTextFile(Path("a"), "new"); });
    const std::string of_asking = RefusalOf([this] { RequireWritable(Path("a")); });
    static_cast<void>(::seteuid(own));
    // Then it is refused, before and at the writing, and nothing is there but the file
    EXPECT_EQ(of_writing, is_somebody ? expected : "");
    EXPECT_EQ(of_asking, is_somebody ? expected : "");
    EXPECT_EQ(ReadTextFile(Path("a")), is_somebody ? "old" : "new");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

TEST_F(TextFile, AFileWhoseGroupOrModeCannotBeKeptIsNotReplaced)
{
    Verifies(req::SRS_CLI_035);
    // Given two files of somebody in groups that they are not in: one where a new file has another group, one in a
    // folder that gives its own to what is in it, with the bit of the group
    std::filesystem::permissions(folder_, std::filesystem::perms::all);
    std::filesystem::create_directory(Path("deep"));
    WriteTextFile(Path("a"), "old");
    WriteTextFile(Path("deep/b"), "old");
    constexpr gid_t kGroup = 23456U;
    const bool may_give = ::chown(Path("deep").c_str(), AsSomebody::kId, kGroup) == 0 &&
                          ::chown(Path("a").c_str(), AsSomebody::kId, kGroup) == 0 &&
                          ::chown(Path("deep/b").c_str(), AsSomebody::kId, kGroup) == 0;
    ASSERT_EQ(::chmod(Path("deep").c_str(), 02777), 0);
    ASSERT_EQ(::chmod(Path("deep/b").c_str(), 02640), 0);
    std::map<std::string, std::string> told;
    bool is_somebody = false;
    {
        const AsSomebody somebody;
        is_somebody = may_give && somebody.IsOne();
        for (const char* const name : {"a", "deep/b"})
        {
            told[name] = RefusalOf([this, name] { WriteTextFile(Path(name), "new"); });
            told[std::string(name) + " before"] = RefusalOf([this, name] { RequireWritable(Path(name)); });
        }
    }
    // Then both are refused, before and at the writing, and stay as they were
    const std::string of_group = Path("a") +
                                 ": error: its owner cannot be kept (Operation not permitted), expected a " +
                                 "file of your own, or none";
    const std::string of_mode =
        Path("deep/b") + ": error: its mode cannot be kept, expected a file of a group of your own, or none";
    const std::map<std::string, std::string> expected{
        {"a", of_group}, {"a before", of_group}, {"deep/b", of_mode}, {"deep/b before", of_mode}};
    if (is_somebody)
    {
        EXPECT_EQ(told, expected);
        EXPECT_EQ(ReadTextFile(Path("a")) + ReadTextFile(Path("deep/b")), "oldold");
    }
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 2);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(Path("deep")), {}), 1);
}

TEST_F(TextFile, AProcessThatIsKilledWhileItWritesLeavesNothing)
{
    Verifies(req::SRS_CLI_035);
    WriteTextFile(Path("a"), "old");
    const pid_t child = ::fork();
    if (child == 0)
    {
        const rlimit limit{1000U, 1000U};
        static_cast<void>(::setrlimit(RLIMIT_FSIZE, &limit)); // The signal of the system in the middle of the writing.
        WriteTextFile(Path("a"), std::string(100000U, 'x'));
        ::_exit(0);
    }
    int end = 0;
    ASSERT_EQ(::waitpid(child, &end, 0), child);
    EXPECT_TRUE(WIFSIGNALED(end));
    EXPECT_EQ(ReadTextFile(Path("a")), "old");
    const auto files = std::distance(std::filesystem::directory_iterator(folder_), {});
    EXPECT_EQ(files, 1);
}

TEST_F(TextFile, WhoReadsWhileAFileIsReplacedGetsAllOfTheOldText)
{
    Verifies(req::SRS_CLI_120);
    WriteTextFile(Path("a"), "old text");
    std::FILE* const reader = std::fopen(Path("a").c_str(), "r");
    ASSERT_NE(reader, nullptr);
    char text[16] = {};
    ASSERT_EQ(std::fread(text, 1U, 3U, reader), 3U);
    // When it is replaced while somebody reads it, who asks the system anew behind the first bytes
    WriteTextFile(Path("a"), "NEW TEXT, WHICH IS LONGER");
    ASSERT_EQ(std::fseek(reader, 0L, SEEK_SET), 0);
    const std::size_t count = std::fread(text, 1U, sizeof(text) - 1U, reader);
    static_cast<void>(std::fclose(reader));
    EXPECT_EQ(std::string(text, count), "old text");
    EXPECT_EQ(ReadTextFile(Path("a")), "NEW TEXT, WHICH IS LONGER");
}

TEST_F(TextFile, WritingToWhatIsNoFileIsRefused)
{
    Verifies(req::SRS_CLI_650);
    EXPECT_THROW(WriteTextFile(folder_.string(), "x"), InputError);
    EXPECT_THROW(WriteTextFile("/dev/null", "x"), InputError);
    EXPECT_THROW(WriteTextFile(Path("no/such/folder/a"), "x"), InputError);
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST_F(TextFile, WhetherAPathCanBeWrittenIsKnownBefore)
{
    Verifies(req::SRS_CLI_650);
    EXPECT_THROW(RequireWritable(folder_.string()), InputError);
    EXPECT_THROW(RequireWritable("/dev/null"), InputError);
    EXPECT_THROW(RequireWritable(Path("no/such/folder/a")), InputError);
    WriteTextFile(Path("a"), "old");
    RequireWritable(Path("a"));
    RequireWritable(Path("b"));
    EXPECT_EQ(ReadTextFile(Path("a")), "old");
    EXPECT_FALSE(std::filesystem::exists(Path("b"))) << "nothing is left behind";
}

// What asks and what writes say the same: of no name, of one of 256 bytes, one longer than the system allows, one
// below a file.
TEST_F(TextFile, APathThatNoFileCanHaveIsRefusedBefore)
{
    Verifies(req::SRS_CLI_240);
    WriteTextFile(Path("a"), "old");
    const auto refusal_of = [](const std::function<void()>& work) -> std::string
    {
        try
        {
            work();
        }
        catch (const InputError& error)
        {
            return error.what();
        }
        return "";
    };
    for (const std::string& path : {Path(std::string(256U, 'n')), Path(std::string(5000U, 'n')), Path("a/b")})
    {
        const std::string asked = refusal_of([&path] { RequireWritable(path); });
        EXPECT_NE(asked, "") << path;
        EXPECT_EQ(refusal_of([&path] { WriteTextFile(path, "x"); }), asked);
    }
    const std::string nameless = refusal_of([] { RequireWritable(""); });
    EXPECT_EQ(nameless, ": error: it has no name, expected the name of a file");
    EXPECT_NE(refusal_of([] { WriteTextFile("", "x"); }), "");
    // The longest name is a name
    const std::string longest = Path(std::string(255U, 'n'));
    RequireWritable(longest);
    WriteTextFile(longest, "x");
    EXPECT_EQ(ReadTextFile(longest), "x");
    const auto files = std::distance(std::filesystem::directory_iterator(folder_), {});
    EXPECT_EQ(files, 2) << "nothing is left behind";
}

TEST_F(TextFile, ASocketIsNoRegularFileEither)
{
    Verifies(req::SRS_CLI_650);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const std::string path = Path("s");
    ASSERT_LT(path.size(), sizeof(address.sun_path));
    std::copy(path.begin(), path.end(), address.sun_path);
    const int number = ::socket(AF_UNIX, SOCK_STREAM, 0);
    ASSERT_GE(number, 0);
    ASSERT_EQ(::bind(number, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
    try
    {
        WriteTextFile(path, "x");
        FAIL() << "no refusal";
    }
    catch (const InputError& error)
    {
        EXPECT_EQ(error.what(), path + ": error: it is no regular file, expected a regular file, or none");
    }
    (void)::close(number);
}

TEST_F(TextFile, AFileOfTheNameInBetweenIsNotTakenAway)
{
    Verifies(req::SRS_CLI_120);
    WriteTextFile(Path("a"), "old");
    // Given a file that somebody else gave the name which the new one gets before it replaces the old one
    const std::string between = Path("a") + "." + std::to_string(::getpid());
    WriteTextFile(between, "of somebody else");
    try
    {
        WriteTextFile(Path("a"), "new");
        FAIL() << "no refusal";
    }
    catch (const InputError& error)
    {
        EXPECT_EQ(error.what(),
                  Path("a") + ": error: it cannot be replaced (File exists), expected a path in a writable folder");
    }
    EXPECT_EQ(ReadTextFile(Path("a")), "old");
    EXPECT_EQ(ReadTextFile(between), "of somebody else");
}

TEST_F(TextFile, AFileOfTheFolderOneIsInNeedsNoFolder)
{
    Verifies(req::SRS_CLI_120);
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(folder_);
    WriteTextFile("alone", "x");
    EXPECT_EQ(ReadTextFile("alone"), "x");
    std::filesystem::current_path(before);
}

TEST_F(TextFile, AFileThatFailsOrGrowsWhileItIsReadIsRefused)
{
    Verifies(req::SRS_EDS_017);
    // Regular files without a length: one cannot be read from its beginning, the other is longer than any text
    EXPECT_EQ(RefusalOf("/proc/self/mem"),
              "/proc/self/mem: error: it cannot be read (Input/output error), expected a readable file");
    EXPECT_EQ(RefusalOf("/proc/self/pagemap"),
              "/proc/self/pagemap: error: it has more than 16777216 bytes, expected at most that many");
}

std::string RefusalOfWriting(const std::string& path, const std::string& text)
{
    try
    {
        WriteTextFile(path, text);
    }
    catch (const InputError& error)
    {
        return error.what();
    }
    return "";
}

TEST_F(TextFile, WhatIsNoRegularFileIsRefusedByOneLineAndStays)
{
    Verifies(req::SRS_CLI_650);
    const std::string none = "expected a regular file, or none";
    ASSERT_EQ(::mkfifo(Path("pipe").c_str(), 0600), 0);
    EXPECT_EQ(RefusalOfWriting(folder_.string(), "x"), folder_.string() + ": error: it is a directory, " + none);
    EXPECT_EQ(RefusalOfWriting("/dev/null", "x"), "/dev/null: error: it is a device, " + none);
    EXPECT_EQ(RefusalOfWriting(Path("pipe"), "x"), Path("pipe") + ": error: it is a pipe, " + none);
    EXPECT_TRUE(std::filesystem::is_fifo(Path("pipe")));
    EXPECT_EQ(RefusalOfWriting(Path("no/a"), "x"),
              Path("no/a") + ": error: it cannot be created (No such file or directory), expected a path in a "
                             "writable folder");
}

TEST_F(TextFile, WhereNothingCanBeMadeOrTheRoomEndsTheOldFileStays)
{
    Verifies(req::SRS_CLI_120);
    EXPECT_EQ(RefusalOfWriting("/proc/none", "x"), "/proc/none: error: it cannot be created (No such file or "
                                                   "directory), expected a path in a writable folder");
    WriteTextFile(Path("a"), "old");
    // Given a system that takes no more than ten bytes of a file
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{10U, before.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    const std::string refusal = RefusalOfWriting(Path("a"), std::string(100U, 'x'));
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
    (void)std::signal(SIGXFSZ, handler);
    EXPECT_EQ(refusal, Path("a") + ": error: it cannot be written (File too large), expected a file system with room");
    EXPECT_EQ(ReadTextFile(Path("a")), "old");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

/// Calls `run` while a descriptor of this process is `file`, or closed where that is empty; what it answers.
std::string WithOutputTo(const int descriptor, const std::string& file, const std::function<std::string()>& run)
{
    const int before = ::dup(descriptor);
    EXPECT_GE(before, 0);
    (void)::close(descriptor);
    const int output = file.empty() ? -1 : ::open(file.c_str(), O_WRONLY | O_APPEND);
    const bool is_set = file.empty() || output == descriptor || ::dup2(output, descriptor) == descriptor;
    const std::string answer = is_set ? run() : "no output";
    (void)::dup2(before, descriptor);
    (void)::close(before);
    return answer;
}

TEST_F(TextFile, AFileIntoWhichTheProgramPrintsIsNotReplaced)
{
    Verifies(req::SRS_CLI_170);
    // Given a log to which standard output or standard error is appended
    WriteTextFile(Path("log"), "what was there before\n");
    std::filesystem::create_hard_link(Path("log"), Path("other name"));
    const auto writing = [](const std::string& path) { return [path]() { return RefusalOfWriting(path, "new"); }; };
    // When the same file, by whatever name, is to be written, then it is refused and keeps what it has
    for (const int descriptor : {STDOUT_FILENO, STDERR_FILENO})
    {
        for (const std::string& path : {Path("log"), Path("other name"), "/proc/self/fd/" + std::to_string(descriptor)})
        {
            EXPECT_EQ(WithOutputTo(descriptor, Path("log"), writing(path)),
                      path + ": error: this program prints into it, expected another file");
        }
    }
    EXPECT_EQ(WithOutputTo(STDOUT_FILENO, Path("log"),
                           [this]()
                           {
                               try
                               {
                                   RequireWritable(Path("log"));
                               }
                               catch (const InputError& error)
                               {
                                   return std::string(error.what());
                               }
                               return std::string("it can be written");
                           }),
              Path("log") + ": error: this program prints into it, expected another file");
    EXPECT_EQ(ReadTextFile(Path("log")), "what was there before\n");
    // And another file beside it is replaced
    WriteTextFile(Path("another"), "old");
    EXPECT_EQ(WithOutputTo(STDOUT_FILENO, Path("log"), writing(Path("another"))), "");
    EXPECT_EQ(ReadTextFile(Path("another")), "new");
}

TEST_F(TextFile, AProgramWithoutOutputReplacesAFile)
{
    Verifies(req::SRS_CLI_170);
    WriteTextFile(Path("a"), "old");
    for (const int descriptor : {STDOUT_FILENO, STDERR_FILENO})
    {
        const std::string text = "new " + std::to_string(descriptor);
        EXPECT_EQ(WithOutputTo(descriptor, "", [&] { return RefusalOfWriting(Path("a"), text); }), "");
        EXPECT_EQ(ReadTextFile(Path("a")), text);
    }
}

TEST_F(TextFile, AFileThatCannotTakeItsPlaceLeavesNothing)
{
    Verifies(req::SRS_CLI_120);
    // Given a path without a name: the file beside it can be made, and named, but not take its place
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(folder_);
    const std::string refusal = RefusalOfWriting("", "x");
    std::filesystem::current_path(before);
    EXPECT_EQ(refusal,
              ": error: it cannot be replaced (No such file or directory), expected a path in a writable folder");
    EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(TextFile, FilesThatBelongTogetherAreReplacedTogether)
{
    Verifies(req::SRS_GEN_170);
    WriteTextFile(Path("a.h"), "old header");
    WriteTextFile(Path("a.c"), "old source");
    std::filesystem::create_directory(Path("folder"));
    // When the second one cannot be written, then both stay as they were and nothing is there but them
    EXPECT_THROW(WriteTextFiles({{Path("a.h"), "new header"}, {Path("folder"), "new source"}}), InputError);
    EXPECT_THROW(WriteTextFiles({{Path("a.h"), "new header"}, {Path("none/a.c"), "new source"}}), InputError);
    EXPECT_EQ(ReadTextFile(Path("a.h")), "old header");
    EXPECT_EQ(ReadTextFile(Path("a.c")), "old source");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 3);
    // When both can, then both are new
    WriteTextFiles({{Path("a.h"), "new header"}, {Path("a.c"), "new source"}});
    EXPECT_EQ(ReadTextFile(Path("a.h")), "new header");
    EXPECT_EQ(ReadTextFile(Path("a.c")), "new source");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 3);
}
} // namespace
} // namespace counterpoint::cia306
