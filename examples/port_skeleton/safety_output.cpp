// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_output.hpp"

namespace port_skeleton
{

std::uint32_t SafetyOutput::Challenge() noexcept
{
    return gate_.Challenge();
}

void SafetyOutput::Drive(const counterpoint::hal::PermitSet& /*permits*/) noexcept
{
    gate_.Close();
}

void SafetyOutput::CutOff() noexcept
{
    gate_.Close();
}

PartState SafetyOutput::State() const noexcept
{
    return PartState::kMissing;
}

PartState SafetyOutput::StateOfCutOff() const noexcept
{
    return PartState::kMissing;
}

} // namespace port_skeleton
