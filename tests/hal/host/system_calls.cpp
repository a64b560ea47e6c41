// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/hal/host/system_calls.hpp"

#include <array>
#include <cerrno>
#include <cstdarg>
#include <fcntl.h>
#include <net/if.h>
#include <poll.h>
#include <sys/epoll.h>
#include <sys/stat.h>

// --wrap=NAME leads every call of NAME to __wrap_NAME and gives the system's function the name __real_NAME.

namespace counterpoint::host
{
namespace
{

struct Plan
{
    int failure;
    int passed;
    int failing;
};

std::array<Plan, kSystemCalls> plans{};
SystemModel* model = nullptr;
thread_local std::vector<int>* waits = nullptr;

Plan& PlanOf(const SystemCall call)
{
    return plans.at(static_cast<std::size_t>(call));
}

/// Whether this call fails by plan; errno is set then.
bool Fails(const SystemCall call)
{
    Plan& plan = PlanOf(call);
    if (plan.failing == 0)
    {
        return false;
    }
    if (plan.passed > 0)
    {
        --plan.passed;
        return false;
    }
    --plan.failing;
    errno = plan.failure;
    return true;
}

/// What a model answered, as the system would.
template <typename Number> Number Told(const Number answer)
{
    if (answer < 0)
    {
        errno = static_cast<int>(-answer);
        return -1;
    }
    return answer;
}

} // namespace

FailingCall::FailingCall(const SystemCall call, const int failure, const int passed, const int failing) : call_{call}
{
    PlanOf(call_) = Plan{failure, passed, failing};
}

FailingCall::~FailingCall()
{
    PlanOf(call_) = Plan{0, 0, 0};
}

PollWatch::PollWatch()
{
    waits = &waits_;
}

PollWatch::~PollWatch()
{
    waits = nullptr;
}

SystemModel::SystemModel()
{
    model = this;
}

SystemModel::~SystemModel()
{
    model = nullptr;
}

int RealSocket(int domain, int type, int protocol) __asm__("__real_socket");
int WrapSocket(int domain, int type, int protocol) __asm__("__wrap_socket");
int WrapSocket(const int domain, const int type, const int protocol)
{
    if (Fails(SystemCall::kSocket))
    {
        return -1;
    }
    const std::optional<int> answer = (model != nullptr) ? model->Socket(domain, type) : std::nullopt;
    return answer ? Told(*answer) : RealSocket(domain, type, protocol);
}

int RealBind(int file, const sockaddr* address, socklen_t bytes) __asm__("__real_bind");
int WrapBind(int file, const sockaddr* address, socklen_t bytes) __asm__("__wrap_bind");
int WrapBind(const int file, const sockaddr* const address, const socklen_t bytes)
{
    if (Fails(SystemCall::kBind))
    {
        return -1;
    }
    const std::optional<int> answer = (model != nullptr) ? model->Bind(file, *address) : std::nullopt;
    return answer ? Told(*answer) : RealBind(file, address, bytes);
}

int RealConnect(int file, const sockaddr* address, socklen_t bytes) __asm__("__real_connect");
int WrapConnect(int file, const sockaddr* address, socklen_t bytes) __asm__("__wrap_connect");
int WrapConnect(const int file, const sockaddr* const address, const socklen_t bytes)
{
    if (!Fails(SystemCall::kConnect))
    {
        return RealConnect(file, address, bytes);
    }
    if (errno != 0)
    {
        return -1;
    }
    // A system that needs no time for it.
    const int flags = ::fcntl(file, F_GETFL);
    static_cast<void>(::fcntl(file, F_SETFL, flags & ~O_NONBLOCK));
    const int result = RealConnect(file, address, bytes);
    static_cast<void>(::fcntl(file, F_SETFL, flags));
    return result;
}

int RealListen(int file, int backlog) __asm__("__real_listen");
int WrapListen(int file, int backlog) __asm__("__wrap_listen");
int WrapListen(const int file, const int backlog)
{
    return Fails(SystemCall::kListen) ? -1 : RealListen(file, backlog);
}

int RealAccept(int file, sockaddr* address, socklen_t* bytes, int flags) __asm__("__real_accept4");
int WrapAccept(int file, sockaddr* address, socklen_t* bytes, int flags) __asm__("__wrap_accept4");
int WrapAccept(const int file, sockaddr* const address, socklen_t* const bytes, const int flags)
{
    return Fails(SystemCall::kAccept) ? -1 : RealAccept(file, address, bytes, flags);
}

int RealSetOption(int file, int level, int option, const void* value, socklen_t bytes) __asm__("__real_setsockopt");
int WrapSetOption(int file, int level, int option, const void* value, socklen_t bytes) __asm__("__wrap_setsockopt");
int WrapSetOption(const int file, const int level, const int option, const void* const value, const socklen_t bytes)
{
    if (Fails(SystemCall::kSetOption))
    {
        return -1;
    }
    const std::optional<int> answer =
        (model != nullptr) ? model->SetOption(file, level, option, value, bytes) : std::nullopt;
    return answer ? Told(*answer) : RealSetOption(file, level, option, value, bytes);
}

ssize_t RealSend(int file, const void* bytes, std::size_t count, int flags) __asm__("__real_send");
ssize_t WrapSend(int file, const void* bytes, std::size_t count, int flags) __asm__("__wrap_send");
ssize_t WrapSend(const int file, const void* const bytes, const std::size_t count, const int flags)
{
    if (Fails(SystemCall::kSend))
    {
        return -1;
    }
    const std::optional<ssize_t> answer = (model != nullptr) ? model->Send(file, bytes, count) : std::nullopt;
    return answer ? Told(*answer) : RealSend(file, bytes, count, flags);
}

ssize_t RealSendTo(int file, const void* bytes, std::size_t count, int flags, const sockaddr* to,
                   socklen_t to_bytes) __asm__("__real_sendto");
ssize_t WrapSendTo(int file, const void* bytes, std::size_t count, int flags, const sockaddr* to,
                   socklen_t to_bytes) __asm__("__wrap_sendto");
ssize_t WrapSendTo(const int file, const void* const bytes, const std::size_t count, const int flags,
                   const sockaddr* const to, const socklen_t to_bytes)
{
    return Fails(SystemCall::kSend) ? -1 : RealSendTo(file, bytes, count, flags, to, to_bytes);
}

ssize_t RealReceive(int file, void* bytes, std::size_t room, int flags) __asm__("__real_recv");
ssize_t WrapReceive(int file, void* bytes, std::size_t room, int flags) __asm__("__wrap_recv");
ssize_t WrapReceive(const int file, void* const bytes, const std::size_t room, const int flags)
{
    if (Fails(SystemCall::kReceive))
    {
        return -1;
    }
    const std::optional<ssize_t> answer = (model != nullptr) ? model->Receive(file, bytes, room) : std::nullopt;
    return answer ? Told(*answer) : RealReceive(file, bytes, room, flags);
}

ssize_t RealReceiveMessage(int file, msghdr* message, int flags) __asm__("__real_recvmsg");
ssize_t WrapReceiveMessage(int file, msghdr* message, int flags) __asm__("__wrap_recvmsg");
ssize_t WrapReceiveMessage(const int file, msghdr* const message, const int flags)
{
    const std::optional<ssize_t> answer = (model != nullptr) ? model->ReceiveMessage(file, *message) : std::nullopt;
    return answer ? Told(*answer) : RealReceiveMessage(file, message, flags);
}

unsigned RealIndexOf(const char* name) __asm__("__real_if_nametoindex");
unsigned WrapIndexOf(const char* name) __asm__("__wrap_if_nametoindex");
unsigned WrapIndexOf(const char* const name)
{
    const std::optional<unsigned> answer = (model != nullptr) ? model->IndexOf(name) : std::nullopt;
    if (answer && (*answer == 0U))
    {
        errno = ENODEV;
    }
    return answer ? *answer : RealIndexOf(name);
}

int RealPoll(pollfd* files, nfds_t count, int milliseconds) __asm__("__real_poll");
int WrapPoll(pollfd* files, nfds_t count, int milliseconds) __asm__("__wrap_poll");
int WrapPoll(pollfd* const files, const nfds_t count, const int milliseconds)
{
    if (waits != nullptr)
    {
        waits->push_back(milliseconds);
    }
    return Fails(SystemCall::kPoll) ? -1 : RealPoll(files, count, milliseconds);
}

int RealPollControl(int set, int operation, int file, epoll_event* event) __asm__("__real_epoll_ctl");
int WrapPollControl(int set, int operation, int file, epoll_event* event) __asm__("__wrap_epoll_ctl");
int WrapPollControl(const int set, const int operation, const int file, epoll_event* const event)
{
    return Fails(SystemCall::kPollControl) ? -1 : RealPollControl(set, operation, file, event);
}

int RealOpen(const char* path, int flags, ...) __asm__("__real_open");
int WrapOpen(const char* path, int flags, ...) __asm__("__wrap_open");
int WrapOpen(const char* const path, const int flags, ...)
{
    va_list rest;
    va_start(rest, flags);
    const int mode = ((flags & O_CREAT) != 0) ? va_arg(rest, int) : 0;
    va_end(rest);
    return Fails(SystemCall::kOpen) ? -1 : RealOpen(path, flags, mode);
}

int RealFileStatus(int file, struct stat* status) __asm__("__real_fstat");
int WrapFileStatus(int file, struct stat* status) __asm__("__wrap_fstat");
int WrapFileStatus(const int file, struct stat* const status)
{
    return Fails(SystemCall::kFileStatus) ? -1 : RealFileStatus(file, status);
}

int RealPathStatus(const char* path, struct stat* status) __asm__("__real_stat");
int WrapPathStatus(const char* path, struct stat* status) __asm__("__wrap_stat");
int WrapPathStatus(const char* const path, struct stat* const status)
{
    return Fails(SystemCall::kPathStatus) ? -1 : RealPathStatus(path, status);
}

int RealTruncate(int file, off_t bytes) __asm__("__real_ftruncate");
int WrapTruncate(int file, off_t bytes) __asm__("__wrap_ftruncate");
int WrapTruncate(const int file, const off_t bytes)
{
    return Fails(SystemCall::kTruncate) ? -1 : RealTruncate(file, bytes);
}

int RealSynchronise(int file) __asm__("__real_fdatasync");
int WrapSynchronise(int file) __asm__("__wrap_fdatasync");
int WrapSynchronise(const int file)
{
    return Fails(SystemCall::kSynchronise) ? -1 : RealSynchronise(file);
}

int RealLink(const char* from, const char* to) __asm__("__real_link");
int WrapLink(const char* from, const char* to) __asm__("__wrap_link");
int WrapLink(const char* const from, const char* const to)
{
    return Fails(SystemCall::kLink) ? -1 : RealLink(from, to);
}

int RealRename(const char* from, const char* to) __asm__("__real_rename");
int WrapRename(const char* from, const char* to) __asm__("__wrap_rename");
int WrapRename(const char* const from, const char* const to)
{
    return Fails(SystemCall::kRename) ? -1 : RealRename(from, to);
}

ssize_t RealRead(int file, void* bytes, std::size_t count, off_t at) __asm__("__real_pread");
ssize_t WrapRead(int file, void* bytes, std::size_t count, off_t at) __asm__("__wrap_pread");
ssize_t WrapRead(const int file, void* const bytes, const std::size_t count, const off_t at)
{
    return Fails(SystemCall::kRead) ? -1 : RealRead(file, bytes, count, at);
}

ssize_t RealWrite(int file, const void* bytes, std::size_t count, off_t at) __asm__("__real_pwrite");
ssize_t WrapWrite(int file, const void* bytes, std::size_t count, off_t at) __asm__("__wrap_pwrite");
ssize_t WrapWrite(const int file, const void* const bytes, const std::size_t count, const off_t at)
{
    return Fails(SystemCall::kWrite) ? -1 : RealWrite(file, bytes, count, at);
}

int RealLock(int file, int operation) __asm__("__real_flock");
int WrapLock(int file, int operation) __asm__("__wrap_flock");
int WrapLock(const int file, const int operation)
{
    return Fails(SystemCall::kLock) ? -1 : RealLock(file, operation);
}

int RealClose(int file) __asm__("__real_close");
int WrapClose(int file) __asm__("__wrap_close");
int WrapClose(const int file)
{
    if (Fails(SystemCall::kClose))
    {
        return -1;
    }
    if (model != nullptr)
    {
        model->OnClose(file);
    }
    return RealClose(file);
}

} // namespace counterpoint::host
