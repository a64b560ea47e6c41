// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Whether a transfer runs, and its time-outs.
#include "canopen/cia301/sdo/client.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint32_t kRequests = 0x600U;
constexpr std::uint32_t kAnswers = 0x580U;
constexpr std::uint32_t kFrameBytes = 8U;

SdoConnection DefaultOf(const NodeId server) noexcept
{
    return SdoConnection{kRequests + server.value, kAnswers + server.value, server};
}

} // namespace

SdoClient::SdoClient(const SdoClientParts& parts) noexcept
    : transfer_(SdoClientLink(parts.sink, DefaultOf(parts.server))), phase_(Phase::kIdle),
      time_out_us_(parts.time_out_us), block_size_(parts.block_size), is_held_(false)
{
    const bool is_size = (block_size_ >= 1U) && (block_size_ <= kMaxBlockSize);
    block_size_ = is_size ? block_size_ : kMaxBlockSize;
}

bool SdoClient::StartUpload(const ObjectAddress& target, const Room& room, const SdoMode mode,
                            const Instant now) noexcept
{
    return Start(SdoJob{target, mode, true, Bytes{nullptr, 0U}, room, block_size_}, now);
}

bool SdoClient::StartDownload(const ObjectAddress& target, const Bytes& value, const SdoMode mode,
                              const Instant now) noexcept
{
    return Start(SdoJob{target, mode, false, value, Room{nullptr, 0U}, block_size_}, now);
}

bool SdoClient::Start(const SdoJob& job, const Instant now) noexcept
{
    const bool is_free = !IsBusy();
    if (is_free)
    {
        transfer_.Take(job);
        phase_ = Phase::kQueued;
        transfer_.Link().SetNow(now);
        transfer_.Link().OnHeard();
        if (!is_held_ && transfer_.Link().Flush())
        {
            Begin();
        }
    }
    return is_free;
}

/// Nothing of the transfer before waits any more.
void SdoClient::Begin() noexcept
{
    if (transfer_.Link().IsDoubtful())
    {
        phase_ = Phase::kMark;
        transfer_.Link().SendMark();
    }
    else
    {
        phase_ = Phase::kRunning;
        transfer_.Begin();
    }
}

void SdoClient::OnFrame(const CanFrame& frame, const Instant now) noexcept
{
    const bool is_answer = (frame.kind == FrameKind::kData) && (frame.length_bytes == kFrameBytes) &&
                           (frame.identifier == transfer_.Link().Connection().answer);
    if (is_answer && IsBusy())
    {
        SdoFrame answer{};
        for (std::uint32_t i = 0U; i < kFrameBytes; ++i)
        {
            answer.bytes[i] = frame.data[i];
        }
        transfer_.Link().SetNow(now);
        if (phase_ == Phase::kMark)
        {
            OnMark(answer);
        }
        else
        {
            transfer_.OnAnswer(answer); // Nothing before it began.
        }
        transfer_.SendBlockSegments();
    }
}

void SdoClient::OnMark(const SdoFrame& answer) noexcept
{
    if (transfer_.Link().TakeMark(answer))
    {
        phase_ = Phase::kQueued;
        if (transfer_.Link().Flush())
        {
            Begin();
        }
    }
}

void SdoClient::OnCycle(const Instant now) noexcept
{
    const std::uint32_t silence_us = transfer_.Link().SilenceUs(now);
    transfer_.Link().SetNow(now);
    const bool is_empty = transfer_.Link().Flush();
    if (IsBusy())
    {
        if ((phase_ == Phase::kQueued) && is_empty)
        {
            Begin();
        }
        else if (silence_us >= time_out_us_)
        {
            GiveUp(SdoAbort::kTimeOut);
        }
        else if (silence_us >= (time_out_us_ / 2U))
        {
            transfer_.OnHalfTimeOut();
        }
        else
        {
            // The server has time.
        }
        transfer_.SendBlockSegments();
    }
}

void SdoClient::Cancel(const SdoAbort reason) noexcept
{
    if (IsBusy())
    {
        GiveUp(reason);
    }
}

void SdoClient::OnServerRestart() noexcept
{
    transfer_.Link().OnServerRestart();
    if (IsBusy())
    {
        transfer_.Fail(SdoAbort::kNoConnection, false);
    }
}

bool SdoClient::Connect(const NodeId server) noexcept
{
    return Connect(DefaultOf(server));
}

bool SdoClient::Connect(const SdoConnection& connection) noexcept
{
    const bool is_free = !IsBusy();
    if (is_free)
    {
        transfer_.Link().Connect(connection);
    }
    return is_free;
}

bool SdoClient::IsBusy() const noexcept
{
    return transfer_.State() == SdoClientState::kBusy;
}

/// Before the transfer began its object was not asked for.
void SdoClient::GiveUp(const SdoAbort reason) noexcept
{
    switch (phase_)
    {
    case Phase::kRunning:
        transfer_.GiveUp(reason);
        break;
    case Phase::kMark:
        transfer_.Link().Abort(transfer_.Link().Mark(), reason);
        transfer_.Fail(reason, false);
        break;
    case Phase::kQueued:
    case Phase::kIdle:
    default:
        transfer_.Fail(reason, false);
        break;
    }
}

} // namespace counterpoint::cia301
