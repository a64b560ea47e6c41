// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_STEPS_HPP
#define VERIFICATION_CAMPAIGN_STEPS_HPP

#include "verification/campaign/continuation.hpp"
#include "verification/campaign/experiment.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace counterpoint::campaign
{
/// Steps of the flow that are left out, run twice, behind the next one, or whose work comes behind the next one.
/// [SRS_CMG_028, SRS_CMG_560]
class StepFaults
{
  public:
    /// @brief In this device.
    explicit StepFaults(Device& device);

    /// @brief Before an experiment.
    void Begin() noexcept
    {
        stage_ = Stage::kNothing;
        is_kept_ = false;
    }
    /// @brief At each phase of a cycle that runs in the function with this frame address.
    void At(const Experiment& fault, std::size_t cycle, Phase phase, const void* frame);

  private:
    /// Of a step that runs once more.
    enum class Stage : std::uint8_t
    {
        kNothing = 0U,
        kWaits = 1U,    ///< Behind the step before it.
        kPassedBy = 2U, ///< What it did is taken back; the next step is at work.
        kAgain = 3U,    ///< It runs once more.
    };

    void TakeBack(const Experiment& fault, Phase phase) noexcept;
    void CatchUp() noexcept;
    void RunTwice(const Experiment& fault, Phase phase, const void* frame);
    void RunBehindNext(const Experiment& fault, Phase phase, const void* frame);
    [[nodiscard]] const Place& FlowOf(const Experiment& fault) const noexcept;
    void Restore(const Experiment& fault, bool with_mark) noexcept;
    void KeepMark(const Experiment& fault);
    void RestoreMark(const Experiment& fault) noexcept;

    Device& device_;
    std::size_t size_;                   ///< Of its memory.
    std::array<Place, 2U> flows_{};      ///< The flow monitor, of each CPU.
    std::vector<std::uint8_t> before_{}; ///< The memory before the step that is disturbed,
    std::vector<std::uint8_t> behind_{}; ///< and behind it, while that waits.
    std::vector<std::uint8_t> mark_{};   ///< The flow monitor's before the step runs again.
    Continuation step_{};                ///< Before the step,
    Continuation next_{};                ///< and behind the next one.
    Stage stage_{Stage::kNothing};
    bool is_kept_{false};
};
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_STEPS_HPP
