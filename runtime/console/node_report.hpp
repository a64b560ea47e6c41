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
enum class ReportForm : std::uint8_t
{
    kText = 1U,
    kJson = 2U, ///< One object a line.
};

/// What a node tells, a line each. A thread of its own writes them: whoever reads slowly does not hold up the device.
/// [SRS_NODE_004]
class NodeReport
{
  public:
    NodeReport(std::ostream& out, ReportForm form, std::uint64_t start_ns);
    ~NodeReport();
    NodeReport(const NodeReport&) = delete;
    NodeReport& operator=(const NodeReport&) = delete;

    /// @brief Something happened at `at_ns` (CLOCK_MONOTONIC): as text, or as event with details.
    void Tell(std::uint64_t at_ns, const std::string& text, const std::string& event,
              const nlohmann::ordered_json& details);
    /// @brief As it is, in text form only.
    void Print(const std::string& lines);
    [[nodiscard]] ReportForm Form() const noexcept
    {
        return form_;
    }
    /// @brief Everything told so far is written; false: it could not be.
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
