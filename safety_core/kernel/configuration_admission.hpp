// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_CONFIGURATION_ADMISSION_HPP
#define SAFETY_CORE_KERNEL_CONFIGURATION_ADMISSION_HPP

#include "safety_core/kernel/configuration_copies.hpp"

namespace counterpoint
{

/// @brief Whether a changed value may be stored; else its abort code. What is stored already was admitted before.
/// [SRS_CFG_044, SRS_CFG_045]
[[nodiscard]] AbortCode Admit(const ConfigurationCopies& copies, const ConfigItem& item) noexcept;

} // namespace counterpoint

#endif
