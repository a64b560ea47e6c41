// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/sdo/client_link.hpp"

#include "canopen/cia301/base/little_endian.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint16_t kMarkedIndex = 0x1000U;
constexpr std::uint8_t kLastMark = 254U;
constexpr std::uint8_t kCommandMask = 0xE0U;
constexpr std::uint8_t kUploadRequest = 0x40U;
constexpr std::uint8_t kUploadAnswer = 0x40U;
constexpr std::uint8_t kExpeditedBit = 0x02U;
constexpr std::uint8_t kAbort = 0x80U;
constexpr std::uint32_t kFrameBytes = 8U;

} // namespace

bool IsFor(const SdoFrame& answer, const ObjectAddress& target) noexcept
{
    return (FromLittleEndian(&answer.bytes[1], 2U) == target.index) && (answer.bytes[3] == target.sub);
}

SdoClientLink::SdoClientLink(FrameSink& sink, const SdoConnection& connection) noexcept
    : sink_(sink), connection_(connection), waiting_{}, stale_{0U, 0U}, now_{0U}, last_{0U}, mark_(0U),
      is_sending_(false), is_doubtful_(false), has_given_up_(false)
{
}

void SdoClientLink::Connect(const SdoConnection& connection) noexcept
{
    const bool is_other = (connection.request != connection_.request) || (connection.answer != connection_.answer) ||
                          (connection.server.value != connection_.server.value);
    if (is_other)
    {
        connection_ = connection;
        is_sending_ = false;
        is_doubtful_ = has_given_up_;
    }
}

void SdoClientLink::Request(const std::uint8_t command, const ObjectAddress& target, const std::uint32_t value) noexcept
{
    SdoFrame frame{};
    frame.bytes[0] = command;
    ToLittleEndian(target.index, &frame.bytes[1], 2U);
    frame.bytes[3] = target.sub;
    ToLittleEndian(value, &frame.bytes[4], 4U);
    Emit(frame);
}

void SdoClientLink::Emit(const SdoFrame& frame) noexcept
{
    waiting_ = frame;
    is_sending_ = true;
    last_ = now_;
    static_cast<void>(Flush());
}

bool SdoClientLink::Flush() noexcept
{
    if (is_sending_)
    {
        CanFrame frame{connection_.request, FrameKind::kData, CanPortId::kFirst, 8U, {}};
        for (std::uint32_t i = 0U; i < kFrameBytes; ++i)
        {
            frame.data[i] = waiting_.bytes[i];
        }
        is_sending_ = !sink_.Send(frame);
        last_ = is_sending_ ? last_ : now_;
    }
    return !is_sending_;
}

void SdoClientLink::Abort(const ObjectAddress& target, const SdoAbort reason) noexcept
{
    Request(kAbort, target, static_cast<std::uint32_t>(reason));
    is_doubtful_ = true;
    has_given_up_ = true;
}

/// Asks for a sub-index that nobody else asks for; see the class.
void SdoClientLink::SendMark() noexcept
{
    const bool is_taken = (stale_.index == kMarkedIndex) && (stale_.sub == (mark_ + 1U));
    const std::uint32_t next = mark_ + (is_taken ? 2U : 1U);
    mark_ = static_cast<std::uint8_t>((next > kLastMark) ? (next - kLastMark) : next);
    Request(kUploadRequest, Mark(), 0U);
}

bool SdoClientLink::TakeMark(const SdoFrame& answer) noexcept
{
    const bool is_value = (answer.bytes[0] & kCommandMask) == kUploadAnswer;
    const bool is_mark = IsFor(answer, Mark()) && ((answer.bytes[0] == kAbort) || is_value);
    if (is_mark)
    {
        is_doubtful_ = false;
        if (is_value && ((answer.bytes[0] & kExpeditedBit) == 0U))
        {
            Request(kAbort, Mark(), static_cast<std::uint32_t>(SdoAbort::kGeneral)); // Not a value that anybody wants.
        }
    }
    return is_mark;
}

ObjectAddress SdoClientLink::Mark() const noexcept
{
    return ObjectAddress{kMarkedIndex, mark_};
}

} // namespace counterpoint::cia301
