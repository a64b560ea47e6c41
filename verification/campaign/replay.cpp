// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/replay.hpp"

#include "runtime/device/names.hpp"
#include "runtime/device/time_text.hpp"
#include "verification/campaign/html.hpp"

#include <algorithm>
#include <cstdio>

namespace counterpoint::campaign
{
namespace
{
/// More members are counted, not named.
constexpr std::size_t kMostNames = 4U;
// Of the picture.
constexpr int kWidth = 720;
constexpr int kLeft = 150;
constexpr int kRow = 34;

void Prolong(std::vector<Stretch>& stretches, const bool is_high, const Nanoseconds from, const Nanoseconds to)
{
    if (!is_high)
    {
        return;
    }
    if (!stretches.empty() && stretches.back().end == from)
    {
        stretches.back().end = to;
        return;
    }
    stretches.push_back({from, to});
}

std::string HexText(const std::uint64_t value)
{
    char text[24] = {};
    std::snprintf(text, sizeof(text), "0x%llX", static_cast<unsigned long long>(value));
    return text;
}

/// As 576.806 ms, with as many digits in each line.
std::string TimeText(const Nanoseconds at)
{
    constexpr std::size_t kTimeWidth = 12U;
    return runtime::MillisecondsColumn(at, kTimeWidth);
}

std::string CauseList(const std::uint32_t signals)
{
    std::string text;
    for (const auto& word : runtime::kCauseWords)
    {
        const auto bit = static_cast<std::uint32_t>(word.meaning);
        if (bit < 32U && ((signals >> bit) & 1U) != 0U)
        {
            text += (text.empty() ? "" : ", ") + std::string(word.text);
        }
    }
    return text;
}
} // namespace

Replay::Replay(Session& session, const std::uint64_t number)
    : session_(session), number_(number), experiment_(session.Faults().At(number)),
      begin_(session.Scenario().Record().cycles[experiment_.cycle].at)
{
    Runner& runner = session.Runs();
    now_ = begin_;
    Tell("fault", PlaceText(session.Parts(), experiment_) + ", " + WordOf(experiment_.kind) + ", at " +
                      WordOf(experiment_.phase) + " of cycle " + std::to_string(experiment_.cycle));
    runner.Rewind(experiment_.cycle);
    last_ = See(runner.OpenWithoutFault(experiment_.cycle - 1U));
    {
        const Trap trap;
        found_ = runner.Run(experiment_); // Nobody looks on: what is hit may be what is looked at.
        runner.Follow(this);
        const Outcome seen = runner.Run(experiment_);
        if (seen.result != found_.result || seen.us != found_.us)
        {
            Tell("replay", "sees no more of it: what is hit is what it looks at");
        }
    }
    runner.Follow(nullptr);
}

Replay::Sighting Replay::See(const SrdoMask open) const
{
    Device& device = session_.Runs().Subject();
    Sighting sighting;
    sighting.open = open;
    sighting.fault = device.Fault();
    sighting.is_watchdog_alive = device.IsWatchdogAlive();
    sighting.is_output_live = device.IsOutputLive();
    sighting.sent = device.Ports().sent;
    for (SlotIndex slot = 0U; slot < device.Config().srdo_count; ++slot)
    {
        sighting.a.push_back(device.Voice(0U).View(slot));
        sighting.b.push_back(device.Voice(1U).View(slot));
    }
    for (const FlatPair& pair : device.Pairs())
    {
        sighting.values.push_back(ReadVariable(pair.normal).bits);
    }
    sighting.different = session_.Runs().DifferentPlaces();
    return sighting;
}

void Replay::OnCycle(const std::size_t cycle, const Sight& sight)
{
    const Recording& recording = session_.Scenario().Record();
    const Nanoseconds next = recording.cycles[std::min(cycle + 1U, recording.cycles.size() - 1U)].at;
    const SrdoMask without = session_.Runs().OpenWithoutFault(cycle);
    now_ = recording.cycles[cycle].at;
    Prolong(open_, sight.open != 0U, now_, next);
    Prolong(open_without_, without != 0U, now_, next);
    Sighting is = See(sight.open);
    std::string names;
    std::size_t fresh = 0U;
    for (const std::size_t place : is.different)
    {
        if (std::find(told_different_.begin(), told_different_.end(), place) == told_different_.end())
        {
            told_different_.push_back(place);
            names +=
                (fresh < kMostNames) ? (fresh == 0U ? "" : ", ") + session_.Parts().device.Places()[place].name : "";
            ++fresh;
        }
    }
    if (fresh != 0U)
    {
        Tell("memory", "differs now: " + names +
                           (fresh > kMostNames ? " and " + std::to_string(fresh - kMostNames) + " more" : ""));
    }
    TellChannel("channel A", last_.a, is.a);
    TellChannel("channel B", last_.b, is.b);
    TellDevice(is);
    TellValues(is);
    if (sight.wrong != Wrong::kNothing && sight.wrong != wrong_)
    {
        Tell("judge",
             ReasonOf(Outcome{Class::kSilent, Detector::kNobody, static_cast<std::uint8_t>(sight.wrong), 0U, 0U}));
    }
    wrong_ = sight.wrong;
    if (sight.is_overdue && !is_overdue_)
    {
        Tell("judge", "no pair within the refresh time");
    }
    if (sight.is_bad_frame && !is_bad_frame_)
    {
        Tell("judge", "a frame that no receiver can use, or that nobody wrote");
    }
    is_overdue_ = is_overdue_ || sight.is_overdue;
    is_bad_frame_ = is_bad_frame_ || sight.is_bad_frame;
    last_ = std::move(is);
}

void Replay::Tell(const char* const who, const std::string& what)
{
    moments_.push_back({now_, who, what});
}

void Replay::TellChannel(const char* const who, const std::vector<SrdoView>& was, const std::vector<SrdoView>& is)
{
    for (std::size_t slot = 0U; slot < is.size(); ++slot)
    {
        const std::string srdo = "slot " + std::to_string(slot) + " ";
        if (is[slot].signals != 0U && is[slot].signals != was[slot].signals)
        {
            Tell(who, srdo + "reports " + CauseList(is[slot].signals));
        }
        if (is[slot].state != was[slot].state)
        {
            Tell(who, srdo + runtime::NameOf(runtime::kStateWords, is[slot].state));
        }
    }
}

void Replay::TellDevice(const Sighting& is)
{
    if (is.fault != last_.fault)
    {
        Tell("kernel", std::string("device fault ") + runtime::Name(is.fault));
    }
    if (!is.is_output_live && last_.is_output_live)
    {
        Tell("pins", "cut themselves off");
    }
    if (!is.is_watchdog_alive && last_.is_watchdog_alive)
    {
        Tell("watchdog", "not answered in time");
    }
    if (is.open != last_.open)
    {
        Tell("output", is.open == 0U ? "SAFE" : "OPEN for slots " + HexText(is.open));
    }
}

void Replay::TellValues(const Sighting& is)
{
    const std::vector<FlatPair>& pairs = session_.Parts().device.Pairs();
    for (std::size_t pair = 0U; pair < is.values.size(); ++pair)
    {
        if (is.values[pair] != last_.values[pair])
        {
            Tell("variable", runtime::ObjectText(pairs[pair].address) + " = " + HexText(is.values[pair]));
        }
    }
}

std::string Replay::Title() const
{
    return session_.Parts().plan.title + ": experiment " + std::to_string(number_);
}

std::string Replay::Text() const
{
    std::string text = Title() + "\n";
    for (const Moment& moment : moments_)
    {
        std::string who = moment.who;
        who.resize(10U, ' ');
        text += TimeText(moment.at) + "  " + who + " " + moment.what + "\n";
    }
    return text + OutcomeText(found_) + "\n";
}

Nanoseconds Replay::PictureEnd() const
{
    constexpr Nanoseconds kLeastBehind = 5 * runtime::kNanosecondsPerMillisecond;
    const Nanoseconds last = moments_.back().at;
    return std::min(now_ + runtime::kNanosecondsPerMillisecond, last + std::max(kLeastBehind, (last - begin_) / 4));
}

std::string Replay::Lane(const std::string& name, const std::vector<Stretch>& stretches, const int row) const
{
    const auto span = static_cast<double>(PictureEnd() - begin_);
    const auto x_of = [this, span](const Nanoseconds at)
    { return kLeft + static_cast<double>(std::max<Nanoseconds>(at - begin_, 0)) / span * (kWidth - kLeft); };
    const int top = row * kRow;
    std::string text = "<text x=\"0\" y=\"" + std::to_string(top + 22) + "\" font-size=\"18\" fill=\"currentColor\">" +
                       name + "</text><line x1=\"" + std::to_string(kLeft) + "\" x2=\"" + std::to_string(kWidth) +
                       "\" y1=\"" + std::to_string(top + 28) + "\" y2=\"" + std::to_string(top + 28) +
                       "\" stroke=\"currentColor\"/>\n";
    for (const Stretch& stretch : stretches)
    {
        const double from = x_of(stretch.begin);
        const double width = std::max(x_of(stretch.end) - from, 2.0);
        text += "<rect x=\"" + std::to_string(from) + "\" y=\"" + std::to_string(top + 6) + "\" width=\"" +
                std::to_string(std::max(std::min(width, kWidth - from), 0.0)) +
                "\" height=\"22\" fill=\"var(--bar)\"/>\n";
    }
    return text;
}

std::string Replay::Picture() const
{
    std::vector<Stretch> marks;
    for (const Moment& moment : moments_)
    {
        marks.push_back({moment.at, moment.at});
    }
    return "<svg viewBox=\"0 0 " + std::to_string(kWidth) + " " + std::to_string(3 * kRow + 26) +
           "\" role=\"img\" aria-label=\"When the output is open\">\n" + Lane("without fault", open_without_, 0) +
           Lane("output open", open_, 1) + Lane("events", marks, 2) + "<text x=\"" + std::to_string(kLeft) + "\" y=\"" +
           std::to_string(3 * kRow + 20) + "\" font-size=\"18\" fill=\"currentColor\">" + TimeText(begin_) +
           "</text><text text-anchor=\"end\" x=\"" + std::to_string(kWidth) + "\" y=\"" +
           std::to_string(3 * kRow + 20) + "\" font-size=\"18\" fill=\"currentColor\">" + TimeText(PictureEnd()) +
           "</text></svg>\n";
}

std::string Replay::Page() const
{
    std::string text = html::Head(Title());
    text += std::string("<p class=\"") + (IsDangerous(found_.result) ? "bad" : "good") + "\">" +
            html::Escaped(OutcomeText(found_)) + "</p>\n" + Picture() + html::Table({"time", "who", "what"}, "text");
    for (const Moment& moment : moments_)
    {
        text += html::Row({TimeText(moment.at), html::Escaped(moment.who), html::Escaped(moment.what)});
    }
    return text + html::kTableEnd + "</body></html>\n";
}
} // namespace counterpoint::campaign
