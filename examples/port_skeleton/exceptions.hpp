// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_PORT_SKELETON_EXCEPTIONS_HPP
#define EXAMPLES_PORT_SKELETON_EXCEPTIONS_HPP

#include "hal/api/exception_record.hpp"
#include "hal/api/output_cutoff.hpp"
#include "parts.hpp"

namespace port_skeleton
{

/// @brief CONTRACT. What every vector of an exception leads to: the outputs first, then the record, in this order. The
/// handler then stands still until the watchdog resets the controller; it does not return to what went wrong, and does
/// not come here by a stack that the exception may have destroyed.
void OnException(counterpoint::hal::OutputCutoff& cut_off, counterpoint::hal::ExceptionMemory& memory,
                 counterpoint::hal::ExceptionCause cause, std::uint64_t address) noexcept;

/// @brief kThere once the vectors lead to it and the record survives a reset by the watchdog.
[[nodiscard]] PartState StateOfExceptions() noexcept;

} // namespace port_skeleton

#endif
