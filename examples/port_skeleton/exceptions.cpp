// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "exceptions.hpp"

namespace port_skeleton
{

void OnException(counterpoint::hal::OutputCutoff& cut_off, counterpoint::hal::ExceptionMemory& memory,
                 const counterpoint::hal::ExceptionCause cause, const std::uint64_t address) noexcept
{
    cut_off.CutOff();
    memory.Record(cause, address);
}

PartState StateOfExceptions() noexcept
{
    return PartState::kMissing;
}

} // namespace port_skeleton
