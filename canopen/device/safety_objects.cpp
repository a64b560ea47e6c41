// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/device/safety_objects.hpp"

namespace counterpoint::device
{
namespace
{

constexpr std::uint16_t kFirstMapping = 0x1381U;
constexpr std::uint16_t kLastMapping = 0x13C0U;
constexpr std::uint32_t kLengthBits = 8U; ///< Of a mapping entry; index and sub-index stand above them.

} // namespace

SafetyObjects::SafetyObjects(Kernel& kernel, const cia301::EntryTable& own) noexcept : kernel_(kernel), own_(own)
{
}

ObjectReading SafetyObjects::Read(const ObjectAddress& address) noexcept
{
    return kernel_.ReadObject(address);
}

AbortCode SafetyObjects::Write(const ObjectAddress& address, const ObjectData& data) noexcept
{
    AbortCode abort = kernel_.WriteObject(address, data);
    const bool is_mapping = (address.index >= kFirstMapping) && (address.index <= kLastMapping) && (address.sub != 0U);
    if (is_mapping && (abort == AbortCode::kObjectUnknown) && IsOwn(ToValue(data) >> kLengthBits))
    {
        abort = AbortCode::kNotMappable;
    }
    return abort;
}

bool SafetyObjects::IsOwn(const std::uint32_t key) const noexcept
{
    std::uint32_t low = 0U;
    std::uint32_t high = own_.count;
    while (low < high)
    {
        const std::uint32_t middle = low + ((high - low) / 2U);
        const bool is_below = cia301::KeyOf(own_.entries[middle].index, own_.entries[middle].sub) < key;
        low = is_below ? (middle + 1U) : low;
        high = is_below ? high : middle;
    }
    return (low < own_.count) && (cia301::KeyOf(own_.entries[low].index, own_.entries[low].sub) == key);
}

} // namespace counterpoint::device
