// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_RUNNER_HPP
#define VERIFICATION_CAMPAIGN_RUNNER_HPP

#include "verification/campaign/device.hpp"
#include "verification/campaign/judge.hpp"
#include "verification/campaign/limits.hpp"
#include "verification/campaign/outcome.hpp"
#include "verification/campaign/plan.hpp"
#include "verification/campaign/read_bytes.hpp"
#include "verification/campaign/space.hpp"
#include "verification/campaign/steps.hpp"
#include "verification/campaign/trap.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace counterpoint::campaign
{
/// Without a fault the device does not do what it must: there is nothing to be measured. [SRS_CMG_043]
class NotWell : public std::runtime_error
{
  public:
    using std::runtime_error::runtime_error;
};

/// Is told of each cycle of an experiment. Owns nothing while it runs that an exception must not leave behind.
class CycleWatcher
{
  public:
    virtual void OnCycle(std::size_t cycle, const Sight& sight) = 0;

    CycleWatcher(const CycleWatcher&) = delete;
    CycleWatcher& operator=(const CycleWatcher&) = delete;

  protected:
    CycleWatcher() = default;
    ~CycleWatcher() = default;
};

/// Runs one experiment after the other, each from the device as it was without fault at the begin of its cycle.
/// [SRS_CMG_001, SRS_CMG_006]
class Runner final : private PhaseHook
{
  public:
    /// @brief Runs the device once without fault and keeps it as it was before each cycle in which a fault of `space`
    /// begins, and behind. Throws NotWell where that run is not as it must be. All outlive it.
    Runner(Device& device, Judge& judge, const Recording& recording, const Space& space, const Limits& limits);

    /// @brief Tries one fault. A Trap has to be there.
    [[nodiscard]] Outcome Run(const Experiment& experiment);
    /// @brief Whether the run without fault is still what it was, in each cycle that is kept: whether no experiment has
    /// left anything behind outside of the memory that is brought back. Takes as long as one of the longest
    /// experiments. A Trap has to be there. [SRS_CMG_500]
    [[nodiscard]] bool IsSound();
    /// @brief Who is told of each cycle, of the run of IsSound, too; null: nobody.
    void Follow(CycleWatcher* const watcher) noexcept
    {
        watcher_ = watcher;
    }
    /// @brief Brings the device back to what it was before this cycle without fault.
    void Rewind(std::size_t cycle);
    [[nodiscard]] Device& Subject() noexcept
    {
        return device_;
    }
    /// @brief Members that are not as they were behind this cycle without fault, in the order of Device::Places.
    [[nodiscard]] std::vector<std::size_t> DifferentPlaces() const;
    /// @brief Slots whose outputs are open behind this cycle of the run without fault.
    [[nodiscard]] SrdoMask OpenWithoutFault(const std::size_t cycle) const
    {
        return sights_[cycle].open;
    }

    /// @brief From an exception to the closed output.
    [[nodiscard]] std::uint32_t ExceptionUs() const noexcept;

  private:
    /// The first cycles, or the one in which it was found, in which a fault could be seen: [SRS_CMG_060]
    struct Signs
    {
        std::size_t memory{0U}; ///< in any byte,
        std::size_t spread{0U}; ///< in a byte outside of the part that is hit,
        std::size_t effect{0U}; ///< in what the device does.
    };

    void At(Phase phase) noexcept override;
    [[nodiscard]] bool IsNeverOtherwise(const Experiment& experiment) const;
    void Begin(const Experiment& experiment);
    void Watch(const Experiment& experiment);
    [[nodiscard]] std::uint8_t MarksOf(const Experiment& experiment);
    void NoticeSigns(const Experiment& experiment, const Sight& sight, Signs& signs) const;
    [[nodiscard]] bool DoesOtherwise(const Sight& sight) const;
    [[nodiscard]] bool SendsOtherwise() const;
    [[nodiscard]] bool HasSpread(const Experiment& experiment) const;
    [[nodiscard]] bool Notice(const Sight& sight, const Experiment& experiment);
    [[nodiscard]] std::string WhatIsNotWell(const Sight& sight) const;
    [[nodiscard]] bool NoticeWrong(const Sight& sight, const Experiment& experiment);
    [[nodiscard]] bool HasClosed(const Sight& sight) const;
    [[nodiscard]] Outcome Blame() const;
    void NoticeClosed(const Experiment& experiment);
    [[nodiscard]] bool IsAsWithoutFault(std::size_t cycle) const;
    [[nodiscard]] std::uint32_t Since(const Experiment& experiment, std::size_t cycle) const;
    void KeepBits() noexcept;
    void ForceBit(Phase phase) noexcept;
    void RunCycle();
    [[nodiscard]] std::size_t EndOf(const Experiment& experiment) const;

    Device& device_;
    Judge& judge_;
    const Recording& recording_;
    CycleWatcher* watcher_{nullptr};
    const Limits& limits_;
    std::uint64_t seed_;
    std::size_t horizon_;
    std::size_t first_;                    ///< The first cycle of which the memory is kept.
    std::size_t size_;                     ///< Of that memory.
    std::vector<std::uint8_t> kept_{};     ///< One after the other.
    std::vector<JudgeMemory> memories_{};  ///< Before each cycle.
    std::vector<Sight> sights_{};          ///< Behind each cycle.
    std::vector<ReadBytes> read_;          ///< By the application.
    std::vector<std::uint8_t> all_set_{};  ///< Bits that are 1 at each phase of each kept cycle.
    std::vector<std::uint8_t> ever_set_{}; ///< Bits that are 1 at one of them.
    std::vector<std::uint8_t> owner_;      ///< The part of each byte.
    StepFaults steps_;
    const void* frame_{nullptr};         ///< Of the function that runs a cycle.
    bool is_obeyed_{false};              ///< The output closed because a command of the fault said so.
    bool is_otherwise_{false};           ///< What the device did was so, or came at another time. [SRS_CMG_816]
    bool is_exposed_{false};             ///< Wrong so far, and may yet be found in time.
    const Experiment* fault_{nullptr};   ///< Null: the run without fault.
    bool is_kept_{false};                ///< The run without fault is over, and kept.
    bool is_sound_{true};                ///< Outlives a run that is brought back.
    std::size_t now_{0U};                ///< The running cycle.
    mutable std::size_t differs_at_{0U}; ///< Where memory was not as without fault when it was last compared.
    Outcome found_{};                    ///< Of the running experiment; outlives a run that is brought back.
};
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_RUNNER_HPP
