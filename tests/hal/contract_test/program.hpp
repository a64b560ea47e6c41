// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_HAL_CONTRACT_TEST_PROGRAM_HPP
#define TESTS_HAL_CONTRACT_TEST_PROGRAM_HPP

#include <array>
#include <cstdio>
#include <string>
#include <sys/wait.h>

namespace counterpoint::hal::contract
{

/// What a program printed, and its exit status; -1 if it did not end by itself.
struct ProgramRun
{
    std::string text;
    int status;
};

/// @brief Runs an example as a person would.
[[nodiscard]] inline ProgramRun RunProgram(const std::string& path, const std::string& argument)
{
    ProgramRun run{"", -1};
    std::FILE* const pipe = popen(("'" + path + "' " + argument + " 2>&1").c_str(), "r");
    if (pipe == nullptr)
    {
        return run;
    }
    std::array<char, 4096U> piece{};
    for (std::size_t count = fread(piece.data(), 1U, piece.size(), pipe); count > 0U;
         count = fread(piece.data(), 1U, piece.size(), pipe))
    {
        run.text.append(piece.data(), count);
    }
    const int status = pclose(pipe);
    run.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return run;
}

} // namespace counterpoint::hal::contract

#endif
