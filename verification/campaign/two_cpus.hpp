// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_TWO_CPUS_HPP
#define VERIFICATION_CAMPAIGN_TWO_CPUS_HPP

#include "verification/campaign/device.hpp"
#include "verification/campaign/experiment.hpp"
#include "verification/campaign/flat_link.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace counterpoint::campaign
{
class RecordedScenario;

/// @brief What a CPU of the recorded device knows of its link.
[[nodiscard]] LinkConfig LinkConfigOf(const RecordedScenario& scenario, PeerRole role);

/// A device of two CPUs in one piece of memory: each has kernel, one channel, output and watchdog of its own, and they
/// tell each other their outcomes by the cross link. Outputs are in series. What is told to the application, and frames
/// that are sent, are those of both. Cycles are counted by CPU A; each holds one of CPU B. [SRS_CMG_061]
class TwoCpus final : public Device
{
  public:
    /// @brief As Device; the scenario outlives it. Throws std::runtime_error where the cycles of the CPUs overtake each
    /// other.
    TwoCpus(Region& region, const RecordedScenario& scenario, bool has_call_faults);

    void Cycle(std::size_t cycle) override;
    void Rewind(std::size_t cycle, const Experiment* fault, std::size_t end, std::uint64_t seed) override;
    [[nodiscard]] bool IsUndisturbed(std::size_t cycle) const override;
    void Follow(PhaseHook* hook) noexcept override;
    [[nodiscard]] SrdoMask Open() noexcept override;
    [[nodiscard]] DeviceFault Fault() const noexcept override;
    [[nodiscard]] bool IsWatchdogAlive() const noexcept override;
    [[nodiscard]] const TwoCpus* AsTwoCpus() const noexcept override
    {
        return this;
    }
    /// @brief The cycle in which a command of CPU A's recording is told to this CPU (0 for CPU A); none: it is not, as
    /// the GFC, which CPU A alone sends.
    [[nodiscard]] std::optional<std::size_t> CycleOfCommand(std::size_t command, std::size_t cpu) const;
    /// @brief Whether the application was told that the device is faulty, by a CPU whose word counts.
    [[nodiscard]] bool IsFaultTold() const noexcept;

  private:
    /// Hands the phases of one CPU on, unless the other one is hit.
    class CpuHook final : public PhaseHook
    {
      public:
        CpuHook(TwoCpus& owner, const std::size_t cpu) noexcept : owner_(owner), cpu_(cpu)
        {
        }
        void At(const Phase phase) noexcept override
        {
            owner_.Tell(cpu_, phase);
        }

      private:
        TwoCpus& owner_;
        std::size_t cpu_;
    };
    /// What comes next to one of them.
    enum class Event : std::uint8_t
    {
        kNothing = 0U,
        kFrame = 1U,
        kOwnFrame = 2U, ///< To both.
        kMessage = 3U,
        kCycle = 4U,
    };
    struct Next
    {
        Event event{Event::kNothing};
        std::size_t cpu{0U};
        Nanoseconds at{0};
    };
    /// What changes while they run. In the region.
    struct Progress
    {
        std::array<std::size_t, 2U> next{};   ///< The cycle of each that comes next, in its own recording.
        std::array<std::size_t, 2U> called{}; ///< So often in this cycle, where a fault is in its time.
        std::array<bool, 2U> has_come{};      ///< A frame, in this cycle of the device.
        FlatLink link{};
    };

    void RequireTurns() const;
    void MatchCommands();
    [[nodiscard]] const Experiment* FaultOf(std::size_t cpu) const noexcept;
    [[nodiscard]] bool IsTimeHit(std::size_t cpu) const noexcept;
    [[nodiscard]] Nanoseconds NextCall(std::size_t cpu) const;
    [[nodiscard]] bool TakeTurn(std::size_t cpu, Nanoseconds at);
    void BeginPeriod(std::size_t cpu);
    void Tell(std::size_t cpu, Phase phase) noexcept;
    [[nodiscard]] Next NextUntil(Nanoseconds until) const;
    void Do(const Next& next, std::size_t cycle);
    void NoteFrame(std::size_t cpu) noexcept;
    void RunCpu(std::size_t cpu, Nanoseconds at, std::size_t cycle);
    [[nodiscard]] Nanoseconds TimeOf(std::size_t cpu, std::size_t cycle) const;
    [[nodiscard]] InstantPair StampOf(std::size_t cpu, Nanoseconds at) const;
    [[nodiscard]] Device& Cpu(std::size_t cpu) noexcept;
    [[nodiscard]] const Device& Cpu(std::size_t cpu) const noexcept;
    [[nodiscard]] bool IsDead(std::size_t cpu) const noexcept;

    const std::array<const Recording*, 2U> recordings_;
    Device second_;
    std::vector<std::optional<std::size_t>> commands_of_b_{}; ///< In its recording, by those of CPU A.
    std::size_t split_;                                       ///< Where the memory of CPU B begins.
    std::size_t lead_;                                        ///< So many cycles CPU A has before CPU B has one.
    std::array<Counters, 2U> counters_;
    Progress* progress_; ///< In the region.
    const Experiment* fault_{nullptr};
    Experiment second_fault_{}; ///< The same, in the cycles of CPU B.
    Nanoseconds since_{0};      ///< When the fault of a CPU begins.
    std::size_t now_{0U};
    PhaseHook* hook_{nullptr};
    std::array<CpuHook, 2U> hooks_;
};
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_TWO_CPUS_HPP
