// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// verification/target/target.hpp on the emulated Zynq UltraScale+: text goes to the processor's UART, the argument is
// what the runner loads at a fixed place of the OCM, and the end is a line of the UART that the runner waits for.
#include "verification/target/target.hpp"
#include "verification/target/zynqmp/uart.hpp"

extern "C"
{
    std::uint32_t TargetMain() noexcept;
    void FirmwareMain() noexcept;
    void FirmwareInterrupt() noexcept;
    void FirmwareFastInterrupt() noexcept;
    void HardwareCutOff() noexcept;
    [[noreturn]] void HardwareStop() noexcept;
}

namespace counterpoint::target
{
namespace
{

constexpr std::uint32_t kArgument = 0xFFFDF000U;
constexpr std::uint32_t kArgumentBytes = 80U;

} // namespace

void Write(const char* const text) noexcept
{
    WriteUart(text);
}

const char* Argument() noexcept
{
    static char text[kArgumentBytes] = {};
    const auto* const from = reinterpret_cast<const volatile char*>(kArgument);
    for (std::uint32_t i = 0U; i < (kArgumentBytes - 1U); ++i)
    {
        text[i] = from[i];
    }
    return text;
}

void Exit(const std::uint32_t status) noexcept
{
    Write("end=");
    WriteNumber(status);
    Write("\n");
    for (;;)
    {
        asm volatile("wfi");
    }
}

} // namespace counterpoint::target

extern "C" void FirmwareMain() noexcept
{
    counterpoint::target::Exit(TargetMain());
}

extern "C" void FirmwareInterrupt() noexcept
{
    counterpoint::target::Write("FAILURE: interrupt\n");
    counterpoint::target::Exit(1U);
}

extern "C" void FirmwareFastInterrupt() noexcept
{
    counterpoint::target::Write("FAILURE: fast interrupt\n");
    counterpoint::target::Exit(1U);
}

/// These programs have no output: it tells that it was asked.
extern "C" void HardwareCutOff() noexcept
{
    counterpoint::target::Write("outputs closed\n");
}
