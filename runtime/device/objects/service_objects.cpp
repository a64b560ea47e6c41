// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/device/objects/service_objects.hpp"

#include "canopen/cia301/dictionary/object_kinds.hpp"

#include <algorithm>
#include <array>

namespace counterpoint::runtime
{
bool IsOfServiceObjects(const std::uint16_t index) noexcept
{
    constexpr std::array<std::uint16_t, 8U> kServiceObjects{0x1001U, 0x1003U, 0x100CU, 0x100DU,
                                                            0x1014U, 0x1015U, 0x1016U, 0x1017U};
    return std::find(kServiceObjects.begin(), kServiceObjects.end(), index) != kServiceObjects.end();
}

bool IsOfAService(const std::uint16_t index) noexcept
{
    // SYNC, TIME, emergencies of others, reactions to errors; then SDO servers and clients, and PDOs.
    constexpr std::array<std::uint16_t, 8U> kSingle{0x1005U, 0x1006U, 0x1007U, 0x1012U,
                                                    0x1013U, 0x1019U, 0x1028U, 0x1029U};
    const bool is_sdo = (index >= 0x1200U) && (index <= 0x12FFU);
    const bool is_pdo = (index >= 0x1400U) && (index <= 0x1BFFU);
    const bool is_single = std::find(kSingle.begin(), kSingle.end(), index) != kSingle.end();
    return is_sdo || is_pdo || is_single || IsOfServiceObjects(index) || cia301::IsStoreObject(index);
}

cia306::Finding KeptByTheKernel(const cia306::Entry& entry)
{
    return {cia306::Severity::kWarning, entry.place, cia306::ObjectName(entry.index, entry.sub),
            "a variable of SRDOs, so that the kernel has it and the service of this object works without it, expected "
            "SRDOMapping=0 and another object in the mapping"};
}
} // namespace counterpoint::runtime
