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
constexpr const char* kFormat = "counterpoint-node-1";
constexpr double kNsPerSecond = 1e9;
constexpr double kNsPerUs = 1e3;
constexpr std::size_t kMostWaiting = 65536U;
constexpr std::size_t kMostImportant = kMostWaiting + 4096U;
constexpr std::size_t kPieceBytes = 4096U; ///< A pipe that is ready takes so many without waiting.
constexpr int kLookMs = 100;
constexpr int kLooksAtEnd = 20;

bool IsImportant(const std::string& event)
{
    return event == "output" || event == "device_fault" || event == "stopped" || event == "stale_frames";
}
} // namespace

NodeReport::NodeReport(std::ostream& out, const ReportForm form, const std::uint64_t start_ns, const int file)
    : out_(out), form_(form), start_ns_(start_ns), file_(file), writer_([this] { Write(); })
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
        {"format", kFormat}, {"at_us", static_cast<std::uint64_t>(since_ns / kNsPerUs)}, {"event", event}};
    line.update(details);
    Put(OneLine(line), room);
}

void NodeReport::Print(const std::string& lines)
{
    if (form_ == ReportForm::kText)
    {
        Put(lines, kMostWaiting);
    }
}

bool NodeReport::Finish()
{
    {
        const std::lock_guard<std::mutex> lock(mutex_);
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
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        // Of an output that nobody reads the newest lines are left out, not the memory of the machine taken.
        if (waiting_.size() >= room)
        {
            ++left_out_;
            return;
        }
        if (left_out_ > 0U)
        {
            const std::string text = std::to_string(left_out_) + " lines left out here: nobody read them";
            waiting_.push_back(
                (form_ == ReportForm::kText)
                    ? text + "\n"
                    : OneLine({{"format", kFormat}, {"event", "left_out"}, {"count", left_out_}, {"text", text}}));
            left_out_ = 0U;
        }
        waiting_.push_back(std::move(line));
    }
    wake_.notify_one();
}

void NodeReport::Write()
{
    std::unique_lock<std::mutex> lock(mutex_);
    while (!is_given_up_ && (!is_finished_ || !waiting_.empty()))
    {
        wake_.wait(lock, [this] { return is_finished_ || !waiting_.empty(); });
        const std::vector<std::string> lines = std::exchange(waiting_, {});
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
    bool is_ready = file_ < 0;
    while (!is_ready && looks < kLooksAtEnd)
    {
        is_ready = ::poll(&place, 1U, kLookMs) > 0;
        looks += is_finished_ ? 1 : 0;
    }
    is_given_up_ = !is_ready;
    return is_ready;
}
} // namespace counterpoint::runtime
