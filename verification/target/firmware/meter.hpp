// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TARGET_FIRMWARE_METER_HPP
#define VERIFICATION_TARGET_FIRMWARE_METER_HPP

#include <cstdint>

namespace counterpoint::target
{

/// @brief Executed instructions on the target; 0 on the host, where the bench counts them another way.
[[nodiscard]] std::uint32_t ReadMeter() noexcept;

} // namespace counterpoint::target

#endif
