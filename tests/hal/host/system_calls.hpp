// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_HAL_HOST_SYSTEM_CALLS_HPP
#define TESTS_HAL_HOST_SYSTEM_CALLS_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <sys/socket.h>
#include <sys/types.h>
#include <vector>

namespace counterpoint::host
{

/// Calls of the operating system that the linker leads here (--wrap, see tests/hal/CMakeLists.txt); the objects under
/// test stay as they ship. Each goes on to the system, unless a test has it fail or has a model answer it.
enum class SystemCall : std::uint8_t
{
    kSocket = 0U,
    kBind,
    kConnect,
    kListen,
    kAccept,
    kSetOption,
    kSend,
    kReceive,
    kPoll,
    kPollControl,
    kOpen,
    kFileStatus,
    kPathStatus,
    kTruncate,
    kSynchronise,
    kLink,
    kRename,
    kRead,
    kWrite,
    kClose,
    kLock,
};
constexpr std::size_t kSystemCalls = 21U;

/// While it lives, calls of this kind fail with the errno `failure`, after `passed` calls that go on to the system, and
/// so many of them. kConnect with 0 connects before it returns.
class FailingCall
{
  public:
    FailingCall(SystemCall call, int failure, int passed = 0, int failing = 1'000'000);
    ~FailingCall();
    FailingCall(const FailingCall&) = delete;
    FailingCall& operator=(const FailingCall&) = delete;

  private:
    SystemCall call_;
};

/// While it lives: how long each call of poll by this thread may wait, in ms. One at a time.
class PollWatch
{
  public:
    PollWatch();
    ~PollWatch();
    PollWatch(const PollWatch&) = delete;
    PollWatch& operator=(const PollWatch&) = delete;
    [[nodiscard]] const std::vector<int>& Waits() const
    {
        return waits_;
    }

  private:
    std::vector<int> waits_{};
};

/// Answers calls in the place of the system while it lives; one at a time. Empty: that call is none of its own. A
/// negative answer is the errno, with its sign turned.
class SystemModel
{
  public:
    SystemModel();
    virtual ~SystemModel();
    SystemModel(const SystemModel&) = delete;
    SystemModel& operator=(const SystemModel&) = delete;

    virtual std::optional<int> Socket(int domain, int type) = 0;
    virtual std::optional<int> Bind(int file, const sockaddr& address) = 0;
    virtual std::optional<int> SetOption(int file, int level, int option, const void* value, socklen_t bytes) = 0;
    virtual std::optional<ssize_t> Send(int file, const void* bytes, std::size_t count) = 0;
    virtual std::optional<ssize_t> Receive(int file, void* bytes, std::size_t room) = 0;
    virtual std::optional<ssize_t> ReceiveMessage(int file, msghdr& message) = 0;
    virtual std::optional<unsigned> IndexOf(const char* name) = 0;
    /// The system closes it.
    virtual void OnClose(int file) = 0;
};

} // namespace counterpoint::host

#endif
