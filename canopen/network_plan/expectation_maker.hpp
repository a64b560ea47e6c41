// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_NETWORK_PLAN_EXPECTATION_MAKER_HPP
#define CANOPEN_NETWORK_PLAN_EXPECTATION_MAKER_HPP

#include "canopen/cia302/safety_gate/safety_check.hpp"
#include "canopen/cia306/file/device.hpp"

#include <cstdint>
#include <vector>

namespace counterpoint::network_plan
{
/// @brief The safety configuration that a DCF gives its device, for the gate; empty: the DCF has no SRDO that is on.
/// Throws cia306::InputError for the first rule that the configuration breaks: what is expected has to be right.
/// [SRS_NET_003, SRS_NET_004]
[[nodiscard]] std::vector<cia302::ExpectedObject> MakeExpectation(const cia306::Device& device, std::uint8_t node_id);
} // namespace counterpoint::network_plan

#endif // CANOPEN_NETWORK_PLAN_EXPECTATION_MAKER_HPP
