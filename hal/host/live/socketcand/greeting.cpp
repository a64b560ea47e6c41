// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/live/socketcand/greeting.hpp"

#include <optional>
#include <utility>

namespace counterpoint::host
{

SocketcandGreeting::SocketcandGreeting(std::string bus) : bus_{std::move(bus)}
{
}

void SocketcandGreeting::GoOn(SocketcandLink& link)
{
    while (!IsOver() && problem_.empty())
    {
        const std::optional<SocketcandMessage> message = link.Next();
        if (!message)
        {
            return;
        }
        Take(*message, link);
    }
}

bool SocketcandGreeting::IsOver() const
{
    return step_ == Step::kOver;
}

void SocketcandGreeting::Take(const SocketcandMessage& message, SocketcandLink& link)
{
    if (step_ == Step::kOwnMode)
    {
        TakeOwnMode(message);
        return;
    }
    const SocketcandWord answer = (step_ == Step::kHi) ? SocketcandWord::kHi : SocketcandWord::kOk;
    if (message.word == SocketcandWord::kErrorText)
    {
        problem_ = "the server says: " + message.text;
    }
    else if (message.word != answer)
    {
        problem_ = "the server's answer is another than expected of socketcand" +
                   (message.problem.empty() ? std::string{} : (": " + message.problem));
    }
    else
    {
        Say(static_cast<Step>(static_cast<std::uint8_t>(step_) + 1U), link);
    }
}

/// In raw mode frames may come before the answer. A server by others refuses the word.
void SocketcandGreeting::TakeOwnMode(const SocketcandMessage& message)
{
    const bool is_answer = (message.word == SocketcandWord::kOk) || (message.word == SocketcandWord::kErrorText);
    if (!is_answer)
    {
        early_.push_back(message);
        return;
    }
    has_own_ = message.word == SocketcandWord::kOk;
    step_ = Step::kOver;
}

void SocketcandGreeting::Say(const Step step, SocketcandLink& link)
{
    SocketcandMessage message;
    message.word = SocketcandWord::kOwnMode;
    if (step == Step::kOpen)
    {
        message.word = SocketcandWord::kOpen;
        message.text = bus_;
    }
    else if (step == Step::kRawMode)
    {
        message.word = SocketcandWord::kRawMode;
    }
    step_ = step;
    link.Say(message);
}
} // namespace counterpoint::host
