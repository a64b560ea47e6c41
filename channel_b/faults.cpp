// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/image.hpp"

#include <cstdint>

/// What a fault does to a slot: the rare way, apart from the ways of frames and cycles.
namespace counterpoint::channel_b
{

void Count(Row& row, SrdoCause cause) noexcept
{
    if (row.error_count != 0xFFFFU)
    {
        ++row.error_count;
    }
    if (row.first_cause == Code(SrdoCause::kNone))
    {
        row.first_cause = Code(cause);
    }
}

void Record(Row& row, SrdoCause cause) noexcept
{
    row.causes |= std::uint32_t{1U} << (static_cast<std::uint32_t>(cause) & 31U);
    SetNews(row, kReported);
    Count(row, cause);
}

void Discard(Row& row) noexcept
{
    row.standing = Standing::kFaulted;
    row.held = kUnset;
    row.ordinal = 0U;
    row.limit = kNothingRuns;
    ClearNews(row, kUnheard);
    ForgetEdge(row);
}

void Fault(Row& row, SrdoCause cause) noexcept
{
    row.srvt_limit = kNothingRuns;
    ClearNews(row, kPending);
    Discard(row);
    Record(row, cause);
}

Confirmation Fail(Row& row, SrdoCause cause) noexcept
{
    Ground(row, Stage::kIdle);
    Record(row, cause);
    return Confirmation{kNoSlot, ConfirmStep::kNone};
}

} // namespace counterpoint::channel_b
