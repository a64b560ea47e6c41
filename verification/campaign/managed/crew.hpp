// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_MANAGED_CREW_HPP
#define VERIFICATION_CAMPAIGN_MANAGED_CREW_HPP

#include "verification/campaign/managed/course.hpp"
#include "verification/campaign/results.hpp"

#include <cstdint>
#include <functional>
#include <vector>

#include <sys/types.h>

namespace counterpoint::campaign::managed
{
/// Processes that try all experiments of a shard that have no outcome yet. Each lets the network run without fault,
/// once; at the instant of a fault it makes a copy of itself, in which the fault happens. [SRS_CMG_075]
class Crew
{
  public:
    /// @brief All outlive it. `begin` is a course at time 0 that nobody has used. `jobs` is at least 1.
    Crew(Course& begin, const Space& space, const Reference& reference, Results& results, std::uint32_t jobs);
    ~Crew();
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;

    /// @brief Until none is left. `progress` is told now and then how many have an outcome.
    void Work(const std::function<void(std::uint64_t)>& progress);

  private:
    /// What the processes share.
    struct Board;

    void Begin(std::size_t job);
    void Toil();
    void TryApart(std::uint64_t index);

    Course& course_;
    const Space& space_;
    const Reference& reference_;
    Results& results_;
    std::vector<std::uint64_t> order_{}; ///< Places in the results, by the instant of their fault.
    std::vector<pid_t> children_;
    Board* board_;
};
} // namespace counterpoint::campaign::managed

#endif // VERIFICATION_CAMPAIGN_MANAGED_CREW_HPP
