// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/check/rules.hpp"

#include <array>

namespace counterpoint::cia306
{
namespace
{
constexpr std::array<std::uint16_t, 3U> kMandatory{0x1000U, 0x1001U, 0x1018U};
constexpr std::uint16_t kFirstOwn = 0x2000U;
constexpr std::uint8_t kStructureSub = 0xFFU; ///< Describes the structure of an object; counts for nothing.
constexpr std::uint8_t kLastSub = 6U;         ///< Of 1301h to 1340h.
constexpr std::uint8_t kTransmissionSub = 4U; ///< Of 1301h to 1340h: a constant of the kernel, whatever the file says.

/// Whether the kernel lets a client write this one, whatever the file says of it. Mappings have a rule of their own:
/// they may be static.
bool IsWrittenByKernel(const Entry& entry)
{
    const bool is_communication =
        entry.index >= kFirstCommunicationIndex && entry.index < kFirstCommunicationIndex + kMaxSrdos;
    const bool is_written = entry.sub != 0U && entry.sub <= kLastSub && entry.sub != kTransmissionSub;
    const bool is_signature = entry.index == kSignatureIndex && entry.sub != 0U && entry.sub <= kMaxSrdos;
    const bool is_flag = entry.index == kGfcIndex || entry.index == kConfigurationValidIndex;
    return is_flag || (is_communication && is_written) || is_signature;
}

std::uint8_t HighestSub(const Object& object)
{
    std::uint8_t highest = 0U;
    for (const auto& [sub, entry] : object.entries)
    {
        highest = (sub != kStructureSub) ? sub : highest;
    }
    return highest;
}
} // namespace

void CheckMandatory(const Device& device, Findings& findings)
{
    if (device.mandatory_place.IsWhole())
    {
        return; // Each object is told already: it is in none of the lists.
    }
    std::string absent;
    for (const std::uint16_t index : kMandatory)
    {
        const bool is_told = device.missing.count(index) != 0U;
        if (device.Find(index) == nullptr && !is_told)
        {
            absent += " " + Hex(index, 4);
        }
    }
    if (!absent.empty())
    {
        findings.Warning(device.mandatory_place, "", "[MandatoryObjects] without" + absent,
                         "0x1000, 0x1001 and 0x1018, which every device has");
    }
}

void CheckHighestSubs(const CheckContext& context, Findings& findings)
{
    for (const auto& [index, object] : context.device.objects)
    {
        const Entry* const count = context.device.Find(index, 0U);
        const std::uint8_t highest = HighestSub(object);
        if (index < kFirstOwn || count == nullptr || highest == 0U || !count->Configured().IsSet())
        {
            continue;
        }
        const ValueResult value = ConfiguredValue(*count, context.node_id);
        const bool is_less = value.value && count->IsFixed() && value.value->bits < highest;
        const bool is_more = value.value && value.value->bits > highest;
        if (is_less || is_more)
        {
            findings.Warning(count->ValuePlace(), ObjectName(index, 0U),
                             "highest sub-index " + std::to_string(value.value->bits),
                             std::to_string(highest) + ", the highest one that the file describes");
        }
    }
}

void CheckKernelAccess(const Device& device, Findings& findings)
{
    for (const auto& [index, object] : device.objects)
    {
        for (const auto& [sub, entry] : object.entries)
        {
            const bool is_told = entry.access == Access::kReadWrite || entry.access == Access::kUnknown;
            if (!is_told && IsWrittenByKernel(entry))
            {
                findings.Warning(entry.access_place, ObjectName(index, sub),
                                 "the device lets clients read and write it all the same", "AccessType=rw");
            }
        }
    }
}
} // namespace counterpoint::cia306
