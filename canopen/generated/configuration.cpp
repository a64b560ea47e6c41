// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/generated/configuration.hpp"

namespace counterpoint::generated
{

ConfigureReply Configure(Kernel& kernel, const Configuration& configuration) noexcept
{
    for (std::uint8_t i = 0U; i < configuration.field_count; ++i)
    {
        // The kernel answers for a mapping that is not configured yet; 13FEh has the last word about it.
        const FieldSetting& field = configuration.fields[i];
        static_cast<void>(kernel.DefineStaticFields(field.index, field.fields));
    }
    ConfigureReply reply{AbortCode::kNone, ObjectAddress{0U, 0U}};
    for (std::uint16_t i = 0U; (i < configuration.setting_count) && (reply.abort == AbortCode::kNone); ++i)
    {
        const Setting& setting = configuration.settings[i];
        ObjectData data{};
        data.size_bytes = setting.size_bytes;
        for (std::uint8_t byte = 0U; byte < setting.size_bytes; ++byte)
        {
            data.bytes[byte] = static_cast<std::uint8_t>((setting.value >> (8U * byte)) & 0xFFU);
        }
        reply = ConfigureReply{kernel.WriteObject(setting.object, data), setting.object};
    }
    return reply;
}

} // namespace counterpoint::generated
