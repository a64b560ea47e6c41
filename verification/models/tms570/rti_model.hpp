// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_MODELS_TMS570_RTI_MODEL_HPP
#define VERIFICATION_MODELS_TMS570_RTI_MODEL_HPP

#include "verification/models/tms570/esm_model.hpp"
#include "verification/models/tms570/peripheral.hpp"

namespace counterpoint::tms570::model
{

/// Two counter blocks and the windowed watchdog.
class RtiModel final : public Peripheral
{
  public:
    RtiModel(const FaultSet& faults, EsmModel& esm, std::uint32_t mhz);

    /// @brief The watchdog has bitten: the controller is reset.
    [[nodiscard]] bool HasBitten() const
    {
        return has_bitten_;
    }
    [[nodiscard]] bool IsWatching();
    /// @brief What was written last to serve the watchdog.
    [[nodiscard]] std::uint32_t LastKey() const
    {
        return last_key_;
    }

    [[nodiscard]] std::uint32_t Read(std::uint32_t offset) override;
    void Write(std::uint32_t offset, std::uint32_t value) override;
    void Advance(std::uint64_t ns) override;

  private:
    struct Counter
    {
        std::uint64_t rest;
        std::uint32_t free;
    };

    void Count(Counter& counter, std::uint64_t cycles, std::uint32_t compare);
    void TakeKey(std::uint32_t key);
    void Bite();
    [[nodiscard]] std::uint64_t PeriodCycles();

    EsmModel& esm_;
    std::uint32_t mhz_;
    std::uint64_t rest_{0U};
    Counter counters_[2]{};
    std::uint64_t watched_cycles_{0U};
    std::uint32_t last_key_{0U};
    bool first_key_seen_{false};
    bool has_bitten_{false};
};

} // namespace counterpoint::tms570::model

#endif
