// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// SDO frames in words, and values by their types.
#include "canopen/monitor/decoder.hpp"

#include "canopen/monitor/texts.hpp"

#include <array>
#include <cstring>
#include <utility>

namespace counterpoint::monitor
{
namespace
{
constexpr std::uint32_t kRequests = 0x600U;
constexpr std::uint32_t kNodes = 0x7FU;
constexpr std::uint8_t kAbort = 0x80U;
constexpr std::uint8_t kLastSegment = 0x80U;

std::uint32_t Number32(const LogFrame& frame, const std::size_t at)
{
    return static_cast<std::uint32_t>(frame.data.at(at)) | (static_cast<std::uint32_t>(frame.data.at(at + 1U)) << 8U) |
           (static_cast<std::uint32_t>(frame.data.at(at + 2U)) << 16U) |
           (static_cast<std::uint32_t>(frame.data.at(at + 3U)) << 24U);
}

constexpr std::array<std::pair<std::uint32_t, const char*>, 30U> kAborts{{
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
}};
} // namespace

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
    return is_decimal ? std::to_string(value) : cia306::Hex(value, static_cast<int>((bits + 3U) / 4U));
}

std::string Decoder::Sdo(const LogFrame& frame)
{
    const auto node_id = static_cast<std::uint8_t>(frame.identifier & kNodes);
    const bool is_request = frame.identifier > kRequests;
    const std::string name = network_.NameOf(node_id) + (is_request ? " <- " : " -> ");
    if (frame.length != kClassicalBytes || !frame.IsPlain())
    {
        return name + "of wrong length";
    }
    Transfer& transfer = transfers_.at(node_id);
    const bool is_abort = frame.data[0] == kAbort;
    const bool is_segment_of_block = transfer.is_block && transfer.is_upload != is_request && !is_abort;
    if (is_segment_of_block)
    {
        transfer.has_last = (frame.data[0] & kLastSegment) != 0U;
        transfer.is_block = !transfer.has_last;
        return name + "segment " + std::to_string(frame.data[0] & 0x7FU) + " of a block of " +
               ObjectText(node_id, transfer.index, transfer.sub);
    }
    const std::uint32_t command = frame.data[0] >> 5U;
    const bool is_block = command >= 5U;
    if (is_abort)
    {
        transfer.is_block = false;
        return name + "abort " + AbortText(Number32(frame, 4U)) + ", " +
               ObjectText(node_id, static_cast<std::uint16_t>(frame.data[1] | (frame.data[2] << 8U)), frame.data[3]);
    }
    return name + (is_block ? SdoBlock(frame, transfer, is_request) : SdoBegin(frame, transfer, is_request));
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
        return "segment of " + ObjectText(node_id, transfer.index, transfer.sub);
    }
    transfer = Transfer{};
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
        const std::uint64_t value = Number32(frame, 4U) & (0xFFFFFFFFU >> (32U - 8U * bytes));
        text += " = " + ValueText(node == nullptr ? nullptr : node->device.Find(transfer.index, transfer.sub), value,
                                  8U * bytes);
    }
    else if (has_data && is_stated)
    {
        text += ", " + std::to_string(Number32(frame, 4U)) + " bytes";
    }
    return text;
}

std::string Decoder::SdoBlock(const LogFrame& frame, Transfer& transfer, const bool is_request) const
{
    const auto node_id = static_cast<std::uint8_t>(frame.identifier & kNodes);
    const std::uint32_t command = frame.data[0] >> 5U;
    const std::uint32_t part = frame.data[0] & 3U;
    // Download: client 6, server 5. Upload: client 5, server 6.
    const bool is_download = is_request ? command == 6U : command == 5U;
    const bool is_begin = is_download ? (frame.data[0] & 1U) == 0U && (is_request || part == 0U) : part == 0U;
    const bool is_end = is_download ? (frame.data[0] & 1U) != 0U : part == 1U;
    if (is_begin)
    {
        transfer = Transfer{};
        transfer.index = static_cast<std::uint16_t>(frame.data[1] | (frame.data[2] << 8U));
        transfer.sub = frame.data[3];
        transfer.is_upload = !is_download;
    }
    // Segments follow the server's answer to a download, the client's start of an upload.
    const bool goes = is_download ? !is_request && !is_end : is_request && part == 3U;
    transfer.is_block = (goes && !transfer.has_last) || (transfer.is_block && !is_end);
    const std::string kind = is_begin ? "begin of" : (is_end ? "end of" : "acknowledge in");
    return kind + " a block " + (is_download ? "write of " : "read of ") +
           ObjectText(node_id, transfer.index, transfer.sub);
}
} // namespace counterpoint::monitor
