// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What is an answer to the SDO client, and what is not.
#include "canopen/cia301/base/little_endian.hpp"
#include "canopen/cia301/sdo/client.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint16_t kMarkedIndex = 0x1000U;
constexpr std::uint8_t kCommandMask = 0xE0U;
constexpr std::uint8_t kBlockMask = 0xE3U;
constexpr std::uint8_t kBlockBeginMask = 0xE1U;
constexpr std::uint8_t kUploadAnswer = 0x40U;
constexpr std::uint8_t kExpeditedBit = 0x02U;
constexpr std::uint8_t kDownloadAnswer = 0x60U;
constexpr std::uint8_t kAbort = 0x80U;

bool IsFor(const SdoFrame& answer, const ObjectAddress& target) noexcept
{
    return (FromLittleEndian(&answer.bytes[1], 2U) == target.index) && (answer.bytes[3] == target.sub);
}

SdoAbort CodeOf(const SdoFrame& answer) noexcept
{
    return static_cast<SdoAbort>(static_cast<std::uint32_t>(FromLittleEndian(&answer.bytes[4], 4U)));
}

} // namespace

void SdoClient::Dispatch(const SdoFrame& answer) noexcept
{
    switch (phase_)
    {
    case Phase::kMark:
        OnMark(answer);
        break;
    case Phase::kDownloadBegin:
    case Phase::kUploadBegin:
    case Phase::kBlockDownloadBegin:
    case Phase::kBlockUploadBegin:
        if (IsFor(answer, target_))
        {
            DispatchBegin(answer);
        }
        break;
    case Phase::kDownloadSegment:
    case Phase::kUploadSegment:
    case Phase::kBlockDownload:
    case Phase::kBlockDownloadAck:
    case Phase::kBlockDownloadEnd:
    case Phase::kBlockUpload:
    case Phase::kBlockUploadEnd:
        DispatchRest(answer);
        break;
    case Phase::kIdle:
    case Phase::kQueued:
    default:
        break;
    }
}

/// A first answer, which names the object. What does not fit is from before.
void SdoClient::DispatchBegin(const SdoFrame& answer) noexcept
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

/// Answers come in order: after the first one, every frame belongs to this transfer.
void SdoClient::DispatchRest(const SdoFrame& answer) noexcept
{
    const std::uint8_t head = answer.bytes[0];
    const bool is_sending = (phase_ == Phase::kBlockDownload) || (phase_ == Phase::kBlockDownloadAck);
    if (head == kAbort)
    {
        // A server that has forgotten the transfer names no object.
        const bool is_ours = IsFor(answer, target_) || IsFor(answer, ObjectAddress{0U, 0U});
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

void SdoClient::OnMark(const SdoFrame& answer) noexcept
{
    const ObjectAddress mark{kMarkedIndex, mark_};
    const bool is_value = (answer.bytes[0] & kCommandMask) == kUploadAnswer;
    if (IsFor(answer, mark) && ((answer.bytes[0] == kAbort) || is_value))
    {
        is_doubtful_ = false;
        phase_ = Phase::kQueued;
        if (is_value && ((answer.bytes[0] & kExpeditedBit) == 0U))
        {
            Request(kAbort, mark, static_cast<std::uint32_t>(SdoAbort::kGeneral)); // Not a value that anybody wants.
        }
        if (Flush())
        {
            Begin();
        }
    }
}

} // namespace counterpoint::cia301
