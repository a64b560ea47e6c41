// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// random_device SEED FILE: writes a random DCF. The same seed gives the same file.
#include "tests/canopen/generate/random_device.hpp"

#include "canopen/cia306/text/text_file.hpp"

#include <cstdio>
#include <exception>
#include <string>

int main(const int count, const char* const* const arguments)
{
    if (count != 3)
    {
        static_cast<void>(std::fputs("usage: random_device SEED FILE\n", stderr));
        return 2;
    }
    try
    {
        counterpoint::cia306::WriteTextFile(arguments[2],
                                            counterpoint::generate::test::RandomDevice(std::stoull(arguments[1])));
    }
    catch (const std::exception& error)
    {
        static_cast<void>(std::fprintf(stderr, "%s\n", error.what()));
        return 2;
    }
    return 0;
}
