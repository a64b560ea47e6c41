// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_MANAGER_LOOP_HPP
#define RUNTIME_MANAGER_LOOP_HPP

#include "hal/host/live/bus.hpp"
#include "runtime/console/node_report.hpp"
#include "runtime/console/told_count.hpp"
#include "runtime/manager/frame_backlog.hpp"
#include "runtime/manager/socket.hpp"
#include "runtime/manager/station.hpp"

#include <cstdint>
#include <deque>
#include <fstream>
#include <memory>
#include <string>

namespace counterpoint::runtime
{
/// Longest pause of the program after which waiting frames are still used: the system tells times of reception for the
/// last ten seconds.
constexpr std::uint64_t kLongestPauseNs = 9000000000U;

/// So long, at most, commands that wait for the inhibit time hold up the end of a run; then they go at once. Less than
/// any system waits between SIGTERM and SIGKILL.
constexpr std::uint64_t kLongestEndNs = 2000000000U;

/// What the command line says about a run.
struct ManagerLoopSettings
{
    std::string log;          ///< Event log; empty: none.
    std::uint64_t for_ns{0U}; ///< 0: until it is told to stop.
    int input{-1};            ///< Descriptor of typed orders; -1: none.
    bool is_json{false};
    bool is_screen{false}; ///< The table is redrawn on a terminal.
    std::uint64_t longest_pause_ns{kLongestPauseNs};
};

/// Runs a live manager: frames, a cycle each millisecond, and orders, until it is told to stop. A lost connection is
/// opened again by its bus; a second one would hear this manager as another device. [SRS_MGR_005,
/// SRS_MGR_006, SRS_MGR_007, SRS_MGR_120, SRS_MGR_124, SRS_MGR_125, SRS_MGR_126, SRS_MGR_128, SRS_MGR_129,
/// SRS_MGR_580, SRS_MGR_581]
class ManagerLoop
{
  public:
    /// @brief All arguments but the bus outlive it; `socket` may be null. Throws cia306::InputError.
    ManagerLoop(network_plan::LoadedNetwork& net, std::unique_ptr<host::LiveBus> bus, NodeReport& report,
                ManagerSocket* socket, ManagerLoopSettings settings);

    /// @brief Runs until `quit`, SIGTERM, SIGINT or the end of its time, and until the commands that wait then have
    /// left. True: every mandatory slave was good then. [SRS_MGR_520, SRS_MGR_521]
    [[nodiscard]] bool Run();
    /// @brief Whether every event is in the log; true without a log.
    [[nodiscard]] bool IsLogWhole() const noexcept
    {
        return is_log_whole_;
    }
    /// @brief The manager with what watches it.
    [[nodiscard]] const ManagerStation& Station() const noexcept
    {
        return station_;
    }
    /// @brief Time of the host since the manager was made.
    [[nodiscard]] std::uint64_t NowUs() const;

  private:
    void Turn();
    [[nodiscard]] bool HasEnded();
    void TellUnsent();
    [[nodiscard]] bool SendFrame(const CanFrame& frame);
    void OnEvent(const ManagerEvent& event);
    void Wait();
    void Receive();
    [[nodiscard]] bool IsTimeless(const host::LiveFrame& frame);
    void TakeFrame(const host::LiveFrame& frame);
    [[nodiscard]] std::uint64_t StationUs();
    void WatchBus();
    void WatchLosses(const host::BusHealth& health);
    void EnterBus(host::BusState state);
    void ReadTyped();
    void Reply(const std::string& line);
    void Show(const std::string& answer);
    void FlushLog();
    void Draw();
    [[nodiscard]] std::string Answer(const std::string& line);
    [[nodiscard]] std::string AnswerCut(const std::string& line);
    [[nodiscard]] std::string Formed(const std::string& answer) const;

    std::unique_ptr<host::LiveBus> bus_;
    std::string address_;
    NodeReport& report_;
    ManagerSocket* socket_;
    ManagerLoopSettings settings_;
    std::ofstream log_;
    std::uint64_t start_ns_{0U};
    std::uint64_t next_cycle_ns_{0U};
    std::uint64_t next_look_ns_{0U};
    std::uint64_t last_turn_ns_{0U};
    FrameBacklog backlog_{0U};
    std::uint64_t station_us_{0U}; ///< How far the manager's time has come.
    bool is_behind_{false};        ///< More frames wait: time is that of the last one.
    bool has_typed_{false};
    host::BusState bus_state_{host::BusState::kActive};
    std::uint32_t absences_{0U};
    std::uint32_t lost_{0U};
    ToldCount malformed_{};
    std::deque<std::string> recent_; ///< Lines under the table.
    std::string typed_;
    std::string answer_;      ///< To what was typed last, on a terminal.
    bool is_too_long_{false}; ///< What is typed until the next line end is the rest of a line that was refused.
    bool is_log_whole_{true};
    std::string reason_;       ///< Why it ends; empty: it does not.
    std::uint64_t end_ns_{0U}; ///< When commands that wait are sent at once; 0: it does not end yet.
    ManagerStation station_;
};
} // namespace counterpoint::runtime

#endif // RUNTIME_MANAGER_LOOP_HPP
