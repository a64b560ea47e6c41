// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_PROOF_PROTOCOLS_LINK_RIG_HPP
#define VERIFICATION_PROOF_PROTOCOLS_LINK_RIG_HPP

#include "safety_core/crosslink/link_supervisor.hpp"
#include "verification/proof/protocols/replay.hpp"

namespace counterpoint::protocols
{

/// A defect that is put around the supervision of the link, for a replay that has to find it.
enum class LinkDefect : std::uint8_t
{
    kNone,
    kLongerTimeout, ///< By one cycle.
    kTakesForeign,  ///< What is damaged or of another sender is taken as well.
    kOlderAnswers,  ///< What answers a message of an earlier start begins contact.
};

/// Message and supervision of the cross link as they ship, on CPU A, under what link.pml lets wire and CPU B do. Limits
/// as there: cycle 10 ms, time-out 30 ms. Sequence numbers and stamps wrap within the first cycles.
class LinkRig
{
  public:
    explicit LinkRig(LinkDefect defect = LinkDefect::kNone);

    /// @brief Input and what is shown as in Tell of link.pml.
    [[nodiscard]] Numbers Apply(const Numbers& input);

  private:
    void Start();
    void Cycle();
    [[nodiscard]] std::int32_t Receive(const Numbers& input);

    LinkDefect defect_;
    LinkSupervisor link_{};
    std::uint32_t cycle_;
};

} // namespace counterpoint::protocols

#endif
