// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_RUNTIME_MANAGER_RUN_RIG_HPP
#define TESTS_RUNTIME_MANAGER_RUN_RIG_HPP

#include "runtime/manager/loop.hpp"
#include "runtime/manager/report/status.hpp"
#include "runtime/network_files/file.hpp"
#include "tests/canopen/cia306/folder_of_files.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>
#include <sstream>
#include <sys/socket.h>
#include <sys/un.h>
#include <thread>
#include <unistd.h>

/// Runs of a live manager on a bus of the test.
namespace counterpoint::tools::test
{
constexpr std::uint64_t kMs = 1000000U;

/// What the bus of a test gives, and what it was asked.
struct Script
{
    std::function<bool(host::LiveFrame&)> receive{[](host::LiveFrame&) { return false; }};
    host::BusState state{host::BusState::kActive};
    std::string name{"udp:239.74.163.91:43191"};
    std::uint32_t received{0U};
    std::uint8_t refused{0U};                               ///< NMT command that finds no room; 0: none.
    std::uint32_t turns{0U};                                ///< How often it was asked how it is.
    std::uint32_t waits_for{0U};                            ///< So many turns long a frame waits in this host.
    std::function<std::uint32_t()> lost{[] { return 0U; }}; ///< Frames that the system has dropped so far.
    std::vector<host::LiveFrame> sent;
};

class ScriptBus final : public host::LiveBus
{
  public:
    explicit ScriptBus(Script& script) : script_(script)
    {
    }
    [[nodiscard]] host::SendResult Send(const host::LiveFrame& frame) override
    {
        const bool is_full = script_.refused != 0U && frame.identifier == 0U && frame.data[0] == script_.refused;
        if (is_full)
        {
            return host::SendResult::kQueueFull;
        }
        script_.sent.push_back(frame);
        return (script_.state == host::BusState::kActive) ? host::SendResult::kSent : host::SendResult::kDown;
    }
    [[nodiscard]] bool Receive(host::LiveFrame& frame) override
    {
        const bool is_one = script_.receive(frame);
        script_.received += is_one ? 1U : 0U;
        return is_one;
    }
    [[nodiscard]] int Descriptor() const override
    {
        return -1;
    }
    [[nodiscard]] host::BusHealth Health() const override
    {
        host::BusHealth health;
        health.state = script_.state;
        ++script_.turns;
        health.waiting = (script_.turns <= script_.waits_for) ? 1U : 0U;
        health.lost_frames = script_.lost();
        return health;
    }
    [[nodiscard]] std::string Name() const override
    {
        return script_.name;
    }
    [[nodiscard]] bool Restart() override
    {
        return false;
    }

  private:
    Script& script_;
};

inline host::LiveFrame Heartbeat(const std::uint64_t time_ns, const std::uint8_t state = 0x7FU)
{
    host::LiveFrame frame;
    frame.identifier = 0x705U;
    frame.length_bytes = 1U;
    frame.data[0] = state;
    frame.time_ns = time_ns;
    return frame;
}

class ManagerRun : public cia306::test::FolderTest
{
  protected:
    ManagerRun()
    {
        settings.log = Path("log.jsonl");
        settings.for_ns = 2000U * kMs;
    }
    ~ManagerRun() override
    {
        Close();
    }
    static host::LiveFile Connect(const std::string& path)
    {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        std::copy(path.begin(), path.end(), address.sun_path);
        host::LiveFile client(::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0));
        EXPECT_EQ(::connect(client.Get(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
        return client;
    }
    /// These lines wait at the input, which stays open until EndInput.
    void Type(const std::string& lines)
    {
        Close();
        ASSERT_EQ(::pipe(ends_), 0);
        ASSERT_EQ(::write(ends_[1], lines.data(), lines.size()), static_cast<ssize_t>(lines.size()));
        settings.input = ends_[0];
    }
    bool Run(runtime::ManagerSocket* const socket = nullptr)
    {
        network_plan::LoadedNetwork net(runtime::ReadNetworkFile(File("net.yaml", network), 0U));
        std::ostringstream out;
        runtime::NodeReport report(out, runtime::ReportForm::kText, host::LiveNow());
        runtime::ManagerLoop loop(net, std::make_unique<ScriptBus>(script), report, socket, settings);
        const bool has_started = loop.Run();
        is_log_whole = loop.IsLogWhole();
        table = runtime::StatusTable(loop.Station(), loop.NowUs());
        EXPECT_TRUE(report.Finish());
        shown = out.str();
        return has_started;
    }
    /// The events of this kind in the log.
    [[nodiscard]] std::vector<nlohmann::json> Told(const std::string& event) const
    {
        std::istringstream log(cia306::ReadTextFile(Path("log.jsonl")));
        std::vector<nlohmann::json> told;
        for (std::string line; std::getline(log, line);)
        {
            told.push_back(nlohmann::json::parse(line));
        }
        told.erase(std::remove_if(told.begin(), told.end(), [&](const auto& each) { return each["event"] != event; }),
                   told.end());
        return told;
    }
    [[nodiscard]] std::string Reason() const
    {
        const std::vector<nlohmann::json> told = Told("stopped");
        return (told.size() == 1U) ? told[0]["reason"].get<std::string>() : "";
    }
    /// Nothing is read for `pause_ns`, from the first turn on; then heartbeats each 5 ms of that time wait, the last
    /// one at its end.
    void Pause(const std::uint64_t pause_ns, const std::vector<host::LiveFrame>& more = {})
    {
        const std::uint64_t begin_ns = host::LiveNow();
        std::vector<host::LiveFrame> waiting;
        for (std::uint64_t at_ns = 5U * kMs; at_ns <= pause_ns; at_ns += 5U * kMs)
        {
            waiting.push_back(Heartbeat(begin_ns + at_ns));
        }
        waiting.insert(waiting.end(), more.begin(), more.end());
        script.receive = [begin_ns, pause_ns, waiting, next = std::size_t{0U}](host::LiveFrame& frame) mutable
        {
            const std::uint64_t now_ns = host::LiveNow();
            const std::uint64_t end_ns = begin_ns + pause_ns;
            std::this_thread::sleep_for(std::chrono::nanoseconds((now_ns < end_ns) ? end_ns - now_ns : 0U));
            const bool is_one = next < waiting.size();
            frame = is_one ? waiting[next] : frame;
            next += is_one ? 1U : 0U;
            return is_one;
        };
        settings.for_ns = pause_ns + 15U * kMs;
    }

    void EndInput()
    {
        static_cast<void>(::close(ends_[1]));
        ends_[1] = -1;
    }

    /// Command and node of each NMT command that the bus took.
    [[nodiscard]] std::vector<std::string> Commands() const
    {
        std::vector<std::string> commands;
        for (const host::LiveFrame& frame : script.sent)
        {
            if (frame.identifier == 0U)
            {
                commands.push_back(std::to_string(frame.data[0]) + " " + std::to_string(frame.data[1]));
            }
        }
        return commands;
    }

    Script script;
    runtime::ManagerLoopSettings settings;
    std::string network{
        "manager: {node: 127}\nslaves: [{node: 5, heartbeat: 5 ms, consumer: 20 ms, arming: immediately}]\n"};
    std::string shown;
    std::string table; ///< As it is at the end.
    bool is_log_whole{false};

  private:
    void Close()
    {
        for (int& end : ends_)
        {
            static_cast<void>((end < 0) ? 0 : ::close(end));
            end = -1;
        }
    }

    int ends_[2]{-1, -1};
};
} // namespace counterpoint::tools::test

#endif // TESTS_RUNTIME_MANAGER_RUN_RIG_HPP
