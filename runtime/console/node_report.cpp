// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/console/node_report.hpp"

#include "runtime/console/json_text.hpp"

#include <array>
#include <cstdio>
#include <utility>

namespace counterpoint::runtime
{
namespace
{
constexpr double kNsPerSecond = 1e9;
constexpr double kNsPerUs = 1e3;
constexpr std::size_t kMostWaiting = 65536U;
} // namespace

NodeReport::NodeReport(std::ostream& out, const ReportForm form, const std::uint64_t start_ns)
    : out_(out), form_(form), start_ns_(start_ns), writer_([this] { Write(); })
{
}

NodeReport::~NodeReport()
{
    static_cast<void>(Finish());
}

void NodeReport::Tell(const std::uint64_t at_ns, const std::string& text, const std::string& event,
                      const nlohmann::ordered_json& details)
{
    const double since_ns = (at_ns > start_ns_) ? static_cast<double>(at_ns - start_ns_) : 0.0;
    if (form_ == ReportForm::kText)
    {
        std::array<char, 32U> time{};
        static_cast<void>(std::snprintf(time.data(), time.size(), "%10.6f s  ", since_ns / kNsPerSecond));
        Put(time.data() + text + "\n");
        return;
    }
    nlohmann::ordered_json line{{"at_us", static_cast<std::uint64_t>(since_ns / kNsPerUs)}, {"event", event}};
    line.update(details);
    Put(OneLine(line));
}

void NodeReport::Print(const std::string& lines)
{
    if (form_ == ReportForm::kText)
    {
        Put(lines);
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
    return static_cast<bool>(out_);
}

void NodeReport::Put(std::string line)
{
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        // Of an output that nobody reads the newest lines are left out, not the memory of the machine taken.
        if (waiting_.size() < kMostWaiting)
        {
            waiting_.push_back(std::move(line));
        }
    }
    wake_.notify_one();
}

void NodeReport::Write()
{
    std::unique_lock<std::mutex> lock(mutex_);
    while (!is_finished_ || !waiting_.empty())
    {
        wake_.wait(lock, [this] { return is_finished_ || !waiting_.empty(); });
        const std::vector<std::string> lines = std::exchange(waiting_, {});
        lock.unlock();
        for (const std::string& line : lines)
        {
            out_ << line;
        }
        out_.flush();
        lock.lock();
    }
}
} // namespace counterpoint::runtime
