// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/sdo/server.hpp"

#include "canopen/cia301/base/little_endian.hpp"
#include "canopen/cia301/store/crc16.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint8_t kCommandMask = 0xE0U;
constexpr std::uint8_t kDownloadSegment = 0x00U;
constexpr std::uint8_t kDownload = 0x20U;
constexpr std::uint8_t kUpload = 0x40U;
constexpr std::uint8_t kUploadSegment = 0x60U;
constexpr std::uint8_t kAbort = 0x80U;
constexpr std::uint8_t kBlockUpload = 0xA0U;
constexpr std::uint8_t kBlockDownload = 0xC0U;
constexpr std::uint8_t kSubCommandOfDownload = 0x01U; ///< 0 begin, 1 end.
constexpr std::uint8_t kSubCommandOfUpload = 0x03U;   ///< 0 begin, 1 end, 2 acknowledgement, 3 start.

constexpr SdoAnswer kNoAnswer{SdoPresence::kNothing, {}};

std::uint8_t AtMost(const std::uint8_t value, const std::uint8_t limit) noexcept
{
    return (value > limit) ? limit : value;
}

constexpr std::uint8_t kExpedited = 0x02U;
constexpr std::uint8_t kStated = 0x01U;
constexpr std::uint8_t kToggle = 0x10U;
constexpr std::uint8_t kLast = 0x01U;
constexpr std::uint8_t kDownloadDone = 0x60U;
constexpr std::uint8_t kSegmentDone = 0x20U;
constexpr std::uint8_t kUploadExpedited = 0x43U;
constexpr std::uint8_t kUploadSegmented = 0x41U;
constexpr std::uint32_t kExpeditedBytes = 4U;

constexpr std::uint8_t kCrcSupport = 0x04U;
constexpr std::uint8_t kSizeStated = 0x02U;
constexpr std::uint8_t kLastSegment = 0x80U;
constexpr std::uint8_t kSequenceMask = 0x7FU;
constexpr std::uint8_t kDownloadBegun = 0xA4U; ///< With CRC.
constexpr std::uint8_t kDownloadEnded = 0xA1U;
constexpr std::uint8_t kBlockTaken = 0xA2U;
constexpr std::uint8_t kUploadBegun = 0xC6U; ///< With CRC and length.
constexpr std::uint8_t kUploadEnd = 0xC1U;

bool IsBlockSize(const std::uint8_t size) noexcept
{
    return (size >= 1U) && (size <= kMaxBlockSize);
}

} // namespace

SdoServer::SdoServer(const SdoServerParts& parts) noexcept
    : dictionary_(parts.dictionary), buffer_(parts.buffer), time_out_us_(parts.time_out_us),
      own_block_size_((parts.block_size == 0U) ? kMaxBlockSize : AtMost(parts.block_size, kMaxBlockSize)),
      phase_(Phase::kIdle), target_{0U, 0U}, last_{0U}, length_(0U), position_(0U), crc_bytes_(0U), crc_(0U),
      toggle_(0U), sequence_(0U), block_size_(0U), has_crc_(false), has_last_(false), refusal_(SdoAbort::kNone),
      is_repeated_(false), delayed_{SdoPresence::kNothing, {}}
{
}

bool SdoServer::IsBusy() const noexcept
{
    return phase_ != Phase::kIdle;
}

SdoAnswer SdoServer::OnFrame(const SdoFrame& request, const std::uint8_t length_bytes, const Instant now) noexcept
{
    SdoAnswer answer = kNoAnswer;
    if ((length_bytes == 8U) && !doubled_.Takes(request.bytes) && !rest_.Takes(request.bytes[0], now))
    {
        // Segments of a sub-block use all bits of the command; 80h has none of their numbers. The next one goes on.
        const bool is_block = (phase_ == Phase::kBlockDownload);
        const std::uint8_t mask = is_block ? 0xFFU : kCommandMask;
        last_ = (!is_block || ((request.bytes[0] & kSequenceMask) == (sequence_ + 1U))) ? now : last_;
        if ((request.bytes[0] & mask) == kAbort)
        {
            phase_ = Phase::kIdle;
        }
        else
        {
            answer = Dispatch(request);
        }
    }
    return answer;
}

SdoAnswer SdoServer::Poll(const Instant now) noexcept
{
    SdoAnswer answer = kNoAnswer;
    const std::uint32_t silence_us = now.us - last_.us;
    rest_.Poll(now, time_out_us_ / 2U);
    if (phase_ == Phase::kBlockUpload)
    {
        last_ = now;
        answer = NextSegment();
    }
    else if (phase_ == Phase::kDelayed)
    {
        answer = AskAgain();
    }
    else if (IsBusy() && (silence_us >= time_out_us_))
    {
        answer = Cut(SdoAbort::kTimeOut);
    }
    else if ((phase_ == Phase::kBlockDownload) && (sequence_ > 0U) && (silence_us >= (time_out_us_ / 2U)) &&
             !is_repeated_)
    {
        answer = AcknowledgeBlock();
        is_repeated_ = true;
    }
    return answer;
}

SdoAnswer SdoServer::Close(const SdoAbort reason) noexcept
{
    return IsBusy() ? Cut(reason) : kNoAnswer;
}

/// As Abort, of a transfer whose client may not know yet.
SdoAnswer SdoServer::Cut(const SdoAbort reason) noexcept
{
    if (phase_ == Phase::kBlockDownload)
    {
        rest_.Await(block_size_);
    }
    return Abort(reason);
}

SdoAnswer SdoServer::Dispatch(const SdoFrame& request) noexcept
{
    const std::uint8_t command = request.bytes[0] & kCommandMask;
    const std::uint8_t upload_part = request.bytes[0] & kSubCommandOfUpload;
    SdoAnswer answer = kNoAnswer;
    if (phase_ == Phase::kBlockDownload)
    {
        answer = BlockSegment(request);
    }
    else if (phase_ == Phase::kIdle)
    {
        answer = Begin(request);
    }
    else if ((phase_ == Phase::kSegmentDownload) && (command == kDownloadSegment))
    {
        answer = DownloadSegment(request);
    }
    else if ((phase_ == Phase::kSegmentUpload) && (command == kUploadSegment))
    {
        answer = UploadSegment(request);
    }
    else if ((phase_ == Phase::kBlockDownloadEnd) && (command == kBlockDownload) &&
             ((request.bytes[0] & kSubCommandOfDownload) == 1U))
    {
        answer = EndBlockDownload(request);
    }
    else if (command != kBlockUpload)
    {
        answer = Abort(SdoAbort::kCommand);
    }
    else if ((phase_ == Phase::kBlockUploadStart) && (upload_part == 3U))
    {
        phase_ = Phase::kBlockUpload;
        answer = NextSegment();
    }
    else if (((phase_ == Phase::kBlockUploadAck) || (phase_ == Phase::kBlockUpload)) && (upload_part == 2U))
    {
        answer = BlockAcknowledged(request);
    }
    else if ((phase_ == Phase::kBlockUploadEnd) && (upload_part == 1U))
    {
        phase_ = Phase::kIdle;
    }
    else
    {
        answer = Abort(SdoAbort::kCommand);
    }
    return answer;
}

SdoAnswer SdoServer::Begin(const SdoFrame& request) noexcept
{
    const std::uint8_t command = request.bytes[0] & kCommandMask;
    SetTarget(request);
    SdoAnswer answer = kNoAnswer;
    if (command == kDownload)
    {
        answer = BeginDownload(request);
    }
    else if (command == kUpload)
    {
        answer = BeginUpload();
    }
    else if ((command == kBlockDownload) && ((request.bytes[0] & kSubCommandOfDownload) == 0U))
    {
        answer = BeginBlockDownload(request);
    }
    else if ((command == kBlockUpload) && ((request.bytes[0] & kSubCommandOfUpload) == 0U))
    {
        answer = BeginBlockUpload(request);
    }
    else
    {
        target_ = ObjectAddress{0U, 0U}; // These requests name no object.
        answer = Abort(SdoAbort::kCommand);
    }
    return answer;
}

void SdoServer::SetTarget(const SdoFrame& request) noexcept
{
    target_ = ObjectAddress{static_cast<std::uint16_t>(FromLittleEndian(&request.bytes[1], 2U)), request.bytes[3]};
    position_ = 0U;
    crc_bytes_ = 0U;
    crc_ = 0U;
    toggle_ = 0U;
    sequence_ = 0U;
    has_last_ = false;
    refusal_ = SdoAbort::kNone;
    is_repeated_ = false;
}

SdoAnswer SdoServer::Abort(const SdoAbort reason) noexcept
{
    phase_ = Phase::kIdle;
    return Answer(kAbort, static_cast<std::uint32_t>(reason));
}

/// A frame with the transfer's index and sub-index and four bytes more.
SdoAnswer SdoServer::Answer(const std::uint8_t command, const std::uint32_t value) const noexcept
{
    SdoAnswer answer{SdoPresence::kFrame, {}};
    answer.frame.bytes[0] = command;
    ToLittleEndian(target_.index, &answer.frame.bytes[1], 2U);
    answer.frame.bytes[3] = target_.sub;
    ToLittleEndian(value, &answer.frame.bytes[4], 4U);
    return answer;
}

SdoAnswer SdoServer::BeginDownload(const SdoFrame& request) noexcept
{
    SdoAnswer answer{};
    if ((request.bytes[0] & kExpedited) != 0U)
    {
        answer = DownloadExpedited(request);
    }
    else
    {
        const SdoAbort abort = PrepareDownload(request, kStated);
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
    return Finish(dictionary_.WriteAgain(target_, Bytes{buffer_.data, position_}), delayed_);
}

/// Whether a download can be taken that states its length where `mark` is set. FFFFFFFFh, which is kUnknownLength, is
/// refused as one less is: nobody has room for either.
SdoAbort SdoServer::PrepareDownload(const SdoFrame& request, const std::uint8_t mark) noexcept
{
    const auto size_bytes = static_cast<std::uint32_t>(FromLittleEndian(&request.bytes[4], 4U));
    const std::uint32_t stated = (size_bytes == kUnknownLength) ? (kUnknownLength - 1U) : size_bytes;
    length_ = ((request.bytes[0] & mark) != 0U) ? stated : kUnknownLength;
    SdoAbort abort = dictionary_.MayWrite(target_, length_);
    if ((abort == SdoAbort::kNone) && (length_ != kUnknownLength) && (length_ > buffer_.size_bytes))
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

SdoAnswer SdoServer::BeginBlockDownload(const SdoFrame& request) noexcept
{
    const SdoAbort abort = PrepareDownload(request, kSizeStated);
    has_crc_ = (request.bytes[0] & kCrcSupport) != 0U;
    block_size_ = own_block_size_;
    phase_ = Phase::kBlockDownload;
    return (abort == SdoAbort::kNone) ? Answer(kDownloadBegun, block_size_) : Abort(abort);
}

/// Segments that follow a refused one are still segments: taken for requests they would be carried out. So the abort
/// comes when none can follow any more. One out of order, or of a number that the block does not have, was not
/// received.
SdoAnswer SdoServer::BlockSegment(const SdoFrame& request) noexcept
{
    const std::uint8_t number = request.bytes[0] & kSequenceMask;
    const bool is_last = (request.bytes[0] & kLastSegment) != 0U;
    if (number == (sequence_ + 1U))
    {
        refusal_ = (refusal_ == SdoAbort::kNone) ? TakeSegment(request) : refusal_;
        sequence_ = number;
        has_last_ = is_last;
        is_repeated_ = is_repeated_ && (refusal_ == SdoAbort::kNone);
    }
    SdoAnswer answer{};
    if (is_last || (number == block_size_))
    {
        answer = AcknowledgeBlock();
        is_repeated_ = false;
        if ((number != 1U) || (phase_ != Phase::kBlockDownload))
        {
            doubled_.Await(request.bytes);
        }
    }
    return answer;
}

/// The next segment in order. Its last bytes may be none of the value, which only the end of the transfer tells: they
/// are counted, and kept if there is room.
SdoAbort SdoServer::TakeSegment(const SdoFrame& request) noexcept
{
    const std::uint32_t limit = (length_ < buffer_.size_bytes) ? length_ : buffer_.size_bytes;
    SdoAbort abort = SdoAbort::kNone;
    if ((position_ >= limit) && (position_ > 0U))
    {
        abort = (limit == length_) ? SdoAbort::kTooLong : SdoAbort::kOutOfMemory;
    }
    else
    {
        crc_ = ContinueCrc(crc_, Bytes{&buffer_.data[crc_bytes_], position_ - crc_bytes_});
        crc_bytes_ = position_;
        for (std::uint32_t i = 0U; (i < kSegmentBytes) && ((position_ + i) < buffer_.size_bytes); ++i)
        {
            buffer_.data[position_ + i] = request.bytes[1U + i];
        }
        position_ += kSegmentBytes;
    }
    return abort;
}

SdoAnswer SdoServer::AcknowledgeBlock() noexcept
{
    SdoAnswer answer{SdoPresence::kFrame, {}};
    answer.frame.bytes[0] = kBlockTaken;
    answer.frame.bytes[1] = sequence_;
    answer.frame.bytes[2] = own_block_size_;
    sequence_ = 0U;
    phase_ = has_last_ ? Phase::kBlockDownloadEnd : Phase::kBlockDownload;
    return (refusal_ == SdoAbort::kNone) ? answer : Abort(refusal_);
}

SdoAnswer SdoServer::EndBlockDownload(const SdoFrame& request) noexcept
{
    const std::uint32_t unused = (static_cast<std::uint32_t>(request.bytes[0]) >> 2U) & 7U;
    const std::uint32_t size_bytes = position_ - unused; // One segment came at least.
    SdoAbort abort = SdoAbort::kOutOfMemory;
    if (size_bytes <= buffer_.size_bytes)
    {
        crc_ = ContinueCrc(crc_, Bytes{&buffer_.data[crc_bytes_], size_bytes - crc_bytes_});
        const bool is_whole = !has_crc_ || (FromLittleEndian(&request.bytes[1], 2U) == crc_);
        abort = is_whole ? Store(size_bytes) : SdoAbort::kCrc;
    }
    SdoAnswer done{SdoPresence::kFrame, {}};
    done.frame.bytes[0] = kDownloadEnded;
    return Finish(abort, done);
}

SdoAnswer SdoServer::BeginBlockUpload(const SdoFrame& request) noexcept
{
    const std::uint8_t threshold = request.bytes[5];
    SdoAnswer answer{};
    const Reading reading = dictionary_.Read(target_, buffer_);
    length_ = reading.size_bytes;
    has_crc_ = (request.bytes[0] & kCrcSupport) != 0U;
    block_size_ = request.bytes[4];
    if (!IsBlockSize(block_size_))
    {
        answer = Abort(SdoAbort::kBlockSize);
    }
    else if (reading.abort != SdoAbort::kNone)
    {
        answer = Abort(reading.abort);
    }
    else if ((threshold > 0U) && (length_ <= threshold))
    {
        answer = AnswerUpload();
    }
    else
    {
        phase_ = Phase::kBlockUploadStart;
        answer = Answer(kUploadBegun, length_);
    }
    return answer;
}

/// The segment after `sequence_` of the sub-block that begins at `position_`.
SdoAnswer SdoServer::NextSegment() noexcept
{
    const std::uint32_t at = position_ + (static_cast<std::uint32_t>(sequence_) * kSegmentBytes);
    const std::uint32_t left = length_ - at;
    const std::uint32_t count = (left < kSegmentBytes) ? left : kSegmentBytes;
    const bool is_last = (count == left);
    ++sequence_;
    SdoAnswer answer{SdoPresence::kFrame, {}};
    answer.frame.bytes[0] = static_cast<std::uint8_t>(sequence_ | (is_last ? kLastSegment : 0U));
    for (std::uint32_t i = 0U; i < count; ++i)
    {
        answer.frame.bytes[1U + i] = buffer_.data[at + i];
    }
    if (is_last || (sequence_ == block_size_))
    {
        phase_ = Phase::kBlockUploadAck;
    }
    return answer;
}

SdoAnswer SdoServer::BlockAcknowledged(const SdoFrame& request) noexcept
{
    const std::uint8_t taken = request.bytes[1];
    SdoAnswer answer{};
    if (taken > sequence_)
    {
        answer = Abort(SdoAbort::kSequence);
    }
    else if (!IsBlockSize(request.bytes[2]))
    {
        answer = Abort(SdoAbort::kBlockSize);
    }
    else
    {
        const std::uint32_t left = length_ - position_;
        const std::uint32_t sent = static_cast<std::uint32_t>(taken) * kSegmentBytes;
        const bool is_done = (taken > 0U) && (sent >= left);
        const std::uint32_t advance = (sent < left) ? sent : left;
        const std::uint32_t unused = is_done ? (sent - left) : 0U;
        crc_ = ContinueCrc(crc_, Bytes{&buffer_.data[position_], advance});
        position_ += advance;
        sequence_ = 0U;
        block_size_ = request.bytes[2];
        phase_ = is_done ? Phase::kBlockUploadEnd : Phase::kBlockUpload;
        if (is_done)
        {
            answer.presence = SdoPresence::kFrame;
            answer.frame.bytes[0] = static_cast<std::uint8_t>(kUploadEnd | (unused << 2U));
            ToLittleEndian(has_crc_ ? crc_ : 0U, &answer.frame.bytes[1], 2U);
        }
        else
        {
            answer = NextSegment();
        }
    }
    return answer;
}

} // namespace counterpoint::cia301
