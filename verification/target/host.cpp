// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The same programs on the host: what they print must be what the target prints.
#include "verification/target/target.hpp"

#include <cstdio>
#include <cstdlib>

extern "C" std::uint32_t TargetMain() noexcept;

namespace counterpoint::target
{

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

} // namespace counterpoint::target

int main()
{
    return static_cast<int>(TargetMain());
}
