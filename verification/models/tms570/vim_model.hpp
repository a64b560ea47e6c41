// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_MODELS_TMS570_VIM_MODEL_HPP
#define VERIFICATION_MODELS_TMS570_VIM_MODEL_HPP

#include "hal/tms570/chip/variant.hpp"
#include "verification/models/tms570/dcan_model.hpp"
#include "verification/models/tms570/esm_model.hpp"
#include "verification/models/tms570/peripheral.hpp"

namespace counterpoint::tms570::model
{

/// What the interrupt manager is wired to.
struct VimPlace
{
    EsmModel& esm;
    DcanModel& first;
    DcanModel& second;
};

/// Interrupt manager: index of the request by enable and priority, check of its table by parity or by ECC. Offsets
/// count from the registers of that check.
class VimModel final : public Peripheral
{
  public:
    VimModel(const FaultSet& faults, const VimPlace& place, TableCheck check);

    /// @brief Whether the processor sees an interrupt (IRQ), or a fast one (FIQ).
    [[nodiscard]] bool Line();
    [[nodiscard]] bool FastLine();
    /// @brief So many check bits of the word at this address do not fit; with parity one is as many.
    void Report(std::uint32_t wrong_bits, std::uint32_t address);
    [[nodiscard]] bool IsTest();
    [[nodiscard]] bool IsOn();

    [[nodiscard]] std::uint32_t Read(std::uint32_t offset) override;
    void Write(std::uint32_t offset, std::uint32_t value) override;

  private:
    [[nodiscard]] std::uint32_t Index();
    [[nodiscard]] bool IsEnabled(std::uint32_t channel);
    [[nodiscard]] bool HasKey(std::uint32_t shift, std::uint32_t key);
    void ReportParity();
    void ReportOneBit();
    void ReportTwoBits(std::uint32_t address);
    void WriteEccControl(std::uint32_t value);

    EsmModel& esm_;
    DcanModel& first_;
    DcanModel& second_;
    bool has_ecc_;
    bool unknown_masked_{false};
};

/// The table of vectors and, behind it, its check bits.
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
