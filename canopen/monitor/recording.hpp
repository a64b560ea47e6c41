// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_MONITOR_RECORDING_HPP
#define CANOPEN_MONITOR_RECORDING_HPP

#include "canopen/cia306/text/input_error.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace counterpoint::monitor
{
constexpr std::size_t kMostDataBytes = 64U;
constexpr std::uint8_t kClassicalBytes = 8U;

/// Nanoseconds from the epoch of the recording.
using Time = std::int64_t;
constexpr Time kMicrosecond = 1000;
constexpr Time kMillisecond = 1000 * kMicrosecond;
constexpr Time kSecond = 1000 * kMillisecond;

/// One frame as it was recorded. Bytes behind `length` have no meaning; a remote frame has none.
struct LogFrame
{
    Time time{0};
    std::uint32_t identifier{0U}; ///< 11 or 29 bits.
    std::uint8_t length{0U};
    bool is_extended{false};
    bool is_remote{false};
    bool is_fd{false};
    bool is_error{false};
    std::array<std::uint8_t, kMostDataBytes> data{};

    /// Whether it is a data frame with an identifier of 11 bits. CANopen uses no other kind, but for remote frames.
    [[nodiscard]] bool IsPlain() const noexcept
    {
        return !is_extended && !is_remote && !is_fd && !is_error;
    }
};

/// Of which bus the frames are that a source gave.
struct Origin
{
    std::string interface;        ///< The one whose frames were given; empty: the recording names none.
    std::size_t other_frames{0U}; ///< Frames of CAN of other interfaces, which were not given. [SRS_MON_041]
    Time other_last{0};           ///< The latest time of those.
    /// Why the frames given may be others than those of the bus: of several interfaces, or the last one cut; empty: no
    /// reason. [SRS_MON_043, SRS_MON_401]
    std::string doubt;
};

/// Chooses one interface of a recording: the one that is asked for, otherwise that of the first frame. [SRS_MON_040]
class InterfaceChoice
{
  public:
    /// @brief `wanted` is empty where none is asked for.
    explicit InterfaceChoice(std::string wanted);
    /// @brief Whether the frame is of the chosen interface; one that is not is counted. `key` differs from that of each
    /// other interface, `names` are what may be asked for.
    [[nodiscard]] bool Takes(std::string_view key, std::initializer_list<std::string_view> names, Time time);
    /// @brief Whether one is asked for, by this name.
    [[nodiscard]] bool IsAsked(const std::string_view name) const noexcept
    {
        return !wanted_.empty() && wanted_ == name;
    }
    /// @brief Whether any interface will do, and none is chosen yet.
    [[nodiscard]] bool IsOpen() const noexcept
    {
        return wanted_.empty() && !key_;
    }
    /// @brief What was chosen and what was not.
    [[nodiscard]] Origin Seen() const;

  private:
    std::string wanted_;
    std::optional<std::string> key_; ///< Of the chosen one.
    std::size_t other_frames_{0U};
    Time other_last_{0};
};

/// Gives the frames of a recording, one after the other.
class FrameSource
{
  public:
    FrameSource() = default;
    virtual ~FrameSource() = default;
    FrameSource(const FrameSource&) = delete;
    FrameSource& operator=(const FrameSource&) = delete;

    /// @brief The next frame; false at the end. Throws InputError with the number of the line or packet.
    [[nodiscard]] virtual bool Next(LogFrame& frame) = 0;
    /// @brief Where the last frame stood: line or packet, from 1.
    [[nodiscard]] virtual std::size_t Place() const noexcept = 0;
    /// @brief Of which interface the frames so far were, and how many of others there were.
    [[nodiscard]] virtual Origin Seen() const = 0;
};

/// The content of a regular file of up to 2 GB. Throws InputError.
[[nodiscard]] std::string ReadRecording(const std::string& path);

/// Which frames are taken: those of the interface of the first frame, or of the one with this name.
struct RecordingOptions
{
    std::string interface;
};

/// A source over the bytes, which outlive it; the format is told by them. `file` is for messages. [SRS_MON_001,
/// SRS_MON_002, SRS_MON_003]
[[nodiscard]] std::unique_ptr<FrameSource> OpenRecording(const std::string& file, std::string_view bytes,
                                                         const RecordingOptions& options);
} // namespace counterpoint::monitor

#endif // CANOPEN_MONITOR_RECORDING_HPP
