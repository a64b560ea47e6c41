// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_INJECTION_SPACE_HPP
#define VERIFICATION_INJECTION_SPACE_HPP

#include "verification/injection/campaign.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::injection
{

/// What is faulted.
struct Plan
{
    bool skips{true};
    bool inversions{true};
    std::uint32_t each{0U};          ///< Of each instruction so many executions a step, spread; 0: all.
    std::uint32_t sample{0U};        ///< Of the skips and inversions so many are drawn; 0: all.
    std::uint32_t registers{0U};     ///< So many bits are drawn.
    std::uint32_t opcodes{0U};       ///< So many bits are drawn.
    std::uint32_t flash{0U};         ///< So many bits are drawn.
    std::uint32_t memory{0U};        ///< So many bits are drawn; all at every step where it is above what there is.
    std::uint32_t stuck{0U};         ///< So many bits are drawn.
    std::uint32_t first{0U};         ///< Steps from here ...
    std::uint32_t last{0xFFFFFFFFU}; ///< ... to here.
    std::uint32_t seed{1U};
    std::uint32_t shard{0U};
    std::uint32_t shards{1U};
};

/// An experiment and its number among all of the plan, the same in any number of shards.
struct Drawn
{
    std::size_t number;
    Experiment experiment;
};

/// The faults that there are in the undisturbed run.
class Space
{
  public:
    Space(const Program& program, const std::vector<std::vector<std::uint32_t>>& traces)
        : program_{program}, traces_{traces}
    {
    }

    /// @brief What this shard has to run, in the order of the script; `all`: of every shard.
    [[nodiscard]] std::vector<Drawn> Draw(const Plan& plan, std::size_t& all) const;
    /// @brief The call of this function in this step, made by what is not faulted, is skipped.
    [[nodiscard]] Experiment SkippedCall(std::uint32_t step, const std::string& function) const;

  private:
    /// @brief Steps in which a fault may come.
    [[nodiscard]] std::uint32_t FaultedSteps() const;
    void DrawCode(const Plan& plan, std::vector<Experiment>& to) const;
    void DrawRegisters(const Plan& plan, std::vector<Experiment>& to) const;
    void DrawInstructions(FaultKind kind, std::uint32_t number, std::uint32_t seed, std::vector<Experiment>& to) const;
    void DrawMemory(const Plan& plan, std::vector<Experiment>& to) const;
    void DrawStuck(const Plan& plan, std::vector<Experiment>& to) const;

    const Program& program_;
    const std::vector<std::vector<std::uint32_t>>& traces_;
};

} // namespace counterpoint::injection

#endif
