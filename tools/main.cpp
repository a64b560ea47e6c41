// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/command_line.hpp"

#include <iostream>
#include <string>
#include <vector>

int main(const int count, const char* const* const arguments)
{
    using namespace counterpoint::tools;
    std::vector<std::string> words;
    for (int place = 1; place < count; ++place)
    {
        words.emplace_back(arguments[place]);
    }
    ExitStatus status = RunCommandLine(words, {std::cout, std::cerr});
    std::cout.flush();
    if (!std::cout)
    {
        std::cerr << "counterpoint: the answer cannot be written, expected an open output\n";
        status = ExitStatus::kBadInput;
    }
    return static_cast<int>(status);
}
