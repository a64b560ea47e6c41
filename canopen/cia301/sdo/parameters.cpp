// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/sdo/parameters.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint8_t kRequestSub = 1U;
constexpr std::uint8_t kAnswerSub = 2U;
constexpr std::uint8_t kPartnerSub = 3U;
constexpr std::uint8_t kHighestSub = 3U;
constexpr std::uint32_t kHighestNode = 127U;
constexpr std::uint32_t kDefaultRequests = 0x600U;
constexpr std::uint32_t kDefaultAnswers = 0x580U;

bool IsDefault(const std::uint32_t identifier, const std::uint32_t base) noexcept
{
    return (identifier > base) && (identifier <= (base + kHighestNode));
}

SdoAbort StoreCobId(std::uint32_t& cob_id, const std::uint32_t value, const bool may_be_default) noexcept
{
    const bool is_off = (value & kCobOff) != 0U;
    const bool is_changed_on = ((cob_id & kCobOff) == 0U) && (!is_off) && (cob_id != value);
    const bool is_plain = (value & (kCobBit30 | kCobExtended)) == 0U;
    const bool is_identifier = is_off || may_be_default || IsConfigurable(value);
    SdoAbort abort = SdoAbort::kValueRange;
    if (is_plain && is_identifier && !is_changed_on)
    {
        cob_id = value;
        abort = SdoAbort::kNone;
    }
    return abort;
}

} // namespace

ObjectValue FetchSdo(const SdoParameters& parameters, const std::uint8_t sub) noexcept
{
    ObjectValue value{SdoAbort::kSubUnknown, 0U, 1U};
    switch (sub)
    {
    case 0U:
        value = ObjectValue{SdoAbort::kNone, kHighestSub, 1U};
        break;
    case kRequestSub:
        value = ObjectValue{SdoAbort::kNone, parameters.request, 4U};
        break;
    case kAnswerSub:
        value = ObjectValue{SdoAbort::kNone, parameters.answer, 4U};
        break;
    case kPartnerSub:
        value = ObjectValue{SdoAbort::kNone, parameters.partner, 1U};
        break;
    default:
        break;
    }
    return value;
}

SdoAbort LoadSdo(SdoParameters& parameters, const SdoSide side, const std::uint8_t sub,
                 const std::uint32_t value) noexcept
{
    SdoParameters loaded = parameters;
    loaded.request |= (sub == kRequestSub) ? kCobOff : 0U;
    loaded.answer |= (sub == kAnswerSub) ? kCobOff : 0U;
    const SdoAbort abort = StoreSdo(loaded, side, sub, value);
    parameters = (abort == SdoAbort::kNone) ? loaded : parameters;
    return abort;
}

SdoAbort StoreSdo(SdoParameters& parameters, const SdoSide side, const std::uint8_t sub,
                  const std::uint32_t value) noexcept
{
    const bool is_client = side == SdoSide::kClient;
    SdoAbort abort = SdoAbort::kSubUnknown;
    switch (sub)
    {
    case 0U:
        abort = SdoAbort::kReadOnly;
        break;
    case kRequestSub:
        abort = StoreCobId(parameters.request, value, is_client && IsDefault(value, kDefaultRequests));
        break;
    case kAnswerSub:
        abort = StoreCobId(parameters.answer, value, is_client && IsDefault(value, kDefaultAnswers));
        break;
    case kPartnerSub:
        abort = (value <= kHighestNode) ? SdoAbort::kNone : SdoAbort::kValueRange;
        parameters.partner = (abort == SdoAbort::kNone) ? static_cast<std::uint8_t>(value) : parameters.partner;
        break;
    default:
        break;
    }
    return abort;
}

} // namespace counterpoint::cia301
