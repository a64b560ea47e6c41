// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TARGET_MANAGER_SCENES_HPP
#define VERIFICATION_TARGET_MANAGER_SCENES_HPP

#include <cstdint>

namespace counterpoint::target
{

/// @brief Plays each scene: managers of examples/network_manager and the drive of examples/actuator on one wire. Prints
/// what the managers tell, and a line "run=" for each scene. 0: every drive ended as the scene wants it.
[[nodiscard]] std::uint32_t PlayScenes() noexcept;

} // namespace counterpoint::target

#endif
