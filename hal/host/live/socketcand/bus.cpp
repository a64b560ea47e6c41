// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/live/socketcand/bus.hpp"

#include "hal/host/live/error.hpp"

#include <poll.h>

namespace counterpoint::host
{
namespace
{

constexpr std::uint64_t kMillisecondNs = 1'000'000U;
/// For connecting and greeting together.
constexpr std::uint64_t kPatienceNs = 3'000U * kMillisecondNs;
constexpr std::uint64_t kRetryNs = kMillisecondNs;
/// What may wait as text before frames wait as frames.
constexpr std::size_t kTextBytes = 4096U;
/// Least distance of two questions about the age of frames.
constexpr std::uint64_t kQuestionNs = kQuestionMs * kMillisecondNs;

SocketcandMessage MessageOf(const SocketcandWord word)
{
    SocketcandMessage message;
    message.word = word;
    return message;
}

} // namespace

LiveSocketcandBus::LiveSocketcandBus(const LiveAddress& address, const LiveOptions& options)
    : OpenedBus{address, options, BusState::kActive}, give_up_at_ns_{LiveNow() + kPatienceNs}, peer_{address},
      link_{peer_.Connect(give_up_at_ns_)}, greeting_{address.interface}
{
    Greet();
    poll_.Add(link_.Descriptor());
    Begin();
}

void LiveSocketcandBus::Refuse(const std::string& what) const
{
    throw LiveBusError("bus '" + address_.text + "': " + what);
}

/// By its time alone, whatever the server sends meanwhile. [SRS_LIVE_582]
void LiveSocketcandBus::Greet()
{
    bool has_heard = false;
    while (!greeting_.IsOver())
    {
        if (!greeting_.Problem().empty())
        {
            Refuse(greeting_.Problem());
        }
        if (link_.IsLost())
        {
            Refuse("the server ended the connection, expected its answer");
        }
        if (LiveNow() >= give_up_at_ns_)
        {
            const std::string told =
                has_heard ? ("did not " + greeting_.Awaited() + " within 3 s") : "said nothing for 3 s";
            Refuse("the server " + told + ", expected the socketcand protocol");
        }
        pollfd wait{link_.Descriptor(), POLLIN, 0};
        if (::poll(&wait, 1U, MillisecondsUntil(give_up_at_ns_)) > 0)
        {
            has_heard = true;
        }
        link_.Read();
        greeting_.GoOn(link_);
    }
}

void LiveSocketcandBus::Begin()
{
    is_lost_ = false;
    SetState(BusState::kActive);
    is_asking_ = false;
    asked_ns_ = give_up_at_ns_ - kPatienceNs; // The greeting is the first question.
    answered_ns_ = asked_ns_;
    poll_.WakeAt(greeting_.Early().empty() ? 0U : LiveNow());
}

/// Goes on with opening a lost connection again, by the policy; nothing of it waits. [SRS_LIVE_058]
void LiveSocketcandBus::Reconnect()
{
    const std::uint64_t now_ns = LiveNow();
    const bool is_due = (options_.reconnect_after_ms != 0U) && (!link_.IsLost() || (now_ns >= retry_at_ns_));
    if (!is_due)
    {
        return;
    }
    if (link_.IsLost())
    {
        link_ = SocketcandLink{peer_.BeginConnect()};
        greeting_ = SocketcandGreeting{address_.interface};
        give_up_at_ns_ = now_ns + kPatienceNs;
        poll_.WakeAt(give_up_at_ns_);
        if (!link_.IsLost())
        {
            poll_.Add(link_.Descriptor());
        }
    }
    link_.Read();
    greeting_.GoOn(link_);
    const bool has_failed = link_.IsLost() || !greeting_.Problem().empty() || (now_ns >= give_up_at_ns_);
    if (has_failed)
    {
        link_.Close();
        peer_.TryOther();
        PlanReconnect();
    }
    else if (greeting_.IsOver())
    {
        ++health_.reconnects;
        Begin();
    }
}

void LiveSocketcandBus::PlanReconnect()
{
    retry_at_ns_ = LiveNow() + (options_.reconnect_after_ms * kMillisecondNs);
    poll_.WakeAt((options_.reconnect_after_ms == 0U) ? 0U : retry_at_ns_);
}

SendResult LiveSocketcandBus::Send(const LiveFrame& frame)
{
    if (!IsSendable(frame) || frame.fd)
    {
        return SendResult::kRefused;
    }
    SendWaiting();
    if (is_lost_)
    {
        return SendResult::kDown;
    }
    if (IsFull())
    {
        return SendResult::kQueueFull;
    }
    queue_.push_back(frame);
    SendWaiting();
    return is_lost_ ? SendResult::kDown : SendResult::kSent;
}

void LiveSocketcandBus::Hand(const LiveFrame& frame)
{
    SocketcandMessage message = MessageOf(frame.remote ? SocketcandWord::kSendRemote : SocketcandWord::kSend);
    message.frame = frame;
    link_.Say(message);
    if (!greeting_.HasOwn())
    {
        unconfirmed_.push_back(frame);
        link_.Say(SocketcandWord::kEcho);
    }
}

void LiveSocketcandBus::SendWaiting()
{
    link_.Flush();
    while (!queue_.empty() && (link_.WaitingBytes() < kTextBytes) && !link_.IsLost())
    {
        Hand(queue_.front());
        queue_.pop_front();
    }
    Ask();
    NoteLoss();
    if (is_lost_)
    {
        return; // What wakes then is the policy.
    }
    const bool is_idle = queue_.empty() && (link_.WaitingBytes() == 0U) && greeting_.Early().empty();
    poll_.WakeAt(is_idle ? 0U : LiveNow() + kRetryNs);
}

void LiveSocketcandBus::Ask()
{
    const std::uint64_t now_ns = LiveNow();
    const bool may_ask = (options_.oldest_ms != 0U) && !is_asking_ && !link_.IsLost();
    if (may_ask && (now_ns >= (asked_ns_ + kQuestionNs)))
    {
        is_asking_ = true;
        asked_ns_ = now_ns;
        unconfirmed_.emplace_back(std::nullopt);
        link_.Say(SocketcandWord::kEcho);
    }
}

void LiveSocketcandBus::TakeAnswer()
{
    is_asking_ = false;
    answered_ns_ = asked_ns_;
}

/// Answers do not name their question: on this connection the next one could be that of any. [SRS_LIVE_581]
void LiveSocketcandBus::GiveUpOverdue()
{
    const std::uint64_t patience_ns = options_.answer_ms * kMillisecondNs;
    if (is_asking_ && ((LiveNow() - asked_ns_) >= patience_ns))
    {
        link_.Close();
    }
}

/// The server's answers come in the order of its frames: a frame is no older than the last question with an answer.
bool LiveSocketcandBus::IsStale(const LiveFrame& frame)
{
    const bool is_of_others = !frame.own && !frame.error && (options_.oldest_ms != 0U);
    const bool is_stale = is_of_others && ((frame.time_ns - answered_ns_) > (options_.oldest_ms * kMillisecondNs));
    health_.stale_frames += is_stale ? 1U : 0U;
    return is_stale;
}

void LiveSocketcandBus::NoteLoss()
{
    if (link_.IsLost() && !is_lost_)
    {
        is_lost_ = true;
        SetState(BusState::kDown);
        health_.dropped_frames += static_cast<std::uint32_t>(queue_.size());
        queue_.clear();
        unconfirmed_.clear();
        PlanReconnect();
    }
}

bool LiveSocketcandBus::Receive(LiveFrame& frame)
{
    if (is_lost_)
    {
        Reconnect();
    }
    else
    {
        SendWaiting();
    }
    std::deque<SocketcandMessage>& early = greeting_.Early();
    bool has_read = false;
    while (!is_lost_)
    {
        std::optional<SocketcandMessage> message;
        if (!early.empty())
        {
            message = early.front();
            early.pop_front();
        }
        else
        {
            message = link_.Next();
        }
        if (message && Take(*message, frame) && Passes(options_.filters, frame) && !IsStale(frame))
        {
            return true;
        }
        if (!message && has_read)
        {
            GiveUpOverdue();
            NoteLoss();
            return false;
        }
        if (!message)
        {
            link_.Read();
            has_read = true;
        }
    }
    return false;
}

/// Whether the message gives a frame.
bool LiveSocketcandBus::Take(const SocketcandMessage& message, LiveFrame& frame)
{
    const bool is_answer = message.word == SocketcandWord::kEcho;
    const bool is_echo = is_answer && !unconfirmed_.empty();
    if (is_answer && !is_echo && (options_.oldest_ms != 0U))
    {
        link_.Close(); // The answer to a later question could not be told from it. [SRS_LIVE_581]
        NoteLoss();
        return false;
    }
    const bool is_frame = message.frame.error || (message.word == SocketcandWord::kFrame) ||
                          (message.word == SocketcandWord::kRemote) || (message.word == SocketcandWord::kOwnFrame) ||
                          (message.word == SocketcandWord::kOwnRemote);
    if (is_echo && !unconfirmed_.front())
    {
        unconfirmed_.pop_front();
        TakeAnswer();
        return false;
    }
    if (is_echo)
    {
        frame = *unconfirmed_.front();
        frame.own = true;
        unconfirmed_.pop_front();
    }
    else if (is_frame)
    {
        frame = message.frame;
    }
    else
    {
        if (!message.problem.empty())
        {
            NoteMalformed(message.problem);
        }
        LearnText(message.text);
        return false;
    }
    frame.time_ns = LiveNow();
    Learn(frame);
    return true;
}

void LiveSocketcandBus::Learn(const LiveFrame& frame)
{
    const ErrorNews news = ReadErrorFrame(frame);
    health_.error_frames += frame.error ? 1U : 0U;
    health_.bus_offs += news.is_bus_off ? 1U : 0U;
    health_.restarts += news.is_restart ? 1U : 0U;
    if (news.is_restart)
    {
        NoteBusOff(); // Which nobody may have told.
    }
    // A frame that came is a bus that works, whatever was said before.
    SetState(frame.error ? news.state.value_or(health_.state) : BusState::kActive);
}

/// Our server tells in words what became of a frame that it could not send.
void LiveSocketcandBus::LearnText(const std::string& text)
{
    if (text.compare(0U, 5U, "send:") != 0)
    {
        return;
    }
    ++health_.dropped_frames;
    if (text.find("bus-off") != std::string::npos)
    {
        SetState(BusState::kBusOff);
    }
    else if (text.find("down") != std::string::npos)
    {
        SetState(BusState::kDown);
    }
}

} // namespace counterpoint::host
