// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The drive of examples/actuator, led astray: the input pins say who writes where it must not. Each misdeed has to end
// in an exception that names it. [SRS_FW_005, SRS_FW_006, SRS_FW_007]
#include "examples/actuator/actuator.hpp"
#include "examples/firmware/common/safe_device.hpp"

extern "C"
{
    extern std::uint8_t region_channel_a[];
    extern std::uint8_t region_channel_b[];
    extern std::uint8_t region_core[];
    extern std::uint8_t region_non_safety[];
    extern std::uint8_t stack_main_bottom[];
    extern std::uint8_t flash_core_start[];
}

namespace counterpoint::firmware
{
namespace
{

// Pins: low four bits who, next four bits what.
constexpr std::uint32_t kWhoMask = 0xFU;
constexpr std::uint32_t kWhatShift = 4U;

enum class Who : std::uint32_t
{
    kNobody = 0U,
    kChannelA = 1U, ///< By a pointer to its variable that is not what it was.
    kChannelB = 2U,
    kCore = 3U,
    kNonSafety = 4U,
    kNonSafetyUndefined = 5U, ///< An undefined instruction.
    kNonSafetyCall = 6U,      ///< A supervisor call that is not the way back.
    kNonSafetyJump = 7U,      ///< A jump into memory that is no code.
};

constexpr std::uint8_t kSrdos = 1U;

[[gnu::section(".bss.party_channel_a")]] Cell<MemoryA<kSrdos>> memory_a;
[[gnu::section(".bss.party_channel_b")]] Cell<MemoryB<kSrdos>> memory_b;
[[gnu::section(".bss.party_core")]] Cell<CoreMemory> memory_core;
Cell<device::AppDevice<examples::Actuator, kSrdos>> memory_rest;
CauseWindows windows[kSrdos];
[[gnu::section(".bss.party_non_safety")]] volatile std::uint32_t cycles_shown;

examples::Actuator actuator{};
MappableObject* objects{nullptr};
std::uint32_t pins{0U};

std::uint8_t* Victim() noexcept
{
    // In the order of run_target.py.
    static std::uint8_t* const kVictims[]{
        region_channel_a,
        region_channel_b,
        region_core,
        region_non_safety,
        stack_main_bottom,
        flash_core_start,
        reinterpret_cast<std::uint8_t*>(std::uintptr_t{0xFFFFFF5CU}), // A register of the system module.
        reinterpret_cast<std::uint8_t*>(&pins),                       // Safe rest.
    };
    constexpr std::uint32_t kCount = sizeof(kVictims) / sizeof(kVictims[0]);
    return kVictims[(pins >> kWhatShift) % kCount];
}

void WriteTo(std::uint8_t* const place) noexcept
{
    *static_cast<volatile std::uint8_t*>(place) = 0x5AU;
}

Who Wrongdoer() noexcept
{
    return static_cast<Who>(pins & kWhoMask);
}

} // namespace

DrivenDevice BuildDevice(const Hardware& hardware) noexcept
{
    // What a flipped bit does, a program is not allowed to: the table of variables is the application's and constant.
    objects = const_cast<MappableObject*>(actuator.Describe().objects);
    const Regions<kSrdos> regions{memory_a, memory_b, memory_core, windows};
    return Build(hardware, regions, memory_rest, actuator);
}

SrdoMask ReadInputs(const Pins inputs) noexcept
{
    pins = inputs.bits >> 1U;
    if (Wrongdoer() == Who::kChannelA)
    {
        objects[0].place = Victim();
    }
    else if (Wrongdoer() == Who::kChannelB)
    {
        objects[2].place = Victim();
    }
    else if (Wrongdoer() == Who::kCore)
    {
        WriteTo(Victim());
    }
    return inputs.bits & 1U;
}

SrdoMask ReadAcknowledge(const Pins inverted) noexcept
{
    return ((inverted.bits & 1U) == 0U) ? 1U : 0U;
}

Pins SetOutputs(const SrdoMask open) noexcept
{
    return Pins{actuator.MayMove(open) ? 1U : 0U};
}

void RunNonSafety() noexcept
{
    cycles_shown = cycles_shown + 1U;
    switch (Wrongdoer())
    {
    case Who::kNonSafety:
        WriteTo(Victim());
        break;
    case Who::kNonSafetyUndefined:
        asm volatile("udf #0");
        break;
    case Who::kNonSafetyCall:
        asm volatile("svc #0" : : : "lr");
        break;
    case Who::kNonSafetyJump:
        reinterpret_cast<void (*)()>(region_non_safety)();
        break;
    case Who::kNobody:
    case Who::kChannelA:
    case Who::kChannelB:
    case Who::kCore:
        break;
    }
}

} // namespace counterpoint::firmware
