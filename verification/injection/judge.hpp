// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_INJECTION_JUDGE_HPP
#define VERIFICATION_INJECTION_JUDGE_HPP

#include "verification/injection/digest.hpp"
#include "verification/injection/outside.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::injection
{

/// What a fault came to, the worst of all steps.
enum class Class : std::uint8_t
{
    kMasked,    ///< Everything that lives became equal again; nothing was seen outside.
    kLatent,    ///< Nothing was seen outside; something that lives is different at the end.
    kBenign,    ///< Something else was seen outside, none of it dangerous.
    kLostFrame, ///< As if the bus had lost a frame, or brought one of this device late or wrong alone.
    kPairCheck, ///< Normal and inverse object do not fit: only the check of the application sees it.
    kDetected,  ///< By the mechanism that is named.
    kCrash,     ///< The processor refused to go on, or the watchdog was no longer answered: ends safe.
    kSilent,    ///< Dangerous, and nothing told it in time.
};

struct Verdict
{
    Class kind{Class::kMasked};
    std::string what{};      ///< Of a silent one: what was wrong. Otherwise the mechanism.
    std::uint32_t steps{0U}; ///< From the fault to what is told.
};

/// The values that the script sends to each consumer, as its object holds them.
using SentValues = std::array<std::vector<std::uint32_t>, 2>;

/// What the judge compares with.
struct Undisturbed
{
    std::vector<Seen> steps{};
    std::vector<bool> is_operational{}; ///< Of each step.
    SentValues values{};
};

/// Compares a faulted run with the one without faults, step by step.
class Judge
{
  public:
    /// @brief `golden` is kept by reference; the fault is in step `from`.
    Judge(const Undisturbed& golden, std::uint32_t from);
    /// @brief The next step of the faulted run. True: the verdict is final.
    [[nodiscard]] bool See(const Seen& seen);
    /// @brief Up to this step all was as without the fault.
    void SkipTo(std::uint32_t step);
    /// @brief The verdict, where the live state became equal (or the script ended).
    [[nodiscard]] Verdict Conclude(bool is_equal) const;
    /// @brief Adds what the verdict depends on, besides the steps to come; times as distances from now.
    void Add(Digest& to) const;

  private:
    /// An output, and data, of each of the two consumers.
    static constexpr std::uint32_t kSuspicions = 4U;

    void Detect(const std::string& mechanism);
    void JudgePins(const Seen& seen);
    void JudgeObjects(const Seen& seen);
    void JudgeFrames(const Seen& seen);
    void FindMechanism(const Seen& seen);
    void FindOthers(const Seen& seen);
    void Fail(const std::string& what);
    void Suspect(bool is_wrong, std::uint32_t which, const std::string& what);
    [[nodiscard]] const char* LeaveMissing(std::uint32_t consumer) const;
    [[nodiscard]] bool IsOperational() const;
    [[nodiscard]] bool WasReleased(std::uint32_t consumer, std::uint32_t value, std::uint32_t steps) const;

    const Undisturbed& golden_;
    std::uint32_t from_;
    std::uint32_t now_;
    std::string mechanism_{};
    std::uint32_t detected_{0U};
    std::string wrong_{};
    std::uint32_t wrong_at_{0U};
    std::uint32_t stale_[2]{};
    std::uint32_t suspected_[kSuspicions]{}; ///< For so many steps.
    std::string suspicions_[kSuspicions]{};
    bool was_closed_[2]{}; ///< Since the undisturbed output closed.
    std::uint32_t sent_normal_{0U};
    std::uint32_t safe_since_{0U}; ///< Steps.
    bool is_level_2_{false};
    bool is_refused_{false}; ///< Who configures goes no further.
    bool is_different_{false};
    bool is_frame_lost_{false};
    bool is_pair_wrong_{false};
};

[[nodiscard]] const char* NameOf(Class kind);
/// @brief Whether two steps show the same outside.
[[nodiscard]] bool AreSame(const Seen& first, const Seen& second);

} // namespace counterpoint::injection

#endif
