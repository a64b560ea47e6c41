// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/injection/judge.hpp"

#include "verification/injection/script.hpp"

#include <algorithm>
#include <iterator>

namespace counterpoint::injection
{
namespace
{

/// An output may be open this many steps longer than without the fault: the discrepancy time and the cycle that sees
/// it.
constexpr std::uint32_t kGrace = 3U;
constexpr std::uint32_t kConsumers = 2U;
constexpr std::uint32_t kInterlocked = 0U; // The consumer that opens behind an acknowledge alone.
constexpr std::uint32_t kNormalIdentifier = 0x105U;
constexpr std::uint32_t kInverseIdentifier = 0x106U;

} // namespace

bool AreSame(const Seen& first, const Seen& second)
{
    bool is_same = (first.pins == second.pins) && (first.device_fault == second.device_fault) &&
                   (first.refused == second.refused) && (first.answer == second.answer) &&
                   (first.sent == second.sent) && (first.events == second.events);
    for (std::uint32_t i = 0U; i < kConsumers; ++i)
    {
        is_same = is_same && (first.objects[i].normal == second.objects[i].normal) &&
                  (first.objects[i].inverse == second.objects[i].inverse);
    }
    return is_same;
}

Judge::Judge(const Undisturbed& golden, const std::uint32_t from) : golden_{golden}, from_{from}, now_{from}
{
    const std::uint32_t pins = (from == 0U) ? 0U : golden.steps[from - 1U].pins;
    for (std::uint32_t i = 0U; i < kConsumers; ++i)
    {
        was_closed_[i] = ((pins >> i) & 1U) == 0U;
    }
}

const char* NameOf(const Class kind)
{
    constexpr const char* kNames[] = {"masked",          "latent",   "benign",           "lost frame",
                                      "pair check only", "detected", "crash, ends safe", "silent"};
    return kNames[static_cast<std::size_t>(kind)];
}

void Judge::Detect(const std::string& mechanism)
{
    if (mechanism_.empty())
    {
        mechanism_ = mechanism;
        detected_ = now_ - from_;
    }
}

void Judge::Fail(const std::string& what)
{
    if (wrong_.empty())
    {
        wrong_ = what;
        wrong_at_ = now_ - from_;
    }
}

// What lasts, or ends without having been told, is wrong; what is told in time is detected.
void Judge::Suspect(const bool is_wrong, const std::uint32_t which, const std::string& what)
{
    const bool was_wrong = suspected_[which] != 0U;
    suspected_[which] = is_wrong ? (suspected_[which] + 1U) : 0U;
    if (is_wrong && (!was_wrong))
    {
        suspicions_[which] = what;
    }
    if ((suspected_[which] > kGrace) || (was_wrong && (!is_wrong) && mechanism_.empty()))
    {
        Fail(suspicions_[which]);
    }
}

void Judge::SkipTo(const std::uint32_t step)
{
    for (std::uint32_t i = 0U; i < kSuspicions; ++i)
    {
        Suspect(false, i, "");
    }
    for (std::uint32_t i = 0U; i < kConsumers; ++i)
    {
        stale_[i] = 0U;
        was_closed_[i] = ((golden_.steps[step - 1U].pins >> i) & 1U) == 0U;
    }
    now_ = step;
}

bool Judge::IsOperational() const
{
    const std::uint32_t first = (now_ > kGrace) ? (now_ - kGrace) : 0U;
    return std::find(golden_.is_operational.begin() + first, golden_.is_operational.begin() + now_ + 1, true) !=
           (golden_.is_operational.begin() + now_ + 1);
}

// What an output that is open has not had.
const char* Judge::LeaveMissing(const std::uint32_t consumer) const
{
    if (!golden_.is_operational[now_])
    {
        return "NMT command missed";
    }
    return ((consumer == kInterlocked) && was_closed_[consumer]) ? "restart without acknowledge"
                                                                 : "output open without leave";
}

// Whether the undisturbed device had this value released within the last steps.
bool Judge::WasReleased(const std::uint32_t consumer, const std::uint32_t value, const std::uint32_t steps) const
{
    const std::uint32_t first = (now_ > steps) ? (now_ - steps) : 0U;
    for (std::uint32_t step = first; step <= now_; ++step)
    {
        if (golden_.steps[step].objects[consumer].normal == value)
        {
            return true;
        }
    }
    return false;
}

void Judge::FindMechanism(const Seen& seen)
{
    const Seen& golden = golden_.steps[now_];
    if ((seen.device_fault != 0U) && (seen.device_fault != golden.device_fault))
    {
        safe_since_ = 0U;
        is_level_2_ = true;
        Detect("device fault " + std::to_string(seen.device_fault));
    }
    if ((seen.is_answered != golden.is_answered) || (seen.answer != golden.answer))
    {
        Detect(seen.is_cut_off ? "pins cut off" : "watchdog");
    }
    if (seen.is_cut_off)
    {
        Detect("pins cut off");
    }
    for (const std::uint32_t event : seen.events)
    {
        const bool is_error = event >= 0x1000000U;
        const bool is_expected = std::find(golden.events.begin(), golden.events.end(), event) != golden.events.end();
        if (is_error && (!is_expected))
        {
            Detect("SRDO cause " + std::to_string((event >> 16U) & 0xFFU));
        }
        if (((event & 0xFFFF0000U) == 0x50000U) && (!is_expected))
        {
            Detect("configuration invalid");
        }
        if (((event & 0xFFFF0000U) == 0x80000U) && (!is_expected))
        {
            is_refused_ = true;
            Detect("signature compared by who configures");
        }
    }
    if (seen.refused != golden.refused)
    {
        is_refused_ = true;
        Detect("refused to who configures");
    }
}

// What is seen by those who work with the device, and by no mechanism of its own.
void Judge::FindOthers(const Seen& seen)
{
    const Seen& golden = golden_.steps[now_];
    for (std::uint32_t i = 0U; i < kConsumers; ++i)
    {
        is_pair_wrong_ = is_pair_wrong_ || (seen.objects[i].normal != ~seen.objects[i].inverse);
    }
    is_frame_lost_ = is_frame_lost_ || !(seen.sent == golden.sent);
    for (const std::uint32_t event : golden.events)
    {
        const bool is_frame = ((event & 0xFFFF0000U) == 0x10000U) || (event == 0x30000U);
        const bool is_told = std::find(seen.events.begin(), seen.events.end(), event) != seen.events.end();
        is_frame_lost_ = is_frame_lost_ || (is_frame && (!is_told));
    }
}

void Judge::JudgePins(const Seen& seen)
{
    const std::uint32_t first = (now_ > kGrace) ? (now_ - kGrace) : 0U;
    std::uint32_t allowed = 0U;
    for (std::uint32_t step = first; step <= now_; ++step)
    {
        allowed |= golden_.steps[step].pins;
    }
    for (std::uint32_t i = 0U; i < kConsumers; ++i)
    {
        Suspect((((seen.pins & ~allowed) >> i) & 1U) != 0U, i, LeaveMissing(i));
        const bool may_open = ((golden_.steps[now_].pins >> i) & 1U) != 0U;
        was_closed_[i] = (!may_open) && (was_closed_[i] || (((seen.pins >> i) & 1U) == 0U));
    }
}

void Judge::JudgeObjects(const Seen& seen)
{
    for (std::uint32_t i = 0U; i < kConsumers; ++i)
    {
        const ObjectPair& now = seen.objects[i];
        const ObjectPair& golden = golden_.steps[now_].objects[i];
        const bool is_open = ((seen.pins >> i) & 1U) != 0U;
        const bool is_other = (now.normal != 0U) && (now.normal == ~now.inverse) && (now.normal != golden.normal);
        const bool was_sent =
            std::find(golden_.values[i].begin(), golden_.values[i].end(), now.normal) != golden_.values[i].end();
        // A value that nobody sent. Whoever looks at the pair alone does not see it.
        Suspect(is_other && (!was_sent), kConsumers + i,
                is_open ? "wrong data released" : "wrong data in the objects, output closed");
        // A lost pair is told by SCT.
        const bool may_hold = (golden.normal != 0U) && WasReleased(i, now.normal, kSctSteps + 2U);
        stale_[i] = (is_other && was_sent) ? (stale_[i] + 1U) : 0U;
        if (stale_[i] > (may_hold ? (kSctSteps + 2U) : kGrace))
        {
            const std::string missing = is_open ? LeaveMissing(i) : "released without leave, output closed";
            const std::string old = is_open ? "old data stay released" : "old data stay released, output closed";
            Fail((golden.normal == 0U) ? missing : old);
        }
    }
}

void Judge::JudgeFrames(const Seen& seen)
{
    for (const SentFrame& frame : seen.sent)
    {
        const bool is_gfc = frame.identifier == 1U;
        if ((frame.identifier != kNormalIdentifier) && (frame.identifier != kInverseIdentifier) && (!is_gfc))
        {
            Fail("frame under a foreign identifier");
        }
        if ((!is_gfc) && (!IsOperational()))
        {
            Fail("NMT command missed");
        }
        if (frame.identifier == kNormalIdentifier)
        {
            sent_normal_ = frame.first;
        }
        bool is_known = false;
        for (const Seen& step : golden_.steps)
        {
            is_known = is_known || (std::find(step.sent.begin(), step.sent.end(), frame) != step.sent.end());
        }
        // A frame that is wrong alone is told by its consumer.
        if ((frame.identifier == kInverseIdentifier) && (!is_known) && (frame.first == ~sent_normal_))
        {
            Fail("wrong pair sent");
        }
    }
}

bool Judge::See(const Seen& seen)
{
    if (seen.end != StepEnd::kDone)
    {
        Detect((seen.end == StepEnd::kException) ? "exception" : "runaway, watchdog");
        JudgeFrames(seen);
        return true;
    }
    is_different_ = is_different_ || (!AreSame(seen, golden_.steps[now_]));
    FindMechanism(seen);
    FindOthers(seen);
    JudgeFrames(seen);
    JudgePins(seen);
    JudgeObjects(seen);
    ++now_;
    // The watchdog ends what happens next; behind pins that are cut off the firmware calls nothing any more.
    const bool is_ended = is_refused_ || (mechanism_ == "watchdog") || (seen.is_cut_off && (seen.pins == 0U));
    const bool is_safe = (seen.pins == 0U) && (seen.objects[0].normal == 0U) && (seen.objects[1].normal == 0U);
    safe_since_ = is_safe ? (safe_since_ + 1U) : 0U;
    return (!wrong_.empty()) || is_ended || (is_level_2_ && (safe_since_ > (2U * kGrace)));
}

Verdict Judge::Conclude(const bool is_equal) const
{
    // What was suspected when the script ended and nothing told it.
    const auto* const open =
        std::find_if(std::begin(suspected_), std::end(suspected_), [](std::uint32_t n) { return n != 0U; });
    if (wrong_.empty() && mechanism_.empty() && (open != std::end(suspected_)))
    {
        return {Class::kSilent, suspicions_[open - std::begin(suspected_)], now_ - from_};
    }
    const bool is_first = mechanism_.empty() || (wrong_at_ < detected_);
    const bool is_crash = (mechanism_ == "exception") || (mechanism_ == "runaway, watchdog");
    const bool is_after =
        (!mechanism_.empty()) && (wrong_at_ > (detected_ + kGrace)) && (!is_crash) && (mechanism_ != "watchdog");
    if ((!wrong_.empty()) && (is_first || is_after))
    {
        return {Class::kSilent, wrong_, wrong_at_};
    }
    if (!mechanism_.empty())
    {
        return {is_crash ? Class::kCrash : Class::kDetected, mechanism_, detected_};
    }
    if (is_pair_wrong_ || is_frame_lost_)
    {
        return {is_pair_wrong_ ? Class::kPairCheck : Class::kLostFrame, "", 0U};
    }
    if (is_different_)
    {
        return {Class::kBenign, is_equal ? "equal again" : "different", 0U};
    }
    return {is_equal ? Class::kMasked : Class::kLatent, "", 0U};
}

void Judge::Add(Digest& to) const
{
    for (const std::string* const text :
         {&mechanism_, &wrong_, &suspicions_[0], &suspicions_[1], &suspicions_[2], &suspicions_[3]})
    {
        to.Add(reinterpret_cast<const std::uint8_t*>(text->data()), text->size());
    }
    const std::uint32_t age = now_ - from_;
    to.Add(now_);
    to.Add(mechanism_.empty() ? 0U : (age - detected_));
    to.Add(wrong_.empty() ? 0U : (age - wrong_at_));
    for (std::uint32_t i = 0U; i < kSuspicions; ++i)
    {
        to.Add(suspected_[i]);
    }
    for (std::uint32_t i = 0U; i < kConsumers; ++i)
    {
        to.Add((std::uint64_t{stale_[i]} << 1U) | (was_closed_[i] ? 1U : 0U));
    }
    to.Add((std::uint64_t{sent_normal_} << 32U) | safe_since_);
    to.Add((is_level_2_ ? 1U : 0U) | (is_different_ ? 2U : 0U) | (is_frame_lost_ ? 4U : 0U) |
           (is_pair_wrong_ ? 8U : 0U));
}

} // namespace counterpoint::injection
