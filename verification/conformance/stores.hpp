// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CONFORMANCE_STORES_HPP
#define VERIFICATION_CONFORMANCE_STORES_HPP

#include "verification/conformance/steps.hpp"

/// Short names of the stores of one SRDO.
namespace counterpoint::conformance
{

constexpr Step Direction(SlotIndex slot, std::uint32_t value)
{
    return Store(slot, ConfigField::kDirection, value);
}

constexpr Step Sct(SlotIndex slot, std::uint32_t value)
{
    return Store(slot, ConfigField::kSct, value);
}

constexpr Step Srvt(SlotIndex slot, std::uint32_t value)
{
    return Store(slot, ConfigField::kSrvt, value);
}

constexpr Step Type(SlotIndex slot, std::uint32_t value)
{
    return Store(slot, ConfigField::kTransmissionType, value);
}

constexpr Step CobId1(SlotIndex slot, std::uint32_t value)
{
    return Store(slot, ConfigField::kCobId1, value);
}

constexpr Step CobId2(SlotIndex slot, std::uint32_t value)
{
    return Store(slot, ConfigField::kCobId2, value);
}

constexpr Step MapCount(SlotIndex slot, std::uint32_t value)
{
    return Store(slot, ConfigField::kMapCount, value);
}

constexpr Step Entry(SlotIndex slot, std::uint8_t sub, std::uint32_t value)
{
    return Store(slot, ConfigField::kMapEntry, value, sub);
}

constexpr Step Signature(SlotIndex slot, std::uint32_t value)
{
    return Store(slot, ConfigField::kSignature, value);
}

} // namespace counterpoint::conformance

#endif
