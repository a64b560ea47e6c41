// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia302/flying_master/times.hpp"

namespace counterpoint::cia302
{
namespace
{

using cia301::ObjectValue;
using cia301::SdoAbort;

constexpr std::uint8_t kPrioritySub = 3U;
constexpr std::uint8_t kLastSub = 6U;
constexpr std::uint32_t kGreatestValue = 0xFFFFU;

} // namespace

FlyingMasterObject::FlyingMasterObject(FlyingMasterTimes& times) noexcept : times_(times)
{
}

SdoAbort FlyingMasterObject::Write(const std::uint8_t sub, const std::uint32_t value) noexcept
{
    if (sub == 0U)
    {
        return SdoAbort::kReadOnly;
    }
    std::uint16_t* const values[kLastSub] = {&times_.timeout,       &times_.delay,       &times_.priority,
                                             &times_.priority_slot, &times_.device_slot, &times_.detection_cycle};
    if (sub > kLastSub)
    {
        return SdoAbort::kSubUnknown;
    }
    if (value > ((sub == kPrioritySub) ? kLowestPriority : kGreatestValue))
    {
        return SdoAbort::kValueRange;
    }
    *values[sub - 1U] = static_cast<std::uint16_t>(value);
    return SdoAbort::kNone;
}

ObjectValue FlyingMasterObject::Read(const std::uint8_t sub) const noexcept
{
    if (sub == 0U)
    {
        return ObjectValue{SdoAbort::kNone, kLastSub, sizeof(std::uint8_t)};
    }
    const std::uint16_t values[kLastSub] = {times_.timeout,       times_.delay,       times_.priority,
                                            times_.priority_slot, times_.device_slot, times_.detection_cycle};
    const bool is_there = sub <= kLastSub;
    return is_there ? ObjectValue{SdoAbort::kNone, values[sub - 1U], sizeof(std::uint16_t)}
                    : ObjectValue{SdoAbort::kSubUnknown, 0U, 0U};
}

ObjectValue FlyingMasterObject::Fetch(const ObjectAddress& address) noexcept
{
    return Read(address.sub);
}

SdoAbort FlyingMasterObject::Store(const ObjectAddress& address, const std::uint32_t value) noexcept
{
    return Write(address.sub, value);
}

} // namespace counterpoint::cia302
