// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_PROOF_PROTOCOLS_COMPARATOR_RIG_HPP
#define VERIFICATION_PROOF_PROTOCOLS_COMPARATOR_RIG_HPP

#include "hal/api/output_gate.hpp"
#include "safety_core/kernel/decision.hpp"
#include "verification/proof/protocols/replay.hpp"

namespace counterpoint::protocols
{

/// A defect that is put around the comparator, for a replay that has to find it.
enum class ComparatorDefect : std::uint8_t
{
    kNone,
    kWayOut,      ///< Voices that say the same arm the latch again.
    kLongerLimit, ///< The discrepancy time is one cycle too long.
    kOneIsEnough, ///< The release of channel A stands for both.
};

/// Comparator, decision, latch and output gate of the product, with two channels that say what comparator.pml lets them
/// say. Limits as there: cycle 1 ms, discrepancy time 2 ms, acknowledge window 3 ms; one slot.
class ComparatorRig
{
  public:
    explicit ComparatorRig(const ComparatorDefect defect = ComparatorDefect::kNone) : defect_(defect)
    {
    }

    /// @brief Input and what is shown as in Tell of comparator.pml.
    [[nodiscard]] Numbers Apply(const Numbers& input);

  private:
    void Start();
    [[nodiscard]] Numbers Cycle(const Numbers& input);

    ComparatorDefect defect_;
    SafeStateLatch latch_{};
    Decision decision_{};
    hal::OutputGate gate_{};
    SrdoMask written_a_{0U}; ///< What the channels keep of what was committed.
    SrdoMask written_b_{0U};
    std::uint32_t cycle_{0U};
};

} // namespace counterpoint::protocols

#endif
