// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_INJECTION_CAMPAIGN_HPP
#define VERIFICATION_INJECTION_CAMPAIGN_HPP

#include "verification/injection/judge.hpp"
#include "verification/injection/machine.hpp"
#include "verification/injection/memory_of_verdicts.hpp"
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

using Look = std::function<void(std::size_t, const Seen&)>;

/// What a planted danger does, each of them with the number of the step from the first one on.
struct Planted
{
    std::function<void(Mailbox&, std::uint32_t)> mail{[](Mailbox&, std::uint32_t) {}};
    std::function<void(Machine&, std::uint32_t)> memory{[](Machine&, std::uint32_t) {}};
    std::function<void(Seen&, std::uint32_t)> seen{[](Seen&, std::uint32_t) {}};
};

/// One image, its undisturbed run, and runs with faults.
class Campaign
{
  public:
    /// @brief Runs the script without a fault. Throws std::runtime_error where the image refuses something, or a step
    /// does not show what its scene is called.
    Campaign(Machine& machine, const Program& program, const std::vector<ScriptStep>& script);

    [[nodiscard]] Verdict Run(const Experiment& experiment);
    /// @brief The same from the begin of its step to its end, without what is known of others.
    [[nodiscard]] Verdict RunAnew(const Experiment& experiment);
    /// @brief `look` is called with each step that is run and what it showed.
    [[nodiscard]] Verdict Show(const Experiment& experiment, const Look& look);
    /// @brief The script from `step` on with something planted.
    [[nodiscard]] Verdict RunControl(std::uint32_t step, const Planted& planted);

    [[nodiscard]] const std::vector<Seen>& Golden() const
    {
        return golden_.steps;
    }
    /// @brief The instructions of each step, without a fault.
    [[nodiscard]] const std::vector<std::vector<std::uint32_t>>& Traces() const
    {
        return traces_;
    }

  private:
    /// What a step does with a fault that stays.
    enum class Meeting : std::uint8_t
    {
        kPasses, ///< Nothing.
        kMeets,  ///< Reads or executes it.
        kEnds,   ///< Writes over it.
    };

    void RunUndisturbed();
    [[nodiscard]] Seen FirstStep(const Experiment& experiment);
    void WalkTo(const Experiment& experiment);
    [[nodiscard]] Verdict RunOnce(const Experiment& experiment, const Look& look);
    [[nodiscard]] Verdict RunLasting(const Experiment& experiment, const Look& look);
    [[nodiscard]] Meeting MeetingOf(const Fault& fault, std::uint32_t step) const;
    [[nodiscard]] std::uint32_t NextMeeting(const Fault& fault, std::uint32_t step, Verdict& without) const;
    void Plant(const Fault& fault, std::uint32_t step);
    [[nodiscard]] bool IsFaultAlone(const Fault& fault, std::uint32_t step);
    [[nodiscard]] bool IsLostGfc(const Experiment& experiment);
    [[nodiscard]] Digest StateOf(const Judge& judge);

    Machine& machine_;
    const Program& program_;
    const std::vector<ScriptStep>& script_;
    std::vector<Snapshot> before_{};
    std::vector<std::vector<std::uint32_t>> traces_{};
    std::vector<std::vector<bool>> is_executed_{}; ///< Of each step each address.
    std::vector<Accesses> accesses_{};
    Undisturbed golden_{};
    MemoryOfVerdicts verdicts_{};
    // Before the instruction of the experiment before, in the undisturbed step.
    Snapshot middle_{};
    std::uint32_t middle_step_;
};

} // namespace counterpoint::injection

#endif
