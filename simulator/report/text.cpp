// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/report/reports.hpp"

#include "canopen/cia306/text/column.hpp"
#include "runtime/device/objects/optional_services.hpp"
#include "runtime/device/time_text.hpp"
#include "simulator/scenario/names.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <ostream>
#include <set>

namespace counterpoint::simulator
{
namespace
{
ObjectAddress ObjectOf(const std::uint64_t number)
{
    return {static_cast<std::uint16_t>(number >> 8U), static_cast<std::uint8_t>(number & 0xFFU)};
}

constexpr Word<host::FrameFate> kFateTexts[] = {
    {"", host::FrameFate::kComplete},
    {"destroyed on the wire", host::FrameFate::kHit},
    {"destroyed by a collision", host::FrameFate::kCollision},
    {"not acknowledged", host::FrameFate::kNotAcknowledged},
    {"sender gone", host::FrameFate::kSenderGone},
};
constexpr const char* kGfcTexts[] = {"GFC refused", "GFC sent", "GFC received", "GFC not followed by an SRDO in time"};
constexpr const char* kHungTexts[] = {"a call does not return: the node stands still",
                                      "a call leads anywhere: the processor stops the node", "the node stands still"};

std::string ManagerText(const ManagerEntry& entry)
{
    return ((entry.node_id == 0U) ? "" : "node " + std::to_string(entry.node_id) + ": ") + entry.text;
}

/// Equal things that come one after the other, with little time between two: the first one is told, with their number.
class Repeats
{
  public:
    void Add(const std::size_t place, const Nanoseconds at, const std::string& text)
    {
        constexpr Nanoseconds kPause = 10 * kNanosecondsPerMillisecond;
        const auto known = first_.find(text);
        if (known != first_.end() && at - groups_[known->second].last < kPause)
        {
            Group& group = groups_[known->second];
            ++group.count;
            group.last = at;
            hidden_.insert(place);
            return;
        }
        first_[text] = place;
        groups_[place] = {1U, at};
    }
    /// @brief Whether an equal one before tells of it.
    [[nodiscard]] bool IsHidden(const std::size_t place) const
    {
        return hidden_.count(place) != 0U;
    }
    /// @brief " (12 times until 512.5 ms)"; empty for one that is alone.
    [[nodiscard]] std::string TextOf(const std::size_t place) const
    {
        const auto group = groups_.find(place);
        const bool is_alone = group == groups_.end() || group->second.count < 2U;
        return is_alone ? ""
                        : " (" + std::to_string(group->second.count) + " times until " +
                              MillisecondsText(group->second.last) + ")";
    }

  private:
    struct Group
    {
        std::size_t count{0U};
        Nanoseconds last{0};
    };
    std::map<std::string, std::size_t> first_; ///< Of the equal ones, by text.
    std::map<std::size_t, Group> groups_;      ///< By their first one.
    std::set<std::size_t> hidden_;
};

/// Events that a fault can bring by the thousand.
bool IsFrequent(const EventKind kind)
{
    return kind == EventKind::kFrameChanged || kind == EventKind::kLinkMessage || kind == EventKind::kEmergency;
}

/// Writes events and frames in order of time, and counts frames where nothing else happens. [SRS_SIM_071]
class TimeLine
{
  public:
    TimeLine(const Run& run, const FrameLines frames, std::ostream& out) : run_(run), lines_(frames), out_(out)
    {
    }

    void Write()
    {
        if (lines_ == FrameLines::kCounted)
        {
            FindRepeats();
        }
        const std::vector<Event>& events = run_.Record().Events();
        for (std::size_t place = 0U; place < events.size(); ++place)
        {
            const Event& event = events[place];
            if (event.kind == EventKind::kReception || events_.IsHidden(place))
            {
                continue; // The frame itself, or the first of the equal ones, is shown.
            }
            WriteManagersUntil(event.at);
            WriteFramesUntil(event.at);
            WriteCount();
            Line(event.at, run_.NodeName(event.node), EventText(run_, event) + events_.TextOf(place));
        }
        WriteManagersUntil(kNever);
        WriteFramesUntil(kNever);
        WriteCount();
    }

  private:
    void FindRepeats()
    {
        const Journal& record = run_.Record();
        for (std::size_t place = 0U; place < record.Events().size(); ++place)
        {
            const Event& event = record.Events()[place];
            if (IsFrequent(event.kind))
            {
                events_.Add(place, event.at, run_.NodeName(event.node) + EventText(run_, event));
            }
        }
        for (std::size_t place = 0U; place < record.Frames().size(); ++place)
        {
            const FrameEntry& frame = record.Frames()[place];
            if (!IsPlain(frame))
            {
                frames_.Add(place, frame.end, BusText(frame));
            }
        }
        for (std::size_t place = 0U; place < record.Managers().size(); ++place)
        {
            const ManagerEntry& entry = record.Managers()[place];
            if (entry.kind == "emergency")
            {
                managers_.Add(place, entry.at, run_.NodeName(entry.manager) + ManagerText(entry));
            }
        }
    }

    [[nodiscard]] static bool IsPlain(const FrameEntry& frame)
    {
        return frame.fate == host::FrameFate::kComplete && frame.sender != kNoNode;
    }

    [[nodiscard]] std::string BusText(const FrameEntry& frame) const
    {
        const std::string from = (frame.sender == kNoNode) ? "inserted" : "from " + run_.NodeName(frame.sender);
        return "frame " + FrameText(frame.frame) + "  " + from + "  " + NameOf(kFateTexts, frame.fate);
    }

    void Line(const Nanoseconds at, const std::string& place, const std::string& text)
    {
        constexpr std::size_t kPlaceWidth = 12U;
        constexpr std::size_t kTimeWidth = 12U;
        const std::size_t room = kPlaceWidth - std::min(kPlaceWidth, cia306::CharactersOf(place));
        out_ << runtime::MillisecondsColumn(at, kTimeWidth) << "  " << place << std::string(room, ' ') << " " << text
             << "\n";
    }

    void WriteManagersUntil(const Nanoseconds until)
    {
        const std::vector<ManagerEntry>& entries = run_.Record().Managers();
        for (; next_told_ < entries.size() && entries[next_told_].at <= until; ++next_told_)
        {
            const ManagerEntry& entry = entries[next_told_];
            if (!entry.text.empty() && !managers_.IsHidden(next_told_))
            {
                WriteFramesUntil(entry.at);
                WriteCount();
                Line(entry.at, run_.NodeName(entry.manager), ManagerText(entry) + managers_.TextOf(next_told_));
            }
        }
    }

    void WriteFramesUntil(const Nanoseconds until)
    {
        const std::vector<FrameEntry>& frames = run_.Record().Frames();
        while (next_frame_ < frames.size() && frames[next_frame_].end <= until)
        {
            const FrameEntry& frame = frames[next_frame_];
            const std::size_t place = next_frame_;
            ++next_frame_;
            if (lines_ == FrameLines::kCounted && IsPlain(frame))
            {
                ++counted_;
                continue;
            }
            if (!frames_.IsHidden(place))
            {
                Line(frame.end, "bus", BusText(frame) + frames_.TextOf(place));
            }
        }
    }

    void WriteCount()
    {
        if (counted_ > 0U)
        {
            out_ << "                 (" << counted_ << (counted_ == 1U ? " frame)" : " frames)") << "\n";
        }
        counted_ = 0U;
    }

    const Run& run_;
    FrameLines lines_;
    std::ostream& out_;
    std::size_t next_frame_{0U};
    std::size_t next_told_{0U};
    std::size_t counted_{0U};
    Repeats events_{};
    Repeats frames_{};
    Repeats managers_{};
};

/// As Node packed it.
cia301::ReceivedEmergency EmergencyOf(const Event& event)
{
    cia301::ReceivedEmergency emergency{{static_cast<std::uint8_t>(event.value >> 24U)},
                                        static_cast<std::uint16_t>(event.value & 0xFFFFU),
                                        static_cast<std::uint8_t>((event.value >> 16U) & 0xFFU),
                                        {}};
    std::uint64_t details = event.other;
    for (std::size_t byte = sizeof(emergency.details); byte > 0U; --byte)
    {
        emergency.details[byte - 1U] = static_cast<std::uint8_t>(details & 0xFFU);
        details >>= 8U;
    }
    return emergency;
}

std::string SrdoText(const Event& event)
{
    return "SRDO " + std::to_string(event.srdo) + " ";
}

/// Frames that nobody sent, or somebody whose they are not; other faults change what was sent.
bool BringsFrames(const FaultKind kind)
{
    return std::holds_alternative<ForeignFault>(kind) || kind == FaultKind(FrameFault::kDuplicate);
}

std::string LinkText(const Event& event)
{
    const auto finding = static_cast<LinkFinding>(event.other);
    const std::string why = (finding == LinkFinding::kNone || finding == LinkFinding::kInvalid)
                                ? ""
                                : std::string(": ") + NameOf(kLinkFindingWords, finding);
    return std::string("link to the other CPU ") + NameOf(kLinkStateWords, static_cast<LinkState>(event.value)) + why;
}

std::string CauseText(const Event& event)
{
    std::string text;
    for (std::uint32_t cause = 1U; cause < 32U; ++cause)
    {
        if (((event.other >> cause) & 1U) != 0U)
        {
            text += (text.empty() ? "" : ", ") + std::string(Name(static_cast<SrdoCause>(cause)));
        }
    }
    return text.empty() ? Name(static_cast<SrdoCause>(event.value)) : text;
}

/// What channels, comparator and outputs say.
std::string InsideText(const Run& run, const Event& event)
{
    switch (event.kind)
    {
    case EventKind::kViewA:
        return SrdoText(event) + "channel A: " + NameOf(runtime::kStateWords, static_cast<SrdoState>(event.value));
    case EventKind::kViewB:
        return SrdoText(event) + "channel B: " + NameOf(runtime::kStateWords, static_cast<SrdoState>(event.value));
    case EventKind::kCauseA:
        return SrdoText(event) + "channel A reports " + CauseText(event);
    case EventKind::kCauseB:
        return SrdoText(event) + "channel B reports " + CauseText(event);
    case EventKind::kVerdict:
        return "comparator: agreed SRDO " + SlotsText(run, event.node, event.value) + ", matched " +
               SlotsText(run, event.node, event.other);
    case EventKind::kDemotion:
        return "comparator: demote SRDO " + SlotsText(run, event.node, event.value);
    case EventKind::kPermits:
        return "three permits for SRDO " + SlotsText(run, event.node, event.value);
    case EventKind::kOutput:
        return SrdoText(event) + ((event.value != 0U) ? "OUTPUT RELEASED" : "OUTPUT SAFE");
    case EventKind::kValue:
        return SrdoText(event) + ObjectText(ObjectOf(event.other)) + " = " + std::to_string(event.value);
    case EventKind::kSignal:
        return SrdoText(event) + "application told: " + Name(static_cast<SrdoCause>(event.value));
    case EventKind::kDeviceFault:
        return std::string("DEVICE SAFE STATE: ") + Name(static_cast<DeviceFault>(event.value));
    default:
        return "";
    }
}
} // namespace

std::string SlotsText(const Run& run, const NodeIndex node, const SrdoMask mask)
{
    std::string text;
    for (const runtime::SrdoModel& srdo : run.ModelOf(node).Srdos())
    {
        const SlotIndex slot = run.ModelOf(node).SlotOf(srdo.number).value_or(0U);
        if (((mask >> slot) & 1U) != 0U)
        {
            text += (text.empty() ? "" : ", ") + std::to_string(srdo.number);
        }
    }
    return text.empty() ? "none" : text;
}

std::string DataText(const CanFrame& frame, const char* const separator)
{
    std::string text;
    for (std::uint8_t byte = 0U; byte < frame.length_bytes && byte < kMaxPayloadBytes; ++byte)
    {
        std::array<char, 8U> digits{};
        static_cast<void>(std::snprintf(digits.data(), digits.size(), "%02X", static_cast<unsigned>(frame.data[byte])));
        text += (text.empty() ? "" : separator) + std::string(digits.data());
    }
    return text;
}

std::string FrameText(const CanFrame& frame)
{
    return IdentifierText(frame.identifier) + " [" + std::to_string(frame.length_bytes) + "] " + DataText(frame, " ");
}

std::string EventText(const Run& run, const Event& event)
{
    const Scenario& scenario = run.Setting();
    switch (event.kind)
    {
    case EventKind::kNmt:
        return std::string("NMT ") + Name(static_cast<NmtState>(event.value));
    case EventKind::kInput:
        return "input " + ObjectText(ObjectOf(event.other)) + " = " + std::to_string(event.value);
    case EventKind::kAcknowledge:
        return SrdoText(event) + "acknowledge " + std::to_string(event.value);
    case EventKind::kGfc:
        return kGfcTexts[event.value % std::size(kGfcTexts)];
    case EventKind::kPowerOn:
        return "power on, configuration accepted";
    case EventKind::kPowerOff:
        return "power off";
    case EventKind::kNoStart:
        return "THE DEVICE DOES NOT START";
    case EventKind::kFault:
        return "FAULT: " + scenario.faults[event.value].name;
    case EventKind::kFrameChanged:
        return "frame " + IdentifierText(static_cast<std::uint32_t>(event.value)) +
               (BringsFrames(scenario.faults[event.other].kind) ? " inserted: " : " changed: ") +
               scenario.faults[event.other].name;
    case EventKind::kWatchdog:
        return "WATCHDOG TRIPPED";
    case EventKind::kHung:
        return kHungTexts[event.value % std::size(kHungTexts)];
    case EventKind::kLink:
        return LinkText(event);
    case EventKind::kLinkMessage:
        return "message of the other CPU: " + scenario.faults[event.other].name;
    case EventKind::kSelfTest:
        return std::string("self test finds: ") + NameOf(kTestWords, event.value);
    case EventKind::kConfigurationInvalid:
        return SrdoText(event) + "configuration invalid";
    case EventKind::kReception:
        return SrdoText(event) + "received " + IdentifierText(static_cast<std::uint32_t>(event.value));
    case EventKind::kTime:
        return "hears " + runtime::TextOf(cia301::TimeOfDay{static_cast<std::uint32_t>(event.value),
                                                            static_cast<std::uint16_t>(event.other)});
    case EventKind::kEmergency:
        return "hears " + runtime::TextOf(EmergencyOf(event));
    case EventKind::kNewNodeId:
        return "SILENT: LSS gave node-ID " + std::to_string(event.value);
    case EventKind::kStore:
        return "somebody stores " + StoreText(event);
    default:
        return InsideText(run, event);
    }
}

namespace
{
/// Where the expectation stands.
std::string PlaceText(const Run& run, const ExpectationVerdict& verdict)
{
    if (verdict.expectation == kOfItself)
    {
        return "";
    }
    const Source& source = run.Setting().expectations[verdict.expectation].source;
    return "  (" + source.file + ":" + std::to_string(source.place.line) + ":" + std::to_string(source.place.column) +
           ")";
}
} // namespace

void WriteTimeLine(const Run& run, const FrameLines frames, std::ostream& out)
{
    out << run.Setting().title << (run.Setting().title.empty() ? "" : "\n");
    TimeLine(run, frames, out).Write();
}

void WriteVerdicts(const Run& run, std::ostream& out)
{
    std::size_t held = 0U;
    for (const ExpectationVerdict& verdict : run.Verdicts())
    {
        out << (verdict.holds ? "  holds   " : "  FAILED  ") << verdict.wanted << ": " << verdict.seen
            << (verdict.holds ? "" : PlaceText(run, verdict)) << "\n";
        held += verdict.holds ? 1U : 0U;
    }
    const std::string& profile = run.Setting().profile;
    out << held << " of " << run.Verdicts().size() << " expectations hold"
        << (profile.empty() ? "" : ", profile " + profile) << "\n";
}
} // namespace counterpoint::simulator
