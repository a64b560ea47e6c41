// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/monitor/decoder.hpp"

#include "canopen/monitor/texts.hpp"

#include <algorithm>

namespace counterpoint::monitor
{
namespace
{
constexpr std::uint32_t kNodes = 0x7FU;
constexpr std::uint32_t kByteBits = 8U;

std::string Command(const std::uint8_t command)
{
    switch (command)
    {
    case 1U:
        return "start";
    case 2U:
        return "stop";
    case 128U:
        return "enter PRE-OPERATIONAL";
    case 129U:
        return "reset node";
    case 130U:
        return "reset communication";
    default:
        return "command " + std::to_string(command);
    }
}

std::string StateName(const std::uint8_t state)
{
    switch (state)
    {
    case 0U:
        return "boot-up";
    case 4U:
        return "STOPPED";
    case 5U:
        return "OPERATIONAL";
    case 127U:
        return "PRE-OPERATIONAL";
    default:
        return "state " + std::to_string(state);
    }
}

/// Bits from `first` on, the lowest first; bits that the frame has not are 0.
std::uint64_t BitsAt(const LogFrame& frame, const std::uint32_t first, const std::uint32_t count)
{
    std::uint64_t value = 0U;
    for (std::uint32_t bit = 0U; bit < std::min(count, 64U); ++bit)
    {
        const std::uint32_t place = first + bit;
        const bool is_set =
            place / kByteBits < frame.length && ((frame.data.at(place / kByteBits) >> (place % kByteBits)) & 1U) != 0U;
        value |= is_set ? std::uint64_t{1U} << bit : 0U;
    }
    return value;
}

std::string Kind(const LogFrame& frame)
{
    if (frame.is_error)
    {
        return "error frame ";
    }
    return std::string(frame.is_extended ? "29 bits " : "") + (frame.is_fd ? "CAN FD " : "") +
           (frame.is_remote ? "remote " : "");
}
} // namespace

Decoder::Decoder(const Network& network, const Analysis& analysis) noexcept : network_(network), analysis_(analysis)
{
}

std::string Decoder::Decode(const LogFrame& frame)
{
    const Service service = analysis_.ServiceOf(frame);
    const std::string head = IdentifierText(frame) + " [" + std::to_string(frame.length) + "] " + DataText(frame) +
                             (frame.length != 0U && !frame.is_remote ? "  " : " ");
    if (service == Service::kForeign)
    {
        return head + Kind(frame);
    }
    const std::string name = head + ServiceName(service) + " " + Kind(frame);
    switch (service)
    {
    case Service::kNmt:
        return frame.length == 2U && frame.IsPlain()
                   ? name + Command(frame.data[0]) + ", " +
                         (frame.data[1] == 0U ? "all nodes" : network_.NameOf(frame.data[1]))
                   : name + "of wrong length";
    case Service::kGfc:
        return name + (frame.length == 0U ? "global fail-safe command" : "with data, nobody counts it");
    case Service::kEmergency:
        return name + Emergency(frame);
    case Service::kErrorControl:
        return name + ErrorControl(frame);
    case Service::kPdo:
        return name + Pdo(frame);
    case Service::kSrdo:
        return name + Srdo(frame);
    case Service::kSdo:
        return name + Sdo(frame);
    case Service::kSync:
    case Service::kTime:
    case Service::kLss:
    case Service::kOther:
    case Service::kForeign:
        break;
    }
    return name;
}

std::string Decoder::Emergency(const LogFrame& frame) const
{
    std::string name = "node " + std::to_string(frame.identifier & kNodes);
    for (const NodeModel& node : network_.Nodes())
    {
        name = node.emergency_id == frame.identifier ? node.name : name;
    }
    if (frame.length != kClassicalBytes)
    {
        return name + " of wrong length";
    }
    const auto code = static_cast<std::uint32_t>(BitsAt(frame, 0U, 16U));
    return name + " " + (code == 0U ? "no error" : "error " + cia306::Hex(code, 4).substr(2U) + "h") + ", register " +
           cia306::Hex(frame.data[2], 2).substr(2U) + "h";
}

std::string Decoder::ErrorControl(const LogFrame& frame) const
{
    const std::string name = network_.NameOf(static_cast<std::uint8_t>(frame.identifier & kNodes));
    if (frame.is_remote)
    {
        return "guarding request, " + name;
    }
    if (frame.length != 1U)
    {
        return name + " of wrong length";
    }
    const bool is_boot_up = frame.data[0] == 0U;
    return name + (is_boot_up ? " " : " is ") + StateName(frame.data[0] & 0x7FU);
}

std::string Decoder::Pdo(const LogFrame& frame) const
{
    // Who sends it knows best; else who receives it.
    const PdoModel* found = nullptr;
    for (const PdoModel& pdo : network_.Pdos())
    {
        const bool is_better = found == nullptr || (pdo.is_transmit && !found->is_transmit);
        found = pdo.identifier == frame.identifier && is_better ? &pdo : found;
    }
    if (found == nullptr)
    {
        return "";
    }
    const NodeModel& node = network_.Nodes()[found->node];
    return node.name + (found->is_transmit ? " TPDO " : " RPDO ") + std::to_string(found->number) + ": " +
           FieldsText(node, found->fields, frame);
}

std::string Decoder::Srdo(const LogFrame& frame) const
{
    for (const WatchModel& watch : network_.Watches())
    {
        const bool is_normal = watch.setup.normal_id == frame.identifier;
        if (!is_normal && watch.setup.inverse_id != frame.identifier)
        {
            continue;
        }
        const SrdoEnd end = watch.consumer.value_or(watch.producer.value_or(SrdoEnd{}));
        const std::string half = is_normal ? " normal: " : " inverse";
        return network_.NameOf(watch) + half +
               (is_normal ? FieldsText(network_.Nodes()[end.node], watch.fields, frame) : "");
    }
    return (frame.identifier & 1U) != 0U ? "normal, of no file" : "inverse, of no file";
}

std::string Decoder::ObjectText(const std::uint8_t node_id, const std::uint16_t index, const std::uint8_t sub) const
{
    const NodeModel* const node = network_.Find(node_id);
    const cia306::Object* const object = node == nullptr ? nullptr : node->device.Find(index);
    const cia306::Entry* const entry = node == nullptr ? nullptr : node->device.Find(index, sub);
    std::string name = object == nullptr ? "" : object->name;
    const bool says_more = entry != nullptr && !entry->name.empty() && entry->name != name;
    name += says_more ? (name.empty() ? "" : ", ") + entry->name : "";
    return AddressText(index, sub) + (name.empty() ? "" : " " + cia306::Printable(name));
}

std::string Decoder::FieldsText(const NodeModel& node, const std::vector<MappedField>& fields,
                                const LogFrame& frame) const
{
    std::string text;
    std::uint32_t bit = 0U;
    for (const MappedField& field : fields)
    {
        if (bit + field.bits > frame.length * 8U)
        {
            return text + (text.empty() ? "" : ", ") + "frame too short for the rest";
        }
        const cia306::Entry* const entry = node.device.Find(field.index, field.sub);
        const cia306::Object* const object = node.device.Find(field.index);
        const bool has_name = entry != nullptr && !entry->name.empty();
        const std::string name = has_name ? entry->name : (object != nullptr ? object->name : "");
        text += (text.empty() ? "" : ", ") +
                (name.empty() ? AddressText(field.index, field.sub) : cia306::Printable(name)) + " = " +
                ValueText(entry, BitsAt(frame, bit, field.bits), field.bits);
        bit += field.bits;
    }
    return text;
}
} // namespace counterpoint::monitor
