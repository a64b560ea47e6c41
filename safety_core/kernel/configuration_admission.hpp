// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_CONFIGURATION_ADMISSION_HPP
#define SAFETY_CORE_KERNEL_CONFIGURATION_ADMISSION_HPP

#include "safety_core/kernel/configuration_copies.hpp"

namespace counterpoint
{

/// @brief Whether a changed value may be stored; else its abort code. What is stored already was admitted before.
/// [SRS_CFG_044, SRS_CFG_045, SRS_CFG_343, SRS_CFG_344, SRS_CFG_345, SRS_CFG_346, SRS_CFG_347]
[[nodiscard]] AbortCode Admit(const ConfigurationCopies& copies, const ConfigItem& item) noexcept;

} // namespace counterpoint

#endif
