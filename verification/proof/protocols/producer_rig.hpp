// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_PROOF_PROTOCOLS_PRODUCER_RIG_HPP
#define VERIFICATION_PROOF_PROTOCOLS_PRODUCER_RIG_HPP

#include "safety_core/contract/channel.hpp"
#include "verification/proof/protocols/replay.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace counterpoint::protocols
{

/// A defect that is put around the channels, for a replay that has to find it.
enum class ProducerDefect : std::uint8_t
{
    kNone,
    kLongerSrvt,     ///< SRVT is one cycle too long.
    kForgetsFaults,  ///< Channel B is not told of transmit faults.
    kConfirmsItself, ///< The inverse frame counts as confirmed with the normal one.
};

/// A producer in both channels that ship, under the calls of producer.pml; times as there. What is shown is what both
/// channels show; where they differ it is nothing that the model says. Its state is kept as the bytes of both.
class ProducerRig
{
  public:
    explicit ProducerRig(ProducerDefect defect = ProducerDefect::kNone);

    /// @brief Input and what is shown as in Tell of producer.pml.
    [[nodiscard]] Numbers Apply(const Numbers& input);

  private:
    [[nodiscard]] Numbers Drive(Channel& channel, const Numbers& input) const;

    ProducerDefect defect_;
    std::uint32_t cycle_{0U};
    std::vector<std::uint8_t> bytes_{};
};

} // namespace counterpoint::protocols

#endif
