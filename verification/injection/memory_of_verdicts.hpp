// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_INJECTION_MEMORY_OF_VERDICTS_HPP
#define VERIFICATION_INJECTION_MEMORY_OF_VERDICTS_HPP

#include "verification/injection/judge.hpp"

#include <cstdint>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

namespace counterpoint::injection
{

/// Verdicts of states between two steps. Two faults that came to the same state have the same verdict: the second one
/// is not run on.
class MemoryOfVerdicts
{
  public:
    /// @brief Whether this state has one; of a fault in step `from`.
    [[nodiscard]] bool Find(const Digest& state, const std::uint32_t from, Verdict& verdict) const
    {
        const auto found = verdicts_.find(state);
        if (found == verdicts_.end())
        {
            return false;
        }
        const Kept& kept = found->second;
        verdict = {kept.kind, *kept.what, kept.has_time ? (kept.at - from) : 0U};
        return true;
    }
    void Keep(const std::vector<Digest>& states, const std::uint32_t from, const Verdict& verdict)
    {
        const bool has_time =
            (verdict.kind == Class::kSilent) || (verdict.kind == Class::kDetected) || (verdict.kind == Class::kCrash);
        const Kept kept{verdict.kind, has_time, from + verdict.steps, &*texts_.insert(verdict.what).first};
        for (const Digest& state : states)
        {
            verdicts_[state] = kept;
        }
    }

  private:
    struct Kept
    {
        Class kind;
        bool has_time;
        std::uint32_t at; ///< Step.
        const std::string* what;
    };

    std::unordered_map<Digest, Kept, Digest::Hash> verdicts_{};
    std::set<std::string> texts_{};
};

} // namespace counterpoint::injection

#endif
