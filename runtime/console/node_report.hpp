// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_CONSOLE_NODE_REPORT_HPP
#define RUNTIME_CONSOLE_NODE_REPORT_HPP

#include <nlohmann/json.hpp>

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <ostream>
#include <string>
#include <thread>
#include <vector>

namespace counterpoint::runtime
{
/// In which form a report is written.
enum class ReportForm : std::uint8_t
{
    kText = 1U,
    kJson = 2U, ///< One object a line.
};

/// Writes what a node tells, a line each. A thread of its own writes the lines, so that a slow reader does not hold up
/// the device, nor its end. Of an output that nobody reads lines are left out and counted; what tells of outputs,
/// faults and the end last. [SRS_NODE_004, SRS_NODE_032]
class NodeReport
{
  public:
    /// @brief Times are told from `start_ns` (CLOCK_MONOTONIC) on. `out` outlives the report; it writes to `file`,
    /// which is waited for, or without one (-1) never blocks.
    NodeReport(std::ostream& out, ReportForm form, std::uint64_t start_ns, int file = -1);
    ~NodeReport();
    NodeReport(const NodeReport&) = delete;
    NodeReport& operator=(const NodeReport&) = delete;

    /// @brief Tells what happened at `at_ns` (CLOCK_MONOTONIC): `text` in text form, `event` with its details in JSON.
    void Tell(std::uint64_t at_ns, const std::string& text, const std::string& event,
              const nlohmann::ordered_json& details);
    /// @brief Writes lines as they are; in text form only.
    void Print(const std::string& lines);
    /// @brief The form of the report.
    [[nodiscard]] ReportForm Form() const noexcept
    {
        return form_;
    }
    /// @brief Waits until everything is written, or until the reader has read nothing for two seconds. False: it could
    /// not be written.
    [[nodiscard]] bool Finish();

  private:
    void Put(std::string line, std::size_t room);
    void Write();
    void WriteAll(const std::vector<std::string>& lines);
    [[nodiscard]] bool IsReady();

    std::ostream& out_;
    ReportForm form_;
    std::uint64_t start_ns_;
    std::mutex mutex_;
    std::condition_variable wake_;
    std::vector<std::string> waiting_;
    std::uint64_t left_out_{0U}; ///< Lines since the last one that was kept.
    std::atomic<bool> is_finished_{false};
    bool is_given_up_{false}; ///< Nobody reads, and the end does not wait any longer.
    int file_;
    std::thread writer_;
};
} // namespace counterpoint::runtime

#endif // RUNTIME_CONSOLE_NODE_REPORT_HPP
