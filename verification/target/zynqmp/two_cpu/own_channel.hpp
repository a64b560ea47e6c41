// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TARGET_ZYNQMP_TWO_CPU_OWN_CHANNEL_HPP
#define VERIFICATION_TARGET_ZYNQMP_TWO_CPU_OWN_CHANNEL_HPP

#include "safety_core/contract/channel.hpp"
#include "safety_core/crosslink/link_config.hpp"

/// The one channel of an image, linked into it by what the processor runs: channel A or channel B.
namespace counterpoint::two_cpu
{

[[nodiscard]] Channel& OwnChannel() noexcept;
[[nodiscard]] PeerRole OwnRole() noexcept;

} // namespace counterpoint::two_cpu

#endif
