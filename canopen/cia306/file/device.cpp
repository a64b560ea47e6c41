// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/file/device.hpp"

#include "canopen/cia306/text/input_error.hpp"

namespace counterpoint::cia306
{
const Text& Entry::Configured() const noexcept
{
    return parameter_value.IsSet() ? parameter_value : default_value;
}

bool Entry::IsFixed() const noexcept
{
    return access == Access::kConstant || access == Access::kReadOnly;
}

bool Entry::IsInTpdo() const noexcept
{
    return is_pdo_mappable && access != Access::kWriteOnly && access != Access::kReadWriteOutput;
}

bool Entry::IsInRpdo() const noexcept
{
    return is_pdo_mappable && !is_safety && !IsFixed() && access != Access::kReadWriteInput;
}

Place Entry::ValuePlace() const noexcept
{
    const Text& configured = Configured();
    return configured.IsSet() ? configured.place : place;
}

bool Device::IsSafetyObject(const std::uint16_t index) const
{
    constexpr std::uint16_t kFirst = 0x1300U;
    constexpr std::uint16_t kLast = 0x13FFU;
    constexpr std::uint16_t kFirstParameter = 0x5F00U;
    constexpr std::uint16_t kLastParameter = 0x5F05U;
    const bool is_parameter = index >= kFirstParameter && index <= kLastParameter;
    const auto object = objects.lower_bound(kFirst);
    const auto listed = missing.lower_bound(kFirst);
    const bool has_object = object != objects.end() && object->first <= kLast;
    const bool is_listed = listed != missing.end() && listed->first <= kLast;
    const bool is_safety_device = has_object || is_listed || is_safety_supported.value_or(false);
    return (index >= kFirst && index <= kLast) || (is_parameter && is_safety_device);
}

const Object* Device::Find(const std::uint16_t index) const
{
    const auto found = objects.find(index);
    return found == objects.end() ? nullptr : &found->second;
}

const Entry* Device::Find(const std::uint16_t index, const std::uint8_t sub) const
{
    const Object* const object = Find(index);
    if (object == nullptr)
    {
        return nullptr;
    }
    const auto found = object->entries.find(sub);
    return found == object->entries.end() ? nullptr : &found->second;
}

bool IsGranularity(const std::uint64_t bits) noexcept
{
    const bool is_bytes = bits == 8U || bits == 16U || bits == 32U || bits == 64U;
    return bits == 1U || is_bytes;
}

ValueResult ConfiguredValue(const Entry& entry, const std::optional<std::uint8_t> node_id)
{
    const Text& configured = entry.Configured();
    if (!configured.IsSet())
    {
        return {std::nullopt, {"no value", "a ParameterValue or DefaultValue"}};
    }
    return ParseValue(configured.text, entry.type, node_id);
}

std::optional<Value> UsableValue(const std::string& file, const Entry& entry, const std::optional<std::uint8_t> node_id)
{
    const bool fits_none = !entry.Configured().IsSet() || ProblemOf(entry.Configured().text, entry.type);
    if (fits_none && !ConfiguredValue(entry, node_id).value)
    {
        return std::nullopt;
    }
    return RequiredValue(file, entry, node_id);
}

Value RequiredValue(const std::string& file, const Entry& entry, const std::optional<std::uint8_t> node_id)
{
    const ValueResult result = ConfiguredValue(entry, node_id);
    if (!result.value)
    {
        throw InputError(file, entry.ValuePlace(),
                         {ObjectName(entry.index, entry.sub) + ": " + result.problem.wrong, result.problem.expected});
    }
    return *result.value;
}
} // namespace counterpoint::cia306
