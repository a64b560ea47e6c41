// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_FAULTS_PART_FAULTS_HPP
#define SIMULATOR_FAULTS_PART_FAULTS_HPP

#include "simulator/journal/journal.hpp"
#include "simulator/scenario/scenario.hpp"

#include <array>
#include <csetjmp>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace counterpoint::simulator
{
/// What a call of a part answers.
enum class PartAnswer : std::uint8_t
{
    kOwn = 1U,  ///< It runs.
    kLast = 2U, ///< It does not run, and says what it said last.
    kZero = 3U, ///< The same, with zeros.
    kGood = 4U, ///< What a healthy part says for which nothing is wrong.
};

/// The fault that one part of a node has at present, if any.
struct PartCondition
{
    bool is_faulty{false};
    PartFault kind{PartFault::kFrozen};
    ChannelCall call{ChannelCall::kOnCycle};
    Wrongness how{Wrongness::kNone};
    std::uint32_t remaining{0U}; ///< Calls that are still to be skipped or doubled.
    std::size_t fault{kNoFaultIndex};
};

/// The conditions of all parts of one node, the first effects of faults, and the way out of a call that hangs.
class PartFaults
{
  public:
    PartFaults() = default;

    /// @brief The fault begins.
    void Begin(const FaultSetup& fault, std::size_t index);
    /// @brief The fault ends.
    void End(const FaultSetup& fault);
    /// @brief Supply off: calls that hang return again after the next start.
    void PowerOff() noexcept;
    /// @brief Sets the time of effects.
    void SetNow(Nanoseconds now) noexcept;

    /// @brief The condition of a part.
    [[nodiscard]] PartCondition& Condition(const Part part) noexcept
    {
        return conditions_[static_cast<std::size_t>(part)];
    }
    /// @brief What a call of the part answers now. A part that does not run has an effect by it; from one that hangs it
    /// does not return.
    [[nodiscard]] PartAnswer AnswerOf(Part part) noexcept;
    /// @brief How often taps have asked that in this thread, of all nodes. It shows that the taps are in place.
    [[nodiscard]] static std::uint64_t Asked(Part part) noexcept;
    /// @brief The fault changes something now. The first time is remembered.
    void HasEffect(const PartCondition& condition) noexcept;
    /// @brief Leaves the running call and all its callers for good, as an exception of the processor does.
    /// [SRS_SIM_055]
    [[noreturn]] void Trap() noexcept;
    /// @brief Where Trap, and a call that hangs, lead to: the node stands still. [SRS_SIM_025]
    [[nodiscard]] std::jmp_buf& WayOut() noexcept
    {
        return way_out_;
    }
    /// @brief The time of effects.
    [[nodiscard]] Nanoseconds Now() const noexcept
    {
        return now_;
    }
    /// @brief Whether Trap was called since the last call.
    [[nodiscard]] bool TakeTrap() noexcept
    {
        return std::exchange(is_trapped_, false);
    }
    /// @brief First effects since the last call: index of the fault, and time.
    [[nodiscard]] std::vector<std::pair<std::size_t, Nanoseconds>> TakeEffects()
    {
        return std::exchange(effects_, {});
    }

  private:
    std::array<PartCondition, kPartCount> conditions_{};
    std::vector<std::pair<std::size_t, Nanoseconds>> effects_;
    std::vector<std::size_t> seen_;
    Nanoseconds now_{0};
    bool is_trapped_{false};
    std::jmp_buf way_out_{};
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_FAULTS_PART_FAULTS_HPP
