// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_GENERATED_ACTUATOR_DRIVE_HPP
#define EXAMPLES_GENERATED_ACTUATOR_DRIVE_HPP

#include "examples/common/settings.hpp"

namespace counterpoint::examples
{

/// The drive of examples/actuator. Whatever stands in its DCF comes from generated code.
class Drive final : public QuietApplication
{
  public:
    /// @brief After each cycle: whether the drive may move. `open` is what the gate lets through.
    [[nodiscard]] static bool MayMove(SrdoMask open) noexcept;
};

} // namespace counterpoint::examples

#endif
