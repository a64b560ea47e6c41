// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Block transfers of the SDO server.
#include "canopen/cia301/base/little_endian.hpp"
#include "canopen/cia301/sdo/server.hpp"
#include "canopen/cia301/store/crc16.hpp"

namespace counterpoint::cia301
{
namespace
{

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

SdoAnswer SdoServer::BeginBlockDownload(const SdoFrame& request) noexcept
{
    const bool is_stated = (request.bytes[0] & kSizeStated) != 0U;
    const auto stated = static_cast<std::uint32_t>(FromLittleEndian(&request.bytes[4], 4U));
    const SdoAbort abort = PrepareDownload(is_stated ? stated : kUnknownLength);
    has_crc_ = (request.bytes[0] & kCrcSupport) != 0U;
    block_size_ = own_block_size_;
    phase_ = Phase::kBlockDownload;
    return (abort == SdoAbort::kNone) ? Answer(kDownloadBegun, block_size_) : Abort(abort);
}

SdoAnswer SdoServer::BlockSegment(const SdoFrame& request) noexcept
{
    const std::uint8_t number = request.bytes[0] & kSequenceMask;
    const bool is_last = (request.bytes[0] & kLastSegment) != 0U;
    SdoAbort abort = SdoAbort::kNone;
    if ((number == 0U) || (number > block_size_))
    {
        abort = SdoAbort::kSequence;
    }
    else if (number == (sequence_ + 1U))
    {
        abort = TakeSegment(request);
        has_last_ = is_last;
    }
    SdoAnswer answer{};
    if (abort != SdoAbort::kNone)
    {
        answer = Abort(abort);
    }
    else if (is_last || (number == block_size_))
    {
        answer = AcknowledgeBlock();
        is_repeated_ = false;
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
        sequence_ = request.bytes[0] & kSequenceMask;
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
    return answer;
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

SdoAnswer SdoServer::StartBlockUpload(const SdoFrame&) noexcept
{
    phase_ = Phase::kBlockUpload;
    return NextSegment();
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

SdoAnswer SdoServer::EndBlockUpload(const SdoFrame&) noexcept
{
    phase_ = Phase::kIdle;
    return SdoAnswer{SdoPresence::kNothing, {}};
}

} // namespace counterpoint::cia301
