// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_MODELS_TMS570_MEMORY_MODELS_HPP
#define VERIFICATION_MODELS_TMS570_MEMORY_MODELS_HPP

#include "verification/models/tms570/esm_model.hpp"
#include "verification/models/tms570/peripheral.hpp"
#include "verification/models/tms570/processor_model.hpp"

#include <map>

namespace counterpoint::tms570::model
{

/// Whether the last access ended in a data abort; whoever made it asks and clears.
struct AbortLine
{
    bool is_raised{false};
    std::uint32_t accessed{0U};
};

/// One TCRAM module: registers of a bank.
class TcramModel final : public Peripheral
{
  public:
    using Peripheral::Peripheral;

    [[nodiscard]] bool MayWriteEcc();
    void Report(std::uint32_t bit);

    void Write(std::uint32_t offset, std::uint32_t value) override;
};

/// The banks of RAM with their ECC: by double word, which bits of it were spoiled.
struct RamBanks
{
    TcramModel& even;
    TcramModel& odd;
    EsmModel& esm;
    const ProcessorModel& processor;
    AbortLine& abort;
};

class RamModel final : public Peripheral
{
  public:
    RamModel(const FaultSet& faults, const RamBanks& banks);

    [[nodiscard]] std::uint32_t Read(std::uint32_t offset) override;
    [[nodiscard]] std::uint32_t ReadEcc(std::uint32_t offset);
    void WriteEcc(std::uint32_t offset, std::uint32_t value);

  private:
    [[nodiscard]] TcramModel& BankOf(std::uint32_t offset);

    RamBanks banks_;
    std::map<std::uint32_t, std::uint32_t> spoiled_{};
};

/// The same cells behind the addresses of their ECC.
class RamEccModel final : public Peripheral
{
  public:
    RamEccModel(const FaultSet& faults, RamModel& ram);

    [[nodiscard]] std::uint32_t Read(std::uint32_t offset) override;
    void Write(std::uint32_t offset, std::uint32_t value) override;

  private:
    RamModel& ram_;
};

/// Level 2 RAM module: judges the pair of data and ECC that it is shown.
class Level2RamModel final : public Peripheral
{
  public:
    Level2RamModel(const FaultSet& faults, EsmModel& esm);

    void Write(std::uint32_t offset, std::uint32_t value) override;

  private:
    void Judge();

    EsmModel& esm_;
};

/// Flash wrapper with its diagnostic mode.
class FlashModel final : public Peripheral
{
  public:
    /// @param read_control Bits of the control register that are there.
    FlashModel(const FaultSet& faults, std::uint32_t read_control);

    /// @brief Bits that the diagnosis spoils in the next read of the mirror.
    [[nodiscard]] std::uint32_t SpoiledBits();
    void Report(std::uint32_t bit);

    void Write(std::uint32_t offset, std::uint32_t value) override;

  private:
    std::uint32_t read_control_;
};

/// The mirror that the diagnosis reads.
class FlashMirrorModel final : public Peripheral
{
  public:
    FlashMirrorModel(const FaultSet& faults, FlashModel& flash, EsmModel& esm, AbortLine& abort);

    [[nodiscard]] std::uint32_t Read(std::uint32_t offset) override;

  private:
    FlashModel& flash_;
    EsmModel& esm_;
    AbortLine& abort_;
};

} // namespace counterpoint::tms570::model

#endif
