// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// A firmware example on the emulator: start-up, exceptions, MPU and unprivileged code are those of silicon, CAN,
// clocks, watchdog and pins are simulated. The program's argument is the scenario's file. An exception stops the device
// and starts the image once more, which then tells what the record says.
#include "examples/firmware/common/device.hpp"
#include "hal/tms570/diagnosis/mpu.hpp"
#include "hal/tms570/probe.hpp"
#include "hal/tms570/start/exceptions.hpp"
#include "hal/tms570/start/memory_map.hpp"
#include "verification/target/firmware/meter.hpp"
#include "verification/target/firmware/simulated_device.hpp"
#include "verification/target/target.hpp"

extern "C"
{
    [[noreturn]] void Reset() noexcept;
    std::uint32_t RaiseInterrupt() noexcept;
    std::uint32_t RaiseFastInterrupt() noexcept;
}

namespace
{

constexpr std::uint32_t kScenarioRoom = 16384U;
constexpr std::uint32_t kStoppedByException = 3U;
constexpr std::uint32_t kCutOff = 0x0C0FF0FFU;
constexpr std::uint32_t kNothingThere = 0x70000000U;

// What stands for pins that hardware holds closed until it is powered again.
[[gnu::section(".noinit.cut_off")]] volatile std::uint32_t cut_off;
char text[kScenarioRoom]{};
std::uint32_t interrupts = 0U;

void RunUnprivilegedOnce() noexcept
{
    RunUnprivileged(counterpoint::firmware::RunNonSafety, stack_non_safety_top);
}

/// True if there was a record: it is told and gone then.
bool TellRecord() noexcept
{
    using namespace counterpoint;
    hal::ExceptionMemory memory = tms570::LastException();
    const hal::ExceptionRecord record = memory.Read();
    if (record.cause == hal::ExceptionCause::kNone)
    {
        return false;
    }
    target::Write("exception cause=");
    target::WriteNumber(static_cast<std::uint32_t>(record.cause));
    target::Write(" accessed=");
    target::WriteHex(record.address_low);
    target::Write(" place=");
    target::WriteHex(record.address_high);
    target::Write(" count=");
    target::WriteNumber(record.count);
    target::Write((cut_off == kCutOff) ? " outputs=closed\n" : " outputs=open\n");
    memory.Clear();
    return true;
}

} // namespace

namespace counterpoint::tms570
{

// In place of hal/tms570/probe.cpp, which asks modules that the emulator does not have.
void ArmProbe(ProbeKind /*kind*/, Register /*place*/) noexcept
{
}

bool IsProvoked(const AbortFacts& facts) noexcept
{
    return (facts.accessed == kNothingThere) && (facts.instruction == ProbeInstruction()) &&
           (facts.cause == hal::ExceptionCause::kDataAccess);
}

} // namespace counterpoint::tms570

namespace counterpoint::target
{

std::uint32_t ReadMeter() noexcept
{
    return ReadCycles();
}

} // namespace counterpoint::target

extern "C" void HardwareCutOff() noexcept
{
    cut_off = kCutOff;
}

extern "C" void HardwareStop() noexcept
{
    // The MPU is off after a real reset.
    std::uint32_t control = 0U;
    asm volatile("mrc p15, 0, %0, c1, c0, 0" : "=r"(control));
    asm volatile("dsb\n\tmcr p15, 0, %0, c1, c0, 0\n\tisb" : : "r"(control & ~1U) : "memory");
    Reset();
}

extern "C" void FirmwareInterrupt() noexcept
{
    ++interrupts;
    // All that a function may use without asking.
    asm volatile("mov r1, #0\n\tmov r2, #0\n\tmov r3, #0\n\tmov r12, #0\n\tvmov d0, r1, r1\n\tvmov d7, r1, r1"
                 :
                 :
                 : "r1", "r2", "r3", "r12", "d0", "d7");
}

extern "C" void FirmwareFastInterrupt() noexcept
{
    FirmwareInterrupt();
}

extern "C" void FirmwareMain() noexcept
{
    using namespace counterpoint;
    if (TellRecord())
    {
        target::Exit(kStoppedByException);
    }
    cut_off = 0U;
    // The way back from a provoked abort is that of silicon: without it there is an endless loop or a record here.
    static_cast<void>(tms570::Probe(tms570::Register{kNothingThere}));
    if ((RaiseInterrupt() != 1U) || (RaiseFastInterrupt() != 1U) || (interrupts != 2U))
    {
        target::Write("FAILURE: an interrupt changed the program that it interrupted\n");
        target::Exit(1U);
    }
    if (!target::ReadText(target::Argument(), text, kScenarioRoom))
    {
        target::Write("FAILURE: the scenario cannot be read\n");
        target::Exit(1U);
    }
    target::StartCycles();
    static tms570::Mpu protection{};
    if (protection.Start(tms570::FixedRegions()) != tms570::Outcome::kDone)
    {
        target::Write("FAILURE: the memory protection did not start\n");
        target::Exit(1U);
    }
    static target::SimulatedDevice device{protection};
    const bool good = device.Run(text, RunUnprivilegedOnce);
    const target::Cost cost = device.GreatestCost();
    target::Write("cost greatest=");
    target::WriteNumber(cost.greatest);
    target::Write(" cycles=");
    target::WriteNumber(cost.cycles);
    target::Write(" stack=");
    target::WriteNumber(target::StackUsed());
    target::Write("\n");
    target::Exit(good ? 0U : 1U);
}
