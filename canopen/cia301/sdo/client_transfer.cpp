// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/sdo/client_transfer.hpp"

#include "canopen/cia301/base/little_endian.hpp"
#include "canopen/cia301/store/crc16.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint8_t kCommandMask = 0xE0U;
constexpr std::uint8_t kBlockMask = 0xE3U;
constexpr std::uint8_t kBlockBeginMask = 0xE1U;
constexpr std::uint8_t kUploadRequest = 0x40U;
constexpr std::uint8_t kUploadAnswer = 0x40U;
constexpr std::uint8_t kDownloadAnswer = 0x60U;
constexpr std::uint8_t kBlockUploadRequest = 0xA4U;   ///< With CRC.
constexpr std::uint8_t kBlockDownloadRequest = 0xC6U; ///< With CRC and length.
constexpr std::uint8_t kAbort = 0x80U;

constexpr std::uint8_t kToggle = 0x10U;
constexpr std::uint8_t kExpedited = 0x02U;
constexpr std::uint8_t kStated = 0x01U;
constexpr std::uint8_t kLast = 0x01U;
constexpr std::uint8_t kNextSegment = 0x60U;
constexpr std::uint32_t kExpeditedBytes = 4U;

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

SdoAbort CodeOf(const SdoFrame& answer) noexcept
{
    return static_cast<SdoAbort>(static_cast<std::uint32_t>(FromLittleEndian(&answer.bytes[4], 4U)));
}

} // namespace

SdoClientTransfer::SdoClientTransfer(const SdoClientLink& link) noexcept
    : link_(link), job_{{0U, 0U}, SdoMode::kInvalid, false, {nullptr, 0U}, {nullptr, 0U}, 0U}, phase_(Phase::kIdle),
      state_(SdoClientState::kIdle), outcome_{SdoAbort::kNone, false, 0U}, length_(0U), position_(0U), crc_bytes_(0U),
      crc_(0U), toggle_(0U), sequence_(0U), block_size_(0U), first_(0U), is_begun_(false), has_crc_(false),
      has_last_(false), is_repeated_(false)
{
}

void SdoClientTransfer::Take(const SdoJob& job) noexcept
{
    job_ = job;
    length_ = job.is_upload ? kUnknownLength : job.source.size_bytes;
    position_ = 0U;
    crc_bytes_ = 0U;
    crc_ = 0U;
    toggle_ = 0U;
    sequence_ = 0U;
    is_begun_ = false;
    has_last_ = false;
    is_repeated_ = false;
    state_ = SdoClientState::kBusy;
    phase_ = Phase::kIdle;
}

void SdoClientTransfer::Begin() noexcept
{
    link_.OnBegin(job_.target);
    if (!job_.is_upload)
    {
        BeginDownload();
    }
    else
    {
        const bool is_block = (job_.mode == SdoMode::kBlock);
        block_size_ = job_.block_size;
        phase_ = is_block ? Phase::kBlockUploadBegin : Phase::kUploadBegin;
        link_.Request(is_block ? kBlockUploadRequest : kUploadRequest, job_.target,
                      is_block ? std::uint32_t{block_size_} : 0U);
    }
}

void SdoClientTransfer::BeginDownload() noexcept
{
    const bool is_expedited = (length_ > 0U) && (length_ <= kExpeditedBytes);
    if (job_.mode == SdoMode::kBlock)
    {
        phase_ = Phase::kBlockDownloadBegin;
        link_.Request(kBlockDownloadRequest, job_.target, length_);
    }
    else if (is_expedited)
    {
        const auto command = static_cast<std::uint8_t>(0x23U | ((kExpeditedBytes - length_) << 2U));
        phase_ = Phase::kDownloadBegin;
        position_ = length_;
        has_last_ = true;
        link_.Request(command, job_.target, static_cast<std::uint32_t>(FromLittleEndian(job_.source.data, length_)));
    }
    else
    {
        phase_ = Phase::kDownloadBegin;
        link_.Request(0x21U, job_.target, length_);
    }
}

void SdoClientTransfer::OnAnswer(const SdoFrame& answer) noexcept
{
    switch (phase_)
    {
    case Phase::kDownloadBegin:
    case Phase::kUploadBegin:
    case Phase::kBlockDownloadBegin:
    case Phase::kBlockUploadBegin:
        if (IsFor(answer, job_.target))
        {
            first_ = answer.bytes[0];
            is_begun_ = true;
            OnFirst(answer);
        }
        break;
    case Phase::kDownloadSegment:
    case Phase::kUploadSegment:
    case Phase::kBlockDownload:
    case Phase::kBlockDownloadAck:
    case Phase::kBlockDownloadEnd:
    case Phase::kBlockUpload:
    case Phase::kBlockUploadEnd:
        if (!IsFirstAgain(answer))
        {
            is_begun_ = false;
            OnRest(answer);
        }
        break;
    case Phase::kIdle:
    default:
        break;
    }
}

/// A first answer, which names the object. What does not fit is from before.
void SdoClientTransfer::OnFirst(const SdoFrame& answer) noexcept
{
    const std::uint8_t head = answer.bytes[0];
    const bool is_upload_answer = (head & kCommandMask) == kUploadAnswer;
    if (head == kAbort)
    {
        Fail(CodeOf(answer), true);
    }
    else if ((phase_ == Phase::kDownloadBegin) && ((head & kCommandMask) == kDownloadAnswer))
    {
        OnSegmentTaken(answer);
    }
    else if (((phase_ == Phase::kUploadBegin) || (phase_ == Phase::kBlockUploadBegin)) && is_upload_answer)
    {
        OnUploadBegin(answer);
    }
    else if ((phase_ == Phase::kBlockDownloadBegin) && ((head & kBlockMask) == 0xA0U))
    {
        OnBlockDownloadBegin(answer);
    }
    else if ((phase_ == Phase::kBlockUploadBegin) && ((head & kBlockBeginMask) == 0xC0U))
    {
        OnBlockUploadBegin(answer);
    }
}

/// A server that kept the request of before its restart answers it behind its boot-up message, and the one that came
/// since as well. The transfer is the one that the last request began, whichever answer was the first. [SRS_SDC_450]
bool SdoClientTransfer::IsFirstAgain(const SdoFrame& answer) const noexcept
{
    return is_begun_ && (answer.bytes[0] == first_) && IsFor(answer, job_.target);
}

/// Answers come in order: after the first one, which may come twice, every frame belongs to this transfer.
void SdoClientTransfer::OnRest(const SdoFrame& answer) noexcept
{
    const std::uint8_t head = answer.bytes[0];
    const bool is_sending = (phase_ == Phase::kBlockDownload) || (phase_ == Phase::kBlockDownloadAck);
    if (head == kAbort)
    {
        // A server that has forgotten the transfer names no object.
        const bool is_ours = IsFor(answer, job_.target) || IsFor(answer, ObjectAddress{0U, 0U});
        if (is_ours)
        {
            Fail(CodeOf(answer), true);
        }
    }
    else if ((phase_ == Phase::kDownloadSegment) && ((head & kCommandMask) == 0x20U))
    {
        OnSegmentTaken(answer);
    }
    else if ((phase_ == Phase::kUploadSegment) && ((head & kCommandMask) == 0x00U))
    {
        OnUploadSegment(answer);
    }
    else if (is_sending && ((head & kBlockMask) == 0xA2U))
    {
        OnBlockAck(answer);
    }
    else if ((phase_ == Phase::kBlockDownloadEnd) && ((head & kBlockMask) == 0xA1U))
    {
        Finish();
    }
    else if (phase_ == Phase::kBlockUpload)
    {
        OnBlockSegment(answer);
    }
    else if ((phase_ == Phase::kBlockUploadEnd) && ((head & kBlockMask) == 0xC1U))
    {
        OnBlockUploadEnd(answer);
    }
    else
    {
        GiveUp(SdoAbort::kCommand);
    }
}

void SdoClientTransfer::SendSegment() noexcept
{
    const std::uint32_t left = length_ - position_;
    const std::uint32_t count = (left < kSegmentBytes) ? left : kSegmentBytes;
    SdoFrame frame{};
    has_last_ = (count == left);
    frame.bytes[0] = static_cast<std::uint8_t>(toggle_ | ((kSegmentBytes - count) << 1U) | (has_last_ ? kLast : 0U));
    for (std::uint32_t i = 0U; i < count; ++i)
    {
        frame.bytes[1U + i] = job_.source.data[position_ + i];
    }
    position_ += count;
    phase_ = Phase::kDownloadSegment;
    link_.Emit(frame);
}

/// The answer to the begin of a download, or to a segment.
void SdoClientTransfer::OnSegmentTaken(const SdoFrame& answer) noexcept
{
    const bool is_segment = (phase_ == Phase::kDownloadSegment);
    if (is_segment && ((answer.bytes[0] & kToggle) != toggle_))
    {
        GiveUp(SdoAbort::kToggle);
    }
    else if (has_last_)
    {
        Finish();
    }
    else
    {
        toggle_ = is_segment ? static_cast<std::uint8_t>(toggle_ ^ kToggle) : toggle_;
        SendSegment();
    }
}

void SdoClientTransfer::OnUploadBegin(const SdoFrame& answer) noexcept
{
    const std::uint8_t head = answer.bytes[0];
    const bool is_stated = (head & kStated) != 0U;
    if ((head & kExpedited) != 0U)
    {
        const std::uint32_t stated = kExpeditedBytes - ((static_cast<std::uint32_t>(head) >> 2U) & 3U);
        const std::uint32_t most = (job_.room.size_bytes < kExpeditedBytes) ? job_.room.size_bytes : kExpeditedBytes;
        const std::uint32_t count = is_stated ? stated : most;
        if (count > job_.room.size_bytes)
        {
            Fail(SdoAbort::kOutOfMemory, false); // The server has nothing to be told: it is done.
        }
        else
        {
            for (std::uint32_t i = 0U; i < count; ++i)
            {
                job_.room.data[i] = answer.bytes[4U + i];
            }
            position_ = count;
            Finish();
        }
    }
    else
    {
        length_ = is_stated ? static_cast<std::uint32_t>(FromLittleEndian(&answer.bytes[4], 4U)) : kUnknownLength;
        if (is_stated && (length_ > job_.room.size_bytes))
        {
            GiveUp(SdoAbort::kOutOfMemory);
        }
        else
        {
            phase_ = Phase::kUploadSegment;
            link_.Emit(SdoFrame{{kNextSegment}});
        }
    }
}

void SdoClientTransfer::OnUploadSegment(const SdoFrame& answer) noexcept
{
    const std::uint8_t head = answer.bytes[0];
    const std::uint32_t count = kSegmentBytes - ((static_cast<std::uint32_t>(head) >> 1U) & 7U);
    if ((head & kToggle) != toggle_)
    {
        GiveUp(SdoAbort::kToggle);
    }
    else if ((length_ != kUnknownLength) && (count > (length_ - position_)))
    {
        GiveUp(SdoAbort::kTooLong);
    }
    else if (count > (job_.room.size_bytes - position_))
    {
        GiveUp(SdoAbort::kOutOfMemory);
    }
    else
    {
        for (std::uint32_t i = 0U; i < count; ++i)
        {
            job_.room.data[position_ + i] = answer.bytes[1U + i];
        }
        position_ += count;
        toggle_ ^= kToggle;
        const bool is_last = (head & kLast) != 0U;
        if (!is_last)
        {
            link_.Emit(SdoFrame{{static_cast<std::uint8_t>(kNextSegment | toggle_)}});
        }
        else if ((length_ != kUnknownLength) && (position_ < length_))
        {
            GiveUp(SdoAbort::kTooShort);
        }
        else
        {
            Finish();
        }
    }
}

void SdoClientTransfer::OnBlockDownloadBegin(const SdoFrame& answer) noexcept
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

void SdoClientTransfer::SendBlockSegments() noexcept
{
    while ((phase_ == Phase::kBlockDownload) && link_.Flush())
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
            frame.bytes[1U + i] = job_.source.data[at + i];
        }
        phase_ = (is_last || (sequence_ == block_size_)) ? Phase::kBlockDownloadAck : Phase::kBlockDownload;
        link_.Emit(frame);
    }
}

void SdoClientTransfer::OnBlockAck(const SdoFrame& answer) noexcept
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
        crc_ = ContinueCrc(crc_, Bytes{&job_.source.data[position_], advance});
        position_ += advance;
        sequence_ = 0U;
        block_size_ = answer.bytes[2];
        link_.Drop(); // A segment that waits has its number from before.
        link_.OnHeard();
        phase_ = is_done ? Phase::kBlockDownloadEnd : Phase::kBlockDownload;
        if (is_done)
        {
            SdoFrame frame{};
            frame.bytes[0] = static_cast<std::uint8_t>(kDownloadEnd | ((sent - left) << 2U));
            ToLittleEndian(has_crc_ ? crc_ : 0U, &frame.bytes[1], 2U);
            link_.Emit(frame);
        }
    }
}

void SdoClientTransfer::OnBlockUploadBegin(const SdoFrame& answer) noexcept
{
    const bool is_stated = (answer.bytes[0] & kSizeStated) != 0U;
    has_crc_ = (answer.bytes[0] & kCrcSupport) != 0U;
    length_ = is_stated ? static_cast<std::uint32_t>(FromLittleEndian(&answer.bytes[4], 4U)) : kUnknownLength;
    if (is_stated && (length_ > job_.room.size_bytes))
    {
        GiveUp(SdoAbort::kOutOfMemory);
    }
    else
    {
        phase_ = Phase::kBlockUpload;
        link_.Emit(SdoFrame{{kUploadStart}});
    }
}

void SdoClientTransfer::OnBlockSegment(const SdoFrame& answer) noexcept
{
    const std::uint8_t number = answer.bytes[0] & kSequenceMask;
    const bool is_last = (answer.bytes[0] & kLastSegment) != 0U;
    const std::uint32_t limit = (length_ < job_.room.size_bytes) ? length_ : job_.room.size_bytes;
    const bool is_next = (number == (sequence_ + 1U));
    link_.OnHeard();
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
void SdoClientTransfer::KeepBlockSegment(const SdoFrame& answer) noexcept
{
    crc_ = ContinueCrc(crc_, Bytes{&job_.room.data[crc_bytes_], position_ - crc_bytes_});
    crc_bytes_ = position_;
    for (std::uint32_t i = 0U; (i < kSegmentBytes) && ((position_ + i) < job_.room.size_bytes); ++i)
    {
        job_.room.data[position_ + i] = answer.bytes[1U + i];
    }
    position_ += kSegmentBytes;
    sequence_ = answer.bytes[0] & kSequenceMask;
}

void SdoClientTransfer::AcknowledgeBlock() noexcept
{
    SdoFrame frame{};
    frame.bytes[0] = kBlockTaken;
    frame.bytes[1] = sequence_;
    frame.bytes[2] = block_size_;
    sequence_ = 0U;
    phase_ = has_last_ ? Phase::kBlockUploadEnd : Phase::kBlockUpload;
    link_.Emit(frame);
}

void SdoClientTransfer::OnHalfTimeOut() noexcept
{
    if ((phase_ == Phase::kBlockUpload) && (sequence_ > 0U) && !is_repeated_)
    {
        AcknowledgeBlock();
        is_repeated_ = true;
    }
}

void SdoClientTransfer::OnBlockUploadEnd(const SdoFrame& answer) noexcept
{
    const std::uint32_t unused = (static_cast<std::uint32_t>(answer.bytes[0]) >> 2U) & 7U;
    const std::uint32_t size_bytes = position_ - unused; // One segment came at least.
    SdoAbort abort = CheckEnd(size_bytes);
    if ((abort == SdoAbort::kNone) && has_crc_)
    {
        crc_ = ContinueCrc(crc_, Bytes{&job_.room.data[crc_bytes_], size_bytes - crc_bytes_});
        abort = (FromLittleEndian(&answer.bytes[1], 2U) == crc_) ? SdoAbort::kNone : SdoAbort::kCrc;
    }
    if (abort == SdoAbort::kNone)
    {
        position_ = size_bytes;
        link_.Emit(SdoFrame{{kUploadEnded}});
        Finish();
    }
    else
    {
        GiveUp(abort);
    }
}

SdoAbort SdoClientTransfer::CheckEnd(const std::uint32_t size_bytes) const noexcept
{
    SdoAbort abort = SdoAbort::kNone;
    if (size_bytes > job_.room.size_bytes)
    {
        abort = SdoAbort::kOutOfMemory;
    }
    else if ((length_ != kUnknownLength) && (size_bytes != length_))
    {
        abort = (size_bytes > length_) ? SdoAbort::kTooLong : SdoAbort::kTooShort;
    }
    return abort;
}

void SdoClientTransfer::Finish() noexcept
{
    outcome_ = SdoOutcome{SdoAbort::kNone, false, position_};
    state_ = SdoClientState::kDone;
    phase_ = Phase::kIdle;
}

void SdoClientTransfer::GiveUp(const SdoAbort reason) noexcept
{
    link_.Abort(job_.target, reason);
    Fail(reason, false);
}

void SdoClientTransfer::Fail(const SdoAbort reason, const bool by_server) noexcept
{
    outcome_ = SdoOutcome{reason, by_server, position_};
    state_ = SdoClientState::kAborted;
    phase_ = Phase::kIdle;
}

} // namespace counterpoint::cia301
