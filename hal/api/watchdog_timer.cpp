// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/api/watchdog_timer.hpp"

namespace counterpoint::hal
{

namespace
{

constexpr std::uint32_t kAlive = 0x3C5AA5C3U;
constexpr std::uint32_t kTripped = 0U;

/// Linear congruence of full period: every value comes once in 2^32 questions, and never twice in a row.
constexpr std::uint32_t kQuestionFactor = 1664525U;
constexpr std::uint32_t kQuestionIncrement = 1013904223U;

[[nodiscard]] constexpr std::uint32_t NextQuestion(const std::uint32_t question) noexcept
{
    return (question * kQuestionFactor) + kQuestionIncrement;
}

} // namespace

void WatchdogTimer::Start(const WatchdogWindow& window, const Instant now) noexcept
{
    window_ = window;
    answered_ = now;
    question_ = NextQuestion(question_);
    alive_ = kAlive;
}

WatchdogQuestion WatchdogTimer::Question() const noexcept
{
    return WatchdogQuestion{question_};
}

void WatchdogTimer::Answer(const WatchdogAnswer& answer, const Instant now) noexcept
{
    const std::uint32_t elapsed = now.us - answered_.us;
    const bool in_window = (elapsed >= window_.opens_us) && (elapsed <= window_.ends_us);
    const std::uint32_t right = (kFlowReference + question_) * kWatchdogConstant;
    if (in_window && (answer.value == right))
    {
        answered_ = now;
        question_ = NextQuestion(question_);
    }
    else
    {
        alive_ = kTripped;
    }
}

void WatchdogTimer::Examine(const Instant now) noexcept
{
    const std::uint32_t elapsed = now.us - answered_.us;
    if (elapsed > window_.ends_us)
    {
        alive_ = kTripped;
    }
}

bool WatchdogTimer::IsAlive() const noexcept
{
    return alive_ == kAlive;
}

} // namespace counterpoint::hal
