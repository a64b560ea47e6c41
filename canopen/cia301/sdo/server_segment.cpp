// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Expedited and segmented transfers of the SDO server.
#include "canopen/cia301/sdo/server.hpp"

#include "canopen/cia301/base/little_endian.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint8_t kExpedited = 0x02U;
constexpr std::uint8_t kStated = 0x01U;
constexpr std::uint8_t kToggle = 0x10U;
constexpr std::uint8_t kLast = 0x01U;
constexpr std::uint8_t kDownloadDone = 0x60U;
constexpr std::uint8_t kSegmentDone = 0x20U;
constexpr std::uint8_t kUploadExpedited = 0x43U;
constexpr std::uint8_t kUploadSegmented = 0x41U;
constexpr std::uint32_t kExpeditedBytes = 4U;

} // namespace

SdoAnswer SdoServer::BeginDownload(const SdoFrame& request) noexcept
{
    SdoAnswer answer{};
    if ((request.bytes[0] & kExpedited) != 0U)
    {
        answer = DownloadExpedited(request);
    }
    else
    {
        const bool is_stated = (request.bytes[0] & kStated) != 0U;
        const auto stated = static_cast<std::uint32_t>(FromLittleEndian(&request.bytes[4], 4U));
        const SdoAbort abort = PrepareDownload(is_stated ? stated : kUnknownLength);
        phase_ = Phase::kSegmentDownload;
        answer = (abort == SdoAbort::kNone) ? Answer(kDownloadDone, 0U) : Abort(abort);
    }
    return answer;
}

SdoAnswer SdoServer::DownloadExpedited(const SdoFrame& request) noexcept
{
    std::uint32_t size_bytes = kExpeditedBytes - ((static_cast<std::uint32_t>(request.bytes[0]) >> 2U) & 3U);
    SdoAbort abort = SdoAbort::kNone;
    if ((request.bytes[0] & kStated) == 0U)
    {
        const Reading size = dictionary_.SizeOf(target_);
        abort = size.abort;
        size_bytes = (size.size_bytes < kExpeditedBytes) ? size.size_bytes : kExpeditedBytes;
    }
    if (abort == SdoAbort::kNone)
    {
        abort = dictionary_.Write(target_, Bytes{&request.bytes[4], size_bytes});
    }
    if ((abort == SdoAbort::kPending) && (size_bytes > buffer_.size_bytes))
    {
        abort = SdoAbort::kOutOfMemory;
    }
    else if (abort == SdoAbort::kPending)
    {
        for (std::uint32_t i = 0U; i < size_bytes; ++i)
        {
            buffer_.data[i] = request.bytes[4U + i];
        }
        position_ = size_bytes;
    }
    return Finish(abort, Answer(kDownloadDone, 0U));
}

/// The end of a write: `done`, an abort, or nothing yet.
SdoAnswer SdoServer::Finish(const SdoAbort abort, const SdoAnswer& done) noexcept
{
    SdoAnswer answer{};
    if (abort == SdoAbort::kPending)
    {
        delayed_ = done;
        phase_ = Phase::kDelayed;
    }
    else
    {
        answer = (abort == SdoAbort::kNone) ? done : Abort(abort);
    }
    return answer;
}

/// The first `position_` bytes of the buffer are the value.
SdoAnswer SdoServer::AskAgain() noexcept
{
    phase_ = Phase::kIdle;
    return Finish(dictionary_.Write(target_, Bytes{buffer_.data, position_}), delayed_);
}

/// Whether a download of the stated length can be taken.
SdoAbort SdoServer::PrepareDownload(const std::uint32_t stated) noexcept
{
    length_ = stated;
    SdoAbort abort = dictionary_.MayWrite(target_, stated);
    if ((abort == SdoAbort::kNone) && (stated != kUnknownLength) && (stated > buffer_.size_bytes))
    {
        abort = SdoAbort::kOutOfMemory;
    }
    return abort;
}

SdoAnswer SdoServer::DownloadSegment(const SdoFrame& request) noexcept
{
    const std::uint8_t head = request.bytes[0];
    const std::uint32_t count = kSegmentBytes - ((static_cast<std::uint32_t>(head) >> 1U) & 7U);
    const std::uint32_t room = buffer_.size_bytes - position_;
    SdoAbort abort = SdoAbort::kNone;
    if ((head & kToggle) != toggle_)
    {
        abort = SdoAbort::kToggle;
    }
    else if ((length_ != kUnknownLength) && (count > (length_ - position_)))
    {
        abort = SdoAbort::kTooLong;
    }
    else if (count > room)
    {
        abort = SdoAbort::kOutOfMemory;
    }
    else
    {
        for (std::uint32_t i = 0U; i < count; ++i)
        {
            buffer_.data[position_ + i] = request.bytes[1U + i];
        }
        position_ += count;
        abort = ((head & kLast) != 0U) ? Store(position_) : SdoAbort::kNone;
    }
    SdoAnswer done{SdoPresence::kFrame, {}};
    done.frame.bytes[0] = kSegmentDone | toggle_;
    toggle_ ^= kToggle;
    return Finish(abort, done);
}

/// Writes a value that is complete; the transfer is over.
SdoAbort SdoServer::Store(const std::uint32_t size_bytes) noexcept
{
    SdoAbort abort = SdoAbort::kNone;
    if ((length_ != kUnknownLength) && (size_bytes != length_))
    {
        abort = (size_bytes > length_) ? SdoAbort::kTooLong : SdoAbort::kTooShort;
    }
    else
    {
        abort = dictionary_.Write(target_, Bytes{buffer_.data, size_bytes});
        position_ = size_bytes;
    }
    phase_ = Phase::kIdle;
    return abort;
}

SdoAnswer SdoServer::BeginUpload() noexcept
{
    const Reading reading = dictionary_.Read(target_, buffer_);
    length_ = reading.size_bytes;
    return (reading.abort == SdoAbort::kNone) ? AnswerUpload() : Abort(reading.abort);
}

/// The value is in the buffer.
SdoAnswer SdoServer::AnswerUpload() noexcept
{
    SdoAnswer answer{};
    if ((length_ > 0U) && (length_ <= kExpeditedBytes))
    {
        const auto unused = static_cast<std::uint8_t>((kExpeditedBytes - length_) << 2U);
        const auto value = static_cast<std::uint32_t>(FromLittleEndian(buffer_.data, length_));
        answer = Answer(kUploadExpedited | unused, value);
    }
    else
    {
        phase_ = Phase::kSegmentUpload;
        answer = Answer(kUploadSegmented, length_);
    }
    return answer;
}

SdoAnswer SdoServer::UploadSegment(const SdoFrame& request) noexcept
{
    SdoAnswer answer{};
    if ((request.bytes[0] & kToggle) != toggle_)
    {
        answer = Abort(SdoAbort::kToggle);
    }
    else
    {
        const std::uint32_t left = length_ - position_;
        const std::uint32_t count = (left < kSegmentBytes) ? left : kSegmentBytes;
        const std::uint8_t last = (count == left) ? kLast : 0U;
        answer.presence = SdoPresence::kFrame;
        answer.frame.bytes[0] = static_cast<std::uint8_t>(toggle_ | ((kSegmentBytes - count) << 1U) | last);
        for (std::uint32_t i = 0U; i < count; ++i)
        {
            answer.frame.bytes[1U + i] = buffer_.data[position_ + i];
        }
        position_ += count;
        toggle_ ^= kToggle;
        phase_ = (last != 0U) ? Phase::kIdle : Phase::kSegmentUpload;
    }
    return answer;
}

} // namespace counterpoint::cia301
