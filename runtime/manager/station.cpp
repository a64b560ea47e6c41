// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/manager/station.hpp"

#include "runtime/manager/report/texts.hpp"
#include "runtime/manager/start_answer.hpp"

#include <utility>

namespace counterpoint::runtime
{
ManagerStation::ManagerStation(network_plan::LoadedNetwork& net, SendFrame send, TellEvent tell)
    : send_(std::move(send)), tell_(std::move(tell)), assembly_(net, *this, journal_),
      dictionary_(assembly_, net, *this), pdos_(net)
{
    journal_.Watch(assembly_);
    journal_.WhenRoom([this](const Instant) { dictionary_.OnRoom(); });
}

void ManagerStation::Enter(const std::uint64_t now_us)
{
    now_us_ = now_us;
    journal_.SetNow(now_us);
}

void ManagerStation::Leave()
{
    for (const ManagerEvent& event : journal_.Take())
    {
        FollowWriting(event);
        diagram_.OnEvent(event);
        tell_(event);
    }
}

bool ManagerStation::Send(const CanFrame& frame) noexcept
{
    const bool is_taken = send_(frame);
    if (is_taken)
    {
        diagram_.OnFrame(frame, true, now_us_);
    }
    return is_taken;
}

void ManagerStation::Begin(const std::uint64_t now_us)
{
    Enter(now_us);
    assembly_.Core().Begin(InstantAt(now_us));
    Leave();
}

void ManagerStation::OnFrame(const CanFrame& frame, const std::uint64_t now_us)
{
    Enter(now_us);
    diagram_.OnFrame(frame, false, now_us);
    assembly_.Core().OnFrame(frame, InstantAt(now_us));
    dictionary_.OnFrame(frame, InstantAt(now_us));
    pdos_.OnFrame(frame, now_us);
    KeepSign(cia302::NodeId{static_cast<std::uint8_t>(frame.identifier & cia302::kLastNode)});
    Leave();
}

/// Behind a frame that may have been one.
void ManagerStation::KeepSign(const cia302::NodeId node)
{
    const cia302::NodeRecord& record = assembly_.Core().Table().Record(node);
    if (record.was_seen && record.last_sign.us == InstantAt(now_us_).us)
    {
        last_signs_us_.at(node.value) = now_us_;
    }
}

void ManagerStation::OnCycle(const std::uint64_t now_us)
{
    Enter(now_us);
    DriveWriting(); // Before this cycle tells something: all that was told is followed.
    assembly_.OnCycle(InstantAt(now_us));
    assembly_.Core().OnCycle(InstantAt(now_us));
    dictionary_.OnCycle(InstantAt(now_us));
    TellInputs();
    Leave();
}

std::string ManagerStation::Carry(const ManagerOrder& order, const std::uint64_t now_us)
{
    Enter(now_us);
    const Instant now = InstantAt(now_us);
    std::string answer;
    if (order.kind == ManagerOrderKind::kGet)
    {
        answer = dictionary_.Get(order.object, now);
    }
    else if (order.kind == ManagerOrderKind::kSet)
    {
        const StartOutlook outlook = OutlookOf(order, assembly_); // Before: a start may change what was found.
        answer = AnswerToSet(outlook, assembly_, dictionary_.Set(order.object, order.value, now));
    }
    else if (order.kind == ManagerOrderKind::kOutput)
    {
        answer = pdos_.Set(order.node, order.pdo, order.bytes);
    }
    else
    {
        answer = CarryOut(order, assembly_, now);
    }
    Leave();
    return answer;
}

void ManagerStation::Finish(const std::uint64_t now_us)
{
    Enter(now_us);
    assembly_.Core().Role().Finish(InstantAt(now_us));
    Leave();
}

std::vector<std::string> ManagerStation::Unsent() const
{
    const cia302::NmtMaster& commands = assembly_.Core().Role().Commands();
    std::vector<std::string> unsent;
    for (std::uint16_t place = 0U; place < commands.Waiting(); ++place)
    {
        const cia302::NmtRequest request = commands.WaitingAt(place);
        const bool is_all = request.node.value == cia302::kAllNodes.value;
        if (request.command != cia302::NmtCommand::kInvalid)
        {
            unsent.push_back(WordOf(request.command) +
                             (is_all ? " all" : " node " + std::to_string(request.node.value)));
        }
    }
    return unsent;
}

void ManagerStation::Tell(const std::string& kind, const std::string& text, const nlohmann::ordered_json& details,
                          const std::uint64_t now_us)
{
    Enter(now_us);
    journal_.Tell(0U, kind, text, details);
    Leave();
}

/// A TxPDO brought another value.
void ManagerStation::TellInputs()
{
    for (const PdoValue* const value : pdos_.TakeNews(now_us_))
    {
        const std::string text = NameOf(*value) + ": " + BytesText(value->bytes);
        journal_.Tell(value->node, "pdo", text, {{"pdo", NameOf(*value)}, {"data", BytesText(value->bytes)}});
    }
}

/// By error handling: 1F80h bit 6.
bool ManagerStation::IsAllStopped() const
{
    const bool is_cia302 = assembly_.Net().Plan().manager.profile == network_plan::StartProfile::kCia302;
    return is_cia302 && assembly_.Core().MasterState() == static_cast<std::int16_t>(cia302::MasterStep::kStopped);
}

void ManagerStation::FollowWriting(const ManagerEvent& event)
{
    const network_plan::LoadedSlave* const slave = assembly_.Net().Find(event.node);
    if (slave == nullptr || !slave->plan.writes_safety)
    {
        return;
    }
    Writing& writing = writing_.at(event.node);
    const std::string state = (event.kind == "gate") ? event.word : "";
    const bool is_refused = state == "differs" || state == "failed";
    if (event.kind == "boot_up")
    {
        writing = Writing::kNone;
    }
    else if (writing == Writing::kNone && is_refused)
    {
        writing = Writing::kWanted;
    }
    else if (writing == Writing::kRuns && is_refused)
    {
        writing = Writing::kTried;
    }
    else if (writing == Writing::kRuns && state == "closed")
    {
        // Somebody commanded it meanwhile. Who stopped it does not want it to be started behind the writing; behind a
        // stop of all by error handling nothing is started.
        const cia302::NodeRecord& record = assembly_.Core().Table().Record(cia302::NodeId{event.node});
        const bool is_stop = (record.asked == cia302::SlaveState::kStopped) && !IsAllStopped();
        writing = is_stop ? Writing::kTried : Writing::kWanted;
    }
    else if (writing == Writing::kRuns && state == "open")
    {
        writing = Writing::kTried;
        static_cast<void>(assembly_.Core().Role().Resume(cia302::NodeId{event.node}, InstantAt(now_us_)));
    }
    else
    {
        // Nothing that concerns the writing.
    }
}

/// As soon as the start-up of the slave has come to its end.
void ManagerStation::DriveWriting()
{
    for (std::uint8_t node = 1U; node <= cia302::kLastNode; ++node)
    {
        Writing& writing = writing_.at(node);
        if (writing == Writing::kWanted && assembly_.Core().WriteSafety(cia302::NodeId{node}, InstantAt(now_us_)))
        {
            writing = Writing::kRuns;
            journal_.Tell(node, "write_safety", "writes the safety configuration", {});
        }
    }
}
} // namespace counterpoint::runtime
