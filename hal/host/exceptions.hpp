// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_EXCEPTIONS_HPP
#define HAL_HOST_EXCEPTIONS_HPP

#include "hal/api/exception_record.hpp"
#include "hal/api/output_cutoff.hpp"

#include <csignal>

namespace counterpoint::host
{

/// Exit status of a process that an exception ended.
inline constexpr int kExceptionExitStatus = 86;

/// A signal that stands for an exception of a processor.
struct HostException
{
    int signal;
    hal::ExceptionCause cause;
};

inline constexpr HostException kHostExceptions[] = {
    {SIGSEGV, hal::ExceptionCause::kDataAccess}, {SIGBUS, hal::ExceptionCause::kBus},
    {SIGILL, hal::ExceptionCause::kInstruction}, {SIGFPE, hal::ExceptionCause::kArithmetic},
    {SIGABRT, hal::ExceptionCause::kProgram},
};

/// While it lives, an exception of this process switches the output off, leaves a record and ends the process with
/// kExceptionExitStatus. At most one object at a time. [SRS_STS_051]
class HostExceptions final
{
  public:
    /// @brief Both outlive this. Throws std::logic_error if there is one already.
    HostExceptions(hal::OutputCutoff& cutoff, hal::ExceptionMemory& memory);
    /// @brief Exceptions do again what they did before the construction.
    ~HostExceptions();

    HostExceptions(const HostExceptions&) = delete;
    HostExceptions(HostExceptions&&) = delete;
    HostExceptions& operator=(const HostExceptions&) = delete;
    HostExceptions& operator=(HostExceptions&&) = delete;

  private:
    static constexpr unsigned kCount = sizeof(kHostExceptions) / sizeof(kHostExceptions[0]);

    struct sigaction before_[kCount]{};
    stack_t stack_before_{};
};

} // namespace counterpoint::host

#endif
