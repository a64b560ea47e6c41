// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/bench/meter.hpp"
#include "verification/target/target.hpp"

namespace counterpoint::bench
{
namespace
{
std::uint32_t begun{0U};
std::uint32_t sum{0U};
} // namespace

void MeterReset() noexcept
{
    sum = 0U;
}

void MeterBegin() noexcept
{
    begun = target::ReadCycles();
}

void MeterEnd() noexcept
{
    sum += target::ReadCycles() - begun;
}

void MeterReport(const MeterLabel& label) noexcept
{
    target::Write("item=");
    target::Write(label.item);
    target::Write(" srdos=");
    target::WriteNumber(label.srdo_count);
    target::Write(" repetitions=");
    target::WriteNumber(label.repetitions);
    target::Write(" instructions=");
    target::WriteNumber(sum);
    target::Write("\n");
}

} // namespace counterpoint::bench
