// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What start-up has to leave behind, and an exception of the kind that the argument names: on each processor, or on
// that alone whose number stands behind it. The same program for each; after a reset it tells the exception before.
// [SRS_ZYN_003, SRS_ZYN_005, SRS_ZYN_006, SRS_ZYN_069]
#include "hal/zynqmp/start/exceptions.hpp"
#include "hal/zynqmp/start/memory_map.hpp"
#include "verification/target/target.hpp"

extern "C"
{
    extern const std::uint8_t image_core[]; // Its address is the number of the processor, plus 1.
    std::uint32_t TargetMain() noexcept;
}

namespace
{
using counterpoint::target::Write;
using counterpoint::target::WriteHex;
using counterpoint::target::WriteNumber;

constexpr std::uint32_t kInitial = 0x1234ABCDU;

class Constructed
{
  public:
    explicit Constructed(const volatile std::uint32_t& from) noexcept : value_{from + 1U}
    {
    }
    [[nodiscard]] std::uint32_t Value() const noexcept
    {
        return value_;
    }

  private:
    std::uint32_t value_;
};

volatile std::uint32_t initialised = kInitial;
volatile std::uint32_t zeroed[64];
volatile double factor = 1.5;
const Constructed constructed{initialised};
counterpoint::tms570::Mpu mpu;
[[gnu::section(".bss.party_channel_a")]] volatile std::uint32_t of_channel_a;
[[gnu::section(".bss.party_channel_b")]] volatile std::uint32_t of_channel_b;
[[gnu::section(".bss.party_core")]] volatile std::uint32_t of_core;
[[gnu::section(".bss.party_non_safety")]] volatile std::uint32_t of_nobody;

void Tell(const char* const what, const bool holds) noexcept
{
    Write(holds ? "holds " : "FAILS ");
    Write(what);
    Write("\n");
}

bool IsZeroed() noexcept
{
    std::uint32_t all = 0U;
    for (const volatile std::uint32_t& word : zeroed)
    {
        all |= word;
    }
    return all == 0U;
}

void TellRecord() noexcept
{
    const counterpoint::hal::ExceptionRecord record = counterpoint::zynqmp::LastException().Read();
    Write("record cause=");
    WriteNumber((record.cause == counterpoint::hal::ExceptionCause::kNone) ? 0U
                                                                           : static_cast<std::uint32_t>(record.cause));
    Write(" count=");
    WriteNumber(record.count);
    Write(" accessed=");
    WriteHex(record.address_low);
    Write(" at=");
    WriteHex(record.address_high);
    Write("\n");
}

/// Each party writes its own region and none of the others': the first write that is not its own is an exception.
void WriteAs(const counterpoint::hal::MemoryOwner owner, volatile std::uint32_t& word) noexcept
{
    mpu.Enter(owner);
    word = 7U;
    mpu.Enter(counterpoint::hal::MemoryOwner::kKernel);
}

/// A supervisor call of user mode from elsewhere than where unprivileged code comes back. [SRS_ZYN_069]
void CallOfItsOwn() noexcept
{
    asm volatile("svc #0");
}

/// Whether this processor is named, or none.
bool IsMeant(const char number) noexcept
{
    const auto own = static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(image_core)) - 1U;
    return (number == '\0') || (static_cast<std::uint32_t>(number - '0') == own);
}

void Raise(const char kind) noexcept
{
    using counterpoint::hal::MemoryOwner;
    switch (kind)
    {
    case 'u':
        asm volatile("udf #1");
        break;
    case 's':
        asm volatile("svc #1");
        break;
    case 'v':
        RunUnprivileged(CallOfItsOwn, stack_non_safety_top);
        break;
    case 'd':
        *reinterpret_cast<volatile std::uint32_t*>(0x70000000U) = 1U; // Nothing answers there.
        break;
    case 'x':
        reinterpret_cast<void (*)()>(reinterpret_cast<std::uintptr_t>(&of_core) | 1U)(); // RAM is not executed.
        break;
    case 'c':
        of_channel_a = 1U; // As the kernel.
        break;
    case 'a':
        WriteAs(MemoryOwner::kChannelA, of_channel_b);
        break;
    case 'b':
        WriteAs(MemoryOwner::kChannelB, of_core);
        break;
    case 'f':
        *reinterpret_cast<volatile std::uint32_t*>(reinterpret_cast<std::uintptr_t>(&FirmwareMain) & ~3U) = 0U;
        break;
    default:
        break;
    }
}

} // namespace

extern "C" std::uint32_t TargetMain() noexcept
{
    using counterpoint::hal::MemoryOwner;
    TellRecord();
    Tell("variables with an initial value", initialised == kInitial);
    Tell("variables without one are zero", IsZeroed());
    Tell("constructors ran", constructed.Value() == (kInitial + 1U));
    Tell("the floating-point unit computes", (factor * 2.0) == 3.0);
    const bool is_set = mpu.Start(counterpoint::zynqmp::FixedRegions()) == counterpoint::tms570::Outcome::kDone;
    Tell("the memory protection is on", is_set && counterpoint::zynqmp::ProtectParties(mpu));
    WriteAs(MemoryOwner::kChannelA, of_channel_a);
    WriteAs(MemoryOwner::kChannelB, of_channel_b);
    WriteAs(MemoryOwner::kKernel, of_core);
    of_nobody = 7U;
    Tell("each party writes what is its own", ((of_channel_a + of_channel_b) + (of_core + of_nobody)) == 28U);
    const char* const argument = counterpoint::target::Argument();
    if ((argument[0] != '\0') && IsMeant(argument[1]))
    {
        Raise(argument[0]);
    }
    return 0U;
}
