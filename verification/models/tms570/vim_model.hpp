// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_MODELS_TMS570_VIM_MODEL_HPP
#define VERIFICATION_MODELS_TMS570_VIM_MODEL_HPP

#include "verification/models/tms570/dcan_model.hpp"
#include "verification/models/tms570/esm_model.hpp"
#include "verification/models/tms570/peripheral.hpp"

namespace counterpoint::tms570::model
{

/// Interrupt manager: index of the request by enable and priority. Offsets count from its parity registers.
class VimModel final : public Peripheral
{
  public:
    VimModel(const FaultSet& faults, EsmModel& esm, DcanModel& first, DcanModel& second);

    /// @brief Whether the processor sees an interrupt (IRQ), or a fast one (FIQ).
    [[nodiscard]] bool Line();
    [[nodiscard]] bool FastLine();
    /// @brief The parity of a word of the table does not fit.
    void ReportParity();
    [[nodiscard]] bool IsParityTest();
    [[nodiscard]] bool IsParityOn();

    [[nodiscard]] std::uint32_t Read(std::uint32_t offset) override;
    void Write(std::uint32_t offset, std::uint32_t value) override;

  private:
    [[nodiscard]] std::uint32_t Index();
    [[nodiscard]] bool IsEnabled(std::uint32_t channel);

    EsmModel& esm_;
    DcanModel& first_;
    DcanModel& second_;
    bool unknown_masked_{false};
};

/// The table of vectors and, behind it, its parity bits.
class VimTableModel final : public Peripheral
{
  public:
    VimTableModel(const FaultSet& faults, VimModel& vim);

    [[nodiscard]] std::uint32_t Read(std::uint32_t offset) override;
    void Write(std::uint32_t offset, std::uint32_t value) override;

  private:
    VimModel& vim_;
};

} // namespace counterpoint::tms570::model

#endif
