// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_MODELS_TMS570_CCM_MODEL_HPP
#define VERIFICATION_MODELS_TMS570_CCM_MODEL_HPP

#include "verification/models/tms570/esm_model.hpp"
#include "verification/models/tms570/peripheral.hpp"

namespace counterpoint::tms570::model
{

/// Comparator of the two processors.
class CcmModel final : public Peripheral
{
  public:
    CcmModel(const FaultSet& faults, EsmModel& esm);

    /// @brief The processors differ.
    void Differ();

    [[nodiscard]] std::uint32_t Read(std::uint32_t offset) override;
    void Write(std::uint32_t offset, std::uint32_t value) override;
    void Advance(std::uint64_t ns) override;

  private:
    EsmModel& esm_;
    std::uint64_t test_left_ns_{0U};
};

} // namespace counterpoint::tms570::model

#endif
