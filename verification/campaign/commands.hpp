// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_COMMANDS_HPP
#define VERIFICATION_CAMPAIGN_COMMANDS_HPP

#include "verification/campaign/recording.hpp"

#include <cstddef>

namespace counterpoint::campaign
{
struct Experiment;

/// Tells a kernel the commands of the recording, with a fault of them. Nothing of it lies in the region. [SRS_CMG_029]
class Commands
{
  public:
    /// @brief The recording outlives it.
    explicit Commands(const Recording& recording) noexcept : recording_(recording)
    {
    }

    /// @brief Those of earlier cycles were told; from there on it has this fault, where it is one of commands. Null:
    /// none.
    void Rewind(std::size_t cycle, const Experiment* fault);
    /// @brief Those of this cycle, and of cycles that did not come.
    void TellUntil(std::size_t cycle, Kernel& kernel);
    /// @brief Whether behind this cycle all are told as recorded.
    [[nodiscard]] bool IsOver(std::size_t cycle) const noexcept;

  private:
    void Tell(std::size_t command, Kernel& kernel);
    [[nodiscard]] std::size_t ExtraCycle() const noexcept;

    const Recording& recording_;
    const Experiment* fault_{nullptr};
    std::size_t next_{0U};
    bool has_extra_{false}; ///< The fault tells a command that is still to come.
};
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_COMMANDS_HPP
