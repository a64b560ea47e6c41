// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What a node tells, where nobody reads it.
#include "runtime/console/node_report.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <mutex>
#include <ostream>
#include <poll.h>
#include <sstream>
#include <string>
#include <thread>
#include <unistd.h>

namespace counterpoint::runtime
{
namespace
{
/// Takes what is written, and keeps its writer in there until it is opened.
class HeldBuffer : public std::streambuf
{
  public:
    void AwaitWriter()
    {
        std::unique_lock<std::mutex> lock(mutex_);
        change_.wait(lock, [this] { return is_entered_; });
    }
    void Open()
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        is_open_ = true;
        change_.notify_all();
    }
    [[nodiscard]] std::string Text()
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        return text_;
    }

  protected:
    std::streamsize xsputn(const char* const bytes, const std::streamsize count) override
    {
        std::unique_lock<std::mutex> lock(mutex_);
        is_entered_ = true;
        change_.notify_all();
        change_.wait(lock, [this] { return is_open_; });
        text_.append(bytes, static_cast<std::size_t>(count));
        return count;
    }

  private:
    std::mutex mutex_;
    std::condition_variable change_;
    bool is_entered_{false};
    bool is_open_{false};
    std::string text_;
};

class NodeReportTest : public ::testing::Test
{
  protected:
    NodeReportTest()
    {
        EXPECT_EQ(::pipe(ends_.data()), 0);
        out_.open("/proc/self/fd/" + std::to_string(ends_[1]));
    }
    ~NodeReportTest() override
    {
        static_cast<void>(::close(ends_[0]));
        static_cast<void>(::close(ends_[1]));
    }
    /// Everything up to a line that begins with a text.
    [[nodiscard]] std::string ReadTo(const std::string& last) const
    {
        std::string text;
        std::array<char, 65536U> bytes{};
        ssize_t count = 1;
        std::size_t from = 0U;
        while (text.find(last, from) == std::string::npos && count > 0)
        {
            from = (text.size() > last.size()) ? text.size() - last.size() : 0U;
            count = ::read(ends_[0], bytes.data(), bytes.size());
            text.append(bytes.data(), static_cast<std::size_t>(count > 0 ? count : 0));
        }
        return text;
    }

    static constexpr int kMany = 70000;
    std::array<int, 2U> ends_{};
    std::ofstream out_;
};

// Given more lines than have room, then the place where some are missing tells how many, and the line of an output that
// closed meanwhile is there.
TEST_F(NodeReportTest, WhatIsLeftOutIsCountedAndAnOutputThatClosedIsTold)
{
    Verifies(req::SRS_NODE_032);
    Verifies(req::SRS_NODE_210);
    NodeReport report(out_, ReportForm::kText, 0U, ends_[1]);
    report.Print("first\n");
    for (int i = 0; i < 3 * kMany; ++i)
    {
        report.Print("value\n");
    }
    report.Tell(0U, "output of SRDO 1 closed", "output", {{"open", false}});
    std::string text = ReadTo("closed");
    std::thread reader([this, &text] { text += ReadTo("end\n"); });
    report.Print("end\n");
    EXPECT_TRUE(report.Finish());
    reader.join();
    std::istringstream lines(text);
    int values = 0;
    int left_out = 0;
    int before_the_gap = 0;
    for (std::string line; std::getline(lines, line);)
    {
        before_the_gap += (left_out == 0) ? 1 : 0;
        values += (line == "value") ? 1 : 0;
        left_out += (line.find(" lines left out here: nobody read them") != std::string::npos) ? std::stoi(line) : 0;
    }
    EXPECT_GT(left_out, 0);
    EXPECT_GE(before_the_gap, 65536);
    EXPECT_EQ(values + left_out, 3 * kMany);
    EXPECT_NE(text.find("output of SRDO 1 closed"), std::string::npos);
}

// Given a writer that waits for its reader and no place left, then 4096 more lines of outputs are kept: 4095, and the
// one that tells how many are missing before them. Of 5000, 905 are missing behind.
TEST_F(NodeReportTest, LinesOfOutputsHavePlacesOfTheirOwn)
{
    Verifies(req::SRS_NODE_210);
    NodeReport report(out_, ReportForm::kText, 0U, ends_[1]);
    for (pollfd room{ends_[1], POLLOUT, 0}; ::poll(&room, 1U, 0) > 0;)
    {
        report.Print("value\n");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(200)); // It has taken what it will take.
    for (int i = 0; i < 2 * kMany; ++i)
    {
        report.Print("value\n");
    }
    const std::array<const char*, 4U> events{"output", "device_fault", "stopped", "stale_frames"};
    for (std::size_t i = 1U; i <= 5000U; ++i)
    {
        report.Tell(0U, "SRDO " + std::to_string(i) + ".", events.at(i % 4U), {{"open", false}});
    }
    std::string text = ReadTo("SRDO 4095.\n");
    std::thread reader([this, &text] { text += ReadTo("end\n"); });
    report.Print("end\n");
    EXPECT_TRUE(report.Finish());
    reader.join();
    EXPECT_NE(text.find("lines left out here: nobody read them\n  0.000000 s  SRDO 1.\n"), std::string::npos);
    EXPECT_NE(text.find("SRDO 4095.\n905 lines left out here: nobody read them\nend\n"), std::string::npos)
        << text.substr(text.size() - 200U);
}

// Given a pipe with room for one piece, whose writer has put half of a first line there and waits, then what is kept is
// counted exactly.
TEST_F(NodeReportTest, ExactlyTheFirst65536LinesOr64MiBAreKept)
{
    Verifies(req::SRS_NODE_032);
    const std::string piece(4096U, 'x');
    struct Row
    {
        std::string line;
        int kept;
        std::string left_out;
    };
    for (const Row& row :
         {Row{"value\n", 65536, "10 lines left out here: nobody read them\nend\n"},
          Row{std::string(1048575U, 'v') + "\n", 64, "10 lines left out here: nobody read them\nend\n"}})
    {
        ASSERT_EQ(::fcntl(ends_[1], F_SETFL, O_NONBLOCK), 0);
        while (::write(ends_[1], piece.data(), piece.size()) > 0)
        {
        }
        ASSERT_EQ(::fcntl(ends_[1], F_SETFL, 0), 0);
        std::array<char, 4096U> bytes{};
        ASSERT_EQ(::read(ends_[0], bytes.data(), bytes.size()), 4096);
        NodeReport report(out_, ReportForm::kText, 0U, ends_[1]);
        report.Print(std::string(8191U, 'x') + "\n");
        for (pollfd room{ends_[1], POLLOUT, 0}; ::poll(&room, 1U, 0) > 0;)
        {
            std::this_thread::yield();
        }
        for (int i = 0; i < row.kept + 10; ++i)
        {
            report.Print(row.line);
        }
        report.PrintLast("end\n");
        std::string text;
        std::thread reader([this, &text] { text = ReadTo("\nend\n"); });
        EXPECT_TRUE(report.Finish());
        reader.join();
        const std::size_t first = text.find('\n') + 1U;
        const std::size_t behind = first + (static_cast<std::size_t>(row.kept) * row.line.size());
        ASSERT_EQ(text.size(), behind + row.left_out.size());
        EXPECT_EQ(text.substr(behind), row.left_out);
    }
}

// Given a reader that reads nothing, then the end does not wait for it.
TEST_F(NodeReportTest, TheEndDoesNotWaitForAReaderThatReadsNothing)
{
    Verifies(req::SRS_NODE_211);
    Verifies(req::SRS_NODE_212);
    NodeReport report(out_, ReportForm::kJson, 0U, ends_[1]);
    for (int i = 0; i < kMany; ++i)
    {
        report.Tell(0U, "", "value", {{"value", i}});
    }
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_FALSE(report.Finish());
    const auto took = std::chrono::steady_clock::now() - begin;
    EXPECT_GE(took, std::chrono::milliseconds(1900));
    EXPECT_LT(took, std::chrono::minutes(2));
    EXPECT_EQ(ReadTo("\n").substr(0U, 58U), R"({"format":"counterpoint-node-1","at_us":0,"event":"value",)");
}

// Given objects that nobody reads, then the line that tells of those left out is one of them, and the end is there.
TEST_F(NodeReportTest, WhatIsLeftOutOfObjectsIsAnObject)
{
    Verifies(req::SRS_MGR_161);
    NodeReport report(out_, ReportForm::kObjects, 0U, ends_[1], "a-manager-1");
    for (int i = 0; i < 3 * kMany; ++i)
    {
        report.Print("{}\n");
    }
    report.Print(""); // No line.
    report.PrintLast("{\"last\": 1}\n");
    std::string text;
    std::thread reader([this, &text] { text = ReadTo("\"last\": 1}\n"); });
    EXPECT_TRUE(report.Finish());
    reader.join();
    std::istringstream lines(text);
    int objects = 0;
    int left_out = 0;
    for (std::string line; std::getline(lines, line);)
    {
        const std::string gap = R"({"format":"a-manager-1","event":"left_out","count":)";
        EXPECT_EQ(line.front(), '{');
        EXPECT_EQ(line.back(), '}');
        objects += (line == "{}") ? 1 : 0;
        left_out += (line.rfind(gap, 0U) == 0U) ? std::stoi(line.substr(gap.size())) : 0;
    }
    EXPECT_GT(left_out, 0);
    EXPECT_EQ(objects + left_out, 3 * kMany);
}

// Given lines left out behind the last one that was kept, then the end tells them.
TEST_F(NodeReportTest, WhatIsLeftOutAtTheEndIsTold)
{
    Verifies(req::SRS_MGR_161);
    NodeReport report(out_, ReportForm::kText, 0U, ends_[1]);
    for (int i = 0; i < 3 * kMany; ++i)
    {
        report.Print("value\n");
    }
    std::string text;
    std::thread reader([this, &text] { text = ReadTo("no such line"); });
    EXPECT_TRUE(report.Finish());
    out_.close();
    EXPECT_EQ(::close(ends_[1]), 0);
    ends_[1] = -1;
    reader.join();
    std::istringstream lines(text);
    int values = 0;
    int left_out = 0;
    for (std::string line; std::getline(lines, line);)
    {
        values += (line == "value") ? 1 : 0;
        left_out += (line.find(" lines left out here: nobody read them") != std::string::npos) ? std::stoi(line) : 0;
    }
    EXPECT_GT(left_out, 0);
    EXPECT_EQ(values + left_out, 3 * kMany);
}

// Given long lines that nobody reads, then 64 MiB wait and no more.
TEST_F(NodeReportTest, LongLinesTakeNoMoreMemoryThanShortOnes)
{
    Verifies(req::SRS_NODE_032);
    NodeReport report(out_, ReportForm::kText, 0U, ends_[1]);
    const std::string line = std::string(1048575U, 'x') + "\n";
    for (int i = 0; i < 200; ++i)
    {
        report.Print(line);
    }
    report.PrintLast("end\n");
    std::string text;
    std::thread reader([this, &text] { text = ReadTo("end\n"); });
    EXPECT_TRUE(report.Finish());
    reader.join();
    // What its thread has taken already, and 64 lines that wait
    EXPECT_GE(text.size(), 64U * line.size());
    EXPECT_LE(text.size(), 129U * line.size());
    EXPECT_NE(text.find(" lines left out here: nobody read them\n"), std::string::npos);
}

// Given screens that nobody takes, then the last one is kept, not all of a night.
TEST_F(NodeReportTest, OfScreensTheLastOneWaits)
{
    Verifies(req::SRS_MGR_161);
    constexpr int kScreens = 200;
    NodeReport report(out_, ReportForm::kText, 0U, ends_[1]);
    report.Print(std::string(200000U, 'x') + "\n"); // More than a pipe takes.
    for (int i = 0; i <= kScreens; ++i)
    {
        report.PrintScreen("screen " + std::to_string(i) + "\n");
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    report.Print("line\n");
    std::string text;
    std::thread reader([this, &text] { text = ReadTo("line\n"); });
    EXPECT_TRUE(report.Finish());
    reader.join();
    std::istringstream lines(text);
    int screens = 0;
    for (std::string line; std::getline(lines, line);)
    {
        screens += (line.rfind("screen ", 0U) == 0U) ? 1 : 0;
    }
    // Those of the time until its thread found that nobody reads
    EXPECT_LT(screens, kScreens / 2);
    EXPECT_NE(text.find("screen 200\nline\n"), std::string::npos);
}

// Given a reader that only is slow, then each screen is written.
TEST(NodeReportOfAFile, HasEachScreenWhileItsReaderReads)
{
    Verifies(req::SRS_MGR_161);
    HeldBuffer buffer;
    std::ostream out(&buffer);
    NodeReport report(out, ReportForm::kText, 0U);
    report.Print("first\n");
    buffer.AwaitWriter();
    report.PrintScreen("screen 1\n");
    report.PrintScreen("screen 2\n");
    buffer.Open();
    EXPECT_TRUE(report.Finish());
    EXPECT_EQ(buffer.Text(), "first\nscreen 1\nscreen 2\n");
}

TEST(NodeReportOfAFile, TellsTheTimeSinceItsStart)
{
    Verifies(req::SRS_NODE_004);
    std::ostringstream text;
    {
        NodeReport report(text, ReportForm::kText, 1000000000U);
        EXPECT_EQ(report.Form(), ReportForm::kText);
        report.Tell(2500000000U, "operational", "state", {{"state", 5}});
        report.Tell(1000000001U, "a", "value", {{"value", 1}});
        report.Tell(999999999U, "before", "value", {{"value", 2}});
        report.Print("a line\n");
        report.PrintLast("a last line\n");
    }
    EXPECT_EQ(text.str(), "  1.500000 s  operational\n  0.000000 s  a\n  0.000000 s  before\na line\na last line\n");
    std::ostringstream objects;
    {
        NodeReport report(objects, ReportForm::kJson, 1000000000U);
        report.Tell(2500000999U, "operational", "state", {{"state", 5}});
        report.Print("a line\n");
        report.PrintLast("a last line\n");
    }
    EXPECT_EQ(objects.str(), R"({"format":"counterpoint-node-1","at_us":1500000,"event":"state","state":5})"
                             "\n");
}

// Given several lines in one go for a reader that has stopped, then the end waits for it once, not once a line.
TEST_F(NodeReportTest, TheEndWaitsOnceForAllLines)
{
    Verifies(req::SRS_NODE_211);
    Verifies(req::SRS_NODE_212);
    HeldBuffer buffer;
    std::ostream out(&buffer);
    NodeReport report(out, ReportForm::kText, 0U, ends_[1]);
    report.Print("first\n");
    buffer.AwaitWriter();
    const std::string piece(4096U, 'x');
    ASSERT_EQ(::fcntl(ends_[1], F_SETFL, O_NONBLOCK), 0);
    while (::write(ends_[1], piece.data(), piece.size()) > 0)
    {
    }
    for (int i = 0; i < 60; ++i)
    {
        report.Print(piece + "\n");
    }
    buffer.Open();
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_FALSE(report.Finish());
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::minutes(2)); // 60 times two seconds.
    EXPECT_EQ(buffer.Text(), "first\n");
}

// Given a reader that has ended, then the end tells that not everything was written.
TEST_F(NodeReportTest, AReaderThatHasEndedHoldsUpNobody)
{
    Verifies(req::SRS_NODE_211);
    Verifies(req::SRS_NODE_212);
    std::signal(SIGPIPE, SIG_IGN);
    NodeReport report(out_, ReportForm::kText, 0U, ends_[1]);
    ASSERT_EQ(::close(ends_[0]), 0);
    ends_[0] = -1;
    report.Print("first\n");
    EXPECT_FALSE(report.Finish());
}
} // namespace
} // namespace counterpoint::runtime
