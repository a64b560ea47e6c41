// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_FIRMWARE_OWN_DEVICE_INVERSE_PORT_HPP
#define EXAMPLES_FIRMWARE_OWN_DEVICE_INVERSE_PORT_HPP

#include "safety_core/contract/can_frame.hpp"

namespace counterpoint::firmware
{

/// @brief The controller that sends and receives inverse frames: one_controller.cpp or two_controllers.cpp.
[[nodiscard]] CanPortId InversePort() noexcept;

} // namespace counterpoint::firmware

#endif
