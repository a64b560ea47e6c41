// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_CONSOLE_STREAMS_HPP
#define RUNTIME_CONSOLE_STREAMS_HPP

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// Exit status of a command.
enum class ExitStatus : std::uint8_t
{
    kHolds = 0U,       ///< What was asked holds.
    kDoesNotHold = 1U, ///< It does not: a violated expectation, a wrong signature.
    kBadInput = 2U,    ///< It could not be asked: a file that cannot be used, wrong usage.
};

/// Where a command writes: answers to `out`, what a person has to know besides to `err`.
struct Streams
{
    std::ostream& out;
    std::ostream& err;
};

/// Writes each as a line.
inline void PrintLines(const std::vector<std::string>& lines, std::ostream& out)
{
    for (const std::string& line : lines)
    {
        out << line << "\n";
    }
}
} // namespace counterpoint::runtime

#endif // RUNTIME_CONSOLE_STREAMS_HPP
