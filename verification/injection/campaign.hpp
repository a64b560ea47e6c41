// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_INJECTION_CAMPAIGN_HPP
#define VERIFICATION_INJECTION_CAMPAIGN_HPP

#include "verification/injection/judge.hpp"
#include "verification/injection/script.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace counterpoint::injection
{

/// A fault and the step that it comes in.
struct Experiment
{
    std::uint32_t step;
    Fault fault;
};

/// What is faulted.
struct Plan
{
    bool skips{true};
    bool inversions{true};
    std::uint32_t each{0U};      ///< Of each instruction so many executions a step, spread; 0: all.
    std::uint32_t sample{0U};    ///< Of the faults of the code so many are drawn; 0: all.
    std::uint32_t registers{0U}; ///< So many bits are drawn.
    std::uint32_t memory{0U};    ///< So many bits are drawn; all at every step where it is above what there is.
    std::uint32_t seed{1U};
    std::uint32_t shard{0U};
    std::uint32_t shards{1U};
};

/// One image, its undisturbed run, and runs with faults.
class Campaign
{
  public:
    /// @brief Runs the script without a fault. Throws std::runtime_error where the image refuses something.
    Campaign(Machine& machine, const Program& program, const std::vector<ScriptStep>& script);

    [[nodiscard]] std::vector<Experiment> Draw(const Plan& plan) const;
    /// @brief `look` is called with each step and what it showed.
    [[nodiscard]] Verdict Run(
        const Experiment& experiment,
        const std::function<void(std::size_t, const Seen&)>& look = [](std::size_t, const Seen&) {});
    /// @brief The call of this function in this step, made by what is not faulted, is skipped.
    [[nodiscard]] Experiment SkippedCall(std::uint32_t step, const std::string& function) const;
    /// @brief The script from `step` on with something done to the world at its begin and to the RAM after it.
    [[nodiscard]] Verdict RunControl(std::uint32_t step, const std::function<void(Mailbox&, std::uint32_t)>& mail,
                                     const std::function<void(Machine&, std::uint32_t)>& memory);

    [[nodiscard]] const std::vector<Seen>& Golden() const
    {
        return golden_;
    }
    [[nodiscard]] std::uint64_t Instructions() const;

  private:
    /// @brief Steps in which a fault may come.
    [[nodiscard]] std::uint32_t FaultedSteps() const
    {
        return static_cast<std::uint32_t>(traces_.size()) - kTailSteps;
    }
    void DrawCode(const Plan& plan, std::vector<Experiment>& to) const;
    void DrawRegisters(const Plan& plan, std::vector<Experiment>& to) const;
    void DrawMemory(const Plan& plan, std::vector<Experiment>& to) const;

    Machine& machine_;
    const Program& program_;
    const std::vector<ScriptStep>& script_;
    std::vector<Snapshot> before_{};
    std::vector<std::vector<std::uint32_t>> traces_{};
    std::vector<Seen> golden_{};
    SentValues values_{};
};

} // namespace counterpoint::injection

#endif
