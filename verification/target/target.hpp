// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TARGET_TARGET_HPP
#define VERIFICATION_TARGET_TARGET_HPP

#include <cstdint>

/// What a program on the emulated processor may ask of its surroundings. Nothing of it is part of the product.
namespace counterpoint::target
{

/// @brief Writes text to the standard output of the emulator. Lines only; each call is one request to the host.
void Write(const char* text) noexcept;
void WriteNumber(std::uint32_t value) noexcept;
/// @brief Eight lower-case hexadecimal digits.
void WriteHex(std::uint32_t value) noexcept;

/// @brief What the emulator was given as the program's argument, or an empty text.
[[nodiscard]] const char* Argument() noexcept;

/// @brief Reads a whole file of the host into `to`, which ends with a zero then. False if it cannot be read or is
/// longer.
[[nodiscard]] bool ReadText(const char* path, char* to, std::uint32_t room) noexcept;

/// Neighbouring bytes in memory.
struct Bytes
{
    const void* first;
    std::uint32_t count;
};

/// @brief Writes the parts one behind the other to a file of the host. False if it cannot be written.
[[nodiscard]] bool WriteFile(const char* path, const Bytes* parts, std::uint32_t count) noexcept;

/// @brief Ends the emulation; its exit status is 0 for 0, else 1.
[[noreturn]] void Exit(std::uint32_t status) noexcept;

void StartCycles() noexcept;
/// @brief Cycle counter of the processor; under `-icount shift=0` the number of executed instructions, exactly.
[[nodiscard]] std::uint32_t ReadCycles() noexcept;
/// @brief Bytes of the stack that were ever written.
[[nodiscard]] std::uint32_t StackUsed() noexcept;
/// @brief Paints the stack below the caller again, so that StackUsed tells about what is called next.
void RepaintStack() noexcept;

} // namespace counterpoint::target

#endif
