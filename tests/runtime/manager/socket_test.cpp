// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The socket of the manager: who sends what, and who keeps nobody waiting.
#include "canopen/cia306/text/input_error.hpp"
#include "runtime/manager/socket.hpp"
#include "tests/canopen/cia306/folder_of_files.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/verifies.hpp"

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <poll.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

namespace counterpoint::tools
{
namespace
{
class ManagerSocketTest : public cia306::test::FolderTest
{
  protected:
    static host::LiveFile Connect(const std::string& path)
    {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        std::copy(path.begin(), path.end(), address.sun_path);
        host::LiveFile client(::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0));
        EXPECT_EQ(::connect(client.Get(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
        return client;
    }
    /// What came; "cut" when the other side has ended the connection, "" when nothing came.
    static std::string Receive(const host::LiveFile& client)
    {
        char text[256] = {};
        const ssize_t count = ::recv(client.Get(), text, sizeof(text), 0);
        return (count == 0) ? "cut" : std::string(text, static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    }
    static void Say(const host::LiveFile& client, const std::string& text)
    {
        EXPECT_EQ(::send(client.Get(), text.data(), text.size(), MSG_NOSIGNAL), static_cast<ssize_t>(text.size()));
    }
    static std::string Echo(const std::string& line)
    {
        return line + "!";
    }
    static void SleepNs(const std::uint64_t ns)
    {
        constexpr std::uint64_t kSecond = 1'000'000'000U;
        const timespec time{static_cast<time_t>(ns / kSecond), static_cast<long>(ns % kSecond)};
        EXPECT_EQ(::clock_nanosleep(CLOCK_MONOTONIC, 0, &time, nullptr), 0);
    }
};

TEST_F(ManagerSocketTest, ASocketTakesThePlaceOfALeftSocketOnly)
{
    Verifies(req::SRS_MGR_137);
    // Given a file of a person
    const std::string file = File("file", "mine");
    EXPECT_THROW(runtime::ManagerSocket socket(file), cia306::InputError);
    EXPECT_EQ(cia306::ReadTextFile(file), "mine");
    // And a socket that nobody serves any more
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const std::string path = Path("left.sock");
    std::copy(path.begin(), path.end(), address.sun_path);
    {
        const host::LiveFile left(::socket(AF_UNIX, SOCK_STREAM, 0));
        ASSERT_EQ(::bind(left.Get(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
    }
    EXPECT_NO_THROW(runtime::ManagerSocket socket(path));
}

// Given a manager whose callers wait, more than its queue holds, then a second one leaves it its socket.
TEST_F(ManagerSocketTest, ABusySocketIsServed)
{
    Verifies(req::SRS_MGR_061);
    const std::string path = Path("busy.sock");
    const runtime::ManagerSocket socket(path);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::copy(path.begin(), path.end(), address.sun_path);
    std::vector<host::LiveFile> callers;
    for (int i = 0; i < 20; ++i)
    {
        callers.emplace_back(::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0));
        static_cast<void>(
            ::connect(callers.back().Get(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)));
    }
    EXPECT_THROW(runtime::ManagerSocket second(path), cia306::InputError);
    EXPECT_TRUE(std::filesystem::is_socket(path));
}

TEST_F(ManagerSocketTest, ASocketRemovesItsOwnFileAndIsForItsOwner)
{
    Verifies(req::SRS_MGR_061);
    const std::string path = Path("own.sock");
    const auto mode = [&path] { return static_cast<unsigned>(std::filesystem::status(path).permissions()); };
    const mode_t before = ::umask(0);
    {
        const runtime::ManagerSocket socket(path);
        EXPECT_EQ(mode(), 0600U);
    }
    EXPECT_FALSE(std::filesystem::exists(path));
    ::umask(077);
    {
        const runtime::ManagerSocket socket(path, 0660);
        EXPECT_EQ(mode(), 0660U);
        // Somebody puts something else in its place
        std::filesystem::remove(path);
        static_cast<void>(File("own.sock", "mine"));
    }
    ::umask(before);
    EXPECT_EQ(cia306::ReadTextFile(path), "mine");
}

TEST_F(ManagerSocketTest, ProgramsSendOrdersByASocket)
{
    Verifies(req::SRS_MGR_006);
    runtime::ManagerSocket socket(Path("m.sock"));
    // A second manager does not take it away
    EXPECT_THROW(runtime::ManagerSocket second(Path("m.sock")), std::runtime_error);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const std::string path = Path("m.sock");
    std::copy(path.begin(), path.end(), address.sun_path);
    const host::LiveFile client(::socket(AF_UNIX, SOCK_STREAM, 0));
    ASSERT_EQ(::connect(client.Get(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
    ASSERT_EQ(::send(client.Get(), "status\nboot ", 12U, 0), 12);
    std::vector<std::string> lines;
    const auto answer = [&lines](const std::string& line)
    {
        lines.push_back(line);
        return "answer to " + line + "\n";
    };
    socket.Serve(answer); // The test before opened one connection and closed it.
    socket.Serve(answer);
    ASSERT_EQ(::send(client.Get(), "5\n", 2U, 0), 2);
    socket.Serve(answer);
    EXPECT_EQ(lines, (std::vector<std::string>{"status", "boot 5"}));
    char text[64] = {};
    EXPECT_EQ(::recv(client.Get(), text, sizeof(text), 0), 34);
    EXPECT_EQ(std::string(text), "answer to status\nanswer to boot 5\n");
}

TEST_F(ManagerSocketTest, AFewLinesOfEachClientATurn)
{
    Verifies(req::SRS_MGR_138);
    runtime::ManagerSocket socket(Path("m.sock"));
    const host::LiveFile many = Connect(Path("m.sock"));
    socket.Serve(Echo);
    const host::LiveFile one = Connect(Path("m.sock"));
    // Given a client with ten lines at once and one with a single line
    Say(many, "0\n1\n2\n3\n4\n5\n6\n7\n8\n9\n");
    Say(one, "x\n");
    socket.Serve(Echo);
    EXPECT_EQ(Receive(many), "0!1!2!3!");
    EXPECT_EQ(Receive(one), "x!");
    socket.Serve(Echo);
    socket.Serve(Echo);
    EXPECT_EQ(Receive(many), "4!5!6!7!8!9!");
}

TEST_F(ManagerSocketTest, WhoIsSilentMakesRoomAndWhoNeverEndsALineIsCut)
{
    Verifies(req::SRS_MGR_138);
    runtime::ManagerSocket socket(Path("m.sock"));
    std::vector<host::LiveFile> clients;
    for (int client = 0; client < 8; ++client)
    {
        clients.push_back(Connect(Path("m.sock")));
        socket.Serve(Echo);
    }
    Say(clients[0], "0\n");
    socket.Serve(Echo);
    EXPECT_EQ(Receive(clients[0]), "0!");
    // When a ninth comes, then the second one, who was silent longest, goes
    const host::LiveFile ninth = Connect(Path("m.sock"));
    socket.Serve(Echo);
    Say(ninth, "9\n");
    socket.Serve(Echo);
    EXPECT_EQ(Receive(ninth), "9!");
    EXPECT_EQ(Receive(clients[1]), "cut");
    EXPECT_EQ(Receive(clients[0]), "");
    // When a line has no end, then it is answered, which ends the connection
    Say(clients[2], std::string(2000U, 'x'));
    socket.Serve(Echo);
    socket.Serve(Echo);
    std::string answer;
    for (int part = 0; part < 8; ++part)
    {
        answer += Receive(clients[2]);
    }
    EXPECT_EQ(answer, std::string(2000U, 'x') + "!");
    EXPECT_EQ(Receive(clients[2]), "cut");
}

TEST_F(ManagerSocketTest, WhoDoesNotTakeItsAnswersIsCut)
{
    Verifies(req::SRS_MGR_138);
    runtime::ManagerSocket socket(Path("m.sock"));
    const host::LiveFile deaf = Connect(Path("m.sock"));
    socket.Serve(Echo);
    const host::LiveFile one = Connect(Path("m.sock"));
    socket.Serve(Echo);
    // Given answers of 100000 bytes that one of two clients never reads
    const auto much = [](const std::string& line) { return (line == "x") ? "x!" : std::string(100000U, 'a'); };
    int turns = 0;
    for (; turns < 1000 && ::send(deaf.Get(), "1\n", 2U, MSG_NOSIGNAL) == 2; ++turns)
    {
        socket.Serve(much);
    }
    // Then it is cut off as soon as there is no room for one
    EXPECT_LT(turns, 1000);
    // And the other one is served
    Say(one, "x\n");
    socket.Serve(much);
    EXPECT_EQ(Receive(one), "x!");
}

// Given a client that sends ten orders at once, whose answers are longer than a socket takes, then it gets all of them.
TEST_F(ManagerSocketTest, AnAnswerWaitsForItsClient)
{
    Verifies(req::SRS_MGR_160);
    constexpr std::size_t kLong = 300000U;
    runtime::ManagerSocket socket(Path("m.sock"));
    const host::LiveFile client = Connect(Path("m.sock"));
    int answers = 0;
    const auto much = [&answers](const std::string& line)
    {
        ++answers;
        return std::string(kLong, line[0]);
    };
    Say(client, "0\n1\n2\n3\n4\n5\n6\n7\n8\n9\n");
    for (int turn = 0; turn < 100; ++turn)
    {
        socket.Serve(much);
    }
    // The second order waits while the first answer does
    EXPECT_EQ(answers, 1);
    std::string all;
    for (int turn = 0; turn < 100000 && all.size() < 10U * kLong; ++turn)
    {
        socket.Serve(much);
        all += Receive(client);
    }
    std::string expected;
    for (const char order : std::string("0123456789"))
    {
        expected += std::string(kLong, order);
    }
    EXPECT_TRUE(all == expected) << all.size();
    EXPECT_EQ(answers, 10);
}

// Given a client that reads nothing of an answer for as long as it may, then it is cut off within it.
TEST_F(ManagerSocketTest, WhoTakesNothingOfAnAnswerIsCutInTime)
{
    Verifies(req::SRS_MGR_160);
    const auto much = [](const std::string& line) { return std::string(300000U, line[0]); };
    const auto rest = [this, &much](runtime::ManagerSocket& socket)
    {
        const host::LiveFile deaf = Connect(Path("m.sock"));
        Say(deaf, "1\n");
        socket.Serve(much);
        socket.Serve(much);
        std::string all;
        std::string more = Receive(deaf);
        for (int turn = 0; turn < 10000 && !more.empty() && more != "cut"; ++turn)
        {
            all += more;
            socket.Serve(much);
            more = Receive(deaf);
        }
        return std::pair(all.size(), more);
    };
    EXPECT_EQ(runtime::kAnswerPatienceNs, 2'000'000'000U);
    runtime::ManagerSocket strict(Path("m.sock"), runtime::kOwnerOnly, 0U);
    const auto cut = rest(strict);
    EXPECT_LT(cut.first, 300000U);
    EXPECT_EQ(cut.second, "cut");
}

// Given a client that says that nothing more comes, then its long answer still does, and then the end.
// The clock of this test stands still but for SleepNs.
TEST_F(ManagerSocketTest, WhoTakesSomethingHasTwoSecondsAnew)
{
    Verifies(req::SRS_MGR_160);
    const auto much = [](const std::string& line) { return std::string(3000000U, line[0]); };
    runtime::ManagerSocket socket(Path("m.sock"));
    const host::LiveFile client = Connect(Path("m.sock"));
    const auto is_served = [&socket]
    {
        std::vector<pollfd> places;
        socket.AddTo(places);
        return places.size() == 2U;
    };
    Say(client, "1\n");
    socket.Serve(much);
    // Given a client that takes nothing for a nanosecond less than two seconds, twice, and something in between
    for (int round = 0; round < 2; ++round)
    {
        SleepNs(1'999'999'999U);
        socket.Serve(much);
        EXPECT_TRUE(is_served()) << round;
        for (int reading = 0; reading < 2000; ++reading)
        {
            EXPECT_NE(Receive(client), "cut");
        }
        socket.Serve(much);
    }
    // When it takes nothing for two seconds, then it is cut off
    SleepNs(1'999'999'999U);
    socket.Serve(much);
    EXPECT_TRUE(is_served());
    SleepNs(1U);
    socket.Serve(much);
    EXPECT_FALSE(is_served());
}

TEST_F(ManagerSocketTest, WhoHasSentAllGetsItsAnswerToTheEnd)
{
    Verifies(req::SRS_MGR_160);
    runtime::ManagerSocket socket(Path("m.sock"));
    const host::LiveFile client = Connect(Path("m.sock"));
    Say(client, "1\n");
    ASSERT_EQ(::shutdown(client.Get(), SHUT_WR), 0);
    const auto much = [](const std::string& line) { return std::string(300000U, line[0]); };
    std::string all;
    std::string more;
    for (int turn = 0; turn < 10000 && more != "cut"; ++turn)
    {
        socket.Serve(much);
        more = Receive(client);
        all += (more == "cut") ? "" : more;
    }
    EXPECT_EQ(all.size(), 300000U);
    EXPECT_EQ(more, "cut");
}

TEST_F(ManagerSocketTest, ALineOf1024BytesIsOneAndOfOneMoreIsNot)
{
    Verifies(req::SRS_MGR_138);
    runtime::ManagerSocket socket(Path("m.sock"));
    const host::LiveFile longest = Connect(Path("m.sock"));
    const host::LiveFile longer = Connect(Path("m.sock"));
    socket.Serve(Echo);
    socket.Serve(Echo);
    Say(longest, std::string(1024U, 'a'));
    Say(longer, std::string(1025U, 'b'));
    std::size_t length = 0U;
    const auto count = [&length](const std::string& line)
    {
        length = line.size();
        return std::string("!");
    };
    socket.Serve(count);
    socket.Serve(count);
    Say(longest, "\n");
    socket.Serve(count);
    EXPECT_EQ(length, 1024U);
    EXPECT_EQ(Receive(longest), "!");
    // The other one is asked about, too, and cut off behind the answer
    EXPECT_EQ(Receive(longer), "!");
    socket.Serve(count);
    EXPECT_EQ(Receive(longer), "cut");
    EXPECT_EQ(length, 1024U);
}

TEST_F(ManagerSocketTest, ALineThatTheEndOfWhatIsSentCutsIsNoOrder)
{
    Verifies(req::SRS_MGR_471);
    runtime::ManagerSocket socket(Path("m.sock"));
    const host::LiveFile client = Connect(Path("m.sock"));
    // Given a client that sends a line and half of one, and then says that nothing more comes
    Say(client, "one\ntwo");
    ASSERT_EQ(::shutdown(client.Get(), SHUT_WR), 0);
    std::vector<std::string> cuts;
    const auto cut = [&cuts](const std::string& line)
    {
        cuts.push_back(line);
        return line + "?";
    };
    for (int turn = 0; turn < 4; ++turn)
    {
        socket.Serve(Echo, cut);
    }
    // Then the first one is an order, and the other one is answered as what it is, once
    EXPECT_EQ(Receive(client), "one!two?");
    EXPECT_EQ(Receive(client), "cut");
    EXPECT_EQ(cuts, (std::vector<std::string>{"two"}));
    // Also of a client that is gone
    {
        const host::LiveFile gone = Connect(Path("m.sock"));
        Say(gone, "stop 1");
    }
    for (int turn = 0; turn < 4; ++turn)
    {
        socket.Serve(Echo, cut);
    }
    EXPECT_EQ(cuts, (std::vector<std::string>{"two", "stop 1"}));
}

TEST_F(ManagerSocketTest, WhereNoSocketCanBeMadeTheReasonIsTold)
{
    Verifies(req::SRS_MGR_137);
    const auto problem = [](const std::string& path)
    {
        try
        {
            const runtime::ManagerSocket socket(path);
        }
        catch (const cia306::InputError& error)
        {
            return std::string(error.what());
        }
        return std::string();
    };
    const std::string expected = "expected a path in a folder that can be written, that nobody serves";
    EXPECT_EQ(problem(Path("none/m.sock")),
              Path("none/m.sock") + ": error: no socket can be made here (No such file or directory), " + expected);
    // A name that is none
    EXPECT_EQ(problem(""), ": error: no socket can be made here (No such file or directory), " + expected);
    // A name as long as an address can hold it, and one byte more
    const std::string longest = Path(std::string(107U - Path("").size(), 'x'));
    EXPECT_EQ(problem(longest), "");
    EXPECT_EQ(problem(longest + "x"), longest + "x: error: a socket name of 108 bytes, expected less than 108");
    // A process that may have no further descriptor
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
    const int next = ::dup(0);
    ASSERT_GE(next, 0);
    ASSERT_EQ(::close(next), 0);
    const rlimit none{static_cast<rlim_t>(next), before.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &none), 0);
    const std::string full = problem(Path("m.sock"));
    ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &before), 0);
    EXPECT_EQ(full, Path("m.sock") + ": error: no socket can be made here (Too many open files), " + expected);
    EXPECT_EQ(problem(Path("m.sock")), "");
}

// An address of zeros is a name, too, and no file that could be looked at or replaced.
TEST_F(ManagerSocketTest, ANameWithoutAFileIsNotReplaced)
{
    Verifies(req::SRS_MGR_137);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const host::LiveFile there(::socket(AF_UNIX, SOCK_STREAM, 0));
    static_cast<void>(::bind(there.Get(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)));
    EXPECT_THROW(runtime::ManagerSocket socket(""), cia306::InputError);
}

TEST_F(ManagerSocketTest, TheEndRemovesNothingThatItDidNotMake)
{
    Verifies(req::SRS_MGR_061);
    namespace fs = std::filesystem;
    const std::string path = Path("link/status");
    fs::create_directory(Path("real"));
    fs::create_directory_symlink(Path("real"), Path("link"));
    {
        const runtime::ManagerSocket socket(path);
        EXPECT_TRUE(fs::is_socket(Path("real/status")));
        // Given a folder of another file system in the place of its own, with a file of this name
        fs::remove(Path("link"));
        fs::create_directory_symlink("/proc/self", Path("link"));
    }
    EXPECT_TRUE(fs::is_socket(Path("real/status")));
    // Or nothing at all
    {
        const runtime::ManagerSocket socket(Path("m.sock"));
        fs::remove(Path("m.sock"));
    }
    EXPECT_FALSE(fs::exists(Path("m.sock")));
}

TEST_F(ManagerSocketTest, WhatIsWaitedForIsWhatAClientMayDo)
{
    Verifies(req::SRS_MGR_138);
    Verifies(req::SRS_MGR_160);
    runtime::ManagerSocket socket(Path("m.sock"));
    const auto events = [&socket]
    {
        std::vector<pollfd> places;
        socket.AddTo(places);
        std::vector<int> waited;
        for (const pollfd& place : places)
        {
            waited.push_back(place.events);
        }
        return waited;
    };
    EXPECT_EQ(events(), (std::vector<int>{POLLIN}));
    const host::LiveFile client = Connect(Path("m.sock"));
    socket.Serve(Echo);
    EXPECT_EQ(events(), (std::vector<int>{POLLIN, POLLIN}));
    // Lines that wait for the next turn: nothing more is read
    Say(client, "0\n1\n2\n3\n4\n");
    socket.Serve(Echo);
    EXPECT_EQ(events(), (std::vector<int>{POLLIN, 0}));
    socket.Serve(Echo);
    EXPECT_EQ(events(), (std::vector<int>{POLLIN, POLLIN}));
    EXPECT_EQ(Receive(client), "0!1!2!3!4!");
    // An answer that waits: room for more of it, also behind the last thing that the client says
    Say(client, "5\nrest");
    ASSERT_EQ(::shutdown(client.Get(), SHUT_WR), 0);
    const auto much = [](const std::string& /*line*/) { return std::string(300000U, 'a'); };
    socket.Serve(much, much);
    EXPECT_EQ(events(), (std::vector<int>{POLLIN, POLLOUT}));
    std::size_t size = 0U;
    for (int turn = 0; turn < 10000 && size < 300000U; ++turn)
    {
        size += Receive(client).size();
        socket.Serve(much, much);
    }
    EXPECT_EQ(events(), (std::vector<int>{POLLIN, POLLOUT}));
    // And the end behind it
    std::string more;
    for (int turn = 0; turn < 10000 && more != "cut"; ++turn)
    {
        more = Receive(client);
        size += (more == "cut") ? 0U : more.size();
        socket.Serve(much, much);
    }
    EXPECT_EQ(size, 600000U);
    EXPECT_EQ(events(), (std::vector<int>{POLLIN}));
}

TEST_F(ManagerSocketTest, WhoGoesBeforeItsAnswerIsGone)
{
    Verifies(req::SRS_MGR_138);
    runtime::ManagerSocket socket(Path("m.sock"));
    std::vector<pollfd> places;
    // Given a client that asks and is gone before it is answered
    {
        const host::LiveFile hasty = Connect(Path("m.sock"));
        Say(hasty, "1\n");
    }
    socket.Serve(Echo);
    socket.AddTo(places);
    EXPECT_EQ(places.size(), 1U);
    // And one that goes without having read its answer
    {
        const host::LiveFile rude = Connect(Path("m.sock"));
        Say(rude, "1\n");
        socket.Serve(Echo);
    }
    socket.Serve(Echo);
    places.clear();
    socket.AddTo(places);
    EXPECT_EQ(places.size(), 1U);
    // Then a line that is cut off is answered by nothing where nobody has an answer to it
    const host::LiveFile cut = Connect(Path("m.sock"));
    Say(cut, "sto");
    ASSERT_EQ(::shutdown(cut.Get(), SHUT_WR), 0);
    socket.Serve(Echo);
    socket.Serve(Echo);
    EXPECT_EQ(Receive(cut), "cut");
}
} // namespace
} // namespace counterpoint::tools
