// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_MODELS_TMS570_GIO_MODEL_HPP
#define VERIFICATION_MODELS_TMS570_GIO_MODEL_HPP

#include "verification/models/tms570/peripheral.hpp"

namespace counterpoint::tms570::model
{

/// GIO ports A and B; pull-downs outside.
class GioModel final : public Peripheral
{
  public:
    using Peripheral::Peripheral;

    /// @brief What a meter at the pins of port A shows. A pin without a driver is low.
    [[nodiscard]] std::uint32_t PinsA();
    [[nodiscard]] std::uint32_t PinsB();
    /// @brief What others drive onto pins of port B that are inputs.
    std::uint32_t inputs_b{0U};

    [[nodiscard]] std::uint32_t Read(std::uint32_t offset) override;
    void Write(std::uint32_t offset, std::uint32_t value) override;

  private:
    [[nodiscard]] std::uint32_t Pins(std::uint32_t port);
};

} // namespace counterpoint::tms570::model

#endif
