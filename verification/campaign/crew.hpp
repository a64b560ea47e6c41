// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_CREW_HPP
#define VERIFICATION_CAMPAIGN_CREW_HPP

#include "verification/campaign/results.hpp"
#include "verification/campaign/runner.hpp"
#include "verification/campaign/space.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include <sys/types.h>

namespace counterpoint::campaign
{
/// Processes that try all experiments of a shard that have no outcome yet. Each has a copy of the device; what a wild
/// access does in one stays there, and does not count: outcomes of a portion hold where the process is sound behind it,
/// else each experiment of the portion is tried in a process of its own. [SRS_CMG_008, SRS_CMG_009, SRS_CMG_150,
/// SRS_CMG_500]
class Crew
{
  public:
    /// @brief All outlive it. `jobs` is at least 1.
    Crew(Runner& runner, const Space& space, Results& results, std::uint32_t jobs);
    ~Crew();
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;

    /// @brief Until none is left. `progress` is told now and then how many have an outcome. Throws NotWell where the
    /// run without fault is not what it was, and std::runtime_error where processes cannot be had or are killed each
    /// time.
    void Work(const std::function<void(std::uint64_t)>& progress);

  private:
    /// What the processes share.
    struct Board;

    void RequireSameAgain();
    void Begin(std::uint32_t job);
    void Toil(std::uint32_t job);
    [[nodiscard]] bool TryPortion(std::uint32_t job, std::uint64_t begin, std::uint64_t end);
    [[nodiscard]] Outcome Try(std::uint32_t job, std::uint64_t index);
    void Put(std::uint64_t index, const Outcome& outcome);
    void Bury(pid_t child, int status);
    [[nodiscard]] bool HasMore(std::uint32_t job, int status);
    [[nodiscard]] std::uint64_t NextOpen(std::uint64_t begin, std::uint64_t end) const;
    void CountKill(std::uint64_t index, int status);

    Runner& runner_;
    const Space& space_;
    Results& results_;
    std::vector<pid_t> children_;
    std::map<std::uint64_t, std::uint32_t> kills_; ///< Of an experiment: how often its process was ended from outside.
    Board* board_;
};
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_CREW_HPP
