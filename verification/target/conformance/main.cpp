// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/target/conformance/suite.hpp"
#include "verification/target/target.hpp"

extern "C" std::uint32_t TargetMain() noexcept;

extern "C" std::uint32_t TargetMain() noexcept
{
    constexpr std::uint32_t kSequences = 20000U;
    constexpr std::uint32_t kFewSequences = 200U;
    // "short": for programs that are changed on purpose.
    const bool is_short = counterpoint::target::Argument()[0] == 's';
    return counterpoint::target::RunSuite(is_short ? kFewSequences : kSequences);
}
