// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_ACTUATOR_ACTUATOR_HPP
#define EXAMPLES_ACTUATOR_ACTUATOR_HPP

#include "examples/common/settings.hpp"

namespace counterpoint::examples
{

/// A drive that moves only while both received commands are 1, the output gate is open, and a person has acknowledged
/// after whatever made it stop.
class Actuator final : public QuietApplication
{
  public:
    static constexpr std::uint8_t kCommands = 2U;

    [[nodiscard]] const DeviceConfig& Describe() noexcept;
    [[nodiscard]] static AbortCode Configure(Kernel& kernel) noexcept;
    /// @brief After each cycle: whether the drive may move. `open` is what the gate lets through.
    [[nodiscard]] bool MayMove(SrdoMask open) const noexcept;

  private:
    std::uint8_t normal_[kCommands]{};  ///< 2200h:01, :02, written by channel A.
    std::uint8_t inverse_[kCommands]{}; ///< 2300h:01, :02, written by channel B.
    MappableObject objects_[2U * kCommands]{};
    DeviceConfig config_{};
};

} // namespace counterpoint::examples

#endif
