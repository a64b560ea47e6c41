// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_MODELS_TMS570_CCM_MODEL_HPP
#define VERIFICATION_MODELS_TMS570_CCM_MODEL_HPP

#include "verification/models/tms570/esm_model.hpp"
#include "verification/models/tms570/peripheral.hpp"

namespace counterpoint::tms570::model
{

/// Comparator of the two processors, and on an LC43x three more with registers of their own.
class CcmModel final : public Peripheral
{
  public:
    CcmModel(const FaultSet& faults, EsmModel& esm, std::uint32_t comparators);

    /// @brief What this comparator compares differs; 0: the processors.
    void Differ(std::uint32_t comparator = 0U);
    /// The one that has the faults of the set.
    std::uint32_t faulty{0U};

    [[nodiscard]] std::uint32_t Read(std::uint32_t offset) override;
    void Write(std::uint32_t offset, std::uint32_t value) override;
    void Advance(std::uint64_t ns) override;

  private:
    [[nodiscard]] bool IsFaulty(std::uint32_t comparator, Fault fault) const;
    void WriteKey(std::uint32_t comparator, std::uint32_t value);

    EsmModel& esm_;
    std::uint32_t comparators_;
    std::uint64_t test_left_ns_[4]{};
};

} // namespace counterpoint::tms570::model

#endif
