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
constexpr std::uint32_t kNormalIdentifier = 0x105U;
constexpr std::uint32_t kInverseIdentifier = 0x106U;

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

} // namespace

Judge::Judge(const std::vector<Seen>& golden, const SentValues& values, const std::uint32_t from)
    : golden_{golden}, values_{values}, from_{from}, now_{from}
{
}

const char* NameOf(const Class kind)
{
    constexpr const char* kNames[] = {"masked", "benign", "latent", "detected", "crash, ends safe", "silent"};
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
    if ((suspected_[which] > kGrace) || (was_wrong && (!is_wrong) && mechanism_.empty()))
    {
        Fail(what);
    }
}

// Whether the undisturbed device had this value released within the last steps.
bool Judge::WasReleased(const std::uint32_t consumer, const std::uint32_t value, const std::uint32_t steps) const
{
    const std::uint32_t first = (now_ > steps) ? (now_ - steps) : 0U;
    for (std::uint32_t step = first; step <= now_; ++step)
    {
        if (golden_[step].objects[consumer].normal == value)
        {
            return true;
        }
    }
    return false;
}

void Judge::FindMechanism(const Seen& seen)
{
    const Seen& golden = golden_[now_];
    if ((seen.device_fault != 0U) && (seen.device_fault != golden.device_fault))
    {
        safe_since_ = 0U;
        is_level_2_ = true;
        Detect("device fault " + std::to_string(seen.device_fault));
    }
    if ((!seen.is_answered) || (seen.answer != golden.answer))
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
    }
}

void Judge::JudgePins(const Seen& seen)
{
    const std::uint32_t first = (now_ > kGrace) ? (now_ - kGrace) : 0U;
    std::uint32_t allowed = 0U;
    for (std::uint32_t step = first; step <= now_; ++step)
    {
        allowed |= golden_[step].pins;
    }
    for (std::uint32_t i = 0U; i < kConsumers; ++i)
    {
        Suspect((((seen.pins & ~allowed) >> i) & 1U) != 0U, i, "output open without leave");
    }
}

void Judge::JudgeObjects(const Seen& seen)
{
    for (std::uint32_t i = 0U; i < kConsumers; ++i)
    {
        const ObjectPair& now = seen.objects[i];
        const ObjectPair& golden = golden_[now_].objects[i];
        const bool is_open = ((seen.pins >> i) & 1U) != 0U;
        const bool is_other = (now.normal != 0U) && (now.normal == ~now.inverse) && (now.normal != golden.normal);
        const bool was_sent = std::find(values_[i].begin(), values_[i].end(), now.normal) != values_[i].end();
        // A value that nobody sent. Whoever looks at the pair alone does not see it.
        Suspect(is_other && (!was_sent), kConsumers + i,
                is_open ? "wrong data released" : "wrong data in the objects, output closed");
        // A lost pair is told by SCT.
        const bool may_hold = (golden.normal != 0U) && WasReleased(i, now.normal, kSctSteps + 2U);
        stale_[i] = (is_other && was_sent) ? (stale_[i] + 1U) : 0U;
        if (stale_[i] > (may_hold ? (kSctSteps + 2U) : kGrace))
        {
            const std::string what = (golden.normal == 0U) ? "released without leave" : "old data stay released";
            Fail(what + (is_open ? "" : ", output closed"));
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
        if (frame.identifier == kNormalIdentifier)
        {
            sent_normal_ = frame.first;
        }
        bool is_known = false;
        for (const Seen& step : golden_)
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
    is_different_ = is_different_ || (!AreSame(seen, golden_[now_]));
    FindMechanism(seen);
    JudgeFrames(seen);
    JudgePins(seen);
    JudgeObjects(seen);
    ++now_;
    // The watchdog ends what happens next; behind pins that are cut off the firmware calls nothing any more.
    const bool is_ended = (mechanism_ == "watchdog") || (seen.is_cut_off && (seen.pins == 0U));
    const bool is_safe = (seen.pins == 0U) && (seen.objects[0].normal == 0U) && (seen.objects[1].normal == 0U);
    safe_since_ = is_safe ? (safe_since_ + 1U) : 0U;
    return (!wrong_.empty()) || is_ended || (is_level_2_ && (safe_since_ > (2U * kGrace)));
}

Verdict Judge::Conclude(const bool is_equal) const
{
    // What was suspected when the script ended and nothing told it.
    const bool is_open =
        std::any_of(std::begin(suspected_), std::end(suspected_), [](std::uint32_t n) { return n != 0U; });
    if (wrong_.empty() && mechanism_.empty() && is_open)
    {
        return {Class::kSilent, "wrong up to the end of the script", now_ - from_};
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
    if (is_different_)
    {
        return {Class::kBenign, is_equal ? "equal again" : "different", 0U};
    }
    return {is_equal ? Class::kMasked : Class::kLatent, "", 0U};
}

} // namespace counterpoint::injection
