// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_MODELS_TMS570_TEST_MODELS_HPP
#define VERIFICATION_MODELS_TMS570_TEST_MODELS_HPP

#include "verification/models/tms570/clock_models.hpp"
#include "verification/models/tms570/peripheral.hpp"

namespace counterpoint::tms570::model
{

/// Controller of the logic test. It runs while the processor sleeps and ends in a reset.
class StcModel final : public Peripheral
{
  public:
    StcModel(const FaultSet& faults, SystemModel& system);

    /// @brief The processor waits for an interrupt. True: it was tested and is reset now.
    [[nodiscard]] bool OnSleep();

    [[nodiscard]] std::uint32_t Read(std::uint32_t offset) override;
    void Write(std::uint32_t offset, std::uint32_t value) override;

  private:
    SystemModel& system_;
};

/// Controller of the memory test.
class PbistModel final : public Peripheral
{
  public:
    PbistModel(const FaultSet& faults, SystemModel& system);

    void Write(std::uint32_t offset, std::uint32_t value) override;
    void Advance(std::uint64_t ns) override;

  private:
    SystemModel& system_;
    std::uint64_t left_ns_{0U};
    bool must_fail_{false};
};

} // namespace counterpoint::tms570::model

#endif
