// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/generated/constant_objects.hpp"

namespace counterpoint::generated
{

using cia301::Bytes;
using cia301::KeyOf;
using cia301::Reading;
using cia301::Room;
using cia301::SdoAbort;

Reading ConstantObjects::OnRead(const ObjectAddress& address, const Room& room) noexcept
{
    const ConstantValue* const value = Find(address);
    Reading reading{SdoAbort::kObjectUnknown, 0U};
    if (value != nullptr)
    {
        reading = Reading{SdoAbort::kOutOfMemory, value->size_bytes};
    }
    if ((value != nullptr) && (value->size_bytes <= room.size_bytes))
    {
        reading.abort = SdoAbort::kNone;
        for (std::uint32_t i = 0U; i < value->size_bytes; ++i)
        {
            room.data[i] = value->bytes[i];
        }
    }
    return reading;
}

SdoAbort ConstantObjects::OnWrite(const ObjectAddress& address, const Bytes& value) noexcept
{
    const ConstantValue* const constant = Find(address);
    bool is_same = (constant != nullptr) && (constant->size_bytes == value.size_bytes);
    for (std::uint32_t i = 0U; is_same && (i < value.size_bytes); ++i)
    {
        is_same = constant->bytes[i] == value.data[i];
    }
    return is_same ? SdoAbort::kNone : SdoAbort::kValueRange;
}

const ConstantValue* ConstantObjects::Find(const ObjectAddress& address) const noexcept
{
    const std::uint32_t wanted = KeyOf(address.index, address.sub);
    const ConstantValue* found = nullptr;
    std::uint32_t low = 0U;
    std::uint32_t high = table_.count;
    while (low < high)
    {
        const std::uint32_t middle = low + ((high - low) / 2U);
        const ConstantValue& value = table_.values[middle];
        const std::uint32_t key = KeyOf(value.address.index, value.address.sub);
        found = (key == wanted) ? &value : found;
        low = (key < wanted) ? (middle + 1U) : low;
        high = (key < wanted) ? high : middle;
    }
    return found;
}

} // namespace counterpoint::generated
