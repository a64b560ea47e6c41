// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_CANOPEN_MONITOR_RECORDINGS_HPP
#define TESTS_CANOPEN_MONITOR_RECORDINGS_HPP

#include "canopen/monitor/analysis.hpp"
#include "canopen/monitor/recording.hpp"

#include <cstdint>
#include <string>
#include <vector>

/// Recordings for tests: lines of candump, and the same frames as capture files.
namespace counterpoint::monitor::test
{
enum class ByteOrder : std::uint8_t
{
    kLittle = 0U,
    kBig = 1U,
};

/// Bytes of a capture file in either order.
class CaptureWriter
{
  public:
    explicit CaptureWriter(const ByteOrder order) noexcept : order_(order)
    {
    }
    void Number(const std::uint64_t value, const std::uint32_t bytes)
    {
        for (std::uint32_t place = 0U; place < bytes; ++place)
        {
            const std::uint32_t shift = order_ == ByteOrder::kLittle ? 8U * place : 8U * (bytes - 1U - place);
            text += static_cast<char>((value >> shift) & 0xFFU);
        }
    }
    std::string text;

  private:
    ByteOrder order_;
};

/// A frame as Linux hands it to a capture: identifier and flags in network order.
[[nodiscard]] std::string SocketCanPacket(const LogFrame& frame);
/// nanoseconds: magic and stamps of that kind.
[[nodiscard]] std::string PcapOf(const std::vector<LogFrame>& frames, ByteOrder order, bool has_nanoseconds);
/// `resolution` is the option if_tsresol, `offset_s` if_tsoffset: what is added to each time.
[[nodiscard]] std::string PcapngOf(const std::vector<LogFrame>& frames, ByteOrder order, std::uint8_t resolution,
                                   std::int64_t offset_s = 0);
/// The same with link type LINUX_SLL (or SLL2); a packet of another protocol stands first.
[[nodiscard]] std::string CookedPcapOf(const std::vector<LogFrame>& frames, ByteOrder order, bool is_second);
/// A block of pcapng with its lengths.
[[nodiscard]] std::string PcapngBlock(std::uint32_t type, const std::string& body, ByteOrder order);
/// One line of candump -l.
[[nodiscard]] std::string CandumpLine(const LogFrame& frame);

/// Path of a file of this name, in a folder that this process alone has and that is gone with it.
[[nodiscard]] std::string PathOf(const std::string& name);
/// Writes a file there; its path.
[[nodiscard]] std::string Written(const std::string& name, const std::string& text);

/// All frames of a recording. Throws InputError.
[[nodiscard]] std::vector<LogFrame> FramesOf(const std::string& bytes, const std::string& interface = "");
/// What the reader says of it; empty where it refuses nothing.
[[nodiscard]] std::string RefusalOf(const std::string& bytes);
/// A data frame at so many microseconds.
[[nodiscard]] LogFrame Frame(Time us, std::uint32_t identifier, const std::vector<std::uint8_t>& data);

/// "12500 not inverse" for each violation of the frames, the time in microseconds.
[[nodiscard]] std::vector<std::string> ViolationsOf(const Network& network, const std::vector<LogFrame>& frames,
                                                    Time end_us = 0);
} // namespace counterpoint::monitor::test

#endif // TESTS_CANOPEN_MONITOR_RECORDINGS_HPP
