// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_PROOF_PROTOCOLS_ELECTION_RIG_HPP
#define VERIFICATION_PROOF_PROTOCOLS_ELECTION_RIG_HPP

#include "canopen/cia302/flying_master/flying_master.hpp"
#include "verification/proof/protocols/replay.hpp"

#include <array>
#include <optional>

namespace counterpoint::protocols
{

/// A defect that is put around the flying masters, for a replay that has to find it.
enum class ElectionDefect : std::uint8_t
{
    kNone,
    kUnbounded,    ///< No limit of restarts by 076h.
    kDeafToForce,  ///< No device hears 076h.
    kWrongPriority ///< Both take part with level 1.
};

/// Two flying masters of the product, preset default, under what election.pml lets them meet. Times as there.
class ElectionRig
{
  public:
    explicit ElectionRig(const ElectionDefect defect = ElectionDefect::kNone) : defect_(defect)
    {
    }

    /// @brief Input and what is shown as in Tell of election.pml.
    [[nodiscard]] Numbers Apply(const Numbers& input);

  private:
    void Cycle(std::size_t device);
    void Hear(std::size_t device, std::int32_t frame, const Numbers& input);
    void Pass(std::int32_t ms);
    [[nodiscard]] bool IsHeartbeatDue(std::size_t device) const;
    [[nodiscard]] std::int32_t StateOf(std::size_t device) const;
    [[nodiscard]] std::int32_t NextOf(std::size_t device) const;
    [[nodiscard]] Instant Now() const
    {
        return Instant{0xFFFF'FC18U + (now_ms_ * 1000U)}; // Turns over after a millisecond.
    }

    ElectionDefect defect_;
    std::uint32_t now_ms_{0U};
    std::array<std::optional<cia302::FlyingMaster>, 2U> masters_{};
};

} // namespace counterpoint::protocols

#endif
