// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_MODELS_TMS570_CLOCK_MODELS_HPP
#define VERIFICATION_MODELS_TMS570_CLOCK_MODELS_HPP

#include "hal/tms570/variant.hpp"
#include "verification/models/tms570/esm_model.hpp"
#include "verification/models/tms570/peripheral.hpp"

namespace counterpoint::tms570::model
{

/// Clock comparator: counts both clocks for the time of its seeds.
class DccModel final : public Peripheral
{
  public:
    DccModel(const FaultSet& faults, EsmModel& esm, const ClockTree& clocks);

    [[nodiscard]] std::uint32_t Read(std::uint32_t offset) override;
    void Write(std::uint32_t offset, std::uint32_t value) override;
    void Advance(std::uint64_t ns) override;

  private:
    void Compare();

    EsmModel& esm_;
    ClockTree clocks_;
    std::uint64_t left_ns_{0U};
};

/// System module: clock sources, initialisation of memories, reset flags; and whether a memory test is over.
class SystemModel final : public Peripheral
{
  public:
    explicit SystemModel(const FaultSet& faults);

    void SetReset(std::uint32_t bits);
    void EndMemoryTest();

    [[nodiscard]] std::uint32_t Read(std::uint32_t offset) override;
    void Write(std::uint32_t offset, std::uint32_t value) override;
    void Advance(std::uint64_t ns) override;

  private:
    std::uint64_t lock_left_ns_{0U};
    std::uint64_t init_left_ns_{0U};
};

} // namespace counterpoint::tms570::model

#endif
