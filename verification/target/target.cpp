// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/target/target.hpp"

#include <cstddef>

namespace
{
/// A register of the processor. Compilers disagree on the type behind std::uint32_t, so nothing with it in its name
/// crosses.
using Word = std::uint32_t;

constexpr Word kSysOpen = 0x01U;
constexpr Word kSysClose = 0x02U;
constexpr Word kSysWrite = 0x05U;
constexpr Word kSysRead = 0x06U;
constexpr Word kSysGetCommandLine = 0x15U;
constexpr Word kSysExit = 0x18U;
constexpr Word kReasonApplicationExit = 0x20026U;
constexpr Word kReasonRunTimeError = 0x20023U;
constexpr Word kOpenForReading = 1U; // Binary.
constexpr Word kOpenForWriting = 4U;
constexpr Word kOpenForWritingBytes = 5U;
constexpr Word kNoHandle = 0xFFFFFFFFU;
constexpr Word kStackPaint = 0xA5A5A5A5U;
} // namespace

extern "C"
{
    Word TargetTrap(Word operation, Word argument) noexcept;
    void TargetStartCycles() noexcept;
    Word TargetReadCycles() noexcept;
    [[noreturn]] void TargetExit(Word status) noexcept;
    extern Word stack_main_bottom[];
    extern Word stack_main_top[];
}

namespace
{
Word AddressOf(const volatile void* place) noexcept
{
    return static_cast<Word>(reinterpret_cast<std::uintptr_t>(place));
}

/// The emulator reads the request's words with the order of a little-endian processor.
constexpr Word LittleEndian(const Word value) noexcept
{
    return (__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__) ? value : __builtin_bswap32(value);
}

/// The compiler does not see that the host reads and writes the block.
Word Request(Word operation, Word first, Word second, Word third) noexcept
{
    volatile Word block[3] = {LittleEndian(first), LittleEndian(second), LittleEndian(third)};
    return TargetTrap(operation, AddressOf(block));
}

Word StandardOutput() noexcept
{
    static Word handle = 0U;
    if (handle == 0U)
    {
        handle = Request(kSysOpen, AddressOf(":tt"), kOpenForWriting, 3U);
    }
    return handle;
}

Word LengthOf(const char* text) noexcept
{
    Word length = 0U;
    while (text[length] != '\0')
    {
        ++length;
    }
    return length;
}
} // namespace

extern "C" void TargetExit(Word status) noexcept
{
    static_cast<void>(TargetTrap(kSysExit, (status == 0U) ? kReasonApplicationExit : kReasonRunTimeError));
    for (;;)
    {
    }
}

/// Only a destroyed object leads here.
extern "C" void __cxa_pure_virtual() // NOLINT(bugprone-reserved-identifier): the name is the ABI's
{
    counterpoint::target::Write("FAILURE: pure virtual call\n");
    TargetExit(1U);
}

namespace counterpoint::target
{

void Write(const char* text) noexcept
{
    static_cast<void>(Request(kSysWrite, StandardOutput(), AddressOf(text), LengthOf(text)));
}

const char* Argument() noexcept
{
    static char text[80] = {};
    if (text[0] == '\0')
    {
        static_cast<void>(Request(kSysGetCommandLine, AddressOf(text), sizeof text, 0U));
    }
    return text;
}

bool ReadText(const char* const path, char* const to, const std::uint32_t room) noexcept
{
    const Word handle = Request(kSysOpen, AddressOf(path), kOpenForReading, LengthOf(path));
    if (handle == kNoHandle)
    {
        return false;
    }
    // The host says how many bytes it did not write.
    const Word left = Request(kSysRead, handle, AddressOf(to), room - 1U);
    const bool fits = (left != 0U) && (left < room);
    to[fits ? (room - 1U) - left : 0U] = '\0';
    return fits;
}

bool WriteFile(const char* const path, const Bytes* const parts, const std::uint32_t count) noexcept
{
    const Word handle = Request(kSysOpen, AddressOf(path), kOpenForWritingBytes, LengthOf(path));
    bool is_written = handle != kNoHandle;
    for (std::uint32_t part = 0U; is_written && (part < count); ++part)
    {
        // The host says how many bytes it did not write.
        is_written = (parts[part].count == 0U) ||
                     (Request(kSysWrite, handle, AddressOf(parts[part].first), parts[part].count) == 0U);
    }
    return is_written && (Request(kSysClose, handle, 0U, 0U) == 0U);
}

void Exit(std::uint32_t status) noexcept
{
    TargetExit(status);
}

void StartCycles() noexcept
{
    TargetStartCycles();
}

std::uint32_t ReadCycles() noexcept
{
    return TargetReadCycles();
}

std::uint32_t StackUsed() noexcept
{
    const volatile Word* place = stack_main_bottom;
    while ((place != stack_main_top) && (*place == kStackPaint))
    {
        ++place;
    }
    return AddressOf(stack_main_top) - AddressOf(place);
}

void RepaintStack() noexcept
{
    // A margin for this function's own frame and for what the caller keeps below its stack pointer: nothing.
    constexpr Word kMarginBytes = 64U;
    volatile Word here = 0U;
    volatile Word* place = stack_main_bottom;
    while (AddressOf(place) < (AddressOf(&here) - kMarginBytes))
    {
        *place = kStackPaint;
        ++place;
    }
}

} // namespace counterpoint::target
