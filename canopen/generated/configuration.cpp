// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/generated/configuration.hpp"

namespace counterpoint::generated
{

namespace
{

constexpr std::uint8_t kLastNode = 127U;

std::uint64_t ValueFor(const NodeSetting& setting, const std::uint8_t node_id) noexcept
{
    std::uint64_t value = std::uint64_t{setting.addend} + node_id;
    if (setting.signatures != nullptr)
    {
        const bool is_node = (node_id >= 1U) && (node_id <= kLastNode);
        value = is_node ? setting.signatures[node_id - 1U] : 0U; // 0 is no signature.
    }
    return value;
}

} // namespace

ConfigureReply Configure(Kernel& kernel, const Configuration& configuration, const std::uint8_t node_id) noexcept
{
    for (std::uint8_t i = 0U; i < configuration.field_count; ++i)
    {
        // The kernel answers for a mapping that is not configured yet; 13FEh has the last word about it.
        const FieldSetting& field = configuration.fields[i];
        static_cast<void>(kernel.DefineStaticFields(field.index, field.fields));
    }
    ConfigureReply reply{AbortCode::kNone, ObjectAddress{0U, 0U}};
    std::uint16_t node_setting =
        (node_id == configuration.node_id) ? configuration.node_setting_count : std::uint16_t{0U};
    for (std::uint16_t i = 0U; (i < configuration.setting_count) && (reply.abort == AbortCode::kNone); ++i)
    {
        const Setting& setting = configuration.settings[i];
        std::uint64_t value = setting.value;
        if ((node_setting < configuration.node_setting_count) &&
            (configuration.node_settings[node_setting].setting == i))
        {
            value = ValueFor(configuration.node_settings[node_setting], node_id);
            ++node_setting;
        }
        ObjectData data{};
        data.size_bytes = setting.size_bytes;
        for (std::uint8_t byte = 0U; byte < setting.size_bytes; ++byte)
        {
            data.bytes[byte] = static_cast<std::uint8_t>((value >> (8U * byte)) & 0xFFU);
        }
        // A number that is cut would be another one than the file has for this node-ID. [SRS_GEN_730]
        const bool is_whole = (value >> (8U * setting.size_bytes)) == 0U;
        reply = ConfigureReply{is_whole ? kernel.WriteObject(setting.object, data) : AbortCode::kValueRange,
                               setting.object};
    }
    return reply;
}

} // namespace counterpoint::generated
