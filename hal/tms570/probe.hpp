// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_PROBE_HPP
#define HAL_TMS570_PROBE_HPP

#include "hal/api/exception_record.hpp"
#include "hal/tms570/chip/registers.hpp"

#include <cstdint>

/// Reading a word that may abort. A test of ECC arms the probe and reads through it; the handler of data aborts asks
/// whether this abort is that one. [SRS_TMS_046]
namespace counterpoint::tms570
{

/// What must be reported when the abort comes.
enum class ProbeKind : std::uint8_t
{
    kInvalid = 0U, ///< Not armed: no abort is provoked.
    kEvenRam = 0x3CU,
    kOddRam = 0x5AU,
    kFlash = 0x69U,
};

/// @brief Expects one abort of this kind at this place; kInvalid ends that.
void ArmProbe(ProbeKind kind, Register place) noexcept;

/// @brief One access of 32 bits; comes back after a provoked abort, too, and the value is then worth nothing. Defined
/// beside Read: silicon or model.
[[nodiscard]] std::uint32_t Probe(Register place) noexcept;
/// @brief Address of the one instruction that Probe reads with.
[[nodiscard]] std::uint32_t ProbeInstruction() noexcept;

/// What the processor tells of an exception.
struct AbortFacts
{
    hal::ExceptionCause cause;
    std::uint32_t accessed;
    std::uint32_t instruction;
};

/// @brief True at most once for each ArmProbe: for the access of Probe to the armed place, which the module under test
/// reports as uncorrectable. Called by the handler, with interrupts off.
[[nodiscard]] bool IsProvoked(const AbortFacts& facts) noexcept;

} // namespace counterpoint::tms570

#endif
