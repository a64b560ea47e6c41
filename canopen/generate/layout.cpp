// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/generate/layout.hpp"

#include "canopen/generate/names.hpp"

#include "canopen/cia306/text/input_error.hpp"
#include "canopen/cia306/text/number.hpp"

#include <algorithm>
#include <set>

namespace counterpoint::generate
{
namespace
{
using cia306::DataKind;

constexpr std::uint16_t kFirstIndex = 0x1000U; ///< Below are data types.
constexpr std::uint16_t kFirstManufacturer = 0x2000U;
constexpr std::uint16_t kFirstSafety = 0x1300U;
constexpr std::uint16_t kLastSafety = 0x13FFU;
constexpr std::size_t kMostVariables = 1024U;

bool IsKernels(const std::uint16_t index)
{
    return index >= kFirstSafety && index <= kLastSafety;
}

/// Where the value of an entry of the table is kept, which has of the safety objects 5F00h to 5F05h alone.
/// [SRS_GEN_006, SRS_GEN_353]
Home TableHome(const cia306::Entry& entry)
{
    const bool is_text = entry.type.kind == DataKind::kText;
    const bool is_domain = is_text && entry.data_type == cia306::kDomainType;
    // With the node-ID a constant changes, too.
    const auto formula = cia306::ParseFormula(entry.Configured().text);
    const bool is_constant = entry.access == cia306::Access::kConstant && !(formula && formula->has_node_id);
    const bool is_fixed =
        is_constant || entry.is_safety || (is_text && (entry.IsFixed() || entry.access == cia306::Access::kUnknown));
    if (is_domain)
    {
        return Home::kNowhere;
    }
    return is_fixed ? Home::kConstant : Home::kStored;
}

/// Makes the elements of a device, and their places.
class Builder
{
  public:
    Builder(const ElementContext& context, Layout& layout) noexcept : context_(context), layout_(layout)
    {
    }

    void Collect()
    {
        for (const auto& [index, object] : context_.device.objects)
        {
            const bool is_served =
                index >= kFirstIndex && !IsKernels(index) && object.type != cia306::ObjectType::kNull;
            for (const auto& [sub, entry] : object.entries)
            {
                static_cast<void>(sub);
                if (is_served)
                {
                    Append(object, entry);
                }
            }
        }
    }

    void Place()
    {
        PlaceTable(true);
        layout_.communication_bytes = layout_.stored_bytes;
        layout_.communication_lengths = layout_.length_count;
        PlaceTable(false);
        PlaceFields();
        for (std::size_t place = 0U; place < layout_.elements.size(); ++place)
        {
            if (layout_.elements[place].IsVariable() && placed_.count(place) == 0U)
            {
                Store(place);
            }
        }
    }

  private:
    void Append(const cia306::Object& object, const cia306::Entry& entry)
    {
        const bool is_known = entry.type.bits != 0U || entry.type.kind == DataKind::kText;
        if (!is_known)
        {
            context_.warnings.push_back({cia306::Severity::kWarning, entry.type_place,
                                         cia306::ObjectName(entry.index, entry.sub),
                                         "is left out, expected a data type whose length is known"});
            return;
        }
        Element element;
        element.entry = &entry;
        element.object_name = object.name;
        element.is_counter = entry.sub == 0U && object.entries.size() > 1U;
        element.home = layout_.safety.HomeOf(entry).value_or(TableHome(entry));
        ReadValue(context_, element);
        layout_.variable_count += element.IsVariable() ? 1U : 0U;
        layout_.entry_count += element.IsVariable() ? 0U : 1U;
        layout_.longest_bytes = std::max(layout_.longest_bytes, element.size_bytes);
        layout_.elements.push_back(element);
    }

    void Store(const std::size_t place)
    {
        Element& element = layout_.elements[place];
        element.offset = layout_.stored_bytes;
        element.length = layout_.length_count;
        layout_.stored_bytes += element.size_bytes;
        layout_.length_count += element.is_text ? 1U : 0U;
        layout_.memory_order.push_back(place);
    }

    void PlaceTable(const bool is_communication)
    {
        for (std::size_t place = 0U; place < layout_.elements.size(); ++place)
        {
            Element& element = layout_.elements[place];
            const bool is_here = (element.entry->index < kFirstManufacturer) == is_communication;
            if (is_here && element.home == Home::kStored)
            {
                Store(place);
            }
            else if (is_here && element.home == Home::kConstant)
            {
                element.offset = layout_.constant_bytes;
                layout_.constant_bytes += element.size_bytes;
            }
        }
    }

    void PlaceFields()
    {
        for (const StaticPart& part : layout_.safety.StaticParts(layout_.elements))
        {
            const std::size_t normal = PlaceField(part, part.normal);
            const std::size_t inverse = PlaceField(part, part.inverse);
            layout_.fields.push_back({part, normal, inverse});
        }
    }

    std::size_t PlaceField(const StaticPart& part, const std::vector<std::size_t>& places)
    {
        const std::size_t begin = layout_.stored_bytes;
        for (const std::size_t place : places)
        {
            if (!placed_.insert(place).second)
            {
                const cia306::Entry& entry = *layout_.elements[place].entry;
                throw cia306::InputError(context_.device.file, part.place,
                                         {"the static mapping of SRDO " + std::to_string(part.number) + " has " +
                                              cia306::ObjectName(entry.index, entry.sub) +
                                              ", which a static mapping has already",
                                          "each object in one static mapping, once"});
            }
            Store(place);
        }
        return begin;
    }

    ElementContext context_;
    Layout& layout_;
    std::set<std::size_t> placed_; ///< Variables of static mappings.
};
} // namespace

Layout LayOut(const cia306::Device& device, const GenerateOptions& options, std::vector<cia306::Finding>& warnings)
{
    Layout layout{SafetyPart(device, options.node_id), {}, {}, {}, 0U, 0U, 0U, 0U, 0U, 0U, 0U, 8U};
    const std::vector<cia306::Finding> too_great = layout.safety.ValuesTooGreat();
    warnings.insert(warnings.end(), too_great.begin(), too_great.end());
    Builder builder({device, options.node_id, warnings}, layout);
    builder.Collect();
    if (layout.variable_count > kMostVariables) // [SRS_GEN_352]
    {
        throw cia306::InputError(
            device.file, {}, {std::to_string(layout.variable_count) + " objects with SRDOMapping=1", "at most 1024"});
    }
    layout.safety.JoinPairs(layout.elements);
    builder.Place();
    NameElements(layout.elements);
    return layout;
}
} // namespace counterpoint::generate
