// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_MODELS_TMS570_CLOCK_MODELS_HPP
#define VERIFICATION_MODELS_TMS570_CLOCK_MODELS_HPP

#include "hal/tms570/chip/variant.hpp"
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

/// Bits of the system module that are no memory cells.
struct SystemBits
{
    std::uint32_t sources_always_off;
    std::uint32_t rti_source_kept;
};
inline constexpr SystemBits kCortexR4Bits{0U, 0xFFFFFFFFU};
/// SPNU563A, 2.5.1.10 and 2.5.1.18.
inline constexpr SystemBits kLc43xBits{0x4U, 0x30FU};

/// System module: clock sources, initialisation of memories, reset flags; and whether a memory test is over.
class SystemModel final : public Peripheral
{
  public:
    SystemModel(const FaultSet& faults, const SystemBits& bits);

    void SetReset(std::uint32_t bits);
    void EndMemoryTest();

    [[nodiscard]] std::uint32_t Read(std::uint32_t offset) override;
    void Write(std::uint32_t offset, std::uint32_t value) override;
    void Advance(std::uint64_t ns) override;

  private:
    SystemBits bits_;
    std::uint64_t lock_left_ns_{0U};
    std::uint64_t init_left_ns_{0U};
};

} // namespace counterpoint::tms570::model

#endif
