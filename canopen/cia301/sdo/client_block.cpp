// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Block transfers of the SDO client.
#include "canopen/cia301/base/little_endian.hpp"
#include "canopen/cia301/sdo/client.hpp"
#include "canopen/cia301/store/crc16.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint8_t kCrcSupport = 0x04U;
constexpr std::uint8_t kSizeStated = 0x02U;
constexpr std::uint8_t kLastSegment = 0x80U;
constexpr std::uint8_t kSequenceMask = 0x7FU;
constexpr std::uint8_t kDownloadEnd = 0xC1U;
constexpr std::uint8_t kBlockTaken = 0xA2U;
constexpr std::uint8_t kUploadStart = 0xA3U;
constexpr std::uint8_t kUploadEnded = 0xA1U;

bool IsBlockSize(const std::uint8_t size) noexcept
{
    return (size >= 1U) && (size <= kMaxBlockSize);
}

} // namespace

void SdoClient::OnBlockDownloadBegin(const SdoFrame& answer) noexcept
{
    has_crc_ = (answer.bytes[0] & kCrcSupport) != 0U;
    block_size_ = answer.bytes[4];
    if (IsBlockSize(block_size_))
    {
        phase_ = Phase::kBlockDownload; // SendBlockSegments follows.
    }
    else
    {
        GiveUp(SdoAbort::kBlockSize);
    }
}

/// As many segments of the sub-block as the sink takes.
void SdoClient::SendBlockSegments() noexcept
{
    while ((phase_ == Phase::kBlockDownload) && Flush())
    {
        const std::uint32_t at = position_ + (static_cast<std::uint32_t>(sequence_) * kSegmentBytes);
        const std::uint32_t left = length_ - at;
        const std::uint32_t count = (left < kSegmentBytes) ? left : kSegmentBytes;
        const bool is_last = (count == left);
        SdoFrame frame{};
        ++sequence_;
        frame.bytes[0] = static_cast<std::uint8_t>(sequence_ | (is_last ? kLastSegment : 0U));
        for (std::uint32_t i = 0U; i < count; ++i)
        {
            frame.bytes[1U + i] = source_.data[at + i];
        }
        phase_ = (is_last || (sequence_ == block_size_)) ? Phase::kBlockDownloadAck : Phase::kBlockDownload;
        Emit(frame);
    }
}

void SdoClient::OnBlockAck(const SdoFrame& answer) noexcept
{
    const std::uint8_t taken = answer.bytes[1];
    if (taken > sequence_)
    {
        GiveUp(SdoAbort::kSequence);
    }
    else if (!IsBlockSize(answer.bytes[2]))
    {
        GiveUp(SdoAbort::kBlockSize);
    }
    else
    {
        const std::uint32_t left = length_ - position_;
        const std::uint32_t sent = static_cast<std::uint32_t>(taken) * kSegmentBytes;
        const bool is_done = (taken > 0U) && (sent >= left);
        const std::uint32_t advance = (sent < left) ? sent : left;
        crc_ = ContinueCrc(crc_, Bytes{&source_.data[position_], advance});
        position_ += advance;
        sequence_ = 0U;
        block_size_ = answer.bytes[2];
        is_sending_ = false; // A segment that waits has its number from before.
        last_ = now_;
        phase_ = is_done ? Phase::kBlockDownloadEnd : Phase::kBlockDownload;
        if (is_done)
        {
            SdoFrame frame{};
            frame.bytes[0] = static_cast<std::uint8_t>(kDownloadEnd | ((sent - left) << 2U));
            ToLittleEndian(has_crc_ ? crc_ : 0U, &frame.bytes[1], 2U);
            Emit(frame);
        }
    }
}

void SdoClient::OnBlockUploadBegin(const SdoFrame& answer) noexcept
{
    const bool is_stated = (answer.bytes[0] & kSizeStated) != 0U;
    has_crc_ = (answer.bytes[0] & kCrcSupport) != 0U;
    length_ = is_stated ? static_cast<std::uint32_t>(FromLittleEndian(&answer.bytes[4], 4U)) : kUnknownLength;
    if (is_stated && (length_ > room_.size_bytes))
    {
        GiveUp(SdoAbort::kOutOfMemory);
    }
    else
    {
        phase_ = Phase::kBlockUpload;
        Emit(SdoFrame{{kUploadStart}});
    }
}

void SdoClient::OnBlockSegment(const SdoFrame& answer) noexcept
{
    const std::uint8_t number = answer.bytes[0] & kSequenceMask;
    const bool is_last = (answer.bytes[0] & kLastSegment) != 0U;
    const std::uint32_t limit = (length_ < room_.size_bytes) ? length_ : room_.size_bytes;
    const bool is_next = (number == (sequence_ + 1U));
    last_ = now_;
    if ((number == 0U) || (number > block_size_))
    {
        GiveUp(SdoAbort::kSequence);
    }
    else if (is_next && (position_ >= limit) && (position_ > 0U))
    {
        GiveUp((limit == length_) ? SdoAbort::kTooLong : SdoAbort::kOutOfMemory);
    }
    else
    {
        if (is_next)
        {
            KeepBlockSegment(answer);
            has_last_ = is_last;
        }
        if (is_last || (number == block_size_))
        {
            AcknowledgeBlock();
            is_repeated_ = false;
        }
    }
}

/// The next segment in order. Its last bytes may be none of the value, which only the end of the transfer tells: they
/// are counted, and kept if there is room.
void SdoClient::KeepBlockSegment(const SdoFrame& answer) noexcept
{
    crc_ = ContinueCrc(crc_, Bytes{&room_.data[crc_bytes_], position_ - crc_bytes_});
    crc_bytes_ = position_;
    for (std::uint32_t i = 0U; (i < kSegmentBytes) && ((position_ + i) < room_.size_bytes); ++i)
    {
        room_.data[position_ + i] = answer.bytes[1U + i];
    }
    position_ += kSegmentBytes;
    sequence_ = answer.bytes[0] & kSequenceMask;
}

void SdoClient::AcknowledgeBlock() noexcept
{
    SdoFrame frame{};
    frame.bytes[0] = kBlockTaken;
    frame.bytes[1] = sequence_;
    frame.bytes[2] = block_size_;
    sequence_ = 0U;
    phase_ = has_last_ ? Phase::kBlockUploadEnd : Phase::kBlockUpload;
    Emit(frame);
}

void SdoClient::OnBlockUploadEnd(const SdoFrame& answer) noexcept
{
    const std::uint32_t unused = (static_cast<std::uint32_t>(answer.bytes[0]) >> 2U) & 7U;
    const std::uint32_t size_bytes = position_ - unused; // One segment came at least.
    SdoAbort abort = CheckEnd(size_bytes);
    if ((abort == SdoAbort::kNone) && has_crc_)
    {
        crc_ = ContinueCrc(crc_, Bytes{&room_.data[crc_bytes_], size_bytes - crc_bytes_});
        abort = (FromLittleEndian(&answer.bytes[1], 2U) == crc_) ? SdoAbort::kNone : SdoAbort::kCrc;
    }
    if (abort == SdoAbort::kNone)
    {
        position_ = size_bytes;
        Emit(SdoFrame{{kUploadEnded}});
        Finish();
    }
    else
    {
        GiveUp(abort);
    }
}

SdoAbort SdoClient::CheckEnd(const std::uint32_t size_bytes) const noexcept
{
    SdoAbort abort = SdoAbort::kNone;
    if (size_bytes > room_.size_bytes)
    {
        abort = SdoAbort::kOutOfMemory;
    }
    else if ((length_ != kUnknownLength) && (size_bytes != length_))
    {
        abort = (size_bytes > length_) ? SdoAbort::kTooLong : SdoAbort::kTooShort;
    }
    return abort;
}

} // namespace counterpoint::cia301
