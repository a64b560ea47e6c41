// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/live/socketcand/greeting.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

namespace counterpoint::host
{
namespace
{

/// More than a bus of 1 Mbit/s carries within the greeting: 3 s with 47 us for the shortest frame are 63829.
constexpr std::size_t kMostEarly = 65535U;

/// By step.
constexpr std::array<const char*, 5U> kAwaited{"say hi", "answer open", "answer rawmode", "answer ownmode", ""};

} // namespace

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

std::string SocketcandGreeting::Awaited() const
{
    return kAwaited.at(static_cast<std::size_t>(step_));
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
    if (!is_answer && (early_.size() == kMostEarly))
    {
        problem_ = "the server did not " + Awaited() + ", but sent " + std::to_string(kMostEarly + 1U) +
                   " messages of the bus, more than one carries in 3 s";
        return;
    }
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
