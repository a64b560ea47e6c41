// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/target/selftest/voice.hpp"
#include "verification/target/target.hpp"

namespace
{
using counterpoint::target::ClangVoice;
using counterpoint::target::Note;
using counterpoint::target::Voice;
using counterpoint::target::Write;

volatile std::uint32_t initialised_word = 0x01020304U;
volatile std::uint32_t zeroed_word;

bool Expect(bool holds, const char* what) noexcept
{
    Write(holds ? "selftest: holds: " : "selftest: FAILURE: ");
    Write(what);
    Write("\n");
    return holds;
}

bool ClangAnswersGcc() noexcept
{
    ClangVoice voice(Note{1U, 0x0123456789ABCDEFU, {0U, 0U, 0U, 0U}});
    Voice& abstract = voice;
    const Note first = abstract.Answer(Note{2U, 0x00000000000000FFU, {1U, 2U, 3U, 4U}});
    const Note second = abstract.Answer(Note{5U, 0U, {0U, 0U, 0U, 0U}});
    return (first.pitch == 3U) && (first.mask == 0x01234567'89AB32EFU) && (first.bytes[0] == 4U) &&
           (first.bytes[3] == 1U) && (second.pitch == 7U) && (second.mask == 0xFFU);
}

/// What the stack computation must refuse. The emulator never runs it.
[[gnu::noinline]] std::uint32_t Recurse(std::uint32_t depth) noexcept
{
    return (depth <= initialised_word) ? depth : (Recurse(depth - 1U) ^ (Recurse(depth / 2U) + depth));
}

std::uint32_t RunAll() noexcept
{
    const auto* bytes = reinterpret_cast<const volatile std::uint8_t*>(&initialised_word);
    bool good = Expect(bytes[0] == 1U, "data are big-endian");
    good = Expect((initialised_word == 0x01020304U) && (zeroed_word == 0U), "initialised and zeroed data") && good;
    good = Expect(ClangAnswersGcc(), "an object of Clang answers one of GCC through an abstract class") && good;
    counterpoint::target::StartCycles();
    const std::uint32_t start = counterpoint::target::ReadCycles();
    const std::uint32_t empty = counterpoint::target::ReadCycles() - start;
    for (std::uint32_t i = 0U; i < 1000U; ++i)
    {
        asm volatile("nop");
    }
    const std::uint32_t loop = (counterpoint::target::ReadCycles() - start) - (2U * empty);
    // nop, add or subtract, compare, branch; GCC may leave out the comparison.
    good = Expect((loop >= 3000U) && (loop <= 4010U), "instructions are counted") && good;
    return good ? 0U : 1U;
}
} // namespace

extern "C" std::uint32_t TargetMain() noexcept;
extern "C" void __cxa_pure_virtual(); // NOLINT(bugprone-reserved-identifier): the name is the ABI's

extern "C" std::uint32_t TargetMain() noexcept
{
    // Each argument is a fault that must end the run as a failure. [SRS_TGT_009]
    switch (counterpoint::target::Argument()[0])
    {
    case 'u':
        asm volatile("udf #0");
        return 0U;
    case 'd':
        // Beyond the memory of the machine.
        return *reinterpret_cast<volatile const std::uint32_t*>(0x70000000U) & 0U;
    case 'p':
        __cxa_pure_virtual();
        return 0U;
    case 'h':
        for (;;)
        {
            zeroed_word = 1U;
        }
    case 'r':
        return Recurse(zeroed_word);
    default:
        return RunAll();
    }
}
