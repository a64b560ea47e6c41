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

/// A setting that depends on the node-ID: `addend` and the node-ID, or the signature for it.
struct NodeSetting
{
    std::uint16_t setting; ///< Its place among the settings.
    std::uint32_t addend;
    const std::uint16_t* signatures; ///< For the node-IDs 1 to 127, or null.
};

/// What a device file says about 1300h to 13FFh, in an order in which the kernel takes it.
struct Configuration
{
    const Setting* settings; ///< For the node-ID of the file.
    const FieldSetting* fields;
    const NodeSetting* node_settings; ///< By ascending place.
    std::uint16_t setting_count;
    std::uint16_t node_setting_count;
    std::uint8_t field_count;
    std::uint8_t node_id; ///< Of the file.
};

/// The first write that the kernel refused; kNone: it took all of them.
struct ConfigureReply
{
    AbortCode abort;
    ObjectAddress object;
};

/// @brief Registers the fields, then writes the settings for a node-ID of 1 to 127, to the first that is refused; one
/// that its object cannot hold with this node-ID is, by kValueRange. For a started kernel outside OPERATIONAL.
/// O(settings) [SRS_GEN_011, SRS_GEN_016, SRS_GEN_730]
[[nodiscard]] ConfigureReply Configure(Kernel& kernel, const Configuration& configuration,
                                       std::uint8_t node_id) noexcept;

} // namespace counterpoint::generated

#endif
