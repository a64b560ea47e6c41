// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/monitor/readers.hpp"

#include <utility>

namespace counterpoint::monitor
{
namespace
{
constexpr std::uint32_t kMicrosecondMagic = 0xA1B2C3D4U;
constexpr std::uint32_t kNanosecondMagic = 0xA1B23C4DU;
// The number of the link type has bits of another meaning above it: whether a check sequence stands behind each packet,
// and its length in units of two bytes.
constexpr std::uint32_t kLinkTypeMask = 0x03FFFFFFU;
constexpr std::uint32_t kCheckFlag = 0x04000000U;
constexpr std::uint32_t kCheckLengthShift = 28U;
constexpr std::size_t kFileHead = 24U;
constexpr std::size_t kPacketHead = 16U;

// A packet of SocketCAN: identifier and flags in network order, length, flags of CAN FD, two bytes, data.
constexpr std::size_t kFrameHead = 8U;
constexpr std::size_t kClassicalPacket = 16U;
constexpr std::size_t kFdPacket = 72U;
constexpr std::uint32_t kExtendedFlag = 0x80000000U;
constexpr std::uint32_t kRemoteFlag = 0x40000000U;
constexpr std::uint32_t kErrorFlag = 0x20000000U;
constexpr std::uint32_t kExtendedMask = 0x1FFFFFFFU;
constexpr std::uint32_t kStandardMask = 0x7FFU;
constexpr std::uint8_t kFdFlag = 0x04U;

bool IsBigEndian(const std::string_view bytes) noexcept
{
    const std::uint32_t magic = CaptureBytes(bytes, true).Number32(0U);
    return magic == kMicrosecondMagic || magic == kNanosecondMagic;
}

// What stands before a CAN frame in captures of Linux.
constexpr std::uint16_t kProtocolCan = 0x000CU;
constexpr std::uint16_t kProtocolCanFd = 0x000DU;
constexpr std::size_t kCookedHead = 16U;
constexpr std::size_t kCookedProtocol = 14U;
constexpr std::size_t kCooked2Head = 20U;
constexpr std::size_t kCooked2Protocol = 0U;
constexpr std::size_t kCooked2Interface = 4U;

/// The packet of CAN_SOCKETCAN that a cooked one holds: the identifier in network order.
std::string SocketCanOf(std::string_view packet, const bool is_big_endian)
{
    std::string bytes(packet);
    if (!is_big_endian)
    {
        std::swap(bytes[0U], bytes[3U]);
        std::swap(bytes[1U], bytes[2U]);
    }
    return bytes;
}
} // namespace

std::optional<cia306::Problem> ReadSocketCan(const std::string_view packet, const bool is_of_fd, LogFrame& frame)
{
    if (packet.size() < kFrameHead)
    {
        return cia306::Problem{"packet of " + std::to_string(packet.size()) + " bytes", "at least 8"};
    }
    const std::uint32_t word = CaptureBytes(packet, true).Number32(0U);
    const auto length = static_cast<std::uint8_t>(packet[4U]);
    const auto flags = static_cast<std::uint8_t>(packet[5U]);
    frame.is_error = (word & kErrorFlag) != 0U;
    frame.is_extended = (word & kExtendedFlag) != 0U && !frame.is_error;
    frame.is_remote = (word & kRemoteFlag) != 0U && !frame.is_error;
    const bool is_long = length > kClassicalBytes || packet.size() == kFdPacket;
    frame.is_fd = is_of_fd || is_long || (flags & kFdFlag) != 0U;
    frame.identifier = word & kExtendedMask;
    const bool is_wide = frame.is_extended || frame.is_error;
    if (!is_wide && frame.identifier > kStandardMask)
    {
        return cia306::Problem{"identifier " + cia306::Hex(frame.identifier, 8) + " without the mark of 29 bits",
                               "at most 0x7FF"};
    }
    const std::size_t most = frame.is_fd ? kMostDataBytes : kClassicalBytes;
    const std::size_t data = frame.is_remote ? 0U : length;
    const bool fits = length <= most && packet.size() >= kFrameHead + data &&
                      packet.size() <= (frame.is_fd ? kFdPacket : kClassicalPacket);
    if (!fits)
    {
        return cia306::Problem{"frame of " + std::to_string(length) + " bytes in a packet of " +
                                   std::to_string(packet.size()) + " bytes",
                               "8 bytes and the data of the frame, " + std::to_string(most) + " at most"};
    }
    frame.length = length;
    for (std::size_t place = 0U; place < data; ++place)
    {
        frame.data[place] = static_cast<std::uint8_t>(packet[kFrameHead + place]);
    }
    return std::nullopt;
}

bool IsReadable(const std::uint32_t link_type) noexcept
{
    return link_type == kLinkSocketCan || link_type == kLinkCooked || link_type == kLinkCooked2;
}

const char* ReadableLinkTypes() noexcept
{
    return "227 (CAN_SOCKETCAN), 113 or 276 (Linux cooked)";
}

std::string DoubtOf(const std::uint32_t link_type)
{
    return link_type == kLinkCooked
               ? "link type 113 (SLL) does not tell interfaces apart: what is judged as one bus may be several"
               : "";
}

PacketResult ReadPacketOf(const std::uint32_t link_type, const std::string_view packet, const bool is_big_endian,
                          LogFrame& frame)
{
    if (link_type == kLinkSocketCan)
    {
        return {true, ReadSocketCan(packet, false, frame), {}};
    }
    const bool is_second = link_type == kLinkCooked2;
    const std::size_t head = is_second ? kCooked2Head : kCookedHead;
    if (packet.size() < head)
    {
        return {false,
                cia306::Problem{"cooked packet of " + std::to_string(packet.size()) + " bytes",
                                "at least " + std::to_string(head)},
                {}};
    }
    const std::uint16_t protocol = CaptureBytes(packet, true).Number16(is_second ? kCooked2Protocol : kCookedProtocol);
    if (protocol != kProtocolCan && protocol != kProtocolCanFd)
    {
        return {false, std::nullopt, {}};
    }
    const std::string_view rest = packet.substr(head);
    const std::string bytes = rest.size() < 4U ? std::string(rest) : SocketCanOf(rest, is_big_endian);
    PacketResult result{true, ReadSocketCan(bytes, protocol == kProtocolCanFd, frame), {}};
    if (is_second)
    {
        result.interface = CaptureBytes(packet, true).Number32(kCooked2Interface);
    }
    return result;
}

PcapReader::PcapReader(std::string file, const std::string_view bytes, const RecordingOptions& options)
    : file_(std::move(file)), bytes_(bytes, bytes.size() >= 4U && IsBigEndian(bytes)), fraction_(kMicrosecond),
      choice_(options.interface)
{
    if (bytes.size() < kFileHead)
    {
        Refuse({"file of " + std::to_string(bytes.size()) + " bytes", "a pcap header of 24"});
    }
    fraction_ = bytes_.Number32(0U) == kNanosecondMagic ? 1 : kMicrosecond;
    const std::uint32_t link_word = bytes_.Number32(20U);
    const std::uint32_t link_type = link_word & kLinkTypeMask;
    const std::uint32_t version = bytes_.Number16(4U);
    if (version != 2U)
    {
        Refuse({"pcap version " + std::to_string(version), "2"});
    }
    if (!IsReadable(link_type))
    {
        Refuse({"link type " + std::to_string(link_type), ReadableLinkTypes()});
    }
    link_type_ = link_type;
    check_bytes_ = (link_word & kCheckFlag) == 0U ? 0U : (link_word >> kCheckLengthShift) * 2U;
    at_ = kFileHead;
    RequireNames(options.interface);
}

/// What would be ignored is refused. [SRS_MON_042]
void PcapReader::RequireNames(const std::string& wanted) const
{
    if (wanted.empty())
    {
        return;
    }
    if (link_type_ != kLinkCooked2)
    {
        Refuse({"--interface " + cia306::Quoted(wanted) + " with pcap of link type " + std::to_string(link_type_) +
                    ", which tells of no frame its interface",
                "no --interface, or a recording of candump, pcapng or link type 276 (SLL2)"});
    }
    if (wanted.find_first_not_of("0123456789") != std::string::npos)
    {
        Refuse({"--interface " + cia306::Quoted(wanted) + " with pcap of link type 276 (SLL2), which has no names",
                "the index of an interface, which is a number"});
    }
}

Origin PcapReader::Seen() const
{
    Origin origin = choice_.Seen();
    origin.doubt = DoubtOf(link_type_);
    return origin;
}

std::size_t PcapReader::Place() const noexcept
{
    return packet_;
}

void PcapReader::Refuse(const cia306::Problem& problem) const
{
    throw cia306::InputError(file_, {packet_, 0U}, problem);
}

bool PcapReader::Next(LogFrame& frame)
{
    bool is_frame = false;
    while (!is_frame && at_ != bytes_.Size())
    {
        is_frame = ReadPacket(frame);
    }
    return is_frame;
}

/// Whether the frame is of the interface that is looked at; all are where nothing tells.
bool PcapReader::Takes(const PacketResult& result, const LogFrame& frame)
{
    const std::string index = result.interface ? std::to_string(*result.interface) : "";
    return choice_.Takes(index, {index}, frame.time);
}

/// Whether it was a frame, of the interface that is looked at.
bool PcapReader::ReadPacket(LogFrame& frame)
{
    ++packet_;
    if (bytes_.Size() - at_ < kPacketHead)
    {
        Refuse({"the file ends in the head of packet " + std::to_string(packet_), "16 bytes"});
    }
    frame = LogFrame{};
    const Time fraction = bytes_.Number32(at_ + 4U);
    frame.time = static_cast<Time>(bytes_.Number32(at_)) * kSecond + fraction * fraction_;
    const std::size_t captured = bytes_.Number32(at_ + 8U);
    const std::size_t original = bytes_.Number32(at_ + 12U);
    at_ += kPacketHead;
    const bool is_whole = captured == original && captured <= bytes_.Size() - at_ && fraction * fraction_ < kSecond;
    if (!is_whole)
    {
        Refuse({"packet " + std::to_string(packet_) + " has " + std::to_string(captured) + " of " +
                    std::to_string(original) + " bytes, " + std::to_string(bytes_.Size() - at_) + " are left",
                "whole packets with a fraction below a second"});
    }
    if (captured < check_bytes_)
    {
        Refuse({"packet " + std::to_string(packet_) + " of " + std::to_string(captured) + " bytes",
                "a check sequence of " + std::to_string(check_bytes_) + " bytes in it, which the file tells of"});
    }
    const PacketResult result =
        ReadPacketOf(link_type_, bytes_.Part(at_, captured - check_bytes_), bytes_.IsBigEndian(), frame);
    if (result.problem)
    {
        Refuse(*result.problem);
    }
    at_ += captured;
    if (!result.is_frame || !Takes(result, frame))
    {
        return false;
    }
    if (frame.time < last_)
    {
        Refuse({"packet " + std::to_string(packet_) + " is before the one before it", "times that do not go back"});
    }
    last_ = frame.time;
    return true;
}
} // namespace counterpoint::monitor
