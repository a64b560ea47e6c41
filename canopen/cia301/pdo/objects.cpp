// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/pdo/objects.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint16_t kNumberBits = 0x01FFU;
constexpr std::uint16_t kRpdoSettings = 0x1400U;
constexpr std::uint16_t kRpdoMapping = 0x1600U;
constexpr std::uint16_t kTpdoSettings = 0x1800U;
constexpr std::uint16_t kTpdoMapping = 0x1A00U;

std::uint16_t NumberOf(const std::uint16_t index) noexcept
{
    return static_cast<std::uint16_t>((index & kNumberBits) + 1U);
}

std::uint16_t KindOf(const std::uint16_t index) noexcept
{
    return static_cast<std::uint16_t>(index & ~std::uint32_t{kNumberBits});
}

} // namespace

PdoObjects::PdoObjects(Tpdos& tpdos, Rpdos& rpdos) noexcept : tpdos_(tpdos), rpdos_(rpdos)
{
}

void PdoObjects::OnSync(const SyncEvent& event) noexcept
{
    rpdos_.OnSync(event);
    tpdos_.OnSync(event);
}

ObjectValue PdoObjects::Fetch(const ObjectAddress& address) noexcept
{
    const std::uint16_t number = NumberOf(address.index);
    ObjectValue value{SdoAbort::kObjectUnknown, 0U, 1U};
    switch (KindOf(address.index))
    {
    case kRpdoSettings:
        value = rpdos_.FetchSetting(number, address.sub);
        break;
    case kRpdoMapping:
        value = rpdos_.FetchMapping(number, address.sub);
        break;
    case kTpdoSettings:
        value = tpdos_.FetchSetting(number, address.sub);
        break;
    case kTpdoMapping:
        value = tpdos_.FetchMapping(number, address.sub);
        break;
    default:
        break;
    }
    return value;
}

SdoAbort PdoObjects::Store(const ObjectAddress& address, const std::uint32_t value) noexcept
{
    const std::uint16_t number = NumberOf(address.index);
    SdoAbort abort = SdoAbort::kObjectUnknown;
    switch (KindOf(address.index))
    {
    case kRpdoSettings:
        abort = rpdos_.StoreSetting(number, address.sub, value);
        break;
    case kRpdoMapping:
        abort = rpdos_.StoreMapping(number, address.sub, value);
        break;
    case kTpdoSettings:
        abort = tpdos_.StoreSetting(number, address.sub, value);
        break;
    case kTpdoMapping:
        abort = tpdos_.StoreMapping(number, address.sub, value);
        break;
    default:
        break;
    }
    return abort;
}

} // namespace counterpoint::cia301
