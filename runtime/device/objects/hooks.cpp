// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/device/objects/hooks.hpp"

#include <algorithm>

namespace counterpoint::runtime
{
using cia301::SdoAbort;

SdoAbort FixedHook::OnWrite(const ObjectAddress& address, const cia301::Bytes& value) noexcept
{
    const auto* const end = table_.entries + table_.count;
    const auto* const entry = std::find_if(table_.entries, end, [&address](const cia301::Entry& each)
                                           { return each.index == address.index && each.sub == address.sub; });
    const bool is_same = entry != end && std::equal(value.data, value.data + value.size_bytes, entry->place);
    return is_same ? SdoAbort::kNone : SdoAbort::kLocalControl;
}

ObjectReading NoSafetyObjects::Read(const ObjectAddress& address) noexcept
{
    static_cast<void>(address);
    return {AbortCode::kObjectUnknown, {}};
}

AbortCode NoSafetyObjects::Write(const ObjectAddress& address, const ObjectData& data) noexcept
{
    static_cast<void>(address);
    static_cast<void>(data);
    return AbortCode::kObjectUnknown;
}

cia301::Reading NoStoreHook::OnRead(const ObjectAddress& address, const cia301::Room& room) noexcept
{
    static_cast<void>(address);
    constexpr std::uint32_t kSize = 4U;
    if (room.size_bytes < kSize)
    {
        return {SdoAbort::kOutOfMemory, 0U};
    }
    std::fill_n(room.data, kSize, std::uint8_t{0U});
    return {SdoAbort::kNone, kSize};
}

SdoAbort NoStoreHook::OnWrite(const ObjectAddress& address, const cia301::Bytes& value) noexcept
{
    static_cast<void>(address);
    static_cast<void>(value);
    return SdoAbort::kNotStored;
}
} // namespace counterpoint::runtime
