// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/sdo/server.hpp"

#include "canopen/cia301/base/little_endian.hpp"

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

} // namespace

SdoServer::SdoServer(const SdoServerParts& parts) noexcept
    : dictionary_(parts.dictionary), buffer_(parts.buffer), time_out_us_(parts.time_out_us),
      own_block_size_((parts.block_size == 0U) ? kMaxBlockSize : AtMost(parts.block_size, kMaxBlockSize)),
      phase_(Phase::kIdle), target_{0U, 0U}, last_{0U}, length_(0U), position_(0U), crc_bytes_(0U), crc_(0U),
      toggle_(0U), sequence_(0U), block_size_(0U), has_crc_(false), has_last_(false), is_repeated_(false),
      delayed_{SdoPresence::kNothing, {}}
{
}

bool SdoServer::IsBusy() const noexcept
{
    return phase_ != Phase::kIdle;
}

SdoAnswer SdoServer::OnFrame(const SdoFrame& request, const std::uint8_t length_bytes, const Instant now) noexcept
{
    SdoAnswer answer = kNoAnswer;
    if (length_bytes == 8U)
    {
        // Segments of a sub-block use all bits of the command; 80h has none of their numbers.
        const std::uint8_t mask = (phase_ == Phase::kBlockDownload) ? 0xFFU : kCommandMask;
        last_ = now;
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
        answer = Abort(SdoAbort::kTimeOut);
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
    return IsBusy() ? Abort(reason) : kNoAnswer;
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
        answer = StartBlockUpload(request);
    }
    else if (((phase_ == Phase::kBlockUploadAck) || (phase_ == Phase::kBlockUpload)) && (upload_part == 2U))
    {
        answer = BlockAcknowledged(request);
    }
    else if ((phase_ == Phase::kBlockUploadEnd) && (upload_part == 1U))
    {
        answer = EndBlockUpload(request);
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

} // namespace counterpoint::cia301
