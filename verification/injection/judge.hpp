// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_INJECTION_JUDGE_HPP
#define VERIFICATION_INJECTION_JUDGE_HPP

#include "verification/injection/machine.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::injection
{

/// What a fault came to, the worst of all steps.
enum class Class : std::uint8_t
{
    kMasked,   ///< Everything that lives became equal again; nothing was seen outside.
    kBenign,   ///< Something else was seen outside, none of it dangerous.
    kLatent,   ///< Nothing was seen outside; something that lives is different at the end.
    kDetected, ///< By the mechanism that is named.
    kCrash,    ///< The processor refused to go on, or the watchdog was no longer answered: ends safe.
    kSilent,   ///< Dangerous, and nothing told it in time.
};

struct Verdict
{
    Class kind{Class::kMasked};
    std::string what{};      ///< Of a silent one: what was wrong. Otherwise the mechanism.
    std::uint32_t steps{0U}; ///< From the fault to what is told.
};

/// The values that the script sends to each consumer, as its object holds them.
using SentValues = std::array<std::vector<std::uint32_t>, 2>;

/// Compares a faulted run with the one without faults, step by step.
class Judge
{
  public:
    /// @brief `golden` and `values` are kept by reference; the fault is in step `from`.
    Judge(const std::vector<Seen>& golden, const SentValues& values, std::uint32_t from);
    /// @brief The next step of the faulted run. True: the verdict is final.
    [[nodiscard]] bool See(const Seen& seen);
    /// @brief The verdict, where the live state became equal (or the script ended).
    [[nodiscard]] Verdict Conclude(bool is_equal) const;

  private:
    /// An output, and data, of each of the two consumers.
    static constexpr std::uint32_t kSuspicions = 4U;

    void Detect(const std::string& mechanism);
    void JudgePins(const Seen& seen);
    void JudgeObjects(const Seen& seen);
    void JudgeFrames(const Seen& seen);
    void FindMechanism(const Seen& seen);
    void Fail(const std::string& what);
    void Suspect(bool is_wrong, std::uint32_t which, const std::string& what);
    [[nodiscard]] bool WasReleased(std::uint32_t consumer, std::uint32_t value, std::uint32_t steps) const;

    const std::vector<Seen>& golden_;
    const SentValues& values_;
    std::uint32_t from_;
    std::uint32_t now_;
    std::string mechanism_{};
    std::uint32_t detected_{0U};
    std::string wrong_{};
    std::uint32_t wrong_at_{0U};
    std::uint32_t stale_[2]{};
    std::uint32_t suspected_[kSuspicions]{}; ///< For so many steps.
    std::uint32_t sent_normal_{0U};
    std::uint32_t safe_since_{0U}; ///< Steps.
    bool is_level_2_{false};
    bool is_different_{false};
};

[[nodiscard]] const char* NameOf(Class kind);

} // namespace counterpoint::injection

#endif
