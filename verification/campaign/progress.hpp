// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_PROGRESS_HPP
#define VERIFICATION_CAMPAIGN_PROGRESS_HPP

#include <chrono>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>

namespace counterpoint::campaign
{
/// @brief What a person wants to know while it runs: part, rate, and how long it will take.
[[nodiscard]] std::string ProgressText(std::uint64_t done, std::uint64_t total, std::uint64_t at_begin, double seconds);

/// Shows it on a terminal, after two seconds and each 500 ms then; on nothing else. [SRS_CMG_012]
class Progress
{
  public:
    using Clock = std::function<std::chrono::steady_clock::time_point()>;

    /// @brief `at_begin` experiments had an outcome before. `err` outlives it.
    Progress(std::ostream& err, std::uint64_t total, std::uint64_t at_begin,
             Clock clock = std::chrono::steady_clock::now);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void Show(std::uint64_t done);

  private:
    std::ostream& err_;
    std::uint64_t total_;
    std::uint64_t at_begin_;
    Clock clock_;
    std::chrono::steady_clock::time_point start_;
    std::chrono::steady_clock::time_point last_;
    bool is_terminal_;
    bool is_shown_{false};
};
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_PROGRESS_HPP
