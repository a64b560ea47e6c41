// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// PROGRAM [ARGUMENT...] [-- PROGRAM [ARGUMENT...]]...: runs programs together in one stepped time. Prints what each
// wrote, in their order, and a last line with the exit status of each.
#include "tests/runtime/stepped_time/stepped_process.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>

int main(int count, char** words)
{
    using counterpoint::tools::test::SteppedProcess;
    std::vector<std::unique_ptr<SteppedProcess>> processes;
    std::vector<std::string> all(words + 1, words + count);
    for (auto first = all.begin(); first != all.end();)
    {
        const auto last = std::find(first, all.end(), "--");
        processes.push_back(std::make_unique<SteppedProcess>(std::vector<std::string>(first, last)));
        first = (last == all.end()) ? last : last + 1;
    }
    std::string statuses = "exit statuses:";
    for (const auto& process : processes)
    {
        std::printf("%s", process->ReadAll().c_str());
        statuses += " " + std::to_string(process->End());
    }
    std::printf("%s\n", statuses.c_str());
    return 0;
}
