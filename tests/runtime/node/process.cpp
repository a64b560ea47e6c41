// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/runtime/node/process.hpp"

#include <gtest/gtest.h>
#include <optional>
#include <unistd.h>

namespace counterpoint::tools::test
{
namespace
{
constexpr int kPatienceMs = 60000;
constexpr std::uint64_t kNsPerMs = 1000000U;

std::vector<std::string> Words(const std::vector<std::string>& arguments, const std::string& bus)
{
    std::vector<std::string> words{COUNTERPOINT_PROGRAM, "node", "--can", bus, "--json"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return words;
}
} // namespace

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
    : SteppedProcess(Words(arguments, bus))
{
}

bool NodeProcess::ReadSome(const std::uint64_t until_ns)
{
    const std::optional<std::string> some = Read(until_ns);
    text_ += some.value_or("");
    for (std::size_t end = text_.find('\n'); end != std::string::npos; end = text_.find('\n'))
    {
        lines_.push_back({nlohmann::json::parse(text_.substr(0U, end)), NowNs()});
        text_.erase(0U, end + 1U);
    }
    return some.has_value();
}

NodeLine NodeProcess::Next(const Wanted& wanted, const int ms)
{
    const std::uint64_t until_ns = NowNs() + static_cast<std::uint64_t>(ms) * kNsPerMs;
    do
    {
        for (; seen_ < lines_.size(); ++seen_)
        {
            if (wanted(lines_[seen_].event))
            {
                return lines_[seen_++];
            }
        }
    } while (ReadSome(until_ns));
    return {};
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
    while (ReadSome(NowNs() + kPatienceMs * kNsPerMs))
    {
    }
    return SteppedProcess::End();
}
} // namespace counterpoint::tools::test
