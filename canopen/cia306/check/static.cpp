// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/check/rules.hpp"

namespace counterpoint::cia306
{
namespace
{
constexpr std::uint32_t kByteBits = 8U;

/// A ParameterValue is what a tool writes into the device, and this entry takes no write.
void CheckWrite(const CheckContext& context, const Entry& entry, Findings& findings)
{
    if (!entry.parameter_value.IsSet())
    {
        return;
    }
    const std::string name = ObjectName(entry.index, entry.sub);
    const std::string wrong = "ParameterValue " + Quoted(entry.parameter_value.text) + " for an entry that is " +
                              (entry.access == Access::kConstant ? "const" : "ro");
    if (!entry.default_value.IsSet())
    {
        findings.Error(entry.parameter_value.place, name, wrong, "a DefaultValue, which nobody writes");
        return;
    }
    const ValueResult written = ParseValue(entry.parameter_value.text, entry.type, context.node_id);
    const ValueResult own = ParseValue(entry.default_value.text, entry.type, context.node_id);
    const bool is_equal = written.value && own.value && written.value->bits == own.value->bits;
    if (is_equal)
    {
        findings.Warning(entry.parameter_value.place, name, wrong, "none: nothing can be written there");
    }
    else
    {
        findings.Error(entry.parameter_value.place, name, wrong,
                       "its DefaultValue " + Quoted(entry.default_value.text) + ": nothing can be written there");
    }
}

void CheckStaticEntry(const SrdoConfiguration& srdo, const MappingEntry& entry, Findings& findings)
{
    const std::string name = ObjectName(srdo.MappingIndex(), entry.sub);
    if (entry.IsDummy())
    {
        findings.Error(entry.place, name,
                       "dummy object " + ObjectName(entry.Index(), entry.Sub()) + " in a static mapping",
                       "an object of the application");
    }
    else if (entry.Bits() % kByteBits != 0U)
    {
        findings.Tell(
            WhenOn(srdo), entry.place, name,
            {"length of " + std::to_string(entry.Bits()) + " bit in a static mapping", "a multiple of 8 bit"});
    }
}
} // namespace

void CheckStaticMapping(const CheckContext& context, const SrdoConfiguration& srdo, Findings& findings)
{
    const Object* const object = context.device.Find(srdo.MappingIndex());
    if (object == nullptr)
    {
        return;
    }
    std::size_t fixed = 0U;
    std::size_t used = 0U;
    for (const auto& [sub, entry] : object->entries)
    {
        // The number of a compact object is ro whatever its entries are.
        const bool is_counter = sub == 0U && entry.is_compact;
        const bool is_used = !is_counter && sub <= srdo.entry_count.value.value_or(0U);
        used += is_used ? 1U : 0U;
        if (is_used && entry.IsFixed())
        {
            ++fixed;
            CheckWrite(context, entry, findings);
        }
    }
    const bool is_mixed = fixed != 0U && fixed != used;
    if (is_mixed)
    {
        findings.Warning(object->place, Hex(object->index, 4),
                         std::to_string(fixed) + " of " + std::to_string(used) + " sub-indices are const or ro",
                         "all of them (static mapping) or none");
    }
    if (srdo.is_static)
    {
        for (const MappingEntry& entry : srdo.mapping)
        {
            CheckStaticEntry(srdo, entry, findings);
        }
    }
}
} // namespace counterpoint::cia306
