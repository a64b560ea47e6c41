// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/loop.hpp"

#include "canopen/cia306/text/input_error.hpp"
#include "canopen/device/safety_queue.hpp"
#include "runtime/device/names.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <poll.h>
#include <sched.h>
#include <unistd.h>

namespace counterpoint::runtime
{
namespace
{
constexpr std::uint64_t kNsPerUs = 1000U;
constexpr std::uint64_t kNsPerSecond = 1000000000U;
constexpr std::uint64_t kWatchNs = 50000000U;
constexpr std::uint64_t kSaveStepNs = 1000000U;
constexpr std::uint64_t kQuestionNs = host::kQuestionMs * 1000000U;
constexpr int kPriority = 20;
constexpr std::size_t kLongestOrder = 1024U;

volatile std::sig_atomic_t caught_signal = 0;

void Catch(const int number)
{
    caught_signal = number;
}

/// Signals come only while the loop waits, so that none is lost between looking and waiting.
void CatchSignals()
{
    caught_signal = 0;
    struct sigaction action{};
    action.sa_handler = &Catch;
    sigset_t blocked{};
    sigemptyset(&blocked);
    for (const int number : {SIGTERM, SIGINT, SIGHUP})
    {
        struct sigaction before{};
        static_cast<void>(::sigaction(number, &action, &before));
        sigaddset(&blocked, number);
        if (number == SIGHUP && before.sa_handler == SIG_IGN)
        {
            static_cast<void>(::sigaction(number, &before, nullptr)); // As nohup wants it.
        }
    }
    static_cast<void>(::sigprocmask(SIG_BLOCK, &blocked, nullptr));
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGTTIN, SIG_IGN);
}

/// The device with the node-ID that LSS has saved, if it has: another one would be told of and never be there.
/// [SRS_NODE_161]
std::unique_ptr<NodeDevice> FirstDevice(const NodeLoopParts& parts)
{
    std::unique_ptr<NodeDevice> device = parts.make(std::nullopt);
    const std::uint8_t saved = device->Assembly().NodeId(); // 0: none.
    if (saved != 0U && saved != device->Config().node_id)
    {
        device.reset(); // Its store is closed before another one opens the file.
        device = parts.make(saved);
    }
    return device;
}
} // namespace

NodeLoop::NodeLoop(const NodeLoopParts& parts)
    : parts_(parts), device_(FirstDevice(parts)), clocks_(device_->Config().cycle_tolerance_us),
      orders_(parts.ports, parts.report), script_(parts.script), cycle_ns_(device_->Config().cycle_us * kNsPerUs),
      is_input_open_(parts.input >= 0)
{
}

ExitStatus NodeLoop::Run()
{
    CatchSignals();
    sched_param priority{};
    priority.sched_priority = kPriority;
    const bool is_preferred = ::sched_setscheduler(0, SCHED_FIFO, &priority) == 0;
    now_ = clocks_.Now();
    now_ns_ = clocks_.NowNs();
    start_ns_ = now_ns_;
    device_->TellStart(BusNames(), now_ns_);
    if (!is_preferred)
    {
        Tell(std::string("warning: no real-time priority (") + std::strerror(errno) + "): cycles may come too late",
             "warning", {{"text", "no real-time priority"}});
    }
    TellConnection();
    if (!device_->PowerOn(now_, now_ns_) && !device_->Assembly().NewNodeId())
    {
        return ExitStatus::kDoesNotHold;
    }
    next_cycle_ns_ = now_ns_ + cycle_ns_;
    while (reason_.empty())
    {
        Step();
        Wait();
    }
    return End();
}

void NodeLoop::Step()
{
    now_ = clocks_.Now();
    now_ns_ = clocks_.NowNs();
    device_->LookAtOutput(now_ns_); // After a pause: what has closed in it did so at its time, not in this cycle.
    Receive();
    if (now_ns_ >= next_cycle_ns_)
    {
        RunCycle();
    }
    else
    {
        device_->Serve(now_, now_ns_);
    }
    if (const std::optional<std::uint8_t> node_id = device_->Assembly().NewNodeId())
    {
        Replace(*node_id);
    }
    static_cast<void>(clocks_.Now());
    if (device_->TakeRestart(clocks_.NowNs()))
    {
        next_cycle_ns_ = clocks_.NowNs() + cycle_ns_;
    }
    device_->LookAtOutput(clocks_.NowNs());
    WatchBus();
    FollowScript();
    orders_.GoOn(*device_, {now_, now_ns_});
    if (caught_signal != 0)
    {
        reason_ = (caught_signal == SIGINT) ? "SIGINT" : "SIGTERM";
        reason_ = (caught_signal == SIGHUP) ? "SIGHUP" : reason_;
    }
}

// After a late one the cycles keep their distance: a watchdog that is answered too early trips, too.
void NodeLoop::RunCycle()
{
    const std::uint64_t late_ns = now_ns_ - next_cycle_ns_;
    latest_cycle_ns_ = std::max(latest_cycle_ns_, late_ns);
    device_->Cycle(clocks_.Seal(), now_ns_);
    next_cycle_ns_ += (late_ns > cycle_ns_ / 4U) ? late_ns + cycle_ns_ : cycle_ns_;
}

std::string NodeLoop::BusNames() const
{
    host::LiveBus* const inverse = parts_.ports.Inverse();
    return parts_.ports.Services().Name() + (inverse == nullptr ? "" : " and " + inverse->Name());
}

void NodeLoop::Carry(const NodeOrder& order)
{
    if (!orders_.Carry(order, *device_, {now_, now_ns_}))
    {
        reason_ = "quit";
    }
}

void NodeLoop::Wait()
{
    static_cast<void>(clocks_.Now());
    const std::uint64_t now_ns = clocks_.NowNs();
    const std::uint64_t cycle_ns = (next_cycle_ns_ > now_ns) ? next_cycle_ns_ - now_ns : 0U;
    const std::uint64_t step_ns = has_connection_ ? std::min(cycle_ns, kQuestionNs) : cycle_ns;
    const std::uint64_t wait_ns = device_->IsSaving() ? std::min(step_ns, kSaveStepNs) : step_ns;
    const timespec time{static_cast<time_t>(wait_ns / kNsPerSecond), static_cast<long>(wait_ns % kNsPerSecond)};
    host::LiveBus* const inverse = parts_.ports.Inverse();
    std::array<pollfd, 4U> places{{{parts_.ports.Safety().Descriptor(), POLLIN, 0},
                                   {parts_.ports.Services().Descriptor(), POLLIN, 0},
                                   {is_input_open_ ? parts_.input : -1, POLLIN, 0},
                                   {inverse == nullptr ? -1 : inverse->Descriptor(), POLLIN, 0}}};
    sigset_t none{};
    sigemptyset(&none);
    const int ready = ::ppoll(places.data(), places.size(), &time, &none);
    if (ready > 0 && places[2U].revents != 0)
    {
        ReadOrders();
    }
}

void NodeLoop::Receive()
{
    // The inverse frames first: whose normal frame was before is then there, too, even if both have one stamp.
    if (host::LiveBus* const inverse = parts_.ports.Inverse())
    {
        Hold(*inverse, second_held_);
    }
    Hold(parts_.ports.Safety(), first_held_);
    while (TakeOldest())
    {
    }
    ReceiveServices();
}

void NodeLoop::Hold(host::LiveBus& bus, HeldFrames& held)
{
    host::LiveFrame frame;
    while (bus.Receive(frame))
    {
        if (!frame.error && device::IsSafetyIdentifier(frame.identifier))
        {
            held.push_back(frame);
        }
    }
}

/// Each controller's frames are in order; between the two their stamps decide. False: none is due.
bool NodeLoop::TakeOldest()
{
    const bool is_second =
        !second_held_.empty() && (first_held_.empty() || second_held_.front().time_ns < first_held_.front().time_ns);
    HeldFrames& held = is_second ? second_held_ : first_held_;
    const bool is_due = !held.empty() && held.front().time_ns <= now_ns_;
    if (is_due)
    {
        device_->OnFrame(held.front(), is_second ? CanPortId::kSecond : CanPortId::kFirst,
                         clocks_.Stamp(held.front().time_ns));
        held.pop_front();
    }
    return is_due;
}

void NodeLoop::ReceiveServices()
{
    host::LiveFrame frame;
    while (parts_.ports.Services().Receive(frame))
    {
        if (!frame.error && !device::IsSafetyIdentifier(frame.identifier))
        {
            device_->OnFrame(frame, CanPortId::kFirst, now_); // Services need no stamps.
        }
    }
}

/// The device with another node-ID in the place of this one.
void NodeLoop::Replace(const std::uint8_t node_id)
{
    Tell("LSS gave node-ID " + std::to_string(node_id) + ": the device starts anew", "lss", {{"node_id", node_id}});
    device_.reset(); // Its store is closed before another one opens the file.
    device_ = parts_.make(node_id);
    first_held_.clear();
    second_held_.clear();
    device_->TellStart(BusNames(), now_ns_);
    static_cast<void>(clocks_.Now());
    if (!device_->PowerOn(clocks_.Seal(), clocks_.NowNs()))
    {
        reason_ = "a kernel that refuses the device";
    }
}

void NodeLoop::TellConnection()
{
    const std::string names = BusNames();
    has_connection_ = names.find("socketcand:") != std::string::npos;
    if (has_connection_)
    {
        const std::string text = "warning: a connection to a server may hold frames: on " + names +
                                 " no told limit holds. SRDOs that may be older than " + std::to_string(kOldestSrdoMs) +
                                 " ms are left aside";
        Tell(text, "warning", {{"text", text}});
    }
}

/// Each consumer is made safe, whatever comes next on the connection. Told at once, then once a second.
void NodeLoop::WatchAge()
{
    if (stale_.Learn(parts_.ports.StaleFrames()))
    {
        device_->Assembly().Device().OnLoss();
    }
    if (const std::uint32_t count = stale_.Due(now_ns_))
    {
        Tell(std::to_string(count) +
                 " SRDO frames left aside: the connection to the server may have held them for more "
                 "than " +
                 std::to_string(kOldestSrdoMs) + " ms",
             "stale_frames", {{"count", count}});
    }
}

void NodeLoop::WatchBus()
{
    if (now_ns_ - watched_ns_ < kWatchNs)
    {
        return;
    }
    watched_ns_ = now_ns_;
    WatchAge();
    const std::uint32_t lost = parts_.ports.LostFrames();
    if (lost != lost_)
    {
        Tell(std::to_string(lost - lost_) + " frames lost between bus and node", "lost_frames",
             {{"count", lost - lost_}});
        lost_ = lost;
        device_->Assembly().Device().OnLoss();
    }
    WatchMalformed();
    WatchState();
}

/// An absence that is over already is one all the same. [SRS_NODE_580]
void NodeLoop::WatchState()
{
    const host::BusState absence = parts_.ports.TakeAbsence();
    const host::BusState state = parts_.ports.State();
    if (absence != host::BusState::kInvalid && !host::IsAway(bus_) && !host::IsAway(state))
    {
        EnterBus(absence);
    }
    if (state != bus_ && state != host::BusState::kInvalid)
    {
        EnterBus(state);
    }
}

void NodeLoop::EnterBus(const host::BusState state)
{
    const std::string word = NameOf(kBusWords, state);
    bus_ = state;
    Tell("bus " + word, "bus", {{"state", word}});
    device::BusCondition condition = device::BusCondition::kActive;
    condition = (state == host::BusState::kPassive) ? device::BusCondition::kPassive : condition;
    device_->Assembly().Device().OnBus(host::IsAway(state) ? device::BusCondition::kOff : condition);
}

/// A frame that was among them is missed by the kernel itself. [SRS_NODE_581]
void NodeLoop::WatchMalformed()
{
    static_cast<void>(malformed_.Learn(parts_.ports.Malformed()));
    if (const std::uint32_t count = malformed_.Due(now_ns_))
    {
        const std::string problem = parts_.ports.Problem();
        Tell(MalformedText(count, problem), "malformed", {{"count", count}, {"problem", problem}});
    }
}

void NodeLoop::FollowScript()
{
    const std::uint64_t since_ns = now_ns_ - start_ns_;
    for (ScriptStep& step : script_.steps)
    {
        if (step.order.kind != OrderKind::kNothing && since_ns >= step.at_ns)
        {
            Carry(step.order);
            step.at_ns += step.every_ns;
            step.order.kind = (step.every_ns == 0U) ? OrderKind::kNothing : step.order.kind;
        }
    }
}

void NodeLoop::ReadOrders()
{
    std::array<char, 4096U> bytes{};
    const ssize_t count = ::read(parts_.input, bytes.data(), bytes.size());
    is_input_open_ = count > 0;
    typed_.append(bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    for (std::size_t end = typed_.find('\n'); end != std::string::npos; end = typed_.find('\n'))
    {
        const std::string line = typed_.substr(0U, end);
        typed_.erase(0U, end + 1U);
        TakeOrder(line);
        is_too_long_ = false;
    }
    if (typed_.size() > kLongestOrder)
    {
        TakeOrder(typed_);
        typed_.clear();
        is_too_long_ = true;
    }
    if (!is_input_open_ && !typed_.empty() && !is_too_long_)
    {
        TellProblem("an order " + cia306::Quoted(typed_) +
                    " without an end of its line, expected whole lines; no more are read");
    }
}

/// The rest of one that is too long is a part of it. [SRS_NODE_331, SRS_NODE_500]
void NodeLoop::TakeOrder(const std::string& line)
{
    if (!reason_.empty())
    {
        TellProblem("an order " + cia306::Quoted(line.substr(0U, kLongestOrder)) +
                    " behind the end of the node, expected none there; it is not carried out");
    }
    else if (line.size() <= kLongestOrder && !is_too_long_)
    {
        Carry(ParseOrder(line));
    }
    else if (!is_too_long_)
    {
        TellProblem("an order of more than " + std::to_string(kLongestOrder) +
                    " characters, expected at most so many in one line; it is left out");
    }
    else
    {
        // It was told with its beginning.
    }
}

void NodeLoop::TellProblem(const std::string& text)
{
    Tell(text, "problem", {{"text", text}});
}

void NodeLoop::Tell(const std::string& text, const std::string& event, const nlohmann::ordered_json& details)
{
    parts_.report.Tell(now_ns_, text, event, details);
}

ExitStatus NodeLoop::End()
{
    const bool is_safe = device_->Assembly().Core().DeviceState().fault != DeviceFault::kNone;
    static_cast<void>(clocks_.Now());
    now_ns_ = clocks_.NowNs();
    device_->Stop(now_ns_);
    parts_.report.Print(device_->Outputs().Latency().Text());
    if (parts_.report.Form() == ReportForm::kJson)
    {
        Tell("", "latency", device_->Outputs().Latency().Json());
    }
    const std::uint64_t latest_us = latest_cycle_ns_ / kNsPerUs;
    Tell("greatest delay of a cycle " + std::to_string(latest_us) + " us; frames stamped behind another: " +
             std::to_string(clocks_.LateCount()) + ", by at most " + std::to_string(clocks_.LatestUs()) + " us",
         "delays", {{"cycle_us", latest_us}, {"late_stamps", clocks_.LateCount()}, {"stamp_us", clocks_.LatestUs()}});
    Tell("stopped by " + reason_ + ": outputs closed, production ended" +
             (is_safe ? "; was in the device safe state" : ""),
         "stopped", {{"reason", reason_}, {"device_safe_state", is_safe}});
    return is_safe ? ExitStatus::kDoesNotHold : ExitStatus::kHolds;
}
} // namespace counterpoint::runtime
