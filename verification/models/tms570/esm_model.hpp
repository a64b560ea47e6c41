// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_MODELS_TMS570_ESM_MODEL_HPP
#define VERIFICATION_MODELS_TMS570_ESM_MODEL_HPP

#include "verification/models/tms570/peripheral.hpp"

namespace counterpoint::tms570::model
{

/// Error signalling module: status, influence on nERROR with its low time, two interrupt levels.
class EsmModel final : public Peripheral
{
  public:
    using Peripheral::Peripheral;

    /// @brief An error of this channel. Groups 1 to 3.
    void Raise(std::uint32_t group, std::uint32_t channel);
    [[nodiscard]] bool IsPinHigh() const;
    [[nodiscard]] bool HighLine();
    [[nodiscard]] bool LowLine();

    [[nodiscard]] std::uint32_t Read(std::uint32_t offset) override;
    void Write(std::uint32_t offset, std::uint32_t value) override;
    void Advance(std::uint64_t ns) override;

  private:
    void PullLow();

    bool low_{false};
    bool forced_{false};
    bool released_{false};
    std::uint64_t low_left_ns_{0U};
};

} // namespace counterpoint::tms570::model

#endif
