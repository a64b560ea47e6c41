// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/exceptions.hpp"

#include <cstdint>
#include <stdexcept>
#include <unistd.h>

namespace counterpoint::host
{

namespace
{

// A handler of a signal gets nothing from whoever installed it but what stands at a fixed place.
hal::OutputCutoff* the_cutoff = nullptr;
hal::ExceptionMemory* the_memory = nullptr;

constexpr std::size_t kStackBytes = 65536U;
alignas(16) std::uint8_t handler_stack[kStackBytes];

[[nodiscard]] hal::ExceptionCause CauseOf(const int signal) noexcept
{
    for (const HostException& exception : kHostExceptions)
    {
        if (exception.signal == signal)
        {
            return exception.cause;
        }
    }
    return hal::ExceptionCause::kInvalid;
}

void OnException(const int signal, siginfo_t* const info, void* /*context*/) noexcept
{
    the_cutoff->CutOff();
    the_memory->Record(CauseOf(signal), reinterpret_cast<std::uintptr_t>(info->si_addr));
    _exit(kExceptionExitStatus);
}

} // namespace

HostExceptions::HostExceptions(hal::OutputCutoff& cutoff, hal::ExceptionMemory& memory)
{
    if (the_cutoff != nullptr)
    {
        throw std::logic_error("the exceptions of this process are handled already");
    }
    the_cutoff = &cutoff;
    the_memory = &memory;
    stack_t stack{};
    stack.ss_sp = handler_stack;
    stack.ss_size = kStackBytes;
    sigaltstack(&stack, &stack_before_);
    struct sigaction action{};
    action.sa_sigaction = &OnException;
    // Nothing else may come in between, and a second exception inside of the handler ends the process at once.
    action.sa_flags = static_cast<int>(SA_SIGINFO | SA_ONSTACK | SA_RESETHAND);
    sigfillset(&action.sa_mask);
    for (unsigned number = 0U; number < kCount; ++number)
    {
        sigaction(kHostExceptions[number].signal, &action, &before_[number]);
    }
}

HostExceptions::~HostExceptions()
{
    for (unsigned number = 0U; number < kCount; ++number)
    {
        sigaction(kHostExceptions[number].signal, &before_[number], nullptr);
    }
    sigaltstack(&stack_before_, nullptr);
    the_cutoff = nullptr;
    the_memory = nullptr;
}

} // namespace counterpoint::host
