// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Course of a transfer and time-outs. What is an answer, segments and blocks are in files of their own.
#include "canopen/cia301/sdo/client.hpp"

#include "canopen/cia301/base/little_endian.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint32_t kRequests = 0x600U;
constexpr std::uint32_t kAnswers = 0x580U;
constexpr std::uint16_t kMarkedIndex = 0x1000U;
constexpr std::uint8_t kLastMark = 254U;
constexpr std::uint8_t kUploadRequest = 0x40U;
constexpr std::uint8_t kAbort = 0x80U;
constexpr std::uint8_t kBlockUploadRequest = 0xA4U;   ///< With CRC.
constexpr std::uint8_t kBlockDownloadRequest = 0xC6U; ///< With CRC and length.
constexpr std::uint32_t kFrameBytes = 8U;

SdoConnection DefaultOf(const NodeId server) noexcept
{
    return SdoConnection{kRequests + server.value, kAnswers + server.value, server};
}

} // namespace

SdoClient::SdoClient(const SdoClientParts& parts) noexcept
    : parts_(parts), connection_(DefaultOf(parts.server)), phase_(Phase::kIdle), state_(SdoClientState::kIdle),
      mode_(SdoMode::kInvalid), outcome_{SdoAbort::kNone, false, 0U}, target_{0U, 0U}, stale_{0U, 0U},
      source_{nullptr, 0U}, room_{nullptr, 0U}, now_{0U}, last_{0U}, length_(0U), position_(0U), crc_bytes_(0U),
      crc_(0U), toggle_(0U), sequence_(0U), block_size_(0U), mark_(0U), is_upload_(false), has_crc_(false),
      has_last_(false), is_repeated_(false), is_doubtful_(false), has_given_up_(false), is_sending_(false), waiting_{}
{
    const bool is_size = (parts_.block_size >= 1U) && (parts_.block_size <= kMaxBlockSize);
    parts_.block_size = is_size ? parts_.block_size : kMaxBlockSize;
}

bool SdoClient::StartUpload(const ObjectAddress& target, const Room& room, const SdoMode mode,
                            const Instant now) noexcept
{
    const bool is_free = (state_ != SdoClientState::kBusy);
    room_ = is_free ? room : room_;
    length_ = is_free ? kUnknownLength : length_;
    return Start(target, mode, true, now);
}

bool SdoClient::StartDownload(const ObjectAddress& target, const Bytes& value, const SdoMode mode,
                              const Instant now) noexcept
{
    const bool is_free = (state_ != SdoClientState::kBusy);
    source_ = is_free ? value : source_;
    length_ = is_free ? value.size_bytes : length_;
    return Start(target, mode, false, now);
}

bool SdoClient::Start(const ObjectAddress& target, const SdoMode mode, const bool is_upload, const Instant now) noexcept
{
    const bool is_free = (state_ != SdoClientState::kBusy);
    if (is_free)
    {
        target_ = target;
        mode_ = mode;
        is_upload_ = is_upload;
        now_ = now;
        last_ = now;
        position_ = 0U;
        crc_bytes_ = 0U;
        crc_ = 0U;
        toggle_ = 0U;
        sequence_ = 0U;
        has_last_ = false;
        is_repeated_ = false;
        state_ = SdoClientState::kBusy;
        phase_ = Phase::kQueued;
        if (Flush())
        {
            Begin();
        }
    }
    return is_free;
}

/// Nothing of the transfer before waits any more.
void SdoClient::Begin() noexcept
{
    if (is_doubtful_)
    {
        SendMark();
    }
    else if (!is_upload_)
    {
        stale_ = target_;
        BeginDownload();
    }
    else
    {
        const bool is_block = (mode_ == SdoMode::kBlock);
        stale_ = target_;
        block_size_ = parts_.block_size;
        phase_ = is_block ? Phase::kBlockUploadBegin : Phase::kUploadBegin;
        Request(is_block ? kBlockUploadRequest : kUploadRequest, target_, is_block ? std::uint32_t{block_size_} : 0U);
    }
}

void SdoClient::BeginDownload() noexcept
{
    constexpr std::uint32_t kExpeditedBytes = 4U;
    const bool is_expedited = (length_ > 0U) && (length_ <= kExpeditedBytes);
    if (mode_ == SdoMode::kBlock)
    {
        phase_ = Phase::kBlockDownloadBegin;
        Request(kBlockDownloadRequest, target_, length_);
    }
    else if (is_expedited)
    {
        const auto command = static_cast<std::uint8_t>(0x23U | ((kExpeditedBytes - length_) << 2U));
        phase_ = Phase::kDownloadBegin;
        position_ = length_;
        has_last_ = true;
        Request(command, target_, static_cast<std::uint32_t>(FromLittleEndian(source_.data, length_)));
    }
    else
    {
        phase_ = Phase::kDownloadBegin;
        Request(0x21U, target_, length_);
    }
}

/// Asks for a sub-index that nobody else asks for; see the class.
void SdoClient::SendMark() noexcept
{
    const bool is_taken = (stale_.index == kMarkedIndex) && (stale_.sub == (mark_ + 1U));
    const std::uint32_t next = mark_ + (is_taken ? 2U : 1U);
    mark_ = static_cast<std::uint8_t>((next > kLastMark) ? (next - kLastMark) : next);
    phase_ = Phase::kMark;
    Request(kUploadRequest, ObjectAddress{kMarkedIndex, mark_}, 0U);
}

void SdoClient::OnFrame(const CanFrame& frame, const Instant now) noexcept
{
    const bool is_answer = (frame.kind == FrameKind::kData) && (frame.length_bytes == kFrameBytes) &&
                           (frame.identifier == connection_.answer);
    if (is_answer && (state_ == SdoClientState::kBusy))
    {
        SdoFrame answer{};
        for (std::uint32_t i = 0U; i < kFrameBytes; ++i)
        {
            answer.bytes[i] = frame.data[i];
        }
        now_ = now;
        Dispatch(answer);
        SendBlockSegments();
    }
}

void SdoClient::OnCycle(const Instant now) noexcept
{
    now_ = now;
    const std::uint32_t silence_us = now.us - last_.us;
    const bool is_empty = Flush();
    if (state_ == SdoClientState::kBusy)
    {
        if ((phase_ == Phase::kQueued) && is_empty)
        {
            Begin();
        }
        else if (silence_us >= parts_.time_out_us)
        {
            GiveUp(SdoAbort::kTimeOut);
        }
        else if ((phase_ == Phase::kBlockUpload) && (sequence_ > 0U) && !is_repeated_ &&
                 (silence_us >= (parts_.time_out_us / 2U)))
        {
            AcknowledgeBlock();
            is_repeated_ = true;
        }
        SendBlockSegments();
    }
}

void SdoClient::Cancel(const SdoAbort reason) noexcept
{
    if (state_ == SdoClientState::kBusy)
    {
        GiveUp(reason);
    }
}

void SdoClient::OnServerRestart() noexcept
{
    is_sending_ = false;
    is_doubtful_ = false;
    if (state_ == SdoClientState::kBusy)
    {
        Fail(SdoAbort::kNoConnection, false);
    }
}

bool SdoClient::Connect(const NodeId server) noexcept
{
    return Connect(DefaultOf(server));
}

bool SdoClient::Connect(const SdoConnection& connection) noexcept
{
    const bool is_free = (state_ != SdoClientState::kBusy);
    const bool is_other = (connection.request != connection_.request) || (connection.answer != connection_.answer) ||
                          (connection.server.value != connection_.server.value);
    if (is_free && is_other)
    {
        connection_ = connection;
        is_sending_ = false;
        is_doubtful_ = has_given_up_;
    }
    return is_free;
}

SdoClientState SdoClient::State() const noexcept
{
    return state_;
}

const SdoOutcome& SdoClient::Outcome() const noexcept
{
    return outcome_;
}

NodeId SdoClient::Server() const noexcept
{
    return connection_.server;
}

void SdoClient::Request(const std::uint8_t command, const ObjectAddress& target, const std::uint32_t value) noexcept
{
    SdoFrame frame{};
    frame.bytes[0] = command;
    ToLittleEndian(target.index, &frame.bytes[1], 2U);
    frame.bytes[3] = target.sub;
    ToLittleEndian(value, &frame.bytes[4], 4U);
    Emit(frame);
}

void SdoClient::Emit(const SdoFrame& frame) noexcept
{
    waiting_ = frame;
    is_sending_ = true;
    last_ = now_;
    static_cast<void>(Flush());
}

/// Whether nothing waits any more.
bool SdoClient::Flush() noexcept
{
    if (is_sending_)
    {
        CanFrame frame{connection_.request, FrameKind::kData, CanPortId::kFirst, 8U, {}};
        for (std::uint32_t i = 0U; i < kFrameBytes; ++i)
        {
            frame.data[i] = waiting_.bytes[i];
        }
        is_sending_ = !parts_.sink.Send(frame);
        last_ = is_sending_ ? last_ : now_;
    }
    return !is_sending_;
}

void SdoClient::Finish() noexcept
{
    outcome_ = SdoOutcome{SdoAbort::kNone, false, position_};
    state_ = SdoClientState::kDone;
    phase_ = Phase::kIdle;
}

/// The server is told, and may have answered already.
void SdoClient::GiveUp(const SdoAbort reason) noexcept
{
    const bool is_mark = (phase_ == Phase::kMark);
    if (phase_ != Phase::kQueued)
    {
        Request(kAbort, is_mark ? ObjectAddress{kMarkedIndex, mark_} : target_, static_cast<std::uint32_t>(reason));
        is_doubtful_ = true;
        has_given_up_ = true;
    }
    Fail(reason, false);
}

void SdoClient::Fail(const SdoAbort reason, const bool by_server) noexcept
{
    outcome_ = SdoOutcome{reason, by_server, position_};
    state_ = SdoClientState::kAborted;
    phase_ = Phase::kIdle;
}

} // namespace counterpoint::cia301
