// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/target/zynqmp/hal/checks.hpp"

#include "verification/target/target.hpp"

namespace counterpoint::target
{
namespace
{

std::uint32_t checks = 0U;
std::uint32_t failures = 0U;

} // namespace

void Check(const bool holds, const char* const name) noexcept
{
    ++checks;
    failures += holds ? 0U : 1U;
    Write(holds ? "holds  " : "FAILS  ");
    Write(name);
    Write("\n");
}

void CheckEqual(const std::uint32_t got, const std::uint32_t expected, const char* const name) noexcept
{
    Check(got == expected, name);
    if (got != expected)
    {
        Write("  expected 0x");
        WriteHex(expected);
        Write(", got 0x");
        WriteHex(got);
        Write("\n");
    }
}

std::uint32_t EndChecks() noexcept
{
    Write("checks=");
    WriteNumber(checks);
    Write(" failures=");
    WriteNumber(failures);
    Write("\n");
    return (failures == 0U) ? 0U : 1U;
}

} // namespace counterpoint::target
