// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/dictionary/number_hook.hpp"

#include "canopen/cia301/base/little_endian.hpp"

namespace counterpoint::cia301
{

Reading NumberHook::OnRead(const ObjectAddress& address, const Room& room) noexcept
{
    const ObjectValue value = Fetch(address);
    Reading reading{value.abort, value.size_bytes};
    if ((reading.abort == SdoAbort::kNone) && (value.size_bytes > room.size_bytes))
    {
        reading.abort = SdoAbort::kOutOfMemory;
    }
    if (reading.abort == SdoAbort::kNone)
    {
        ToLittleEndian(value.value, room.data, value.size_bytes);
    }
    return reading;
}

SdoAbort NumberHook::OnWrite(const ObjectAddress& address, const Bytes& value) noexcept
{
    return Store(address, static_cast<std::uint32_t>(FromLittleEndian(value.data, value.size_bytes)));
}

} // namespace counterpoint::cia301
