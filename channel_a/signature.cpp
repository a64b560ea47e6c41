// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/crc.hpp"
#include "channel_a/rules.hpp"

namespace counterpoint::channel_a
{
namespace
{

constexpr std::uint32_t kOneByte = 1U;
constexpr std::uint32_t kTwoBytes = 2U;
constexpr std::uint32_t kFourBytes = 4U;

} // namespace

// Field after field, each as it is read. A map count that is too large counts as the greatest. [SRS_CFG_010,
// SRS_CFG_020]
std::uint16_t SignatureOf(const Record& record, const Mapping& mapping) noexcept
{
    Crc16 crc{};
    crc.AddBytes(record.grants.Of(Grant::kDirection), kOneByte);
    crc.AddBytes(record.values.sct_ms, kTwoBytes);
    crc.AddBytes(record.values.srvt_ms, kOneByte);
    crc.AddBytes(record.values.cob_id[kNormalHalf], kFourBytes);
    crc.AddBytes(record.values.cob_id[kInverseHalf], kFourBytes);
    crc.AddBytes(mapping.count, kOneByte);
    for (std::uint32_t position = 0U; position < mapping.count; ++position)
    {
        crc.AddBytes(position + 1U, kOneByte);
        crc.AddBytes(mapping.entries[position], kFourBytes); // MISRA D-002
    }
    return crc.Value();
}

} // namespace counterpoint::channel_a
