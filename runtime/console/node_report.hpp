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
    kJson = 2U,    ///< One object a line.
    kObjects = 3U, ///< As kJson, of objects that are printed as they are.
};

/// The format of what a node tells.
constexpr const char* kNodeFormat = "counterpoint-node-1";

/// Writes what a node tells, a line each. A thread of its own writes the lines, so that a slow reader does not hold up
/// the device, nor its end. Of an output that nobody reads lines are left out and counted; what tells of outputs,
/// faults and the end last. [SRS_NODE_004, SRS_NODE_032, SRS_NODE_210, SRS_NODE_211,
/// SRS_NODE_212]
class NodeReport
{
  public:
    /// @brief Times are told from `start_ns` (CLOCK_MONOTONIC) on. `out` outlives the report; it writes to `file`,
    /// which is waited for, or without one (-1) never blocks. `format` is that of its objects.
    NodeReport(std::ostream& out, ReportForm form, std::uint64_t start_ns, int file = -1,
               std::string format = kNodeFormat);
    ~NodeReport();
    NodeReport(const NodeReport&) = delete;
    NodeReport& operator=(const NodeReport&) = delete;

    /// @brief Tells what happened at `at_ns` (CLOCK_MONOTONIC): `text` in text form, `event` with its details in JSON.
    void Tell(std::uint64_t at_ns, const std::string& text, const std::string& event,
              const nlohmann::ordered_json& details);
    /// @brief Writes lines as they are; not in the form kJson.
    void Print(const std::string& lines);
    /// @brief As Print, of the end: there is room for it where nobody reads.
    void PrintLast(const std::string& lines);
    /// @brief As Print, of a screen: while nobody reads it takes the place of the one before. [SRS_MGR_161]
    void PrintScreen(const std::string& screen);
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
    bool Keep(std::string line, std::size_t room);
    void TellGap();
    void Write();
    void WriteAll(const std::vector<std::string>& lines);
    [[nodiscard]] bool IsReady();

    std::ostream& out_;
    ReportForm form_;
    std::string format_;
    std::uint64_t start_ns_;
    std::mutex mutex_;
    std::condition_variable wake_;
    std::vector<std::string> waiting_;
    std::size_t waiting_bytes_{0U};
    bool is_screen_last_{false}; ///< Of what waits.
    std::uint64_t left_out_{0U}; ///< Lines since the last one that was kept.
    std::atomic<bool> is_finished_{false};
    std::atomic<bool> is_blocked_{false}; ///< What is written waits for its reader.
    bool is_given_up_{false};             ///< Nobody reads, and the end does not wait any longer.
    int file_;
    std::thread writer_;
};
} // namespace counterpoint::runtime

#endif // RUNTIME_CONSOLE_NODE_REPORT_HPP
