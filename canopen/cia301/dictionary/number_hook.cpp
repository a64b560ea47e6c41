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
    return Take(address, value, Attempt::kFirst);
}

SdoAbort NumberHook::OnWriteAgain(const ObjectAddress& address, const Bytes& value) noexcept
{
    return Take(address, value, Attempt::kAgain);
}

SdoAbort NumberHook::Take(const ObjectAddress& address, const Bytes& value, const Attempt attempt) noexcept
{
    const auto number = static_cast<std::uint32_t>(FromLittleEndian(value.data, value.size_bytes));
    const bool is_allowed = is_configuring_ || (rule_ == nullptr) || rule_->Allows(address, number);
    SdoAbort abort = SdoAbort::kValueRange;
    if (is_allowed)
    {
        abort = (attempt == Attempt::kAgain) ? StoreAgain(address, number) : Store(address, number);
    }
    return abort;
}

} // namespace counterpoint::cia301
