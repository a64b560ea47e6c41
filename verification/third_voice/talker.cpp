// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/third_voice/talker.hpp"

#include <algorithm>

namespace counterpoint::third_voice
{
namespace
{
constexpr Time kMs = 1000;
constexpr std::uint32_t kSoonUs = 400U; ///< A dense talker's next frame.
} // namespace

CanFrame Talker::Speak(const SrdoObjects& objects, Dice& dice)
{
    const std::uint32_t bits = BitsOf(objects);
    std::size_t length = bits / 8U;
    if (!is_inverse)
    {
        data = dice.Next();
    }
    std::uint64_t word = is_inverse ? ~data : data;
    is_wrong = dice.Chance(is_dense ? 12U : 3U);
    length = (is_wrong && dice.Chance(50U)) ? (length + 1U) % 9U : length;
    word ^= is_wrong ? (std::uint64_t{1U} << dice.Below(std::max<std::uint32_t>(bits, 1U))) : 0U;
    CanFrame frame{is_inverse ? objects.cob_id_2 : objects.cob_id_1,
                   FrameKind::kData,
                   CanPortId::kFirst,
                   static_cast<std::uint8_t>(length),
                   {}};
    if (dice.Chance(1U))
    {
        frame.kind = dice.Pick({FrameKind::kRemote, FrameKind::kExtended, FrameKind::kFlexibleDataRate});
    }
    if (dice.Chance(1U))
    {
        frame.identifier = 1U;
        frame.length_bytes = static_cast<std::uint8_t>(dice.Chance(80U) ? 0U : 1U);
    }
    for (std::size_t byte = 0U; byte < frame.length_bytes; ++byte)
    {
        frame.data[byte] = static_cast<std::uint8_t>(word >> (8U * byte));
    }
    return frame;
}

void Talker::Plan(const SrdoObjects& objects, const Time now, Dice& dice)
{
    const Time sct = kMs * objects.sct_ms;
    const Time srvt = kMs * objects.srvt_ms;
    const bool slips = dice.Chance(6U); // Leaves the alternation.
    const bool is_soon = is_dense && dice.Chance(70U);
    if (is_soon)
    {
        normal_at = is_inverse ? normal_at : now;
        next = now + 1 + Time{dice.Below(kSoonUs)};
    }
    else if (!is_inverse)
    {
        normal_at = now;
        next = now + (dice.Chance(75U) ? 1 + Time{dice.Below(static_cast<std::uint32_t>(srvt))}
                                       : dice.Pick({srvt - 1, srvt, srvt + 1, srvt + 1 + Time{dice.Below(5000U)}}));
    }
    else
    {
        next = std::max(now + 1,
                        normal_at + (dice.Chance(75U) ? sct / 4 + Time{dice.Below(static_cast<std::uint32_t>(sct / 2))}
                                                      : dice.Pick({sct - 1, sct, sct + 1, 2 * sct})));
    }
    is_inverse = (is_inverse == slips);
}
} // namespace counterpoint::third_voice
