// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "parameter_memory.hpp"

namespace port_skeleton
{

std::uint32_t ParameterMemory::BankBytes() const noexcept
{
    return 0U;
}

counterpoint::hal::MemoryStatus ParameterMemory::Status() noexcept
{
    return counterpoint::hal::MemoryStatus::kFailed;
}

void ParameterMemory::Erase(const counterpoint::hal::MemoryBank /*bank*/) noexcept
{
}

void ParameterMemory::Program(const counterpoint::hal::MemorySection& /*section*/,
                              const std::uint8_t* const /*from*/) noexcept
{
}

bool ParameterMemory::Read(const counterpoint::hal::MemorySection& /*section*/, std::uint8_t* const /*to*/) noexcept
{
    return false;
}

PartState ParameterMemory::State() const noexcept
{
    return PartState::kMissing;
}

} // namespace port_skeleton
