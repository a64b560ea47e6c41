// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_CONSOLE_NODE_REPORT_HPP
#define RUNTIME_CONSOLE_NODE_REPORT_HPP

#include <nlohmann/json.hpp>

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
/// the device. [SRS_NODE_004]
class NodeReport
{
  public:
    /// @brief Times are told from `start_ns` (CLOCK_MONOTONIC) on. `out` outlives the report.
    NodeReport(std::ostream& out, ReportForm form, std::uint64_t start_ns);
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
    /// @brief Waits until everything is written. False: it could not be written.
    [[nodiscard]] bool Finish();

  private:
    void Put(std::string line);
    void Write();

    std::ostream& out_;
    ReportForm form_;
    std::uint64_t start_ns_;
    std::mutex mutex_;
    std::condition_variable wake_;
    std::vector<std::string> waiting_;
    bool is_finished_{false};
    std::thread writer_;
};
} // namespace counterpoint::runtime

#endif // RUNTIME_CONSOLE_NODE_REPORT_HPP
