// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia302/network/answer_watch.hpp"

#include "canopen/cia301/base/little_endian.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint8_t kSdoBytes = 8U;
constexpr std::uint8_t kCommandShift = 5U;
constexpr std::uint8_t kExpeditedBit = 0x02U;
constexpr std::uint8_t kToggleBit = 0x80U;
constexpr ObjectAddress kNoObject{0U, 0U};

/// Bits 5 to 7 of the first byte.
constexpr std::uint8_t kDownloadRequest = 1U;
constexpr std::uint8_t kUploadRequest = 2U;
constexpr std::uint8_t kUploadAnswer = 2U;
constexpr std::uint8_t kDownloadAnswer = 3U;
constexpr std::uint8_t kAbort = 4U;
constexpr std::uint8_t kBlockUpload = 5U;
constexpr std::uint8_t kBlockDownload = 6U;

std::uint8_t CommandOf(const CanFrame& frame) noexcept
{
    return static_cast<std::uint8_t>(frame.data[0] >> kCommandShift);
}

ObjectAddress ObjectOf(const CanFrame& frame) noexcept
{
    return ObjectAddress{static_cast<std::uint16_t>(cia301::FromLittleEndian(&frame.data[1], 2U)), frame.data[3]};
}

bool IsSame(const ObjectAddress& left, const ObjectAddress& right) noexcept
{
    return (left.index == right.index) && (left.sub == right.sub);
}

/// One more, without an end to wrap at.
std::uint8_t Counted(const std::uint8_t count) noexcept
{
    return (count < AnswerWatch::kInARow) ? static_cast<std::uint8_t>(count + 1U) : count;
}

} // namespace

void AnswerWatch::OnQuestion(AskedNode& node, const CanFrame& frame) noexcept
{
    if (frame.kind == FrameKind::kRemote)
    {
        node.guarded_twice = node.is_remote_doubled ? node.guarded_twice : std::uint8_t{0U};
        node.is_remote_open = true;
        node.is_remote_doubled = false;
    }
    else if (frame.length_bytes == kSdoBytes)
    {
        OnRequest(node, frame);
    }
    else
    {
        // No SDO.
    }
}

/// The same object again without an answer is a repeated request: one late answer more may come.
void AnswerWatch::OnRequest(AskedNode& node, const CanFrame& frame) noexcept
{
    constexpr std::uint8_t kMostOpen = 255U;
    const std::uint8_t command = CommandOf(frame);
    const ObjectAddress object = ObjectOf(frame);
    const bool is_begin = (command == kDownloadRequest) || (command == kUploadRequest);
    if (is_begin && !node.is_answered && IsSame(object, node.object))
    {
        node.open = (node.open < kMostOpen) ? static_cast<std::uint8_t>(node.open + 1U) : node.open;
    }
    else if (is_begin)
    {
        const bool is_single = node.is_answered && !node.is_doubled;
        node.twice = is_single ? std::uint8_t{0U} : node.twice;
        node.object = object;
        node.open = 1U;
        node.is_answered = false;
        node.is_ended = false;
        node.is_doubled = false;
        node.is_short = (command == kUploadRequest) || ((frame.data[0] & kExpeditedBit) != 0U);
    }
    else if ((command == kBlockUpload) || (command == kBlockDownload))
    {
        node.object = kNoObject; // Segments of a block look like anything.
        node.is_answered = false;
    }
    else
    {
        // A segment, or an abort.
    }
}

/// Two resets before the first boot-up message may bring two of them: the second one may find the device booting. What
/// is behind a boot-up message begins anew, for a device may as well make one boot of two resets, and so does what is
/// behind a reset of a device that was never there.
void AnswerWatch::OnReset(AskedNode& node) noexcept
{
    constexpr std::uint8_t kMostResets = 255U;
    const bool is_most = (node.resets == kMostResets);
    const std::uint8_t more = is_most ? node.resets : static_cast<std::uint8_t>(node.resets + 1U);
    node.resets = (node.has_booted || !node.is_known) ? std::uint8_t{1U} : more;
    node.has_booted = false;
}

bool AnswerWatch::OnAnswer(AskedNode& node, const CanFrame& frame) noexcept
{
    if (frame.length_bytes == kSdoBytes)
    {
        OnSdo(node, frame);
    }
    else if (frame.length_bytes != 1U)
    {
        // Neither an answer nor an error control message.
    }
    else if (frame.data[0] == 0U)
    {
        OnBootUp(node);
    }
    else
    {
        OnSign(node, (frame.data[0] & kToggleBit) != 0U);
    }
    return (node.twice >= kInARow) || (node.guarded_twice >= kInARow);
}

void AnswerWatch::OnSdo(AskedNode& node, const CanFrame& frame) noexcept
{
    const std::uint8_t command = CommandOf(frame);
    const bool is_abort = (command == kAbort);
    const bool is_answer = (command == kUploadAnswer) || (command == kDownloadAnswer) || is_abort;
    const bool is_its = is_answer && (node.object.index != 0U) && IsSame(ObjectOf(frame), node.object);
    if (is_its && (node.open > 0U))
    {
        const bool has_value = (command == kDownloadAnswer) || ((frame.data[0] & kExpeditedBit) != 0U);
        --node.open;
        node.is_answered = true;
        node.is_ended = is_abort || (node.is_short && has_value);
    }
    else if (is_its) // None is open: it was answered before.
    {
        OnSecond(node, is_abort);
    }
    else
    {
        // Of a transfer before this one, or a segment.
    }
}

/// A server may give up a transfer that it has begun; one that has ended it cannot.
void AnswerWatch::OnSecond(AskedNode& node, const bool is_abort) noexcept
{
    const bool is_news = !node.is_doubled && (!is_abort || node.is_ended);
    node.twice = is_news ? Counted(node.twice) : node.twice;
    node.is_doubled = node.is_doubled || is_news;
}

/// What was asked before is forgotten. A device boots once after each reset.
void AnswerWatch::OnBootUp(AskedNode& node) noexcept
{
    const bool is_after_reset = (node.resets > 0U);
    const bool is_second = node.has_booted && !is_after_reset;
    node.twice = is_second ? Counted(node.twice) : node.twice;
    node.has_booted = is_after_reset;
    node.is_known = true;
    node.resets = is_after_reset ? static_cast<std::uint8_t>(node.resets - 1U) : std::uint8_t{0U};
    node.object = kNoObject;
    node.open = 0U;
    node.is_answered = false;
    node.is_remote_open = false;
    node.has_toggled = false;
}

void AnswerWatch::OnSign(AskedNode& node, const bool is_toggle_set) noexcept
{
    node.has_toggled = node.has_toggled || is_toggle_set;
    if (!node.is_remote_open && node.has_toggled && !node.is_remote_doubled)
    {
        node.guarded_twice = Counted(node.guarded_twice);
        node.is_remote_doubled = true;
    }
    node.is_remote_open = false;
}

} // namespace counterpoint::cia302
