// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/pdo/settings.hpp"

namespace counterpoint::cia301
{

ObjectValue FetchShared(const PdoSettings& settings, const std::uint8_t sub, const std::uint8_t highest_sub) noexcept
{
    ObjectValue value{SdoAbort::kSubUnknown, 0U, 1U};
    switch (sub)
    {
    case 0U:
        value = ObjectValue{SdoAbort::kNone, highest_sub, 1U};
        break;
    case kCobIdSub:
        value = ObjectValue{SdoAbort::kNone, settings.cob_id, 4U};
        break;
    case kTypeSub:
        value = ObjectValue{SdoAbort::kNone, settings.type, 1U};
        break;
    case kInhibitSub:
        value = ObjectValue{SdoAbort::kNone, settings.inhibit_100us, 2U};
        break;
    case kEventSub:
        value = ObjectValue{SdoAbort::kNone, settings.event_ms, 2U};
        break;
    default:
        break;
    }
    return value;
}

bool IsUsable(const std::uint32_t cob_id) noexcept
{
    const bool is_off = (cob_id & kCobOff) != 0U;
    return ((cob_id & kCobExtended) == 0U) && (is_off || IsConfigurable(cob_id & kCobIdentifier));
}

bool IsAdmitted(const std::uint32_t own, const std::uint32_t cob_id) noexcept
{
    const bool stays_valid = ((own | cob_id) & kCobOff) == 0U;
    const bool is_changed = ((own ^ cob_id) & kFixedCobBits) != 0U;
    return IsUsable(cob_id) && !(stays_valid && is_changed);
}

} // namespace counterpoint::cia301
