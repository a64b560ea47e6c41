// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What the host's parts do when the system refuses them something: no descriptor, no room, no connection.
#include "hal/host/file_parameter_memory.hpp"
#include "hal/host/live/address.hpp"
#include "hal/host/udp_cross_link.hpp"
#include "tests/hal/host/live_rig.hpp"
#include "tests/hal/host/system_calls.hpp"
#include "verification/trace/ids/crosslink.hpp"
#include "verification/trace/ids/live_bus.hpp"
#include "verification/trace/ids/store.hpp"
#include "verification/trace/verifies.hpp"

#include <array>
#include <cerrno>
#include <filesystem>
#include <gtest/gtest.h>
#include <stdexcept>
#include <unistd.h>

namespace counterpoint::host
{
namespace
{

/// The text of the std::runtime_error that `act` throws; empty: it threw none.
std::string RefusalOf(const std::function<void()>& act)
{
    try
    {
        act();
    }
    catch (const std::runtime_error& error)
    {
        return error.what();
    }
    return {};
}

std::string Group(const std::string& option)
{
    return "udp:239.74.163.12:" + std::to_string(20'000 + (::getpid() % 40'000)) + option;
}

TEST(UdpBusSystemTest, SaysThatItCannotJoin)
{
    Verifies(req::SRS_LIVE_010);
    const auto problem = [] { return ProblemOf([] { static_cast<void>(OpenLiveBus(Group(""))); }); };
    const std::string end = ", expected to join the group on the loopback interface";
    {
        const FailingCall socket{SystemCall::kSocket, EMFILE};
        EXPECT_EQ(problem(), "bus '" + Group("") + "': Too many open files" + end);
    }
    {
        const FailingCall bind{SystemCall::kBind, EADDRINUSE};
        EXPECT_EQ(problem(), "bus '" + Group("") + "': Address already in use" + end);
    }
    // Address, membership, interface, hops, own frames
    for (const int passed : {0, 1, 2, 3, 4})
    {
        const FailingCall option{SystemCall::kSetOption, EPERM, passed};
        EXPECT_EQ(problem(), "bus '" + Group("") + "': Operation not permitted" + end) << passed;
    }
    EXPECT_EQ(problem(), "");
}

TEST(UdpBusSystemTest, KeepsInOrderWhatTheSystemDoesNotTakeYet)
{
    Verifies(req::SRS_LIVE_004);
    const auto bus = OpenLiveBus(Group(""));
    {
        const FailingCall send{SystemCall::kSend, ENOBUFS, 0, 3};
        ASSERT_EQ(bus->Send(Live(0x1U, {})), SendResult::kSent);
        ASSERT_EQ(bus->Send(Live(0x2U, {})), SendResult::kSent);
        EXPECT_EQ(bus->Health().waiting, 2U);
        EXPECT_EQ(Wait(*bus)->identifier, 1U);
        EXPECT_EQ(Wait(*bus)->identifier, 2U);
    }
    EXPECT_EQ(bus->Health().waiting, 0U);
}

TEST(LivePollSystemTest, SaysThatThereIsNothingToWaitWith)
{
    Verifies(req::SRS_LIVE_005);
    const FailingCall control{SystemCall::kPollControl, ENOSPC};
    EXPECT_EQ(RefusalOf([] { static_cast<void>(OpenLiveBus(Group(""))); }),
              "no descriptor to wait with: No space left on device");
}

TEST(UdpWireSystemTest, TellsWhatIsNotHandedOver)
{
    Verifies(req::SRS_LNK_022);
    const auto base = static_cast<std::uint16_t>(32'000 + ((::getpid() % 10'000) * 2));
    const UdpPorts ports{base, static_cast<std::uint16_t>(base + 1U)};
    {
        const FailingCall socket{SystemCall::kSocket, EMFILE};
        EXPECT_EQ(RefusalOf([&ports] { const UdpCrossLink wire{ports}; }),
                  "UDP port " + std::to_string(base) + " on 127.0.0.1: Too many open files, expected a free port");
    }
    UdpCrossLink wire{ports};
    hal::LinkFrame frame{};
    frame.length = static_cast<std::uint16_t>(hal::kLinkFrameBytes + 1U);
    EXPECT_EQ(wire.Send(frame), hal::LinkStatus::kNothing);
    frame.length = static_cast<std::uint16_t>(hal::kLinkFrameBytes);
    EXPECT_EQ(wire.Send(frame), hal::LinkStatus::kDone);
    const FailingCall send{SystemCall::kSend, ENOBUFS};
    EXPECT_EQ(wire.Send(frame), hal::LinkStatus::kNothing);
}

class FileMemorySystemTest : public ::testing::Test
{
  protected:
    FileMemorySystemTest()
    {
        std::filesystem::remove(path);
    }
    ~FileMemorySystemTest() override
    {
        std::filesystem::remove(path);
    }
    [[nodiscard]] std::string Refusal() const
    {
        return RefusalOf([this] { const FileParameterMemory memory{path, 64U}; });
    }

    std::string path{
        (std::filesystem::path(::testing::TempDir()) / ("counterpoint_refused_" + std::to_string(::getpid()) + ".bin"))
            .string()};
};

TEST_F(FileMemorySystemTest, IsMadeWholeOrNotAtAll)
{
    Verifies(req::SRS_STO_013);
    const std::string no_room = path + ": cannot be written, expected a regular file with room";
    {
        const FailingCall truncate{SystemCall::kTruncate, EFBIG};
        EXPECT_EQ(Refusal(), no_room);
    }
    // The first, or the second bank cannot be erased
    for (const int passed : {0, 1})
    {
        const FailingCall write{SystemCall::kWrite, ENOSPC, passed};
        EXPECT_EQ(Refusal(), no_room);
    }
    // A file system that knows no links, and a name that cannot be given either
    {
        const FailingCall link{SystemCall::kLink, EPERM};
        const FailingCall rename{SystemCall::kRename, EACCES};
        EXPECT_EQ(Refusal(), no_room);
    }
    EXPECT_FALSE(std::filesystem::exists(path));
    {
        const FailingCall link{SystemCall::kLink, EPERM};
        const FailingCall close{SystemCall::kClose, EIO, 0, 1};
        EXPECT_EQ(Refusal(), no_room);
    }
    EXPECT_FALSE(std::filesystem::exists(path));
    // A folder in which nothing can be made, a name below what is no folder
    {
        const FailingCall open{SystemCall::kOpen, EACCES};
        EXPECT_EQ(Refusal(),
                  path +
                      ": cannot be opened for reading and writing: Permission denied, expected a file for parameters");
    }
    EXPECT_EQ(
        RefusalOf([] { const FileParameterMemory memory{"/dev/null/store", 64U}; }),
        "/dev/null/store: cannot be opened for reading and writing: Not a directory, expected a file for parameters");
    // One that has no name left for the part
    {
        const FailingCall open{SystemCall::kOpen, EEXIST};
        EXPECT_EQ(Refusal(),
                  path + ": cannot be opened for reading and writing: File exists, expected a file for parameters");
    }
    EXPECT_FALSE(std::filesystem::exists(path));
    EXPECT_FALSE(std::filesystem::exists(path + ".new"));
    // Without links, it is renamed
    {
        const FailingCall link{SystemCall::kLink, EPERM};
        EXPECT_EQ(Refusal(), "");
    }
    EXPECT_EQ(std::filesystem::file_size(path), 128U);
    EXPECT_FALSE(std::filesystem::exists(path + ".new"));
}

TEST_F(FileMemorySystemTest, TheFileOfAFasterDeviceStays)
{
    Verifies(req::SRS_STO_013);
    // Given another device that makes the file between the look for it and its making
    const FailingCall link{SystemCall::kLink, EEXIST};
    EXPECT_EQ(Refusal(),
              path + ": cannot be opened for reading and writing: No such file or directory, expected a file for "
                     "parameters");
    EXPECT_FALSE(std::filesystem::exists(path));
    // On a file system without links
    const FailingCall other{SystemCall::kLink, EPERM};
    const FailingCall open{SystemCall::kOpen, EEXIST, 1};
    EXPECT_EQ(Refusal(),
              path + ": cannot be opened for reading and writing: File exists, expected a file for parameters");
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(FileMemorySystemTest, IsOpenedWhereTheFileSystemKnowsNoLocks)
{
    Verifies(req::SRS_STO_013);
    const FailingCall lock{SystemCall::kLock, ENOLCK};
    EXPECT_EQ(Refusal(), "");
    EXPECT_EQ(std::filesystem::file_size(path), 128U);
}

TEST_F(FileMemorySystemTest, WhatCannotBeLookedAtIsRefused)
{
    Verifies(req::SRS_STO_013);
    ASSERT_EQ(Refusal(), "");
    EXPECT_EQ(RefusalOf([this] { const FileParameterMemory memory{path, 0U}; }),
              path + ": a bank of 0 bytes, expected a multiple of 8 above 0");
    const FailingCall status{SystemCall::kFileStatus, EIO};
    EXPECT_EQ(Refusal(), path + ": cannot be opened for reading and writing: Input/output error, expected a file for "
                                "parameters");
}

TEST_F(FileMemorySystemTest, AFileOfAnotherDeviceUnderItsNameIsNotTheOneThatIsOpen)
{
    Verifies(req::SRS_STO_018);
    FileParameterMemory memory{path, 64U};
    std::filesystem::remove(path);
    std::filesystem::create_symlink("/proc/version", path);
    memory.Erase(hal::MemoryBank::kFirst);
    EXPECT_EQ(memory.Status(), hal::MemoryStatus::kFailed);
}

TEST_F(FileMemorySystemTest, WhatTheSystemRefusesFails)
{
    Verifies(req::SRS_STO_018);
    FileParameterMemory memory{path, 64U};
    const std::array<std::uint8_t, 8> bytes{1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U};
    std::array<std::uint8_t, 8> got{};
    for (const SystemCall call : {SystemCall::kWrite, SystemCall::kSynchronise, SystemCall::kFileStatus})
    {
        {
            const FailingCall failing{call, EIO};
            memory.Program({hal::MemoryBank::kFirst, 0U, 8U}, bytes.data());
            EXPECT_EQ(memory.Status(), hal::MemoryStatus::kFailed);
            memory.Erase(hal::MemoryBank::kSecond);
            EXPECT_EQ(memory.Status(), hal::MemoryStatus::kFailed);
        }
        memory.Program({hal::MemoryBank::kFirst, 0U, 8U}, bytes.data());
        EXPECT_EQ(memory.Status(), hal::MemoryStatus::kReady);
    }
    // What is gone only when it was written has not been written either
    {
        const FailingCall status{SystemCall::kFileStatus, EIO, 1};
        memory.Erase(hal::MemoryBank::kSecond);
        EXPECT_EQ(memory.Status(), hal::MemoryStatus::kFailed);
    }
    {
        const FailingCall status{SystemCall::kFileStatus, EIO, 1};
        memory.Program({hal::MemoryBank::kFirst, 0U, 8U}, bytes.data());
        EXPECT_EQ(memory.Status(), hal::MemoryStatus::kFailed);
    }
    EXPECT_TRUE(memory.Read({hal::MemoryBank::kFirst, 56U, 8U}, got.data()));
    EXPECT_FALSE(memory.Read({hal::MemoryBank::kFirst, 72U, 8U}, got.data()));
    const FailingCall read{SystemCall::kRead, EIO};
    EXPECT_FALSE(memory.Read({hal::MemoryBank::kFirst, 0U, 8U}, got.data()));
}

} // namespace
} // namespace counterpoint::host
