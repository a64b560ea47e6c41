// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/manager/loop.hpp"

#include "canopen/cia306/text/input_error.hpp"
#include "runtime/console/json_text.hpp"
#include "runtime/device/names.hpp"
#include "runtime/manager/report/journal.hpp"
#include "runtime/manager/report/status.hpp"
#include "runtime/node/ports.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <poll.h>
#include <unistd.h>
#include <utility>

namespace counterpoint::runtime
{
namespace
{
constexpr std::uint64_t kNsPerUs = 1000U;
constexpr std::uint64_t kCycleNs = 1000000U;
constexpr std::uint64_t kLookNs = 250000000U;
constexpr std::uint64_t kLastTriesNs = 100000000U; ///< For room in the sink, behind kLongestEndNs.
constexpr std::size_t kFramesOfTurn = 256U;
constexpr std::size_t kFramesOfPause = 1000000U; ///< More than any system keeps.
constexpr std::size_t kRecentLines = 12U;

volatile std::sig_atomic_t caught_signal = 0;

void Catch(const int number)
{
    caught_signal = number;
}

/// While it lives, SIGINT, SIGTERM and SIGHUP do not end the process by themselves (SIGHUP only where nohup does not
/// ignore it). SIGPIPE is ignored for good: the reader of the output may end, and the network goes on. One object at a
/// time. [SRS_MGR_120, SRS_MGR_121]
class CaughtSignals
{
  public:
    CaughtSignals()
    {
        caught_signal = 0;
        static_cast<void>(std::signal(SIGPIPE, SIG_IGN));
        before_int_ = std::signal(SIGINT, &Catch);
        before_term_ = std::signal(SIGTERM, &Catch);
        if (before_hup_ != SIG_IGN)
        {
            static_cast<void>(std::signal(SIGHUP, &Catch));
        }
    }
    ~CaughtSignals()
    {
        static_cast<void>(std::signal(SIGINT, before_int_));
        // A second SIGTERM, as timeout sends it, must not cut off what is written last.
        if (caught_signal != SIGTERM)
        {
            static_cast<void>(std::signal(SIGTERM, before_term_));
        }
        static_cast<void>(std::signal(SIGHUP, before_hup_));
    }
    CaughtSignals(const CaughtSignals&) = delete;
    CaughtSignals& operator=(const CaughtSignals&) = delete;

  private:
    using Handler = void (*)(int);
    Handler before_int_{SIG_DFL};
    Handler before_term_{SIG_DFL};
    Handler before_hup_{std::signal(SIGHUP, SIG_IGN)};
};
} // namespace

ManagerLoop::ManagerLoop(network_plan::LoadedNetwork& net, std::unique_ptr<host::LiveBus> bus, NodeReport& report,
                         ManagerSocket* const socket, ManagerLoopSettings settings)
    : bus_(std::move(bus)), address_(bus_->Name()), report_(report), socket_(socket), settings_(std::move(settings)),
      start_ns_(host::LiveNow()), station_(
                                      net, [this](const CanFrame& frame) { return SendFrame(frame); },
                                      [this](const ManagerEvent& event) { OnEvent(event); })
{
    if (!settings_.log.empty())
    {
        log_.open(settings_.log, std::ios::trunc);
        if (!log_)
        {
            throw cia306::InputError(settings_.log, {}, {"it cannot be opened", "a path in a writable folder"});
        }
    }
}

std::uint64_t ManagerLoop::NowUs() const
{
    return (host::LiveNow() - start_ns_) / kNsPerUs;
}

/// The manager's time never goes back, and never ahead of frames that wait to be read: after a pause of this process
/// they are as far apart as they were on the bus. [SRS_MGR_127]
std::uint64_t ManagerLoop::StationUs()
{
    station_us_ = is_behind_ ? station_us_ : std::max(station_us_, NowUs());
    return station_us_;
}

bool ManagerLoop::SendFrame(const CanFrame& frame)
{
    return bus_->Send(host::FromCanFrame(frame)) == host::SendResult::kSent;
}

void ManagerLoop::OnEvent(const ManagerEvent& event)
{
    if (log_.is_open())
    {
        log_ << JsonLine(event) << "\n";
    }
    const bool is_end = event.kind == "stopped";
    const auto print = [this, is_end](const std::string& line)
    { is_end ? report_.PrintLast(line) : report_.Print(line); };
    if (settings_.is_json)
    {
        print(JsonLine(event) + "\n");
    }
    else if (!event.text.empty())
    {
        recent_.push_back(TextLine(event));
        while (recent_.size() > kRecentLines)
        {
            recent_.pop_front();
        }
        if (!settings_.is_screen)
        {
            print(TextLine(event) + "\n");
        }
    }
}

bool ManagerLoop::Run()
{
    const CaughtSignals signals;
    start_ns_ = host::LiveNow();
    last_turn_ns_ = start_ns_;
    backlog_ = FrameBacklog(start_ns_);
    next_cycle_ns_ = start_ns_ + kCycleNs;
    station_.Begin(0U);
    while (reason_.empty() || !HasEnded())
    {
        Turn();
    }
    const bool has_started = station_.Assembly().HasStarted();
    TellUnsent();
    station_.Tell("stopped", "stopped by " + reason_, {{"reason", reason_}, {"started", has_started}}, StationUs());
    Draw();
    FlushLog();
    if (settings_.is_screen)
    {
        report_.PrintLast("\n");
    }
    return has_started;
}

void ManagerLoop::Turn()
{
    Wait();
    Receive();
    if (has_typed_)
    {
        ReadTyped();
    }
    const std::uint64_t now_ns = host::LiveNow();
    if (now_ns >= next_cycle_ns_)
    {
        station_.OnCycle(StationUs());
        next_cycle_ns_ = now_ns + kCycleNs;
    }
    if (socket_ != nullptr)
    {
        socket_->Serve([this](const std::string& line) { return Answer(line); },
                       [this](const std::string& line) { return AnswerCut(line); });
    }
    if (now_ns >= next_look_ns_)
    {
        next_look_ns_ = now_ns + kLookNs;
        WatchBus();
        Draw();
        FlushLog();
    }
    const bool is_time_over = settings_.for_ns != 0U && now_ns - start_ns_ >= settings_.for_ns;
    const bool is_ending = !reason_.empty(); // What ends it first is told.
    reason_ = (!is_ending && is_time_over) ? "--for" : reason_;
    reason_ = (!is_ending && caught_signal != 0) ? "signal" : reason_;
}

/// A stop that was taken and waits for the inhibit time must not stay here: with N slaves N times that time. The
/// manager works on meanwhile, as always, but for orders. Where that takes longer than an end may take, what waits
/// goes at once: a slave may lose a command that comes too soon, and would never get one that stays here. Without a bus
/// there is nothing to wait for. [SRS_MGR_520]
bool ManagerLoop::HasEnded()
{
    const std::uint64_t now_ns = host::LiveNow();
    end_ns_ = (end_ns_ == 0U) ? now_ns + kLongestEndNs : end_ns_;
    if (now_ns >= end_ns_)
    {
        station_.Finish(StationUs());
    }
    const host::BusHealth health = bus_->Health();
    const bool is_waiting = station_.Assembly().Core().Role().Commands().Waiting() > 0U || health.waiting > 0U;
    return !is_waiting || host::IsAway(health.state) || now_ns >= end_ns_ + kLastTriesNs;
}

/// What has not left is lost: who ordered it has to know. [SRS_MGR_520]
void ManagerLoop::TellUnsent()
{
    const std::vector<std::string> commands = station_.Unsent();
    const std::uint32_t frames = bus_->Health().waiting;
    if (commands.empty() && frames == 0U)
    {
        return;
    }
    std::string text;
    for (const std::string& command : commands)
    {
        text += (text.empty() ? ": " : ", ") + command;
    }
    const std::string waiting = (frames == 0U) ? "" : "; " + std::to_string(frames) + " frames wait in this host";
    station_.Tell("unsent", std::to_string(commands.size()) + " NMT commands have not left" + text + waiting,
                  {{"count", commands.size()}, {"commands", commands}, {"frames", frames}}, StationUs());
}

void ManagerLoop::Wait()
{
    std::vector<pollfd> places{{bus_->Descriptor(), POLLIN, 0}, {settings_.input, POLLIN, 0}};
    if (socket_ != nullptr)
    {
        socket_->AddTo(places);
    }
    const std::uint64_t now_ns = host::LiveNow();
    const std::uint64_t wait_ns = (next_cycle_ns_ > now_ns) ? next_cycle_ns_ - now_ns : 0U;
    const timespec time{0, static_cast<long>(wait_ns)};
    const int ready = ::ppoll(places.data(), places.size(), &time, nullptr);
    has_typed_ = ready > 0 && places[1].revents != 0;
}

/// Boot-up messages and emergencies mean the same whenever they came: none of them is told a second time. [SRS_MGR_128]
bool ManagerLoop::IsTimeless(const host::LiveFrame& frame)
{
    const bool is_foreign = !frame.own && !frame.error && !frame.fd;
    const cia302::NodeWatch& watch = station_.Assembly().Core().Watched();
    return IsBootUp(frame) ||
           (is_foreign && watch.EmergencySender(host::ToCanFrame(frame, CanPortId::kFirst)).value != 0U);
}

void ManagerLoop::Receive()
{
    // Of a bus that never falls silent some at a time: cycles and orders come in between.
    host::LiveFrame frame;
    std::vector<host::LiveFrame> frames;
    std::size_t old = 0U;
    while (frames.size() < kFramesOfTurn && old < kFramesOfPause && bus_->Receive(frame))
    {
        const bool is_old = host::LiveNow() - last_turn_ns_ > settings_.longest_pause_ns;
        old += is_old ? 1U : 0U;
        if (!is_old || IsTimeless(frame))
        {
            frames.push_back(frame);
        }
    }
    last_turn_ns_ = host::LiveNow();
    is_behind_ = frames.size() == kFramesOfTurn;
    const bool is_connection = address_.rfind("socketcand:", 0U) == 0U; // It tells no times of reception.
    if (is_connection && backlog_.Has(frames, last_turn_ns_))
    {
        old += frames.size();
        frames.erase(std::remove_if(frames.begin(), frames.end(),
                                    [this](const host::LiveFrame& each) { return !IsTimeless(each); }),
                     frames.end());
    }
    if (old > 0U)
    {
        // Before what is left: a boot-up message whose reset was left aside is not the second one of the reset before.
        const std::string text =
            "frames left aside but for boot-up messages and emergencies: when they came cannot be known";
        station_.Tell("lost_frames", std::to_string(old) + " " + text, {{"count", old}}, StationUs());
        station_.Assembly().Core().OnLost(InstantAt(StationUs()));
    }
    for (const host::LiveFrame& taken : frames)
    {
        TakeFrame(taken);
    }
}

/// [SRS_MGR_543]
void ManagerLoop::TakeFrame(const host::LiveFrame& frame)
{
    if (frame.error || frame.fd)
    {
        return;
    }
    const std::uint64_t stamp_us = (frame.time_ns > start_ns_) ? (frame.time_ns - start_ns_) / kNsPerUs : 0U;
    station_us_ = std::max(station_us_, std::min(stamp_us, NowUs()));
    if (frame.own)
    {
        station_.Assembly().OnSent(host::ToCanFrame(frame, CanPortId::kFirst));
    }
    else
    {
        station_.OnFrame(host::ToCanFrame(frame, CanPortId::kFirst), station_us_);
    }
}

/// An absence that is over already is one all the same: what was on the bus meanwhile nobody heard. [SRS_MGR_580]
void ManagerLoop::WatchBus()
{
    const host::BusHealth health = bus_->Health();
    const bool was_away = health.absences != absences_ && !host::IsAway(bus_state_);
    absences_ = health.absences;
    if (was_away && !host::IsAway(health.state))
    {
        EnterBus(health.absence);
    }
    if (health.state != bus_state_)
    {
        EnterBus(health.state);
    }
    WatchLosses(health);
}

void ManagerLoop::EnterBus(const host::BusState state)
{
    bus_state_ = state;
    const char* const word = NameOf(kBusWords, bus_state_, "down");
    station_.Tell("bus", std::string("bus ") + word, {{"state", word}}, StationUs());
    cia302::ControllerState controller = cia302::ControllerState::kRunning;
    controller = (bus_state_ == host::BusState::kBusOff) ? cia302::ControllerState::kBusOff : controller;
    controller = (bus_state_ == host::BusState::kDown) ? cia302::ControllerState::kAbsent : controller;
    station_.Assembly().OnController(controller, InstantAt(StationUs()));
}

/// What could not be read may have been a frame, as what the system has dropped. [SRS_MGR_541, SRS_MGR_581]
void ManagerLoop::WatchLosses(const host::BusHealth& health)
{
    const bool has_lost = health.lost_frames > lost_;
    if (has_lost)
    {
        const std::uint32_t count = health.lost_frames - lost_;
        station_.Tell("lost_frames", std::to_string(count) + " frames lost between bus and manager", {{"count", count}},
                      StationUs());
        lost_ = health.lost_frames;
    }
    if (malformed_.Learn(health.malformed) || has_lost)
    {
        station_.Assembly().Core().OnLost(InstantAt(StationUs()));
    }
    if (const std::uint32_t count = malformed_.Due(host::LiveNow()))
    {
        const std::string problem = bus_->Problem();
        station_.Tell("malformed", MalformedText(count, problem), {{"count", count}, {"problem", problem}},
                      StationUs());
    }
}

/// [SRS_MGR_542]
void ManagerLoop::ReadTyped()
{
    std::array<char, 4096U> bytes{};
    const ssize_t count = ::read(settings_.input, bytes.data(), bytes.size());
    settings_.input = (count > 0) ? settings_.input : -1;
    typed_.append(bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    for (std::size_t end = typed_.find('\n'); end != std::string::npos; end = typed_.find('\n'))
    {
        const std::string line = typed_.substr(0U, end);
        typed_.erase(0U, end + 1U);
        if (!is_too_long_)
        {
            Reply(line);
        }
        is_too_long_ = false;
    }
    if (typed_.size() > kLongestManagerOrder)
    {
        if (!is_too_long_)
        {
            Reply(typed_); // The rest of it is left aside.
        }
        typed_.clear();
        is_too_long_ = true;
    }
    if (settings_.input < 0 && !typed_.empty() && !is_too_long_)
    {
        const std::string answer = AnswerCut(typed_);
        typed_.clear();
        Show(answer);
    }
}

void ManagerLoop::Reply(const std::string& line)
{
    const bool is_table = settings_.is_screen && ParseManagerOrder(line).kind == ManagerOrderKind::kStatus;
    const std::string answer = Answer(line);
    Show(is_table ? "" : answer); // The table is there.
}

/// On a terminal an answer stays until the next one: the screen is drawn anew too often to read it otherwise.
void ManagerLoop::Show(const std::string& answer)
{
    answer_ = answer;
    if (settings_.is_screen)
    {
        Draw();
    }
    else
    {
        report_.Print(answer);
    }
}

/// The network is worth more than its log: it is managed on, and the end says what is missing.
void ManagerLoop::FlushLog()
{
    log_.flush();
    if (!log_ && is_log_whole_)
    {
        is_log_whole_ = false;
        station_.Tell("log_ended", "the event log cannot be written any more", {}, StationUs());
    }
}

void ManagerLoop::Draw()
{
    if (settings_.is_screen)
    {
        std::string screen = "\x1b[H\x1b[2J" + StatusTable(station_, StationUs()) + "\n";
        for (const std::string& line : recent_)
        {
            screen += line + "\n";
        }
        screen += answer_.empty() ? "" : "\n" + answer_;
        report_.PrintScreen(screen + "\norder (help): " + typed_);
    }
}

std::string ManagerLoop::Answer(const std::string& line)
{
    const ManagerOrder order = ParseManagerOrder(line);
    std::string answer;
    if (!reason_.empty() && order.kind != ManagerOrderKind::kNothing)
    {
        // Who reads the log finds the quit before it. [SRS_MGR_521]
        const std::string result = "not carried out: the manager ends";
        station_.Tell("order", "order " + line + ": " + result, {{"order", line}, {"answer", result}}, StationUs());
        answer = result + "\n";
    }
    else if (order.kind == ManagerOrderKind::kStatus)
    {
        answer = settings_.is_json ? OneLine(StatusJson(station_, StationUs())) : StatusTable(station_, StationUs());
    }
    else if (order.kind == ManagerOrderKind::kHelp)
    {
        answer = ManagerOrderHelp();
    }
    else if (order.kind == ManagerOrderKind::kQuit)
    {
        reason_ = "quit";
        answer = "taken\n";
    }
    else if (order.kind == ManagerOrderKind::kProblem)
    {
        answer = order.problem + "\n";
    }
    else if (order.kind != ManagerOrderKind::kNothing)
    {
        const std::string result = station_.Carry(order, StationUs());
        station_.Tell("order", "order " + line + ": " + result, {{"order", line}, {"answer", result}}, StationUs());
        answer = result + "\n";
    }
    return Formed(answer);
}

/// It may be the beginning of another one: stop 1 of stop 10. [SRS_MGR_471]
std::string ManagerLoop::AnswerCut(const std::string& line)
{
    const std::string result =
        "order " + cia306::Quoted(line) + " without an end of its line, expected whole lines; it is not carried out";
    station_.Tell("order", result, {{"order", line}, {"answer", result}}, StationUs());
    return Formed(result + "\n");
}

std::string ManagerLoop::Formed(const std::string& answer) const
{
    return (settings_.is_json && !answer.empty() && answer[0] != '{')
               ? OneLine(
                     {{"format", kManagerFormat}, {"event", "answer"}, {"text", answer.substr(0U, answer.size() - 1U)}})
               : answer;
}
} // namespace counterpoint::runtime
