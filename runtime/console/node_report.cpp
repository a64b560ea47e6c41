// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/console/node_report.hpp"

#include "runtime/console/json_text.hpp"

#include <array>
#include <cstdio>
#include <poll.h>
#include <utility>

namespace counterpoint::runtime
{
namespace
{
constexpr double kNsPerSecond = 1e9;
constexpr double kNsPerUs = 1e3;
constexpr std::size_t kMostWaiting = 65536U;
constexpr std::size_t kMostImportant = kMostWaiting + 4096U;
constexpr std::size_t kMostBytes = 64U * 1024U * 1024U; ///< Lines are long or short.
constexpr std::size_t kPieceBytes = 4096U;              ///< A pipe that is ready takes so many without waiting.
constexpr int kLookMs = 100;
constexpr int kLooksAtEnd = 20;

bool IsImportant(const std::string& event)
{
    return event == "output" || event == "device_fault" || event == "stopped" || event == "stale_frames";
}
} // namespace

NodeReport::NodeReport(std::ostream& out, const ReportForm form, const std::uint64_t start_ns, const int file,
                       std::string format)
    : out_(out), form_(form), format_(std::move(format)), start_ns_(start_ns), file_(file), writer_([this] { Write(); })
{
}

NodeReport::~NodeReport()
{
    static_cast<void>(Finish());
}

void NodeReport::Tell(const std::uint64_t at_ns, const std::string& text, const std::string& event,
                      const nlohmann::ordered_json& details)
{
    const std::size_t room = IsImportant(event) ? kMostImportant : kMostWaiting;
    const double since_ns = (at_ns > start_ns_) ? static_cast<double>(at_ns - start_ns_) : 0.0;
    if (form_ == ReportForm::kText)
    {
        std::array<char, 32U> time{};
        static_cast<void>(std::snprintf(time.data(), time.size(), "%10.6f s  ", since_ns / kNsPerSecond));
        Put(time.data() + text + "\n", room);
        return;
    }
    nlohmann::ordered_json line{
        {"format", format_}, {"at_us", static_cast<std::uint64_t>(since_ns / kNsPerUs)}, {"event", event}};
    line.update(details);
    Put(OneLine(line), room);
}

void NodeReport::Print(const std::string& lines)
{
    if (form_ != ReportForm::kJson)
    {
        Put(lines, kMostWaiting);
    }
}

void NodeReport::PrintLast(const std::string& lines)
{
    if (form_ != ReportForm::kJson)
    {
        Put(lines, kMostImportant);
    }
}

void NodeReport::PrintScreen(const std::string& screen)
{
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (is_screen_last_ && is_blocked_)
        {
            waiting_bytes_ -= waiting_.back().size();
            waiting_.pop_back();
        }
        is_screen_last_ = Keep(screen, kMostImportant);
    }
    wake_.notify_one();
}

bool NodeReport::Finish()
{
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        TellGap();
        is_finished_ = true;
    }
    wake_.notify_one();
    if (writer_.joinable())
    {
        writer_.join();
    }
    return static_cast<bool>(out_) && !is_given_up_;
}

void NodeReport::Put(std::string line, const std::size_t room)
{
    if (!line.empty())
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        static_cast<void>(Keep(std::move(line), room));
    }
    wake_.notify_one();
}

/// With the lock. Of an output that nobody reads the newest lines are left out, not the memory of the machine taken.
bool NodeReport::Keep(std::string line, const std::size_t room)
{
    const bool has_room = waiting_.size() < room && (waiting_bytes_ < kMostBytes || room == kMostImportant);
    left_out_ += has_room ? 0U : 1U;
    if (has_room)
    {
        TellGap();
        waiting_bytes_ += line.size();
        is_screen_last_ = false;
        waiting_.push_back(std::move(line));
    }
    return has_room;
}

/// With the lock.
void NodeReport::TellGap()
{
    if (left_out_ > 0U)
    {
        const std::string text = std::to_string(left_out_) + " lines left out here: nobody read them";
        waiting_.push_back(
            (form_ == ReportForm::kText)
                ? text + "\n"
                : OneLine({{"format", format_}, {"event", "left_out"}, {"count", left_out_}, {"text", text}}));
        left_out_ = 0U;
    }
}

void NodeReport::Write()
{
    std::unique_lock<std::mutex> lock(mutex_);
    while (!is_given_up_ && (!is_finished_ || !waiting_.empty()))
    {
        wake_.wait(lock, [this] { return is_finished_ || !waiting_.empty(); });
        const std::vector<std::string> lines = std::exchange(waiting_, {});
        waiting_bytes_ = 0U;
        is_screen_last_ = false;
        lock.unlock();
        WriteAll(lines);
        lock.lock();
    }
}

/// In pieces that a reader has room for, so that it can be left at any of them.
void NodeReport::WriteAll(const std::vector<std::string>& lines)
{
    std::string piece;
    for (std::size_t line = 0U; line < lines.size() && !is_given_up_; ++line)
    {
        piece += lines[line];
        const bool is_last = line + 1U == lines.size();
        while (!is_given_up_ && !piece.empty() && (is_last || piece.size() >= kPieceBytes))
        {
            if (IsReady())
            {
                out_ << piece.substr(0U, kPieceBytes);
                out_.flush();
                piece.erase(0U, kPieceBytes);
            }
        }
    }
}

/// Waits for the reader. False: at the end, after it has read nothing for too long.
bool NodeReport::IsReady()
{
    pollfd place{file_, POLLOUT, 0};
    int looks = 0;
    bool is_ready = file_ < 0 || ::poll(&place, 1U, 0) > 0;
    is_blocked_ = !is_ready;
    while (!is_ready && looks < kLooksAtEnd)
    {
        is_ready = ::poll(&place, 1U, kLookMs) > 0;
        looks += is_finished_ ? 1 : 0;
    }
    is_blocked_ = !is_ready;
    is_given_up_ = !is_ready;
    return is_ready;
}
} // namespace counterpoint::runtime
