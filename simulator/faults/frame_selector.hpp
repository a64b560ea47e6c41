// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_FAULTS_FRAME_SELECTOR_HPP
#define SIMULATOR_FAULTS_FRAME_SELECTOR_HPP

#include "simulator/faults/random.hpp"
#include "simulator/journal/bus_place.hpp"
#include "simulator/scenario/scenario.hpp"

#include "safety_core/contract/can_frame.hpp"

#include <vector>

namespace counterpoint::simulator
{
/// Decides which frames a fault hits. [SRS_SIM_020]
class FrameSelector
{
  public:
    /// @brief `fault` outlives the selector; `identifiers` are those of the chosen SRDO, if one is chosen.
    FrameSelector(const FaultSetup& fault, std::size_t index, std::vector<std::uint32_t> identifiers);

    /// @brief Looks at a frame, and counts it if it fits. Call it once for each frame, in the order of time.
    void Examine(const CanFrame& frame, NodeIndex sender, Nanoseconds now, Random& random);
    /// @brief Whether the frame that was examined last is hit.
    [[nodiscard]] bool IsChosen() const noexcept;
    /// @brief Whether the fault acts on this receiver.
    [[nodiscard]] bool IsFor(const BusPlace& receiver) const noexcept;
    /// @brief The fault.
    [[nodiscard]] const FaultSetup& Fault() const noexcept;
    /// @brief Its index in Scenario::faults.
    [[nodiscard]] std::size_t Index() const noexcept;

  private:
    [[nodiscard]] bool Fits(const CanFrame& frame, NodeIndex sender, Nanoseconds now) const;

    const FaultSetup* fault_;
    std::size_t index_; ///< In Scenario::faults.
    std::vector<std::uint32_t> identifiers_;
    std::uint32_t seen_{0U}; ///< Frames that fit so far.
    std::uint32_t done_{0U}; ///< Frames that were hit so far.
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
