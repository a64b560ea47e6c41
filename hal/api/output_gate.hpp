// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_API_OUTPUT_GATE_HPP
#define HAL_API_OUTPUT_GATE_HPP

#include "hal/api/safety_output.hpp"
#include "safety_core/contract/time.hpp"

#include <cstdint>

namespace counterpoint::hal
{

/// How long a right Drive keeps the outputs open, in us.
struct GateLimit
{
    std::uint32_t us;
};

/// The decision of the final output, for every port alike: which slots three fresh permits open. Zero-filled memory
/// opens nothing. [SRS_HAL_003, SRS_HAL_004, SRS_HAL_007, SRS_HAL_008]
///
/// Invariants: `open_copy_` is the complement of `open_`, `driven_copy_` that of `driven_`; a bit of which this does
/// not hold is closed, or counts as the longer elapsed time. `challenge_` is 0 while none is outstanding.
class OutputGate
{
  public:
    /// @brief Issues the challenge that the next Drive must answer.
    [[nodiscard]] std::uint32_t Challenge() noexcept;
    /// @brief Judges the permits; the challenge is used up. `now` is the port's own time in microseconds.
    void Drive(const PermitSet& permits, Instant now) noexcept;
    /// @brief Judges the permits against `challenge`, which need not be one of this gate; nothing changes.
    /// [SRS_STS_031]
    [[nodiscard]] static ProbeAnswer Probe(const PermitSet& permits, std::uint32_t challenge) noexcept;
    /// @brief Slots whose outputs are open at `now`; none when the last right Drive is more than `limit` ago, and then
    /// none until the next right Drive. Call at least once in 2^32 us minus `limit`, as every port does that has pins
    /// to set.
    [[nodiscard]] SrdoMask Open(Instant now, GateLimit limit) noexcept;
    /// @brief Closes everything until the next right Drive.
    void Close() noexcept;

  private:
    [[gnu::noinline]] void NoteClosed(const PermitSet& permits) noexcept;

    SrdoMask open_{0U};
    SrdoMask open_copy_{0U};
    Instant driven_{0U};
    Instant driven_copy_{0U};
    std::uint32_t challenge_{0U};
    std::uint32_t sequence_{0U};
};

} // namespace counterpoint::hal

#endif
