// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_CONTRACT_TIME_HPP
#define SAFETY_CORE_CONTRACT_TIME_HPP

#include <cstdint>

namespace counterpoint
{

/// A reading of one of the two counters of time. Microseconds, modular; the difference of two instants is valid up to
/// 2^31 us. Nothing in kernel and channels reads a clock: instants come in as arguments. [SRS_TIME_001]
struct Instant
{
    std::uint32_t us;
};

/// The two independent counters, read at one place and moment. A channel sees only its own. [SRS_TIME_002]
struct InstantPair
{
    Instant a;
    Instant b;
};

} // namespace counterpoint

#endif
