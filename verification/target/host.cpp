// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The same programs on the host: what they print must be what the target prints.
#include "verification/target/target.hpp"

#include <cstdio>
#include <cstdlib>

extern "C" std::uint32_t TargetMain() noexcept;

namespace counterpoint::target
{
/// Of this program alone: a target is told by its emulator.
void SetArgument(const char* argument) noexcept;
} // namespace counterpoint::target

namespace counterpoint::target
{
namespace
{

const char* the_argument = "";

} // namespace

void Write(const char* text) noexcept
{
    static_cast<void>(std::fputs(text, stdout));
}

void WriteNumber(std::uint32_t value) noexcept
{
    static_cast<void>(std::printf("%u", static_cast<unsigned int>(value)));
}

void WriteHex(std::uint32_t value) noexcept
{
    static_cast<void>(std::printf("%08x", static_cast<unsigned int>(value)));
}

const char* Argument() noexcept
{
    return the_argument;
}

void SetArgument(const char* const argument) noexcept
{
    the_argument = argument;
}

bool ReadText(const char* const path, char* const to, const std::uint32_t room) noexcept
{
    std::FILE* const file = std::fopen(path, "rb");
    if (file == nullptr)
    {
        return false;
    }
    const std::size_t length = std::fread(to, 1U, room, file);
    static_cast<void>(std::fclose(file));
    const bool fits = length < room;
    to[fits ? length : 0U] = '\0';
    return fits;
}

} // namespace counterpoint::target

int main(const int count, char** const words)
{
    counterpoint::target::SetArgument((count > 1) ? words[1] : "");
    return static_cast<int>(TargetMain());
}
