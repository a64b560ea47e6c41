// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What hal/tms570/start/start_up.S calls in an image that measures: the start-up, the vectors and the entries of the
// exceptions are those of the firmware, and an exception ends the run as a failure. [SRS_TGT_009]
#include "verification/target/target.hpp"

extern "C"
{
    std::uint32_t TargetMain() noexcept;
    void FirmwareMain() noexcept;
    void FirmwareInterrupt() noexcept;
    void FirmwareFastInterrupt() noexcept;
    [[noreturn]] void FirmwareException(std::uint32_t cause, std::uint32_t accessed, std::uint32_t place) noexcept;
}

namespace
{

// hal::ExceptionCause, as start_up.S hands it over.
constexpr std::uint32_t kAccess = 1U;
constexpr std::uint32_t kInstruction = 3U;

[[noreturn]] void Fail(const char* const what, const std::uint32_t place) noexcept
{
    using namespace counterpoint::target;
    Write("FAILURE: ");
    Write(what);
    Write(" at 0x");
    WriteHex(place);
    Write("\n");
    Exit(1U);
}

} // namespace

extern "C" void FirmwareMain() noexcept
{
    counterpoint::target::Exit(TargetMain());
}

extern "C" void FirmwareInterrupt() noexcept
{
    Fail("interrupt", 0U);
}

extern "C" void FirmwareFastInterrupt() noexcept
{
    Fail("fast interrupt", 0U);
}

extern "C" void FirmwareException(const std::uint32_t cause, const std::uint32_t accessed,
                                  const std::uint32_t place) noexcept
{
    using namespace counterpoint::target;
    if (cause == kAccess)
    {
        Write("accessed 0x");
        WriteHex(accessed);
        Write("\n");
        Fail("data or prefetch abort", place);
    }
    Fail((cause == kInstruction) ? "undefined instruction" : "supervisor call or reserved vector", place);
}
