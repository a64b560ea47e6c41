// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CONFORMANCE_CASE_JUDGE_HPP
#define VERIFICATION_CONFORMANCE_CASE_JUDGE_HPP

#include <cstdint>

namespace counterpoint::conformance
{

/// An expectation that did not hold. `step` counts from 1; `origin` is what was added to every time of the case.
struct Failure
{
    const char* case_name;
    const char* field;
    std::uint64_t expected;
    std::uint64_t got;
    std::uint32_t step;
    std::uint32_t origin;
};

/// Hears of each expectation that did not hold. [SRS_CNF_003]
class Reporter
{
  public:
    virtual void OnFailure(const Failure& failure) noexcept = 0;

    Reporter(const Reporter&) = delete;
    Reporter& operator=(const Reporter&) = delete;

  protected:
    Reporter() noexcept = default;
    ~Reporter() noexcept = default;
};

/// Judges the expectations of one case at one origin of time.
class CaseJudge
{
  public:
    explicit CaseJudge(Reporter& reporter) noexcept : reporter_{reporter}
    {
    }
    void Begin(const char* case_name, std::uint32_t origin) noexcept;
    void BeginStep() noexcept
    {
        ++step_;
    }
    void Expect(const char* field, std::uint64_t expected, std::uint64_t got) noexcept;
    [[nodiscard]] bool HasFailed() const noexcept
    {
        return failed_;
    }

  private:
    Reporter& reporter_;
    const char* case_name_{nullptr};
    std::uint32_t step_{0U};
    std::uint32_t origin_{0U};
    bool failed_{false};
};

} // namespace counterpoint::conformance

#endif
