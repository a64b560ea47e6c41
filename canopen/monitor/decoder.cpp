// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/monitor/decoder.hpp"

#include "canopen/monitor/texts.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <utility>

namespace counterpoint::monitor
{
namespace
{
constexpr std::uint32_t kNodes = 0x7FU;
constexpr std::uint32_t kByteBits = 8U;

using NumberRow = std::pair<std::uint32_t, const char*>;

constexpr NumberRow kCommands[] = {
    {1U, "start"}, {2U, "stop"}, {128U, "enter PRE-OPERATIONAL"}, {129U, "reset node"}, {130U, "reset communication"}};
constexpr NumberRow kStates[] = {{0U, "boot-up"}, {4U, "STOPPED"}, {5U, "OPERATIONAL"}, {127U, "PRE-OPERATIONAL"}};

/// CiA 302-2: who is the NMT master.
constexpr NumberRow kFlyingMaster[] = {
    {0x71U, "active NMT master"},       {0x72U, "begins the negotiation"}, {0x73U, "asks for the active NMT master"},
    {0x74U, "could be the NMT master"}, {0x75U, "asks who could be"},      {0x76U, "forces a new negotiation"}};
constexpr std::uint32_t kActiveMaster = 0x71U;

struct PredefinedPdo
{
    std::uint32_t identifier;
    const char* name;
};
constexpr PredefinedPdo kPredefinedPdos[] = {{0x180U, "TPDO 1"}, {0x200U, "RPDO 1"}, {0x280U, "TPDO 2"},
                                             {0x300U, "RPDO 2"}, {0x380U, "TPDO 3"}, {0x400U, "RPDO 3"},
                                             {0x480U, "TPDO 4"}, {0x500U, "RPDO 4"}};

/// The word of a number; of an unknown one the number behind `kind`.
template <std::size_t kCount>
std::string WordOf(const NumberRow (&rows)[kCount], const std::uint32_t number, const std::string& kind)
{
    const auto* const row = std::find_if(std::begin(rows), std::end(rows),
                                         [number](const NumberRow& each) { return each.first == number; });
    return row == std::end(rows) ? kind + " " + std::to_string(number) : row->second;
}

/// Bits from `first` on, the lowest first; the frame has them, checked by the caller.
std::uint64_t BitsAt(const LogFrame& frame, const std::uint32_t first, const std::uint32_t count)
{
    std::uint64_t value = 0U;
    for (std::uint32_t bit = 0U; bit < std::min(count, 64U); ++bit)
    {
        const std::uint32_t place = first + bit;
        const bool is_set = ((frame.data.at(place / kByteBits) >> (place % kByteBits)) & 1U) != 0U;
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

constexpr std::uint32_t kRequests = 0x600U;
constexpr std::uint32_t kSegmentNumber = 0x7FU;
constexpr std::uint8_t kAbort = 0x80U;
constexpr std::uint32_t kAbortCommand = 4U;
constexpr std::uint32_t kLastCommand = 6U;
constexpr std::uint8_t kLastSegment = 0x80U;
constexpr std::uint8_t kTimeBytes = 6U;
constexpr const char* kWrongLength = "INVALID: of wrong length";

bool IsFlyingMaster(const std::uint32_t identifier)
{
    return identifier >= kFlyingMaster[0].first && identifier <= 0x76U;
}

/// A remote frame has no value, and asks for something only where it is one of a PDO or of guarding. [SRS_MON_019]
bool AsksForNothing(const LogFrame& frame, const Service service)
{
    const bool is_request = service == Service::kErrorControl || service == Service::kPdo ||
                            (service == Service::kOther && !IsFlyingMaster(frame.identifier));
    return frame.is_remote && !is_request;
}

constexpr NumberRow kAborts[] = {
    {0x05030000U, "toggle bit not alternated"},
    {0x05040000U, "time-out"},
    {0x05040001U, "command not valid"},
    {0x05040002U, "block size"},
    {0x05040003U, "sequence number"},
    {0x05040004U, "CRC"},
    {0x05040005U, "out of memory"},
    {0x06010000U, "access not supported"},
    {0x06010001U, "write only"},
    {0x06010002U, "read only"},
    {0x06020000U, "no such object"},
    {0x06040041U, "not mappable"},
    {0x06040042U, "mapping too long"},
    {0x06040043U, "parameters not compatible"},
    {0x06040047U, "internal"},
    {0x06060000U, "hardware"},
    {0x06070010U, "wrong length"},
    {0x06070012U, "too long"},
    {0x06070013U, "too short"},
    {0x06090011U, "no such sub-index"},
    {0x06090030U, "value out of range"},
    {0x06090031U, "value too high"},
    {0x06090032U, "value too low"},
    {0x06090036U, "limits contradict"},
    {0x060A0023U, "no connection"},
    {0x08000000U, "general error"},
    {0x08000020U, "not stored"},
    {0x08000021U, "local control"},
    {0x08000022U, "not in this state"},
    {0x08000024U, "no data"},
};

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
    if (AsksForNothing(frame, service))
    {
        return name + "INVALID: no data frame";
    }
    switch (service)
    {
    case Service::kNmt:
        return name + Nmt(frame);
    case Service::kGfc:
        return name + (frame.length == 0U ? "global fail-safe command" : "INVALID: with data");
    case Service::kEmergency:
        return name + Emergency(frame);
    case Service::kErrorControl:
        return name + ErrorControlText(frame);
    case Service::kPdo:
        return name + Pdo(frame);
    case Service::kSrdo:
        return name + Srdo(frame);
    case Service::kSdo:
        return name + Sdo(frame);
    case Service::kSync:
        return name + (frame.length <= 1U ? "" : kWrongLength);
    case Service::kTime:
        return name + (frame.length == kTimeBytes ? "" : kWrongLength);
    case Service::kLss:
        return name + (frame.length == kClassicalBytes ? "" : kWrongLength);
    case Service::kForeign: // It was told above.
    case Service::kOther:
        break;
    }
    return name + Other(frame);
}

/// A command that no device obeys is marked. [SRS_MON_019]
std::string Decoder::Nmt(const LogFrame& frame) const
{
    if (frame.length != 2U)
    {
        return kWrongLength;
    }
    const bool is_node = frame.data[1] <= kNodes;
    const bool is_command = std::any_of(std::begin(kCommands), std::end(kCommands),
                                        [&frame](const NumberRow& row) { return row.first == frame.data[0]; });
    const std::string node = (frame.data[1] == 0U)
                                 ? "all nodes"
                                 : (is_node ? network_.NameOf(frame.data[1]) : "node " + std::to_string(frame.data[1]));
    return (is_node && is_command ? "" : "INVALID: ") + WordOf(kCommands, frame.data[0], "command") + ", " + node;
}

/// What the identifier means by itself: flying master, PDOs of the predefined connection set. [SRS_MON_019]
std::string Decoder::Other(const LogFrame& frame) const
{
    if (IsFlyingMaster(frame.identifier))
    {
        return "flying master: " + FlyingMaster(frame);
    }
    for (const PredefinedPdo& pdo : kPredefinedPdos)
    {
        if (frame.identifier > pdo.identifier && frame.identifier <= pdo.identifier + kNodes)
        {
            return (frame.is_remote ? "request of " : "") + std::string(pdo.name) + " of " +
                   network_.NameOf(static_cast<std::uint8_t>(frame.identifier - pdo.identifier)) +
                   ", by its identifier";
        }
    }
    return "";
}

/// What no flying master obeys is marked. [SRS_MON_531]
std::string Decoder::FlyingMaster(const LogFrame& frame) const
{
    const bool has_node = frame.identifier == kActiveMaster;
    if (frame.length != (has_node ? 2U : 0U))
    {
        return kWrongLength;
    }
    const std::string word = WordOf(kFlyingMaster, frame.identifier, "");
    const bool is_node = !has_node || (frame.data[1] >= 1U && frame.data[1] <= kNodes);
    return (is_node ? "" : "INVALID: ") + word +
           (has_node ? " is " + network_.NameOf(frame.data[1]) + ", priority " + std::to_string(frame.data[0]) : "");
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
        return name + " " + kWrongLength;
    }
    const auto code = static_cast<std::uint32_t>(BitsAt(frame, 0U, 16U));
    return name + " " + (code == 0U ? "no error" : "error " + cia306::Hex(code, 4).substr(2U) + "h") + ", register " +
           cia306::Hex(frame.data[2], 2).substr(2U) + "h";
}

std::string Decoder::ErrorControlText(const LogFrame& frame)
{
    const ErrorControlFrame told = error_control_.Take(frame);
    const std::string name = network_.NameOf(told.node_id);
    if (told.is_request)
    {
        return "guarding request, " + name;
    }
    if (!told.has_length)
    {
        return name + " " + kWrongLength;
    }
    const std::string state =
        told.is_state ? WordOf(kStates, told.state, "state") : "state " + std::to_string(told.state);
    return (told.is_answer ? "guarding answer, " : "") + name + (told.is_boot_up ? " " : " is ") +
           (told.is_state ? "" : "INVALID: ") + state +
           (told.is_answer || told.toggle != 0U ? ", toggle " + std::to_string(told.toggle) : "") +
           (told.is_alternated ? "" : ", INVALID: not alternated");
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
    const std::string name = node.name + (found->is_transmit ? " TPDO " : " RPDO ") + std::to_string(found->number);
    return frame.is_remote ? "request of " + name : name + ": " + FieldsText(node, found->fields, frame);
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
    const std::string half = (frame.identifier & 1U) != 0U ? "normal, of " : "inverse, of ";
    for (const NodeModel& node : network_.Nodes())
    {
        for (const cia306::SrdoConfiguration& srdo : node.safety.srdos)
        {
            if (srdo.cob_id_1.Is(frame.identifier) || srdo.cob_id_2.Is(frame.identifier))
            {
                return half + node.name + " SRDO " + std::to_string(srdo.number) + ", which is not active";
            }
        }
    }
    return half + "no file";
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

std::string AbortText(const std::uint32_t code)
{
    std::string text = cia306::Hex(code >> 16U, 4).substr(2U) + " " + cia306::Hex(code & 0xFFFFU, 4).substr(2U) + "h";
    for (const auto& [number, meaning] : kAborts)
    {
        text += number == code ? " (" + std::string(meaning) + ")" : "";
    }
    return text;
}

std::string ValueText(const cia306::Entry* const entry, const std::uint64_t value, const std::uint32_t bits)
{
    const cia306::DataKind kind = entry == nullptr ? cia306::DataKind::kUnknown : entry->type.kind;
    if (kind == cia306::DataKind::kSigned && bits >= 1U && bits <= 64U)
    {
        const std::uint64_t sign = std::uint64_t{1U} << (bits - 1U);
        return std::to_string(static_cast<std::int64_t>((value ^ sign) - sign));
    }
    if (kind == cia306::DataKind::kReal && bits == 32U)
    {
        const auto pattern = static_cast<std::uint32_t>(value);
        float number = 0.0F;
        std::memcpy(&number, &pattern, sizeof(number));
        return std::to_string(static_cast<double>(number));
    }
    if (kind == cia306::DataKind::kReal && bits == 64U)
    {
        double number = 0.0;
        std::memcpy(&number, &value, sizeof(number));
        return std::to_string(number);
    }
    const bool is_decimal = kind == cia306::DataKind::kBoolean || kind == cia306::DataKind::kUnsigned;
    return is_decimal ? std::to_string(value) : cia306::Hex(value, static_cast<int>((std::max(bits, 1U) + 3U) / 4U));
}

std::string Decoder::Sdo(const LogFrame& frame)
{
    const auto node_id = static_cast<std::uint8_t>(frame.identifier & kNodes);
    const bool is_request = frame.identifier > kRequests;
    const std::string name = network_.NameOf(node_id) + (is_request ? " <- " : " -> ");
    if (frame.length != kClassicalBytes)
    {
        return name + kWrongLength;
    }
    Transfer& transfer = transfers_.at(node_id);
    if (transfer.is_block && transfer.is_upload != is_request && frame.data[0] != kAbort)
    {
        return name + SegmentOfBlock(frame, transfer);
    }
    const std::uint32_t command = frame.data[0] >> 5U;
    if (command == kAbortCommand)
    {
        transfer.is_block = false;
        return name + "abort " + AbortText(static_cast<std::uint32_t>(BitsAt(frame, 32U, 32U))) + ", " +
               ObjectText(node_id, static_cast<std::uint16_t>(frame.data[1] | (frame.data[2] << 8U)), frame.data[3]);
    }
    // The answer to a block write has no fourth part.
    const bool is_known = command <= kLastCommand && (is_request || (frame.data[0] & 0xE3U) != 0xA3U);
    if (!is_known)
    {
        return name + "INVALID: command " + cia306::Hex(frame.data[0], 2).substr(2U) + "h";
    }
    return name +
           (command > kAbortCommand ? SdoBlock(frame, transfer, is_request) : SdoBegin(frame, transfer, is_request));
}

/// All bits of the command are the number of the segment, from 1 on, and whether it is the last one. [SRS_MON_330]
std::string Decoder::SegmentOfBlock(const LogFrame& frame, Transfer& transfer) const
{
    const std::uint32_t number = frame.data[0] & kSegmentNumber;
    transfer.has_last = (frame.data[0] & kLastSegment) != 0U;
    transfer.last_number = transfer.has_last ? number : 0U;
    transfer.is_block = !transfer.has_last;
    return std::string(number == 0U ? "INVALID: " : "") + "segment " + std::to_string(number) + " of a block of " +
           TransferText(frame, transfer);
}

/// A recording may begin within a transfer, which names its object at its begin alone. [SRS_MON_331]
std::string Decoder::TransferText(const LogFrame& frame, const Transfer& transfer) const
{
    return transfer.is_known
               ? ObjectText(static_cast<std::uint8_t>(frame.identifier & kNodes), transfer.index, transfer.sub)
               : "an object that is not known";
}

/// Commands 0 to 3: a segment, or the begin of an expedited or segmented transfer.
std::string Decoder::SdoBegin(const LogFrame& frame, Transfer& transfer, const bool is_request)
{
    const auto node_id = static_cast<std::uint8_t>(frame.identifier & kNodes);
    const std::uint32_t command = frame.data[0] >> 5U;
    // Requests: 0 segment down, 1 begin down, 2 begin up, 3 segment up. Answers: 0 segment up, 1 segment down, 2 begin
    // up, 3 begin down.
    const bool is_begin = is_request ? command == 1U || command == 2U : command >= 2U;
    if (!is_begin)
    {
        return "segment of " + TransferText(frame, transfer);
    }
    transfer = Transfer{};
    transfer.is_known = true;
    transfer.index = static_cast<std::uint16_t>(frame.data[1] | (frame.data[2] << 8U));
    transfer.sub = frame.data[3];
    const bool is_write = is_request ? command == 1U : command == 3U;
    const bool has_data = is_request ? is_write : !is_write;
    std::string text = (is_write ? (is_request ? "write " : "written ") : (is_request ? "read " : "value ")) +
                       ObjectText(node_id, transfer.index, transfer.sub);
    const bool is_expedited = (frame.data[0] & 0x02U) != 0U;
    const bool is_stated = (frame.data[0] & 0x01U) != 0U;
    if (has_data && is_expedited)
    {
        const std::uint32_t bytes = is_stated ? 4U - ((frame.data[0] >> 2U) & 3U) : 4U;
        const NodeModel* const node = network_.Find(node_id);
        const std::uint64_t value = BitsAt(frame, 32U, 8U * bytes);
        text += " = " + ValueText(node == nullptr ? nullptr : node->device.Find(transfer.index, transfer.sub), value,
                                  8U * bytes);
    }
    else if (has_data && is_stated)
    {
        text += ", " + std::to_string(BitsAt(frame, 32U, 32U)) + " bytes";
    }
    return text;
}

std::string Decoder::SdoBlock(const LogFrame& frame, Transfer& transfer, const bool is_request) const
{
    const std::uint32_t command = frame.data[0] >> 5U;
    const std::uint32_t part = frame.data[0] & 3U;
    // Download: client 6, server 5. Upload: client 5, server 6.
    const bool is_download = is_request ? command == 6U : command == 5U;
    // Command 6 has one bit for begin and end, behind it whether a size is stated; command 5 has two bits.
    const std::uint32_t step = command == 6U ? part & 1U : part;
    const bool is_begin = step == 0U;
    const bool is_end = step == 1U;
    const bool is_acknowledge = step == 2U;
    if (is_begin)
    {
        transfer = Transfer{};
        transfer.is_known = true;
        transfer.index = static_cast<std::uint16_t>(frame.data[1] | (frame.data[2] << 8U));
        transfer.sub = frame.data[3];
    }
    transfer.is_upload = !is_download;
    // Who has not taken all of a block gets the rest of it once more.
    const bool is_rest = is_acknowledge && transfer.has_last && frame.data[1] != transfer.last_number;
    transfer.has_last = transfer.has_last && !is_rest;
    // Segments follow the server's answer to a download, the client's start of an upload, and each acknowledgement.
    const bool goes = is_acknowledge || (!is_end && (is_download ? !is_request : part == 3U));
    transfer.is_block = goes && !transfer.has_last;
    const std::string kind =
        is_begin ? "begin of" : (is_end ? "end of" : (is_acknowledge ? "acknowledge in" : "start of"));
    return kind + " a block " + (is_download ? "write of " : "read of ") + TransferText(frame, transfer);
}

} // namespace counterpoint::monitor
