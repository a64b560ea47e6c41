// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/target/firmware/scenario.hpp"

namespace counterpoint::target
{
namespace
{

constexpr std::uint32_t kDecimal = 10U;
constexpr std::uint32_t kHexadecimal = 16U;
constexpr std::uint32_t kNoDigit = 99U;

// Their numbers are those of the NMT commands and SrdoState as simulated_device.cpp has them in the same order.
constexpr const char* kNmtWords[]{"operational", "preoperational", "stopped", "resetnode", "resetcommunication"};
constexpr const char* kStateWords[]{"off", "waiting", "faulted", "released", "producer"};
constexpr const char* kSwitchWords[]{"off", "on"};
constexpr const char* kCounterWords[]{"go", "stop"};

std::uint32_t DigitOf(const char character) noexcept
{
    if ((character >= '0') && (character <= '9'))
    {
        return static_cast<std::uint32_t>(character - '0');
    }
    if ((character >= 'a') && (character <= 'f'))
    {
        return static_cast<std::uint32_t>(character - 'a') + kDecimal;
    }
    return kNoDigit;
}

} // namespace

Scenario::Scenario(const char* const text) noexcept : place_{text}
{
}

bool Scenario::IsAtEnd() const noexcept
{
    return (*place_ == '\0') || (*place_ == '\n') || (*place_ == '#');
}

void Scenario::SkipBlanks() noexcept
{
    while (*place_ == ' ')
    {
        ++place_;
    }
}

void Scenario::SkipToEvent() noexcept
{
    SkipBlanks();
    while ((*place_ == '\n') || (*place_ == '#'))
    {
        while ((*place_ != '\n') && (*place_ != '\0'))
        {
            ++place_;
        }
        if (*place_ == '\n')
        {
            ++place_;
            ++line_;
        }
        SkipBlanks();
    }
}

bool Scenario::Takes(const char* word) noexcept
{
    SkipBlanks();
    const char* place = place_;
    while ((*word != '\0') && (*place == *word))
    {
        ++place;
        ++word;
    }
    const bool is_whole = (*word == '\0') && ((*place == ' ') || (*place == '\n') || (*place == '\0'));
    place_ = is_whole ? place : place_;
    return is_whole;
}

std::uint32_t Scenario::Number(const std::uint32_t base) noexcept
{
    SkipBlanks();
    is_good_ = is_good_ && (DigitOf(*place_) < base);
    std::uint32_t value = 0U;
    while (DigitOf(*place_) < base)
    {
        value = (value * base) + DigitOf(*place_);
        ++place_;
    }
    return value;
}

void Scenario::ReadFrame(Event& event) noexcept
{
    event.frame = CanFrame{};
    event.frame.kind = FrameKind::kData;
    event.frame.port = CanPortId::kFirst;
    event.frame.identifier = Number(kHexadecimal);
    SkipBlanks();
    while (!IsAtEnd() && is_good_)
    {
        is_good_ = event.frame.length_bytes < kMaxPayloadBytes;
        if (is_good_)
        {
            event.frame.data[event.frame.length_bytes] = static_cast<std::uint8_t>(Number(kHexadecimal));
            ++event.frame.length_bytes;
        }
        SkipBlanks();
    }
}

void Scenario::ReadChoice(Event& event, const char* const* const words, const std::uint32_t count) noexcept
{
    for (std::uint32_t number = 0U; number < count; ++number)
    {
        if (Takes(words[number]))
        {
            event.value = number;
            return;
        }
    }
    is_good_ = false;
}

void Scenario::ReadExpectation(Event& event) noexcept
{
    if (Takes("outputs"))
    {
        event.verb = Verb::kExpectOutputs;
        event.value = Number(kHexadecimal);
    }
    else if (Takes("gate"))
    {
        event.verb = Verb::kExpectGate;
        event.value = Number(kHexadecimal);
    }
    else if (Takes("state"))
    {
        event.verb = Verb::kExpectState;
        event.srdo = Number(kDecimal);
        ReadChoice(event, kStateWords, 5U);
    }
    else if (Takes("fault"))
    {
        event.verb = Verb::kExpectFault;
        event.value = Number(kDecimal);
    }
    else if (Takes("sent"))
    {
        event.verb = Verb::kExpectSent;
        event.value = Number(kDecimal);
    }
    else
    {
        is_good_ = Takes("last") && is_good_;
        event.verb = Verb::kExpectLast;
        ReadFrame(event);
    }
}

void Scenario::ReadVerb(Event& event) noexcept
{
    if (Takes("frame"))
    {
        event.verb = Verb::kFrame;
        ReadFrame(event);
    }
    else if (Takes("nmt"))
    {
        event.verb = Verb::kNmt;
        ReadChoice(event, kNmtWords, 5U);
    }
    else if (Takes("input"))
    {
        event.verb = Verb::kInput;
        event.value = Number(kHexadecimal);
    }
    else if (Takes("overflow"))
    {
        event.verb = Verb::kOverflow;
    }
    else if (Takes("busoff"))
    {
        event.verb = Verb::kBusOff;
        ReadChoice(event, kSwitchWords, 2U);
    }
    else if (Takes("late"))
    {
        event.verb = Verb::kLate;
        event.value = Number(kDecimal);
    }
    else if (Takes("counterb"))
    {
        event.verb = Verb::kCounterB;
        ReadChoice(event, kCounterWords, 2U);
    }
    else if (Takes("expect"))
    {
        ReadExpectation(event);
    }
    else
    {
        is_good_ = Takes("end") && is_good_;
        event.verb = Verb::kEnd;
    }
}

Event Scenario::Next() noexcept
{
    SkipToEvent();
    Event event{};
    event.line = line_;
    if (!is_good_)
    {
        return event;
    }
    if (*place_ == '\0')
    {
        event.verb = Verb::kEnd;
        return event;
    }
    event.at_us = Number(kDecimal);
    ReadVerb(event);
    SkipBlanks();
    is_good_ = is_good_ && IsAtEnd();
    event.verb = is_good_ ? event.verb : Verb::kInvalid;
    return event;
}

} // namespace counterpoint::target
