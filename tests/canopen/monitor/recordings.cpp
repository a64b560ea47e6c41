// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/monitor/recordings.hpp"

#include "canopen/cia306/text/text_file.hpp"
#include "canopen/monitor/texts.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <unistd.h>

namespace counterpoint::monitor::test
{
namespace
{
std::string Padding(const std::size_t count)
{
    return std::string((4U - count % 4U) % 4U, '\0');
}

class Folder
{
  public:
    Folder()
        : path(std::filesystem::temp_directory_path() / ("counterpoint_monitor_test_" + std::to_string(::getpid())))
    {
        std::filesystem::create_directories(path);
    }
    ~Folder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    const std::filesystem::path path;
};
} // namespace

std::string SocketCanPacket(const LogFrame& frame)
{
    CaptureWriter writer(ByteOrder::kBig);
    writer.Number(frame.identifier | (frame.is_extended ? 0x80000000U : 0U) | (frame.is_remote ? 0x40000000U : 0U) |
                      (frame.is_error ? 0x20000000U : 0U),
                  4U);
    writer.Number(frame.length, 1U);
    writer.Number(frame.is_fd ? 4U : 0U, 1U);
    writer.Number(0U, 2U);
    for (std::uint8_t place = 0U; place < frame.length && !frame.is_remote; ++place)
    {
        writer.Number(frame.data.at(place), 1U);
    }
    return writer.text;
}

std::string PcapOf(const std::vector<LogFrame>& frames, const ByteOrder order, const bool has_nanoseconds)
{
    CaptureWriter writer(order);
    writer.Number(has_nanoseconds ? 0xA1B23C4DU : 0xA1B2C3D4U, 4U);
    writer.Number(2U, 2U);
    writer.Number(4U, 2U);
    writer.Number(0U, 4U);
    writer.Number(0U, 4U);
    writer.Number(262144U, 4U);
    writer.Number(227U, 4U);
    for (const LogFrame& frame : frames)
    {
        const std::string packet = SocketCanPacket(frame);
        writer.Number(static_cast<std::uint64_t>(frame.time / kSecond), 4U);
        writer.Number(static_cast<std::uint64_t>(frame.time % kSecond / (has_nanoseconds ? 1 : kMicrosecond)), 4U);
        writer.Number(packet.size(), 4U);
        writer.Number(packet.size(), 4U);
        writer.text += packet;
    }
    return writer.text;
}

std::string CookedPcapOf(const std::vector<LogFrame>& frames, const ByteOrder order, const bool is_second)
{
    CaptureWriter writer(order);
    for (const auto& [value, bytes] : std::vector<std::pair<std::uint32_t, std::uint32_t>>{
             {0xA1B2C3D4U, 4U}, {2U, 2U}, {4U, 2U}, {0U, 4U}, {0U, 4U}, {262144U, 4U}, {is_second ? 276U : 113U, 4U}})
    {
        writer.Number(value, bytes);
    }
    const auto append = [&](const Time time, const std::uint16_t protocol, const std::string& packet)
    {
        CaptureWriter head(ByteOrder::kBig);
        head.Number(is_second ? protocol : 0U, 2U);
        head.text += std::string(is_second ? 18U : 12U, '\0');
        if (!is_second)
        {
            head.Number(protocol, 2U);
        }
        writer.Number(static_cast<std::uint64_t>(time / kSecond), 4U);
        writer.Number(static_cast<std::uint64_t>(time % kSecond / kMicrosecond), 4U);
        writer.Number(head.text.size() + packet.size(), 4U);
        writer.Number(head.text.size() + packet.size(), 4U);
        writer.text += head.text + packet;
    };
    append(0, 0x0800U, "IP");
    for (const LogFrame& frame : frames)
    {
        std::string packet = SocketCanPacket(frame);
        if (order == ByteOrder::kLittle)
        {
            std::reverse(packet.begin(), packet.begin() + 4);
        }
        append(frame.time, frame.is_fd ? 0x000DU : 0x000CU, packet);
    }
    return writer.text;
}

std::string PcapngBlock(const std::uint32_t type, const std::string& body, const ByteOrder order)
{
    CaptureWriter writer(order);
    const std::size_t length = body.size() + Padding(body.size()).size() + 12U;
    writer.Number(type, 4U);
    writer.Number(length, 4U);
    writer.text += body + Padding(body.size());
    writer.Number(length, 4U);
    return writer.text;
}

std::string PcapngOf(const std::vector<LogFrame>& frames, const ByteOrder order, const std::uint8_t resolution,
                     const std::int64_t offset_s)
{
    CaptureWriter section(order);
    section.Number(0x1A2B3C4DU, 4U);
    section.Number(1U, 2U);
    section.Number(0U, 2U);
    section.Number(0xFFFFFFFFFFFFFFFFU, 8U);
    CaptureWriter interface(order);
    interface.Number(227U, 2U);
    interface.Number(0U, 2U);
    interface.Number(262144U, 4U);
    interface.Number(2U, 2U); // if_name
    interface.Number(4U, 2U);
    interface.text += "can0";
    interface.Number(9U, 2U); // if_tsresol
    interface.Number(1U, 2U);
    interface.text += std::string(1U, static_cast<char>(resolution)) + std::string(3U, '\0');
    interface.Number(14U, 2U); // if_tsoffset
    interface.Number(8U, 2U);
    interface.Number(static_cast<std::uint64_t>(offset_s), 8U);
    interface.Number(0U, 4U);
    std::string text = PcapngBlock(0x0A0D0D0AU, section.text, order) + PcapngBlock(1U, interface.text, order) +
                       PcapngBlock(0x0BADU, "unknown", order);
    for (const LogFrame& frame : frames)
    {
        const std::string packet = SocketCanPacket(frame);
        const auto time = static_cast<std::uint64_t>(resolution == 9U ? frame.time : frame.time / kMicrosecond);
        CaptureWriter head(order);
        head.Number(0U, 4U);
        head.Number(time >> 32U, 4U);
        head.Number(time & 0xFFFFFFFFU, 4U);
        head.Number(packet.size(), 4U);
        head.Number(packet.size(), 4U);
        text += PcapngBlock(6U, head.text + packet, order);
    }
    return text;
}

std::string CandumpLine(const LogFrame& frame)
{
    std::string data = frame.is_remote ? "R" + std::to_string(frame.length) : DataText(frame);
    data.erase(std::remove(data.begin(), data.end(), ' '), data.end());
    char head[64] = {};
    static_cast<void>(std::snprintf(head, sizeof(head), "(%010lld.%06lld) can0 ",
                                    static_cast<long long>(frame.time / kSecond),
                                    static_cast<long long>(frame.time % kSecond / kMicrosecond)));
    const std::uint32_t flags = frame.is_error ? 0x20000000U : 0U;
    const bool is_wide = frame.is_extended || frame.is_error;
    return head + cia306::Hex(frame.identifier | flags, is_wide ? 8 : 3).substr(2U) + (frame.is_fd ? "##1" : "#") +
           data + "\n";
}

std::string PathOf(const std::string& name)
{
    static const Folder folder;
    return (folder.path / name).string();
}

std::string Written(const std::string& name, const std::string& text)
{
    const std::string path = PathOf(name);
    cia306::WriteTextFile(path, text);
    return path;
}

std::vector<LogFrame> FramesOf(const std::string& bytes, const std::string& interface)
{
    const auto source = OpenRecording("test.log", bytes, {interface});
    std::vector<LogFrame> frames;
    LogFrame frame;
    while (source->Next(frame))
    {
        frames.push_back(frame);
    }
    return frames;
}

std::string RefusalOf(const std::string& bytes)
{
    try
    {
        static_cast<void>(FramesOf(bytes));
    }
    catch (const cia306::InputError& error)
    {
        return error.what();
    }
    return "";
}

LogFrame Frame(const Time us, const std::uint32_t identifier, const std::vector<std::uint8_t>& data)
{
    LogFrame frame;
    frame.time = us * kMicrosecond;
    frame.identifier = identifier;
    frame.length = static_cast<std::uint8_t>(data.size());
    std::copy(data.begin(), data.end(), frame.data.begin());
    return frame;
}

std::vector<std::string> ViolationsOf(const Network& network, const std::vector<LogFrame>& frames, const Time end_us)
{
    std::vector<std::string> texts;
    Analysis analysis(network,
                      [&texts](const Violation& violation)
                      {
                          texts.push_back(std::to_string(violation.breach.time / kMicrosecond) + " " +
                                          CauseName(violation.breach.cause));
                      });
    for (const LogFrame& frame : frames)
    {
        analysis.Take(frame);
    }
    if (end_us != 0)
    {
        analysis.Advance(end_us * kMicrosecond);
    }
    return texts;
}
} // namespace counterpoint::monitor::test
