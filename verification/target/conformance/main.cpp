// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/target/conformance/suite.hpp"

extern "C" std::uint32_t TargetMain() noexcept;

extern "C" std::uint32_t TargetMain() noexcept
{
    constexpr std::uint32_t kSequences = 20000U;
    return counterpoint::target::RunSuite(kSequences);
}
