// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_BENCH_SERVICE_LOAD_HPP
#define VERIFICATION_BENCH_SERVICE_LOAD_HPP

#include "verification/bench/frame_mix.hpp"

namespace counterpoint::bench
{

enum class LoadOutcome : std::uint8_t
{
    kInvalid = 0U,
    kDone = 0x69U,
    kNoMix = 1U,      ///< No file of bench_mix where it is expected.
    kNotStarted = 2U, ///< The node refused its configuration.
    kOther = 3U,      ///< The node did something else than on the simulated bus.
    kFaulted = 4U,
};

/// @brief Lives through the mix once more and reports what that costs by MeterReport. [SRS_BEN_012]
[[nodiscard]] LoadOutcome RunServiceLoad(const Mix& mix) noexcept;
[[nodiscard]] const char* NameOf(LoadOutcome outcome) noexcept;

} // namespace counterpoint::bench

#endif
