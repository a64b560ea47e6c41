// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/managed/course.hpp"

#include "runtime/device/names.hpp"
#include "verification/campaign/trap.hpp"
#include "verification/campaign/variants.hpp"

#include <algorithm>
#include <map>

namespace counterpoint::campaign::managed
{
namespace
{
constexpr Nanoseconds kMs = runtime::kNanosecondsPerMillisecond;
constexpr std::uint32_t kByteBits = 8U;

[[nodiscard]] Nanoseconds TimeOf(const runtime::ManagerEvent& event)
{
    return static_cast<Nanoseconds>(event.at_us) * runtime::kNanosecondsPerMicrosecond;
}

/// Who tells of a fault by an event of a manager; kNobody: it is none.
[[nodiscard]] Teller TellerOf(const runtime::ManagerEvent& event)
{
    const auto number = [&event](const char* const key)
    { return event.details.contains(key) ? event.details[key].get<int>() : 0; };
    if (event.kind == "gate")
    {
        return (event.word == "differs" || event.word == "failed") ? Teller::kSafetyGate : Teller::kNobody;
    }
    if (event.kind == "status")
    {
        return (!event.word.empty() || number("abort") != 0 || number("code") != 0) ? Teller::kStatus : Teller::kNobody;
    }
    const std::map<std::string, Teller> tellers{{"heartbeat_lost", Teller::kErrorControl},
                                                {"guard_missed", Teller::kErrorControl},
                                                {"guard_lost", Teller::kErrorControl},
                                                {"toggle_error", Teller::kErrorControl},
                                                {"never_seen", Teller::kErrorControl},
                                                {"unexpected", Teller::kDuplicate},
                                                {"boot_up", Teller::kBootUp},
                                                {"duplicate", Teller::kDuplicate},
                                                {"emergency", Teller::kEmergency},
                                                {"flying_master", Teller::kElection},
                                                {"bus", Teller::kController},
                                                {"nmt", Teller::kCommand}};
    const auto found = tellers.find(event.kind);
    return (found == tellers.end()) ? Teller::kNobody : found->second;
}

[[nodiscard]] std::string DetailsOf(const runtime::ManagerEvent& event)
{
    std::string text = event.word;
    for (const char* const key : {"letter", "code", "abort", "object", "command", "number", "state"})
    {
        text += event.details.contains(key) ? " " + event.details[key].dump() : "";
    }
    return text;
}

/// Likewise of a device.
[[nodiscard]] bool IsTold(const simulator::Event& event)
{
    using simulator::EventKind;
    return event.kind == EventKind::kSignal || event.kind == EventKind::kDeviceFault ||
           event.kind == EventKind::kConfigurationInvalid || event.kind == EventKind::kNoStart ||
           event.kind == EventKind::kWatchdog || event.kind == EventKind::kHung;
}

[[nodiscard]] std::string TextOf(const simulator::Event& event)
{
    using simulator::EventKind;
    switch (event.kind)
    {
    case EventKind::kSignal:
        return "SRDO " + std::to_string(event.srdo) + ": " +
               runtime::NameOf(runtime::kCauseWords, static_cast<SrdoCause>(event.value), "?");
    case EventKind::kDeviceFault:
        return std::string("device fault: ") +
               runtime::NameOf(runtime::kDeviceFaultWords, static_cast<DeviceFault>(event.value), "?");
    case EventKind::kConfigurationInvalid:
        return "configuration invalid";
    default:
        return "does not run";
    }
}
} // namespace

Course::Course(const Plan& plan) : plan_(plan), stage_(plan), watch_(stage_, plan)
{
}

void Course::AdvanceTo(const Nanoseconds until)
{
    for (;;)
    {
        const Nanoseconds next = std::min({looked_ < 0 ? 0 : looked_ + kMs, later_at_, until});
        stage_.World().RunUntil(next);
        if (next == later_at_)
        {
            later_at_ = runtime::kNever;
            later_();
        }
        if (next == (looked_ < 0 ? 0 : looked_ + kMs))
        {
            looked_ = next;
            watch_.Look(next);
            for (std::size_t index = 0U; memory_ && index < stage_.Managers().size(); ++index)
            {
                memory_->Look(index, *stage_.Managers()[index]);
            }
        }
        if (next == until)
        {
            return;
        }
    }
}

Reference Course::RunWithout()
{
    if (std::find(plan_.parts.begin(), plan_.parts.end(), Target::kMemory) != plan_.parts.end())
    {
        memory_.emplace();
    }
    AdvanceTo(stage_.End());
    Reference reference = watch_.TakeReference();
    reference.memory = memory_ ? memory_->Members() : std::vector<ManagerMember>{};
    for (const Telling& telling : Tellings())
    {
        ++reference.told[telling.key];
    }
    return reference;
}

std::vector<Telling> Course::Tellings()
{
    std::vector<Telling> tellings;
    for (const auto& manager : stage_.Managers())
    {
        for (const runtime::ManagerEvent& event : manager->Events())
        {
            const Teller teller = TellerOf(event);
            if (teller != Teller::kNobody)
            {
                const std::string key = "manager " + std::to_string(manager->Node()) + " " + event.kind + " " +
                                        std::to_string(event.node) + " " + DetailsOf(event);
                tellings.push_back({teller, key, TimeOf(event), event.text.empty() ? event.kind : event.text});
            }
        }
    }
    for (std::size_t index = 0U; index < stage_.Guards().size(); ++index)
    {
        if (const Nanoseconds at = stage_.Guards()[index]->EndedAt(); at >= 0)
        {
            const std::string who = "manager " + std::to_string(stage_.Managers()[index]->Node());
            tellings.push_back({Teller::kException, who + " exception", at, "its program ended"});
        }
    }
    for (const simulator::Event& event : stage_.Record().Events())
    {
        if (IsTold(event))
        {
            const std::string text = TextOf(event);
            tellings.push_back({Teller::kDevice, "device " + std::to_string(event.node) + " " + text, event.at, text});
        }
    }
    return tellings;
}

std::vector<Telling> Course::News(const Reference& reference, const Nanoseconds from)
{
    std::vector<Telling> news;
    std::map<std::string, std::uint32_t> counts;
    for (const Telling& telling : Tellings())
    {
        const auto known = reference.told.find(telling.key);
        const std::uint32_t usual = (known == reference.told.end()) ? 0U : known->second;
        ++counts[telling.key];
        if (counts[telling.key] > usual && telling.at >= from)
        {
            news.push_back(telling);
        }
    }
    std::stable_sort(news.begin(), news.end(),
                     [](const Telling& left, const Telling& right) { return left.at < right.at; });
    return news;
}

Outcome Course::Try(const Trial& trial, const Space& space, const Reference& reference)
{
    std::optional<Trap> trap;
    if (IsInManagers(trial.target))
    {
        trap.emplace();
        watch_.NoteManagerHit();
        for (const auto& guard : stage_.Guards())
        {
            guard->Guard();
        }
    }
    watch_.Compare(reference, trial.at);
    Inject(trial, space);
    // A clock is wrong until the end.
    const Nanoseconds effect = IsOfFrames(trial.target)            ? EndOf(trial.hit)
                               : (trial.target == Target::kClocks) ? stage_.End()
                                                                   : trial.at;
    Nanoseconds differed = effect; // The last ms at which the network was not as without the fault.
    bool is_changed = false;
    while (looked_ + kMs <= stage_.End() && watch_.Found() == Wrong::kNothing)
    {
        AdvanceTo(looked_ + kMs);
        const bool is_same = watch_.Seen() == reference.pictures.at(static_cast<std::size_t>(looked_ / kMs));
        is_changed = is_changed || !is_same;
        const bool is_busy = !is_same || later_at_ != runtime::kNever || watch_.IsWaiting();
        differed = is_busy ? std::max(differed, looked_) : differed;
        if (looked_ - differed >= plan_.settle)
        {
            break;
        }
    }
    return Judged(trial, reference, is_changed, looked_ != differed);
}

Outcome Course::Judged(const Trial& trial, const Reference& reference, const bool is_changed, const bool is_back)
{
    const auto since = [&trial](const Nanoseconds at)
    {
        return static_cast<std::uint32_t>(std::max<Nanoseconds>(at - trial.at, 0) /
                                          runtime::kNanosecondsPerMicrosecond);
    };
    const std::vector<Telling> news = News(reference, trial.at);
    const Telling first = news.empty() ? Telling{} : news.front();
    Outcome outcome{};
    outcome.detector = static_cast<Detector>(first.teller);
    outcome.us = news.empty() ? 0U : since(first.at);
    if (watch_.Found() != Wrong::kNothing)
    {
        outcome.result = Class::kSilent;
        outcome.detail = static_cast<std::uint8_t>(watch_.Found());
        outcome.us = since(watch_.FoundAt());
    }
    else if (watch_.Listed() != Limit::kNothing)
    {
        outcome.result = Class::kListed;
        outcome.detail = static_cast<std::uint8_t>(watch_.Listed());
    }
    else if (!news.empty())
    {
        outcome.result = Class::kDetected;
    }
    else if (is_changed && !is_back)
    {
        outcome.result = Class::kSafeOther;
    }
    else
    {
        outcome.result = (is_changed || !watch_.HasSentTheSame(looked_)) ? Class::kBenign : Class::kMasked;
    }
    return outcome;
}

void Course::Inject(const Trial& trial, const Space& space)
{
    if (IsOfFrames(trial.target))
    {
        stage_.Hit().Arm(trial.hit, space.Identifiers());
    }
    else if (trial.target == Target::kWrites)
    {
        Write(trial, space.Objects().at(trial.subject));
    }
    else if (trial.target == Target::kSlaves)
    {
        InjectIntoSlave(trial, stage_.Slaves().at(trial.subject));
    }
    else if (trial.target == Target::kMemory)
    {
        InjectIntoMemory(trial, space);
    }
    else if (trial.target == Target::kClocks)
    {
        InjectIntoClock(trial);
    }
    else
    {
        InjectIntoManager(trial, *stage_.Managers().at(trial.subject));
    }
}

void Course::InjectIntoMemory(const Trial& trial, const Space& space)
{
    const ManagerMember& member = space.Members().at(trial.subject);
    FlipIn(*stage_.Managers().at(member.manager), member.name, Space::ByteOf(trial), trial.variant % kByteBits);
}

void Course::InjectIntoClock(const Trial& trial)
{
    const CounterFault what = Space::ClockFaultOf(trial);
    stage_.Managers()
        .at(trial.subject)
        ->Disturb({trial.at, what.rate_ppm, Nanoseconds{what.jump_us} * runtime::kNanosecondsPerMicrosecond});
}

void Course::Write(const Trial& trial, const WrittenObject& object)
{
    constexpr std::uint8_t kUnused = 4U;
    const Slave& slave = stage_.Slaves().at(object.slave);
    const std::uint32_t value =
        stage_.ValueIn(slave, object.expected.object).value_or(object.expected.value) ^ (1U << trial.variant);
    if (trial.fault == Fault::kStored)
    {
        watch_.NoteStored();
        stage_.World().At(slave.index).Firmware().Store(object.expected.object, value);
        return;
    }
    CanFrame frame{};
    frame.kind = FrameKind::kData;
    frame.port = CanPortId::kFirst;
    frame.identifier = 0x600U + slave.node_id;
    frame.length_bytes = kMaxPayloadBytes;
    frame.data[0] = static_cast<std::uint8_t>(0x23U | (std::uint32_t{kUnused} - object.expected.size) << 2U);
    frame.data[1] = static_cast<std::uint8_t>(object.expected.object.index & 0xFFU);
    frame.data[2] = static_cast<std::uint8_t>(object.expected.object.index >> 8U);
    frame.data[3] = object.expected.object.sub;
    for (std::uint8_t byte = 0U; byte < object.expected.size; ++byte)
    {
        frame.data[4U + byte] = static_cast<std::uint8_t>((value >> (byte * 8U)) & 0xFFU);
    }
    stage_.Somebody().Send(frame);
}

void Course::InjectIntoSlave(const Trial& trial, const Slave& slave)
{
    simulator::Node& node = stage_.World().At(slave.index);
    if (trial.fault == Fault::kExchanged)
    {
        constexpr std::uint32_t kOther = 0x5A5A0000U;
        node.Firmware().SetSerial(slave.serial ^ kOther);
        watch_.NoteExchanged(slave);
    }
    if (node.HasSupply())
    {
        node.PowerOff();
    }
    if (trial.fault == Fault::kExchanged)
    {
        node.PowerOn();
    }
    if (trial.fault == Fault::kRestarted)
    {
        later_at_ = trial.at + Space::AwayOf(trial);
        later_ = [&node]() { node.PowerOn(); };
    }
}

void Course::InjectIntoManager(const Trial& trial, simulator::SimulatedManager& manager)
{
    simulator::Action action{};
    action.at = trial.at;
    action.kind =
        (trial.fault == Fault::kOffBus) ? simulator::ActionKind::kNoController : simulator::ActionKind::kKillManager;
    manager.Plan(action);
    if (trial.fault == Fault::kOffBus)
    {
        action.at = trial.at + Space::AwayOf(trial);
        action.kind = simulator::ActionKind::kBusBack;
        manager.Plan(action);
        later_at_ = action.at;
        later_ = []() {};
    }
    if (trial.fault == Fault::kBack)
    {
        later_at_ = trial.at + Space::AwayOf(trial);
        later_ = [this, &manager]()
        {
            watch_.NoteNewManager(manager.BusNode());
            manager.SwitchOn(stage_.World().Now());
        };
    }
}
} // namespace counterpoint::campaign::managed
