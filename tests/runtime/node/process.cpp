// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/runtime/node/process.hpp"

#include <array>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace counterpoint::tools::test
{
namespace
{
constexpr int kPatienceMs = 5000;
constexpr std::uint64_t kNsPerMs = 1000000U;
} // namespace

std::uint64_t NowNs()
{
    timespec time{};
    ::clock_gettime(CLOCK_MONOTONIC, &time);
    return static_cast<std::uint64_t>(time.tv_sec) * 1000000000U + static_cast<std::uint64_t>(time.tv_nsec);
}

std::string OwnBus()
{
    return "udp:239.74.163.2:" + std::to_string(20000 + ::getpid() % 20000);
}

std::string OtherBus()
{
    return "udp:239.74.163.2:" + std::to_string(40000 + ::getpid() % 20000);
}

std::unique_ptr<NodeProcess> StartNode(const std::string& dcf, const std::vector<std::string>& more,
                                       const std::string& bus)
{
    std::vector<std::string> arguments{"--dcf", std::string(COUNTERPOINT_SOURCE) + "/examples/" + dcf, "--cycle-us",
                                       std::to_string(kCycleUs)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    auto node = std::make_unique<NodeProcess>(arguments, bus);
    EXPECT_EQ(node->WaitFor("nmt").event["state"], "pre_operational");
    return node;
}

double LimitMsOf(const NodeProcess& consumer)
{
    for (const NodeLine& line : consumer.Lines())
    {
        if (line.event["event"] == "srdo" && line.event["consumer"] == true)
        {
            return line.event["limit_us"].get<double>() / 1000.0;
        }
    }
    return 0.0;
}

NodeProcess::Wanted Event(const std::string& name, const std::string& key, const nlohmann::json& value)
{
    return [name, key, value](const nlohmann::json& event)
    { return event["event"] == name && event.contains(key) && event[key] == value; };
}

NodeProcess::NodeProcess(const std::vector<std::string>& arguments, const std::string& bus)
{
    std::vector<std::string> words{COUNTERPOINT_PROGRAM, "node", "--can", bus, "--json"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words)
    {
        pointers.push_back(word.data());
    }
    pointers.push_back(nullptr);
    std::array<int, 2U> in{};
    std::array<int, 2U> out{};
    if (::pipe(in.data()) != 0 || ::pipe(out.data()) != 0)
    {
        std::abort();
    }
    process_ = ::fork();
    if (process_ == 0)
    {
        ::dup2(in[0], STDIN_FILENO);
        ::dup2(out[1], STDOUT_FILENO);
        for (const int file : {in[0], in[1], out[0], out[1]})
        {
            ::close(file);
        }
        ::execv(pointers.front(), pointers.data());
        ::_exit(127);
    }
    ::close(in[0]);
    ::close(out[1]);
    input_ = in[1];
    output_ = out[0];
}

NodeProcess::~NodeProcess()
{
    if (process_ > 0)
    {
        Signal(SIGKILL);
        Signal(SIGCONT);
        ::waitpid(process_, nullptr, 0);
    }
    ::close(input_);
    ::close(output_);
}

void NodeProcess::Type(const std::string& order)
{
    const std::string line = order + "\n";
    if (::write(input_, line.data(), line.size()) != static_cast<ssize_t>(line.size()))
    {
        std::abort();
    }
}

void NodeProcess::Signal(const int number)
{
    ::kill(process_, number);
}

bool NodeProcess::ReadSome(const int ms)
{
    pollfd place{output_, POLLIN, 0};
    std::array<char, 4096U> bytes{};
    const ssize_t count = (::poll(&place, 1U, ms) > 0) ? ::read(output_, bytes.data(), bytes.size()) : 0;
    if (count <= 0)
    {
        return false;
    }
    text_.append(bytes.data(), static_cast<std::size_t>(count));
    for (std::size_t end = text_.find('\n'); end != std::string::npos; end = text_.find('\n'))
    {
        lines_.push_back({nlohmann::json::parse(text_.substr(0U, end)), NowNs()});
        text_.erase(0U, end + 1U);
    }
    return true;
}

NodeLine NodeProcess::Next(const Wanted& wanted, const int ms)
{
    const std::uint64_t until_ns = NowNs() + static_cast<std::uint64_t>(ms) * kNsPerMs;
    while (true)
    {
        for (; seen_ < lines_.size(); ++seen_)
        {
            if (wanted(lines_[seen_].event))
            {
                return lines_[seen_++];
            }
        }
        const std::uint64_t now_ns = NowNs();
        if (now_ns >= until_ns ||
            (!ReadSome(static_cast<int>((until_ns - now_ns) / kNsPerMs) + 1) && NowNs() >= until_ns))
        {
            return {};
        }
    }
}

NodeLine NodeProcess::WaitFor(const Wanted& wanted)
{
    return Next(wanted, kPatienceMs);
}

NodeLine NodeProcess::WaitFor(const std::string& event)
{
    return Next([&event](const nlohmann::json& line) { return line["event"] == event; }, kPatienceMs);
}

bool NodeProcess::Tells(const Wanted& wanted, const int ms)
{
    return !Next(wanted, ms).event.is_null();
}

int NodeProcess::End()
{
    while (ReadSome(kPatienceMs))
    {
    }
    int status = 0;
    ::waitpid(process_, &status, 0);
    process_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}
} // namespace counterpoint::tools::test
