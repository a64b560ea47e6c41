// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_GENERATED_CONFIGURATION_HPP
#define CANOPEN_GENERATED_CONFIGURATION_HPP

#include "safety_core/kernel/kernel.hpp"

#include <cstdint>

namespace counterpoint::generated
{

/// One object of the safety configuration.
struct Setting
{
    ObjectAddress object;
    std::uint8_t size_bytes; ///< 1, 2 or 4.
    std::uint32_t value;
};

/// The variables of an SRDO with a static mapping.
struct FieldSetting
{
    CommunicationIndex index;
    StaticFields fields;
};

/// What a device file says about 1300h to 13FFh, in an order in which the kernel takes it.
struct Configuration
{
    const Setting* settings;
    const FieldSetting* fields;
    std::uint16_t setting_count;
    std::uint8_t field_count;
};

/// The first refusal; kNone if there was none.
struct ConfigureReply
{
    AbortCode abort;
    ObjectAddress object;
};

/// @brief Registers the fields, then writes the settings. For a started kernel outside OPERATIONAL. O(settings)
/// [SRS-GEN-011]
[[nodiscard]] ConfigureReply Configure(Kernel& kernel, const Configuration& configuration) noexcept;

} // namespace counterpoint::generated

#endif
