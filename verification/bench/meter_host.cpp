// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/bench/meter.hpp"

#include <valgrind/callgrind.h>

#include <cstdio>

namespace counterpoint::bench
{

void MeterReset() noexcept
{
    CALLGRIND_ZERO_STATS;
}

void MeterBegin() noexcept
{
    CALLGRIND_TOGGLE_COLLECT;
}

void MeterEnd() noexcept
{
    CALLGRIND_TOGGLE_COLLECT;
}

void MeterReport(const MeterLabel& label) noexcept
{
    char text[96];
    std::snprintf(text, sizeof text, "item=%s srdos=%u repetitions=%u", label.item, label.srdo_count,
                  label.repetitions);
    CALLGRIND_DUMP_STATS_AT(text);
}

} // namespace counterpoint::bench
