// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Expedited and segmented transfers of the SDO client.
#include "canopen/cia301/sdo/client.hpp"

#include "canopen/cia301/base/little_endian.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint8_t kToggle = 0x10U;
constexpr std::uint8_t kExpedited = 0x02U;
constexpr std::uint8_t kStated = 0x01U;
constexpr std::uint8_t kLast = 0x01U;
constexpr std::uint8_t kNextSegment = 0x60U;
constexpr std::uint32_t kExpeditedBytes = 4U;

} // namespace

void SdoClient::SendSegment() noexcept
{
    const std::uint32_t left = length_ - position_;
    const std::uint32_t count = (left < kSegmentBytes) ? left : kSegmentBytes;
    SdoFrame frame{};
    has_last_ = (count == left);
    frame.bytes[0] = static_cast<std::uint8_t>(toggle_ | ((kSegmentBytes - count) << 1U) | (has_last_ ? kLast : 0U));
    for (std::uint32_t i = 0U; i < count; ++i)
    {
        frame.bytes[1U + i] = source_.data[position_ + i];
    }
    position_ += count;
    phase_ = Phase::kDownloadSegment;
    Emit(frame);
}

/// The answer to the begin of a download, or to a segment.
void SdoClient::OnSegmentTaken(const SdoFrame& answer) noexcept
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

void SdoClient::OnUploadBegin(const SdoFrame& answer) noexcept
{
    const std::uint8_t head = answer.bytes[0];
    const bool is_stated = (head & kStated) != 0U;
    if ((head & kExpedited) != 0U)
    {
        const std::uint32_t stated = kExpeditedBytes - ((static_cast<std::uint32_t>(head) >> 2U) & 3U);
        const std::uint32_t most = (room_.size_bytes < kExpeditedBytes) ? room_.size_bytes : kExpeditedBytes;
        const std::uint32_t count = is_stated ? stated : most;
        if (count > room_.size_bytes)
        {
            Fail(SdoAbort::kOutOfMemory, false); // The server has nothing to be told: it is done.
        }
        else
        {
            for (std::uint32_t i = 0U; i < count; ++i)
            {
                room_.data[i] = answer.bytes[4U + i];
            }
            position_ = count;
            Finish();
        }
    }
    else
    {
        length_ = is_stated ? static_cast<std::uint32_t>(FromLittleEndian(&answer.bytes[4], 4U)) : kUnknownLength;
        if (is_stated && (length_ > room_.size_bytes))
        {
            GiveUp(SdoAbort::kOutOfMemory);
        }
        else
        {
            phase_ = Phase::kUploadSegment;
            Emit(SdoFrame{{kNextSegment}});
        }
    }
}

void SdoClient::OnUploadSegment(const SdoFrame& answer) noexcept
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
    else if (count > (room_.size_bytes - position_))
    {
        GiveUp(SdoAbort::kOutOfMemory);
    }
    else
    {
        for (std::uint32_t i = 0U; i < count; ++i)
        {
            room_.data[position_ + i] = answer.bytes[1U + i];
        }
        position_ += count;
        toggle_ ^= kToggle;
        const bool is_last = (head & kLast) != 0U;
        if (!is_last)
        {
            Emit(SdoFrame{{static_cast<std::uint8_t>(kNextSegment | toggle_)}});
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

} // namespace counterpoint::cia301
