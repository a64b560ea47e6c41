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

/// The decision of the final output, for every port alike: which slots three fresh permits open. What closes open
/// slots but right permits, or no permits where none were asked for, *interrupts* the gate: it stays closed, and says
/// so by the challenge 0, until it is armed. Zero-filled memory, and a new gate, is interrupted.
/// [SRS_HAL_003, SRS_HAL_004, SRS_HAL_007, SRS_HAL_008, SRS_HAL_300, SRS_HAL_301, SRS_HAL_302, SRS_HAL_303]
///
/// Invariants: `open_copy_` is the complement of `open_`, `driven_copy_` that of `driven_`; a bit of which this does
/// not hold is closed, or counts as the longer elapsed time. `challenge_` is 0 while none is outstanding. Armed is one
/// pattern of `armed_` with its complement in `armed_copy_`, everything else is interrupted.
class OutputGate
{
  public:
    /// @brief Issues the challenge that the next Drive must answer; 0 while the gate is interrupted. One that no Drive
    /// has answered since the last call interrupts it if slots are open.
    [[nodiscard]] std::uint32_t Challenge() noexcept;
    /// @brief Judges the permits; the challenge is used up. What it refuses interrupts the gate if slots are open. No
    /// permits at all, without a challenge that they answer, close and arm it. `now` is the port's own time in
    /// microseconds.
    void Drive(const PermitSet& permits, Instant now) noexcept;
    /// @brief Judges the permits against `challenge`, which need not be one of this gate; nothing changes.
    /// [SRS_STS_031]
    [[nodiscard]] static ProbeAnswer Probe(const PermitSet& permits, std::uint32_t challenge) noexcept;
    /// @brief Slots whose outputs are open at `now`; none when the last right Drive is more than `limit` ago, which
    /// interrupts the gate. Call at least once in 2^32 us minus `limit`, as every port does that has pins to set.
    [[nodiscard]] SrdoMask Open(Instant now, GateLimit limit) noexcept;
    /// @brief Closes everything until the next right Drive. For a port that has a reason of its own, which it tells
    /// itself: it neither interrupts nor arms.
    void Close() noexcept;

  private:
    [[gnu::noinline]] void NoteClosed(const PermitSet& permits) noexcept;
    [[nodiscard]] bool IsArmed() noexcept;
    void Arm() noexcept;
    void Interrupt() noexcept;

    static constexpr std::uint32_t kInterrupted = 0U;
    static constexpr std::uint32_t kArmed = 0x5A5A5A5AU;

    SrdoMask open_{0U};
    SrdoMask open_copy_{0U};
    Instant driven_{0U};
    Instant driven_copy_{0U};
    std::uint32_t challenge_{0U};
    std::uint32_t sequence_{0U};
    std::uint32_t armed_{kInterrupted};
    std::uint32_t armed_copy_{kInterrupted};
};

} // namespace counterpoint::hal

#endif
