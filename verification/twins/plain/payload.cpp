// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Objects and frames. [SRS_CFG_036]
#include "verification/twins/plain/point.hpp"
#include "verification/twins/plain/record.hpp"

namespace counterpoint::twins::plain
{

namespace
{
const Number kUnmapped{"SRS_CFG_036", "mapped bits of the last byte"};
const Act kReadsAbove{"SRS_CFG_036", "bits of an object above its length ignored when it is read"};
const Act kWritesAbove{"SRS_CFG_036", "bits of an object above its length written as 0"};
const Number kBitsOfObject{"SRS_CFG_036", "bits of each value"};
const Act kReads{"SRS_CFG_036", "objects read"};
const Act kWrites{"SRS_CFG_036", "objects written"};
const Decision kDummy{"SRS_CFG_033", "nothing is written for a dummy"};
const Act kNextRead{"SRS_CFG_036", "values read one behind the other"};
const Act kNextWritten{"SRS_CFG_036", "values written one behind the other"};
const Number kFirstBit{"SRS_CFG_036", "place of the first bit of a value"};
} // namespace

std::uint8_t MappedOf(const Record& record, std::uint32_t byte) noexcept
{
    const std::uint32_t first = 8U * byte;
    if (record.bits >= (first + 8U))
    {
        return 0xFFU;
    }
    return (record.bits <= first) ? std::uint8_t{0U}
                                  : kUnmapped(static_cast<std::uint8_t>((1U << (record.bits - first)) - 1U));
}

Payload PayloadOf(const Bytes& bytes) noexcept
{
    Payload payload{};
    for (std::uint32_t i = 0U; i < kMaxPayloadBytes; ++i)
    {
        std::uint32_t& half = (i < 4U) ? payload.low : payload.high;
        half |= static_cast<std::uint32_t>(bytes.at[i]) << (8U * (i % 4U));
    }
    return payload;
}

Bytes BytesOf(const Payload& payload) noexcept
{
    Bytes bytes{};
    for (std::uint32_t i = 0U; i < kMaxPayloadBytes; ++i)
    {
        bytes.at[i] = static_cast<std::uint8_t>(((i < 4U) ? payload.low : payload.high) >> (8U * (i % 4U)));
    }
    return bytes;
}

/// What the normal objects say, or the complement of what the inverse ones say.
Bytes ReadObjects(const Record& record, Side side) noexcept
{
    Bytes bytes{};
    std::uint32_t to = 0U;
    for (const Part& part : record.parts)
    {
        const std::uint32_t bits = kReadsAbove() ? kBitsOfObject(part.bits) : ((part.bits + 7U) & ~7U);
        for (std::uint32_t bit = 0U; (bit < bits) && (part.place != nullptr) && kReads(); ++bit)
        {
            const std::uint32_t value = (static_cast<std::uint32_t>(part.place[bit / 8U]) >> (bit % 8U)) & 1U;
            const std::uint32_t normal = (side == Side::kNormal) ? value : (value ^ 1U);
            const std::uint32_t at = (kNextRead() ? kFirstBit(to) : 0U) + bit;
            if (at < kMaxPayloadBits)
            {
                bytes.at[at / 8U] = static_cast<std::uint8_t>(bytes.at[at / 8U] | (normal << (at % 8U)));
            }
        }
        to += part.bits;
    }
    return bytes;
}

void WriteObjects(const Record& record, Side side, const Bytes& normal) noexcept
{
    std::uint32_t from = 0U;
    for (const Part& part : record.parts)
    {
        const std::uint32_t whole = (part.bits + 7U) & ~7U;
        for (std::uint32_t bit = 0U; (bit < whole) && (!kDummy(part.place == nullptr)) && (part.place != nullptr);
             ++bit)
        {
            const std::uint32_t at = (kNextWritten() ? kFirstBit(from) : 0U) + bit;
            const bool is_mapped = bit < kBitsOfObject(part.bits);
            std::uint32_t value = (at < kMaxPayloadBits) ? ((normal.at[at / 8U] >> (at % 8U)) & 1U) : 0U;
            value ^= (side == Side::kNormal) ? 0U : 1U;
            if (!kWrites())
            {
                continue;
            }
            const std::uint8_t mask = static_cast<std::uint8_t>(1U << (bit % 8U));
            const bool is_set = (is_mapped || (!kWritesAbove())) && (value != 0U);
            const std::uint8_t others = static_cast<std::uint8_t>(part.place[bit / 8U] & ~mask);
            part.place[bit / 8U] = static_cast<std::uint8_t>(others | (is_set ? mask : 0U));
        }
        from += part.bits;
    }
}

} // namespace counterpoint::twins::plain
