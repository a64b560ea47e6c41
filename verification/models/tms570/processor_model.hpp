// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_MODELS_TMS570_PROCESSOR_MODEL_HPP
#define VERIFICATION_MODELS_TMS570_PROCESSOR_MODEL_HPP

#include "hal/tms570/chip/processor.hpp"
#include "verification/models/tms570/faults.hpp"

#include <cstdint>

namespace counterpoint::tms570::model
{

enum class Privilege : std::uint8_t
{
    kUser = 0U,
    kPrivileged = 1U,
};

/// System registers of a processor and what its memory protection says of an access.
class ProcessorModel
{
  public:
    ProcessorModel(const FaultSet& faults, std::uint32_t regions);

    [[nodiscard]] std::uint32_t Read(ProcessorRegister which) const;
    void Write(ProcessorRegister which, std::uint32_t value);
    void WriteAccess(std::uint32_t region, std::uint32_t access);

    /// @brief Whether a write would be let through.
    [[nodiscard]] bool MayWrite(std::uint32_t address, Privilege privilege) const;
    [[nodiscard]] bool MayRead(std::uint32_t address, Privilege privilege) const;
    [[nodiscard]] bool MayExecute(std::uint32_t address, Privilege privilege) const;
    /// @brief The processor looks at the ECC of the RAM.
    [[nodiscard]] bool ChecksRam() const;

  private:
    struct Region
    {
        std::uint32_t base;
        std::uint32_t size;
        std::uint32_t access;
    };
    static constexpr std::uint32_t kMostRegions = 16U;

    [[nodiscard]] const Region* RegionOf(std::uint32_t address) const;

    const FaultSet& faults_;
    std::uint32_t region_count_;
    Region regions_[kMostRegions]{};
    std::uint32_t number_{0U};
    std::uint32_t control_{0U};
    std::uint32_t auxiliary_{0x0E000000U};
};

} // namespace counterpoint::tms570::model

#endif
