// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/monitor/readers.hpp"

#include <algorithm>
#include <utility>

namespace counterpoint::monitor
{
namespace
{
constexpr std::uint32_t kSectionHead = 0x0A0D0D0AU;
constexpr std::uint32_t kInterface = 1U;
constexpr std::uint32_t kObsoletePacket = 2U;
constexpr std::uint32_t kSimplePacket = 3U;
constexpr std::uint32_t kEnhancedPacket = 6U;
constexpr std::uint32_t kByteOrderMagic = 0x1A2B3C4DU;
constexpr std::size_t kLeastBlock = 12U;
constexpr std::size_t kBlockHead = 8U;
constexpr std::size_t kLeastSection = 28U;
constexpr std::size_t kInterfaceHead = 8U;
constexpr std::size_t kPacketHead = 20U;
constexpr std::size_t kMostInterfaces = 1000U;
constexpr std::uint16_t kOptionName = 2U;
constexpr std::uint16_t kOptionResolution = 9U;
constexpr std::uint16_t kOptionOffset = 14U;
constexpr std::uint8_t kPowerOfTwo = 0x80U;
constexpr std::int64_t kMostSeconds = 4000000000;

std::size_t Padded(const std::size_t count) noexcept
{
    return (count + 3U) / 4U * 4U;
}
} // namespace

PcapngReader::PcapngReader(std::string file, const std::string_view bytes, const RecordingOptions& options)
    : file_(std::move(file)), bytes_(bytes, false), all_(bytes), choice_(options.interface)
{
}

std::size_t PcapngReader::Place() const noexcept
{
    return block_;
}

Origin PcapngReader::Seen() const
{
    Origin origin = choice_.Seen();
    origin.doubt = doubt_;
    return origin;
}

void PcapngReader::Refuse(const cia306::Problem& problem) const
{
    throw cia306::InputError(file_, {block_, 0U},
                             {"block " + std::to_string(block_) + ": " + problem.wrong, problem.expected});
}

/// Takes the byte order of the section that begins here.
void PcapngReader::BeginSection()
{
    if (bytes_.Size() - at_ < kLeastSection)
    {
        Refuse({"the file ends in the head of a section", "28 bytes"});
    }
    bytes_ = CaptureBytes(all_, false);
    if (bytes_.Number32(at_ + kBlockHead) != kByteOrderMagic)
    {
        bytes_ = CaptureBytes(all_, true);
    }
    if (bytes_.Number32(at_ + kBlockHead) != kByteOrderMagic)
    {
        Refuse({"a section without byte order", "1A2B3C4Dh in either order"});
    }
    if (bytes_.Number16(at_ + 12U) != 1U)
    {
        Refuse({"version " + std::to_string(bytes_.Number16(at_ + 12U)), "1"});
    }
    interfaces_.clear();
    ++section_;
}

bool PcapngReader::Next(LogFrame& frame)
{
    while (at_ != bytes_.Size())
    {
        ++block_;
        if (bytes_.Size() - at_ < kLeastBlock)
        {
            Refuse({"the file ends in the head of a block", "12 bytes"});
        }
        const std::uint32_t type = bytes_.Number32(at_); // The head of a section is the same in either order.
        if (type == kSectionHead)
        {
            BeginSection();
        }
        const std::size_t length = bytes_.Number32(at_ + 4U);
        const bool is_whole = length >= kLeastBlock && length % 4U == 0U && length <= bytes_.Size() - at_ &&
                              (type != kSectionHead || length >= kLeastSection);
        if (!is_whole || bytes_.Number32(at_ + length - 4U) != length)
        {
            Refuse({"length of " + std::to_string(length) + " bytes",
                    "a multiple of 4 from 12 on, within the file, and repeated at the end of the block"});
        }
        const std::size_t begin = at_ + kBlockHead;
        const std::size_t end = at_ + length - 4U;
        at_ += length;
        if (type == kInterface)
        {
            ReadInterface(begin, end);
        }
        else if (type == kSimplePacket || type == kObsoletePacket)
        {
            Refuse({"a packet of type " + std::to_string(type), "enhanced packets, which have a time"});
        }
        else if (type == kEnhancedPacket && ReadPacket(begin, end, frame))
        {
            return true;
        }
    }
    return false;
}

void PcapngReader::ReadInterface(const std::size_t begin, const std::size_t end)
{
    const bool fits = end - begin >= kInterfaceHead && interfaces_.size() < kMostInterfaces;
    if (!fits)
    {
        Refuse(
            {"an interface of " + std::to_string(end - begin) + " bytes", "at least 8, and at most 1000 interfaces"});
    }
    Interface interface;
    interface.link_type = bytes_.Number16(begin);
    ReadOptions(begin + kInterfaceHead, end, interface);
    interface.key = interface.name;
    if (interface.name.empty())
    {
        // Nothing tells whether it is one of another section: it counts as another.
        interface.name = std::to_string(interfaces_.size());
        interface.key = "interface " + interface.name + " of section " + std::to_string(section_);
    }
    interfaces_.push_back(interface);
}

void PcapngReader::ReadOptions(std::size_t begin, const std::size_t end, Interface& interface) const
{
    while (end - begin >= 4U)
    {
        const std::uint16_t code = bytes_.Number16(begin);
        const std::size_t length = bytes_.Number16(begin + 2U);
        begin += 4U;
        if (code == 0U)
        {
            return;
        }
        if (Padded(length) > end - begin)
        {
            Refuse({"an option of " + std::to_string(length) + " bytes", "options within their block"});
        }
        const std::string_view value = bytes_.Part(begin, length);
        if (code == kOptionResolution && length == 1U)
        {
            const auto resolution = static_cast<std::uint8_t>(value.front());
            const bool is_binary = (resolution & kPowerOfTwo) != 0U;
            const std::uint32_t power = resolution & 0x7FU;
            if (power > (is_binary ? 62U : 18U))
            {
                Refuse({"a time resolution of " + std::to_string(resolution), "at most 10^-18 or 2^-62 seconds"});
            }
            interface.ticks = 1U;
            for (std::uint32_t step = 0U; step < power; ++step)
            {
                interface.ticks *= is_binary ? 2U : 10U;
            }
        }
        if (code == kOptionOffset && length == 8U)
        {
            interface.offset_s = static_cast<std::int64_t>(bytes_.Number64(begin));
            if (interface.offset_s < -kMostSeconds || interface.offset_s > kMostSeconds)
            {
                Refuse({"a time offset of " + std::to_string(interface.offset_s) + " seconds",
                        "-4 000 000 000 to 4 000 000 000"});
            }
        }
        interface.name = code == kOptionName ? std::string(value) : interface.name;
        begin += Padded(length);
    }
}

Time PcapngReader::TimeOf(const std::uint64_t ticks, const Interface& interface) const
{
    const std::uint64_t own_seconds = ticks / interface.ticks;
    const std::uint64_t rest = ticks % interface.ticks;
    if (own_seconds > static_cast<std::uint64_t>(kMostSeconds))
    {
        Refuse({"a time of " + std::to_string(own_seconds) + " seconds", "at most 4 000 000 000"});
    }
    const std::int64_t seconds = interface.offset_s + static_cast<std::int64_t>(own_seconds);
    if (seconds < 0)
    {
        Refuse(
            {"a time of " + std::to_string(seconds) + " seconds", "none before 0, with the offset of its interface"});
    }
    const long double fraction = static_cast<long double>(rest) / static_cast<long double>(interface.ticks);
    const bool is_exact = interface.ticks <= 1000000000U;
    const auto nanoseconds =
        is_exact ? static_cast<Time>(rest * 1000000000U / interface.ticks) : static_cast<Time>(fraction * 1.0e9L);
    return static_cast<Time>(seconds) * kSecond + nanoseconds;
}

bool PcapngReader::HasReadable() const
{
    return std::any_of(interfaces_.begin(), interfaces_.end(),
                       [](const Interface& interface) { return IsReadable(interface.link_type); });
}

/// A capture may also have interfaces of other networks, but not as the one that is looked at.
void PcapngReader::RequireOtherNetwork(const Interface& interface) const
{
    const bool is_looked_at = choice_.IsAsked(interface.name) || (choice_.IsOpen() && !HasReadable());
    if (is_looked_at)
    {
        Refuse({"link type " + std::to_string(interface.link_type), ReadableLinkTypes()});
    }
}

/// Whether the frame is of the interface that is looked at. One description may be of several: all that Linux has.
bool PcapngReader::Takes(const Interface& interface, const PacketResult& result, const Time time)
{
    const std::string index = result.interface ? "/" + std::to_string(*result.interface) : "";
    const bool is_taken = choice_.Takes(interface.key + index, {interface.name, interface.name + index}, time);
    doubt_ = is_taken && doubt_.empty() ? DoubtOf(interface.link_type) : doubt_;
    return is_taken;
}

/// Whether the packet is a frame of the interface that is looked at.
bool PcapngReader::ReadPacket(const std::size_t begin, const std::size_t end, LogFrame& frame)
{
    if (end - begin < kPacketHead)
    {
        Refuse({"a packet of " + std::to_string(end - begin) + " bytes", "at least 20"});
    }
    const std::size_t number = bytes_.Number32(begin);
    const std::size_t captured = bytes_.Number32(begin + 12U);
    const std::size_t original = bytes_.Number32(begin + 16U);
    const bool is_whole = number < interfaces_.size() && captured == original && captured <= end - begin - kPacketHead;
    if (!is_whole)
    {
        Refuse({"a packet of interface " + std::to_string(number) + " with " + std::to_string(captured) + " of " +
                    std::to_string(original) + " bytes",
                "a whole packet of an interface that was described"});
    }
    const Interface& interface = interfaces_[number];
    if (!IsReadable(interface.link_type))
    {
        RequireOtherNetwork(interface);
        return false;
    }
    const std::uint64_t high = bytes_.Number32(begin + 4U);
    frame = LogFrame{};
    frame.time = TimeOf((high << 32U) | bytes_.Number32(begin + 8U), interface);
    const PacketResult result =
        ReadPacketOf(interface.link_type, bytes_.Part(begin + kPacketHead, captured), bytes_.IsBigEndian(), frame);
    if (result.problem)
    {
        Refuse(*result.problem);
    }
    if (!result.is_frame || !Takes(interface, result, frame.time))
    {
        return false;
    }
    if (frame.time < last_)
    {
        Refuse({"its time is before the one before it", "times that do not go back"});
    }
    last_ = frame.time;
    return true;
}
} // namespace counterpoint::monitor
