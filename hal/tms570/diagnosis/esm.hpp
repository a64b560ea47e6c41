// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_DIAGNOSIS_ESM_HPP
#define HAL_TMS570_DIAGNOSIS_ESM_HPP

#include "hal/tms570/chip/registers.hpp"
#include "hal/tms570/chip/shared.hpp"
#include "hal/tms570/diagnosis/esm_channels.hpp"
#include "hal/tms570/diagnosis/esm_registers.hpp"

#include <cstdint>

namespace counterpoint::tms570
{

/// Group 1 to 3 and channel in it; group 0: none.
struct EsmError
{
    std::uint8_t group;
    std::uint8_t channel;
};

/// What the module knows at one moment.
struct EsmStatus
{
    std::uint32_t group_1_low;
    std::uint32_t group_1_high;
    std::uint32_t group_2;
    std::uint32_t group_3;
};

/// @brief Status of all groups; nothing is cleared.
[[nodiscard]] EsmStatus ReadEsm() noexcept;
/// @brief Clears what a test has forced, in the status and in the shadow of group 2.
void ClearEsm(const EsmStatus& forced) noexcept;
/// @brief Drives nERROR low until a restart of the module. Needs no state.
void ForceErrorPin() noexcept;
/// @brief Lets nERROR go high again after its low time, as after a forced error that was found.
void ReleaseErrorPin() noexcept;

/// Error signalling module: which error leads to what. [SRS_TMS_030, SRS_TMS_031, SRS_TMS_032, SRS_TMS_033]
class Esm
{
  public:
    /// @brief Before any test: no error of group 2 or 3, nor in the shadow of group 2 from before the reset. kFailed:
    /// First tells which. [SRS_TMS_031]
    [[nodiscard]] Outcome ExamineCold() noexcept;
    /// @brief nERROR is forced and seen low, then released and seen high. [SRS_TMS_033]
    [[nodiscard]] Outcome TestErrorPin() noexcept;
    /// @brief Sets the reactions of the table and reads them back. Also kFailed if an error with the reaction safe
    /// state is present.
    [[nodiscard]] Outcome Start() noexcept;
    /// @brief From the interrupts of either level, and once a cycle. kFailed: safe state; the caller cuts off the
    /// outputs. nERROR is low by then. [SRS_TMS_032]
    [[nodiscard]] Outcome Serve() noexcept;
    /// @brief Once a cycle: set up as it was.
    [[nodiscard]] Outcome Examine() const noexcept;

    /// @brief The first error with reaction safe state since power-on of this object.
    [[nodiscard]] EsmError First() const noexcept
    {
        const std::uint32_t first = first_.Load();
        return EsmError{static_cast<std::uint8_t>(first >> kGroupShift),
                        static_cast<std::uint8_t>(first & kChannelMask)};
    }
    /// @brief Errors that the hardware corrected, since Start; stays at its greatest value.
    [[nodiscard]] std::uint16_t Corrected() const noexcept
    {
        return corrected_.Load();
    }

    /// More corrected errors than this become the safe state: an alpha particle comes once, a defect stays.
    static constexpr std::uint16_t kMostCorrected = 16U;

  private:
    [[nodiscard]] Outcome Judge(const EsmStatus& status) noexcept;
    void Keep(std::uint8_t group, std::uint32_t errors, std::uint8_t first_channel) noexcept;

    static constexpr std::uint32_t kGroupShift = 8U;
    static constexpr std::uint32_t kChannelMask = 0xFFU;

    /// Group and channel in one: a fast interrupt in between must not mix two errors.
    Shared<std::uint32_t> first_{0U};
    Shared<std::uint16_t> corrected_{0U};
};

} // namespace counterpoint::tms570

#endif
