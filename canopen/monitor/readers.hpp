// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_MONITOR_READERS_HPP
#define CANOPEN_MONITOR_READERS_HPP

#include "canopen/monitor/recording.hpp"

#include <optional>
#include <vector>

namespace counterpoint::monitor
{
/// Lines of `candump -l`: (SECONDS.FRACTION) INTERFACE ID#DATA [DIRECTION], and what `candump -ta` or `-tz` prints:
/// (SECONDS.FRACTION)  INTERFACE  ID   [LENGTH]  BYTES. [SRS_MON_002]
class CandumpReader final : public FrameSource
{
  public:
    /// @brief `file` is for messages; `text` outlives the reader.
    CandumpReader(std::string file, std::string_view text, const RecordingOptions& options);
    [[nodiscard]] bool Next(LogFrame& frame) override;
    [[nodiscard]] std::size_t Place() const noexcept override;
    [[nodiscard]] Origin Seen() const override;

  private:
    /// `at` is the part of the line that is wrong and what follows it.
    [[noreturn]] void Refuse(std::string_view line, std::string_view at, const char* expected) const;
    [[nodiscard]] bool ReadLine(std::string_view line, LogFrame& frame);
    void ReadTime(std::string_view line, std::size_t& at, LogFrame& frame) const;
    [[nodiscard]] std::string_view ReadLogged(std::string_view line, std::size_t at, LogFrame& frame) const;
    [[nodiscard]] std::string_view ReadPrinted(std::string_view line, std::size_t at, LogFrame& frame) const;
    void ReadIdentifier(std::string_view line, std::string_view text, LogFrame& frame) const;
    void ReadFrame(std::string_view line, std::string_view text, LogFrame& frame) const;
    void ReadData(std::string_view line, std::string_view text, LogFrame& frame) const;

    std::string file_;
    std::string_view text_;
    InterfaceChoice choice_;
    std::size_t at_{0U};
    std::size_t line_{0U};
    Time last_{0};
    bool is_end_open_{false}; ///< The last line was read, and no line break ended it.
};

/// Numbers of a capture file in the byte order of the machine that wrote it.
class CaptureBytes
{
  public:
    CaptureBytes(const std::string_view bytes, const bool is_big_endian) noexcept
        : bytes_(bytes), is_big_endian_(is_big_endian)
    {
    }
    /// Number of bytes.
    [[nodiscard]] std::size_t Size() const noexcept
    {
        return bytes_.size();
    }
    /// Byte order of the machine that wrote the file.
    [[nodiscard]] bool IsBigEndian() const noexcept
    {
        return is_big_endian_;
    }
    /// The number at `at`; `at` + 2 is at most Size(), checked by the caller.
    [[nodiscard]] std::uint16_t Number16(const std::size_t at) const noexcept
    {
        const std::uint32_t first = At(at);
        const std::uint32_t second = At(at + 1U);
        return static_cast<std::uint16_t>(is_big_endian_ ? (first << 8U) | second : (second << 8U) | first);
    }
    /// The number at `at`; `at` + 4 is at most Size(), checked by the caller.
    [[nodiscard]] std::uint32_t Number32(const std::size_t at) const noexcept
    {
        const std::uint32_t first = Number16(at);
        const std::uint32_t second = Number16(at + 2U);
        return is_big_endian_ ? (first << 16U) | second : (second << 16U) | first;
    }
    /// The number at `at`; `at` + 8 is at most Size(), checked by the caller.
    [[nodiscard]] std::uint64_t Number64(const std::size_t at) const noexcept
    {
        const std::uint64_t first = Number32(at);
        const std::uint64_t second = Number32(at + 4U);
        return is_big_endian_ ? (first << 32U) | second : (second << 32U) | first;
    }
    /// Bytes from `at` on.
    [[nodiscard]] std::string_view Part(const std::size_t at, const std::size_t count) const noexcept
    {
        return bytes_.substr(at, count);
    }

  private:
    [[nodiscard]] std::uint8_t At(const std::size_t at) const noexcept
    {
        return static_cast<std::uint8_t>(bytes_[at]);
    }

    std::string_view bytes_;
    bool is_big_endian_;
};

/// Reads a packet of link type CAN_SOCKETCAN; `is_of_fd`: what stands around it tells that its frame is one of CAN FD,
/// whatever the packet itself tells. Nothing: it became a frame; else what is wrong with it. [SRS_MON_003, SRS_MON_530]
[[nodiscard]] std::optional<cia306::Problem> ReadSocketCan(std::string_view packet, bool is_of_fd, LogFrame& frame);

constexpr std::uint32_t kLinkSocketCan = 227U;
constexpr std::uint32_t kLinkCooked = 113U;  ///< LINUX_SLL: a capture of the interface "any".
constexpr std::uint32_t kLinkCooked2 = 276U; ///< LINUX_SLL2.

/// @brief Whether packets of this link type can be read.
[[nodiscard]] bool IsReadable(std::uint32_t link_type) noexcept;
/// @brief "227 (CAN_SOCKETCAN), 113 or 276 (Linux cooked)"
[[nodiscard]] const char* ReadableLinkTypes() noexcept;
/// @brief Why frames of several interfaces cannot be told apart, where packets of this link type may be of several and
/// do not tell of which; empty for all others. [SRS_MON_043]
[[nodiscard]] std::string DoubtOf(std::uint32_t link_type);

/// What became of a packet.
struct PacketResult
{
    bool is_frame{false}; ///< False without a problem: a cooked packet of something else than CAN.
    std::optional<cia306::Problem> problem;
    std::optional<std::uint32_t> interface; ///< Index, in a packet of LINUX_SLL2.
};

/// A packet of a readable link type. Cooked packets have the identifier in the byte order of the machine that recorded,
/// which is that of the file. [SRS_MON_003]
[[nodiscard]] PacketResult ReadPacketOf(std::uint32_t link_type, std::string_view packet, bool is_big_endian,
                                        LogFrame& frame);

/// Reads pcap files of both byte orders, with micro- or nanoseconds. [SRS_MON_003]
class PcapReader final : public FrameSource
{
  public:
    /// @brief `file` is for messages; `bytes` outlive the reader. Throws InputError.
    PcapReader(std::string file, std::string_view bytes, const RecordingOptions& options);
    [[nodiscard]] bool Next(LogFrame& frame) override;
    [[nodiscard]] std::size_t Place() const noexcept override;
    [[nodiscard]] Origin Seen() const override;

  private:
    [[noreturn]] void Refuse(const cia306::Problem& problem) const;
    void RequireNames(const std::string& wanted) const;
    [[nodiscard]] bool ReadPacket(LogFrame& frame);
    [[nodiscard]] bool Takes(const PacketResult& result, const LogFrame& frame);

    std::string file_;
    CaptureBytes bytes_;
    Time fraction_; ///< Of a second: one microsecond or nanosecond.
    InterfaceChoice choice_;
    std::uint32_t link_type_{0U};
    std::size_t check_bytes_{0U}; ///< Of the check sequence behind each packet. [SRS_MON_044]
    std::size_t at_{0U};
    std::size_t packet_{0U};
    Time last_{0};
};

/// Reads pcapng files. [SRS_MON_003]
class PcapngReader final : public FrameSource
{
  public:
    /// @brief `file` is for messages; `bytes` outlive the reader. Throws InputError.
    PcapngReader(std::string file, std::string_view bytes, const RecordingOptions& options);
    [[nodiscard]] bool Next(LogFrame& frame) override;
    [[nodiscard]] std::size_t Place() const noexcept override;
    [[nodiscard]] Origin Seen() const override;

  private:
    struct Interface
    {
        std::uint16_t link_type{0U};
        std::uint64_t ticks{1000000U}; ///< A second has so many.
        std::int64_t offset_s{0};      ///< From -kMostSeconds to kMostSeconds.
        std::string name;              ///< Its number in the section, where it has none.
        std::string key; ///< Not that of an interface with another name, nor of one without a name of another section.
    };

    [[noreturn]] void Refuse(const cia306::Problem& problem) const;
    void BeginSection();
    void ReadInterface(std::size_t begin, std::size_t end);
    void ReadOptions(std::size_t begin, std::size_t end, Interface& interface) const;
    [[nodiscard]] bool ReadPacket(std::size_t begin, std::size_t end, LogFrame& frame);
    [[nodiscard]] Time TimeOf(std::uint64_t ticks, const Interface& interface) const;
    [[nodiscard]] bool HasReadable() const;
    void RequireOtherNetwork(const Interface& interface) const;
    [[nodiscard]] bool Takes(const Interface& interface, const PacketResult& result, Time time);

    std::string file_;
    CaptureBytes bytes_;
    std::string_view all_;
    InterfaceChoice choice_;
    std::vector<Interface> interfaces_; ///< Of the section.
    std::string doubt_;
    std::size_t section_{0U};
    std::size_t at_{0U};
    std::size_t block_{0U};
    Time last_{0};
};
} // namespace counterpoint::monitor

#endif // CANOPEN_MONITOR_READERS_HPP
