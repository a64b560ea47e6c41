// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_CONSOLE_STREAMS_HPP
#define RUNTIME_CONSOLE_STREAMS_HPP

#include <cstdint>
#include <iosfwd>

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
} // namespace counterpoint::runtime

#endif // RUNTIME_CONSOLE_STREAMS_HPP
