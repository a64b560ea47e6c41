// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_FAULTS_FRAME_SELECTOR_HPP
#define SIMULATOR_FAULTS_FRAME_SELECTOR_HPP

#include "simulator/faults/random.hpp"
#include "simulator/journal/journal.hpp"
#include "simulator/scenario/scenario.hpp"

#include "safety_core/contract/can_frame.hpp"

#include <vector>

namespace counterpoint::simulator
{
/// Counts what fits a choice, and decides whose turn it is.
class Turns
{
  public:
    /// @brief One more fits. The answer: whether it is hit.
    [[nodiscard]] bool Take(const FrameChoice& choice, bool is_lucky) noexcept;

  private:
    std::uint32_t seen_{0U}; ///< So far.
    std::uint32_t done_{0U}; ///< Hit so far.
};

/// Tells the journal what a fault has changed, and the first effect of each fault.
class EffectTeller
{
  public:
    /// @brief `journal` outlives it; `kind` is what is told of each effect.
    EffectTeller(Journal& journal, EventKind kind) noexcept;
    /// @brief The fault with this index has changed what `receiver` gets.
    void Tell(std::size_t fault, NodeIndex receiver, std::uint32_t identifier, Nanoseconds at);

  private:
    Journal& journal_;
    EventKind kind_;
    std::vector<std::size_t> told_; ///< Faults whose first effect is in the journal.
};

/// Decides which frames a fault hits. [SRS_SIM_020]
class FrameSelector
{
  public:
    /// @brief `fault` outlives the selector; `identifiers` are those of the chosen SRDO, if one is chosen.
    FrameSelector(const FaultSetup& fault, std::size_t index, std::vector<std::uint32_t> identifiers);

    /// @brief Looks at a frame, and counts it if it fits. Call it once for each frame, in the order of time.
    void Examine(const CanFrame& frame, NodeIndex sender, Nanoseconds now, Random& random);
    /// @brief Whether the frame that was examined last is hit.
    [[nodiscard]] bool IsChosen() const noexcept
    {
        return is_chosen_;
    }
    /// @brief Whether the fault acts on this receiver.
    [[nodiscard]] bool IsFor(const BusPlace& receiver) const noexcept;
    /// @brief The fault.
    [[nodiscard]] const FaultSetup& Fault() const noexcept
    {
        return *fault_;
    }
    /// @brief Its index in Scenario::faults.
    [[nodiscard]] std::size_t Index() const noexcept
    {
        return index_;
    }

  private:
    [[nodiscard]] bool Fits(const CanFrame& frame, NodeIndex sender, Nanoseconds now) const;

    const FaultSetup* fault_;
    std::size_t index_; ///< In Scenario::faults.
    std::vector<std::uint32_t> identifiers_;
    Turns turns_;
    bool is_chosen_{false};
};

/// Whether an intermittent fault that began at `from` is there at `now`.
[[nodiscard]] constexpr bool IsOn(const Nanoseconds now, const Nanoseconds from, const Nanoseconds on,
                                  const Nanoseconds off)
{
    return on == 0 || (now - from) % (on + off) < on;
}
} // namespace counterpoint::simulator

#endif // SIMULATOR_FAULTS_FRAME_SELECTOR_HPP
