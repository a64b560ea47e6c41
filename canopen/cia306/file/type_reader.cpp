// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/file/type_reader.hpp"

#include <optional>

namespace counterpoint::cia306
{
namespace
{
constexpr std::uint64_t kMostBits = 64U;

/// The number that an object which describes a type holds at `sub`.
std::optional<std::uint64_t> NumberOf(const Object& type, const std::uint8_t sub)
{
    const auto found = type.entries.find(sub);
    const bool has_value = found != type.entries.end() && found->second.Configured().IsSet();
    if (!has_value)
    {
        return std::nullopt;
    }
    const ValueResult result = ParseValue(found->second.Configured().text, kUnsigned32, std::nullopt);
    return result.value ? std::optional(result.value->bits) : std::nullopt;
}

/// The data type that the DEFSTRUCT of a record gives a sub-index; 0 where there is none.
std::uint16_t MemberType(const Device& device, const Object& object, const std::uint8_t sub)
{
    const Object* const structure = device.Find(object.data_type);
    const bool is_structure = structure != nullptr && structure->type == ObjectType::kDefstruct;
    if (!is_structure)
    {
        return 0U;
    }
    if (sub == 0U)
    {
        return kUnsigned8;
    }
    const auto member = structure->entries.find(sub);
    const bool has_value = member != structure->entries.end() && member->second.Configured().IsSet();
    if (!has_value)
    {
        // Some files give the type of the member as its DataType instead of its value.
        return member == structure->entries.end() ? std::uint16_t{0U} : member->second.data_type;
    }
    const auto code = NumberOf(*structure, sub);
    const bool is_code = code && *code <= 0xFFFFU;
    return is_code ? static_cast<std::uint16_t>(*code) : std::uint16_t{0U};
}

DataType TypeOf(const Device& device, const std::uint16_t code)
{
    const DataType known = DataTypeOf(code);
    const Object* const object = device.Find(code);
    if (known.kind != DataKind::kUnknown || object == nullptr)
    {
        return known;
    }
    if (object->type == ObjectType::kDefstruct)
    {
        return {"a structure (DEFSTRUCT)", DataKind::kStructure, 0U};
    }
    const auto bits = object->type == ObjectType::kDeftype ? NumberOf(*object, 0U) : std::nullopt;
    const bool is_length = bits && *bits != 0U && *bits <= kMostBits;
    return is_length ? DataType{"DEFTYPE", DataKind::kUnsigned, static_cast<std::uint8_t>(*bits)} : known;
}
} // namespace

void ResolveTypes(Device& device)
{
    for (auto& [index, object] : device.objects)
    {
        static_cast<void>(index);
        const bool is_record = object.type == ObjectType::kRecord || object.type == ObjectType::kArray;
        for (auto& [sub, entry] : object.entries)
        {
            const bool is_member = is_record && entry.data_type == 0U;
            entry.data_type = is_member ? MemberType(device, object, sub) : entry.data_type;
            entry.type = TypeOf(device, entry.data_type);
        }
    }
}
} // namespace counterpoint::cia306
