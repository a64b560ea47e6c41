// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/managed/watch.hpp"

#include <algorithm>

namespace counterpoint::campaign::managed
{
namespace
{
constexpr Nanoseconds kMs = runtime::kNanosecondsPerMillisecond;
constexpr Nanoseconds kGrace = 3 * kMs;      ///< Three frames and a cycle: what was under way is nobody's fault.
constexpr Nanoseconds kObeyed = 20 * kMs;    ///< A command is followed within this.
constexpr Nanoseconds kLookAtAll = 50 * kMs; ///< Whole configurations are read so often.
constexpr Nanoseconds kSilence = 1000 * kMs; ///< For so long neither hears the other: the bus is not there.
constexpr std::uint32_t kLowest7 = 0x7FU;
constexpr std::uint32_t kAnswers = 0x580U;
constexpr std::uint32_t kRequests = 0x600U;
constexpr std::uint32_t kEmergencies = 0x80U;
constexpr std::uint32_t kLife = 0x700U;
constexpr std::uint8_t kUpload = 0x40U;
constexpr std::uint8_t kStart = 0x01U;
constexpr std::uint16_t kGfc = 0x1300U;

[[nodiscard]] std::uint32_t NumberIn(const ObjectAddress& object)
{
    return (std::uint32_t{object.index} << 8U) | object.sub;
}

/// Value of an expedited upload with its length, which is 4 where the answer tells none; 0 bytes: it is none.
[[nodiscard]] ExpectedValue UploadIn(const CanFrame& frame)
{
    constexpr std::uint8_t kCommandAndExpedited = 0xE2U;
    constexpr std::uint8_t kHasSize = 1U;
    ExpectedValue upload{};
    if (frame.length_bytes != kMaxPayloadBytes || (frame.data[0] & kCommandAndExpedited) != (kUpload | 2U))
    {
        return upload;
    }
    const std::uint8_t unused = static_cast<std::uint8_t>((frame.data[0] >> 2U) & 3U);
    upload.object = {static_cast<std::uint16_t>(frame.data[1] | (frame.data[2] << 8U)), frame.data[3]};
    upload.size = static_cast<std::uint8_t>(((frame.data[0] & kHasSize) != 0U) ? 4U - unused : 4U);
    for (std::uint8_t byte = 0U; byte < upload.size; ++byte)
    {
        upload.value |= std::uint32_t{frame.data[4U + byte]} << (byte * 8U);
    }
    return upload;
}

[[nodiscard]] std::uint64_t HashOf(std::uint64_t hash, const CanFrame& frame)
{
    const auto add = [&hash](const std::uint64_t value) { hash = (hash ^ value) * 0x100000001B3U; };
    add(frame.identifier);
    add(static_cast<std::uint64_t>(frame.kind));
    add(frame.length_bytes);
    for (std::uint8_t byte = 0U; byte < frame.length_bytes; ++byte)
    {
        add(frame.data[byte]);
    }
    return hash;
}

[[nodiscard]] bool IsSame(const RecordedFrame& is, const RecordedFrame& was)
{
    return is.start == was.start && is.sender == was.sender && is.frame.identifier == was.frame.identifier &&
           is.frame.kind == was.frame.kind && is.frame.length_bytes == was.frame.length_bytes &&
           std::equal(is.frame.data, is.frame.data + is.frame.length_bytes, was.frame.data);
}

void Clear(Reading& reading, const Nanoseconds now)
{
    if (now - reading.cleared > kGrace)
    {
        reading.before = reading.now;
    }
    reading.cleared = now;
    reading.now.clear();
}

[[nodiscard]] const Answer* AnswerFor(const Reading& reading, const std::uint32_t key, const Nanoseconds now)
{
    const bool is_under_way = now - reading.cleared <= kGrace;
    const auto found = is_under_way ? reading.before.find(key) : reading.now.find(key);
    return (found == (is_under_way ? reading.before.end() : reading.now.end())) ? nullptr : &found->second;
}

/// What it sends without fault, and its other services.
[[nodiscard]] bool MaySend(const Stage& stage, const Reference& reference, const std::uint32_t identifier,
                           const host::NodeIndex sender)
{
    const auto known = reference.identifiers.find(sender);
    if (known != reference.identifiers.end() && known->second.count(identifier) != 0U)
    {
        return true;
    }
    const std::uint32_t service = identifier & ~kLowest7;
    const bool is_answer = service == kEmergencies || service == kAnswers || service == kLife;
    if (const Slave* const slave = stage.SlaveAt(sender))
    {
        return is_answer && (identifier & kLowest7) == slave->node_id;
    }
    return is_answer || service == kRequests || service == 0U;
}

/// Any object that differs, 1300h last; 0: none.
[[nodiscard]] std::uint16_t OtherIn(Stage& stage, const Slave& slave)
{
    std::uint16_t other = 0U;
    for (const ExpectedValue& expected : slave.expected)
    {
        const std::uint16_t index = expected.object.index;
        const bool is_better = other == 0U || index != kGfc;
        const std::optional<std::uint32_t> value =
            is_better ? stage.ValueIn(slave, expected.object) : std::optional<std::uint32_t>();
        other = (value && *value != expected.value) ? index : other;
    }
    return other;
}
} // namespace

Watch::Watch(Stage& stage, const Plan& plan)
    : stage_(stage), plan_(plan), devices_(stage), runs_(stage.Slaves().size(), false),
      started_(stage.Slaves().size(), -kObeyed), other_since_(stage.Slaves().size(), -1),
      reached_(stage.Slaves().size(), 0), heard_(stage.Slaves().size() + 1U, 0)
{
    stage.World().Bus().Install(*this);
}

/// A manager whose memory or clock is wrong is no longer asked for its rules: a safety device is judged as it is.
void Watch::Tell(const Wrong wrong)
{
    const bool is_rule = wrong == Wrong::kStartOfAll || wrong == Wrong::kTwoMasters || wrong == Wrong::kIdentifier;
    if (is_manager_hit_ && is_rule)
    {
        limit_ = (limit_ == Limit::kNothing) ? Limit::kOwnRule : limit_;
    }
    else if (wrong_ == Wrong::kNothing)
    {
        wrong_ = wrong;
        found_at_ = stage_.World().Now();
    }
}

void Watch::OnReception(const host::FrameOnBus& sent, const host::NodeIndex receiver, host::ReceptionList& receptions)
{
    if (!receptions.IsEmpty())
    {
        Meet(sent.sender, receiver);
    }
    if (stage_.ManagerAt(receiver) == nullptr)
    {
        return;
    }
    for (const host::Reception& reception : receptions)
    {
        const Coming coming{stage_.World().Now() + reception.delay, reception.frame, receiver};
        (reception.delay == 0) ? Take(coming) : coming_.push_back(coming);
    }
}

/// A device gets something of a manager, or a manager of a device.
void Watch::Meet(const host::NodeIndex sender, const host::NodeIndex receiver)
{
    for (std::size_t place = 0U; place < stage_.Slaves().size(); ++place)
    {
        const host::NodeIndex node = stage_.Slaves()[place].bus_node;
        if (node == receiver && stage_.ManagerAt(sender) != nullptr)
        {
            reached_[place] = stage_.World().Now();
        }
        if (node == sender && stage_.ManagerAt(receiver) != nullptr)
        {
            heard_[place] = stage_.World().Now();
        }
    }
    if (stage_.ManagerAt(sender) != nullptr && stage_.ManagerAt(receiver) != nullptr)
    {
        heard_.back() = stage_.World().Now();
    }
}

/// A manager gets a frame.
void Watch::Take(const Coming& coming)
{
    const CanFrame& frame = coming.frame;
    const auto node = static_cast<std::uint8_t>(frame.identifier & kLowest7);
    if (frame.kind != FrameKind::kData || node == 0U)
    {
        return;
    }
    const std::uint32_t service = frame.identifier & ~kLowest7;
    if (service == kLife && frame.length_bytes == 1U && (frame.data[0] & kLowest7) == 0U)
    {
        Reading& reading = readings_[{coming.receiver, node}];
        Clear(reading, coming.at);
        reading.booted = coming.at;
    }
    if (service != kAnswers)
    {
        return;
    }
    for (const Slave& slave : stage_.Slaves())
    {
        if (slave.node_id == node)
        {
            OnAnswer(frame, slave, readings_[{coming.receiver, node}], coming.at);
        }
    }
}

/// The first answer to a request counts, and whatever else tells what is expected: two managers may ask the same. What
/// is wrong and nobody waits for tells nothing.
void Watch::OnAnswer(const CanFrame& frame, const Slave& slave, Reading& reading, const Nanoseconds now) const
{
    const ExpectedValue upload = UploadIn(frame);
    const bool is_asked = upload.size != 0U && reading.asked == NumberIn(upload.object);
    reading.asked = is_asked ? 0U : reading.asked;
    for (const ExpectedValue& expected : slave.expected)
    {
        const bool is_right = upload.size == expected.size && upload.value == expected.value;
        if (upload.size != 0U && NumberIn(expected.object) == NumberIn(upload.object) && (is_right || is_asked))
        {
            reading.now[NumberIn(upload.object)] = {is_right, now};
        }
    }
}

void Watch::NoteNewManager(const host::NodeIndex bus_node)
{
    for (auto& [key, reading] : readings_)
    {
        reading = (key.first == bus_node) ? Reading{} : reading;
    }
}

void Watch::OnConfirmation(const host::FrameOnBus& sent, host::ReceptionList& /*receptions*/)
{
    const CanFrame& frame = sent.frame;
    if (sent.sender == stage_.Somebody().BusNode())
    {
        return;
    }
    frames_.push_back({sent.start, stage_.World().Now(), frame, sent.sender});
    if (reference_ == nullptr)
    {
        std::uint64_t& hash = made_.hashes[sent.sender];
        hash = HashOf(hash, frame);
        made_.identifiers[sent.sender].insert(frame.identifier);
    }
    else if (!MaySend(stage_, *reference_, frame.identifier, sent.sender))
    {
        Tell(Wrong::kIdentifier);
    }
    if (stage_.ManagerAt(sent.sender) != nullptr)
    {
        OnOwnFrame(frame, sent.sender);
    }
}

/// A manager sends.
void Watch::OnOwnFrame(const CanFrame& frame, const host::NodeIndex sender)
{
    const auto node = static_cast<std::uint8_t>(frame.identifier & kLowest7);
    if (frame.identifier == 0U && frame.length_bytes >= 2U)
    {
        OnCommand(frame, sender);
    }
    else if ((frame.identifier & ~kLowest7) == kRequests && frame.length_bytes == kMaxPayloadBytes)
    {
        const bool is_upload = frame.data[0] == kUpload;
        const ObjectAddress object{static_cast<std::uint16_t>(frame.data[1] | (frame.data[2] << 8U)), frame.data[3]};
        readings_[{sender, node}].asked = is_upload ? NumberIn(object) : 0U;
    }
}

/// A manager commands.
void Watch::OnCommand(const CanFrame& frame, const host::NodeIndex sender)
{
    const Nanoseconds now = stage_.World().Now();
    for (std::size_t place = 0U; place < stage_.Slaves().size(); ++place)
    {
        const Slave& slave = stage_.Slaves()[place];
        if (frame.data[1] != 0U && frame.data[1] != slave.node_id)
        {
            continue;
        }
        if (frame.data[0] != kStart)
        {
            Clear(readings_[{sender, slave.node_id}], now);
            continue;
        }
        started_[place] = now;
        if (slave.expected.empty())
        {
            continue;
        }
        if (frame.data[1] == 0U)
        {
            Tell(Wrong::kStartOfAll);
        }
        // A start of all is one of each, too, where the devices alone count.
        if (frame.data[1] != 0U || is_manager_hit_)
        {
            TellOf(slave, WrongOfStart(slave, sender));
        }
    }
}

/// A safety slave is started.
Wrong Watch::WrongOfStart(const Slave& slave, const host::NodeIndex sender)
{
    const Nanoseconds now = stage_.World().Now();
    const Reading& reading = readings_[{sender, slave.node_id}];
    Wrong wrong = Wrong::kNothing;
    for (const ExpectedValue& expected : slave.expected)
    {
        const Answer* const answer = AnswerFor(reading, NumberIn(expected.object), now);
        if (answer == nullptr || !answer->is_right)
        {
            return Wrong::kUnverified;
        }
        const std::optional<std::uint32_t> value = stage_.ValueIn(slave, expected.object);
        if (!value || *value == expected.value)
        {
            continue;
        }
        if (is_stored_ && answer->at <= at_ + kGrace)
        {
            limit_ = Limit::kChangedBehind;
        }
        else if (now - at_ > kGrace)
        {
            wrong = Wrong::kConfiguration;
        }
    }
    const bool is_other =
        exchanged_ == &slave && slave.serial != 0U && reading.booted > at_ && now - reading.booted > kGrace;
    return (wrong == Wrong::kNothing && is_other) ? Wrong::kIdentity : wrong;
}

/// Of a manager that is hit counts what its slave is.
void Watch::TellOf(const Slave& slave, const Wrong wrong)
{
    if (wrong == Wrong::kNothing)
    {
        return;
    }
    if (!is_manager_hit_)
    {
        Tell(wrong);
    }
    else if (OtherIn(stage_, slave) == 0U)
    {
        limit_ = (limit_ == Limit::kNothing) ? Limit::kOwnRule : limit_;
    }
    else if (devices_.IsHeldByItself(slave))
    {
        limit_ = Limit::kOwnGate;
    }
    else
    {
        Tell(wrong);
    }
}

void Watch::TellIfAny(const Wrong wrong)
{
    if (wrong != Wrong::kNothing)
    {
        Tell(wrong);
    }
}

void Watch::Look(const Nanoseconds now)
{
    for (std::size_t index = 0U; index < coming_.size();)
    {
        if (coming_[index].at > now)
        {
            ++index;
            continue;
        }
        Take(coming_[index]);
        coming_.erase(coming_.begin() + static_cast<std::ptrdiff_t>(index));
    }
    LookAtStates(now);
    LookAtMasters(now);
    TellIfAny(devices_.LookAtOutputs(reference_, made_, now));
    devices_.Draw(picture_, now);
    if (reference_ != nullptr)
    {
        TellIfAny(devices_.LookAtValues(picture_, *reference_, now));
    }
    if (reference_ == nullptr)
    {
        made_.pictures.push_back(picture_);
    }
}

void Watch::LookAtStates(const Nanoseconds now)
{
    for (std::size_t place = 0U; place < stage_.Slaves().size(); ++place)
    {
        const Slave& slave = stage_.Slaves()[place];
        const bool runs = stage_.World().At(slave.index).State() == cia301::NodeState::kOperational;
        const bool begins = runs && !runs_[place];
        runs_[place] = runs;
        const std::size_t ms = static_cast<std::size_t>(now / kMs);
        const bool ran_without = reference_ != nullptr && ms < reference_->pictures.size() &&
                                 (reference_->pictures[ms].words[place] & 0xFFU) ==
                                     static_cast<std::uint32_t>(cia301::NodeState::kOperational);
        if (begins && reference_ != nullptr && !ran_without && now - started_[place] > kObeyed &&
            limit_ == Limit::kNothing)
        {
            limit_ = Limit::kForeignStart;
        }
        if (!runs)
        {
            other_since_[place] = -1;
            continue;
        }
        if (now % kLookAtAll != 0 || slave.expected.empty())
        {
            continue;
        }
        const std::uint16_t other = OtherIn(stage_, slave);
        if (other == 0U)
        {
            other_since_[place] = -1;
        }
        else if (other == kGfc && started_[place] >= 0 && started_[place] < at_)
        {
            limit_ = Limit::kGfcBehind;
        }
        else if (is_stored_ && started_[place] < at_)
        {
            limit_ = Limit::kChangedBehind; // While it ran.
        }
        else if (other_since_[place] < 0)
        {
            other_since_[place] = now;
        }
        else if (now - std::min(reached_[place], heard_[place]) > kSilence)
        {
            limit_ = Limit::kApart;
        }
        else if (now - other_since_[place] > plan_.stop_within && limit_ != Limit::kChangedBehind)
        {
            TellOf(slave, Wrong::kRunsOn);
        }
    }
}

std::size_t Watch::ActiveManagers(const Nanoseconds now)
{
    std::size_t active = 0U;
    for (std::size_t index = 0U; index < stage_.Managers().size(); ++index)
    {
        const simulator::SimulatedManager& manager = *stage_.Managers()[index];
        if (!manager.HasSupply() || !stage_.World().Bus().IsOnBus(manager.BusNode()))
        {
            continue;
        }
        stage_.Guards()[index]->Look(now, [&manager, &active]()
                                     { active += manager.Station()->Assembly().Core().IsActive() ? 1U : 0U; });
    }
    return active;
}

void Watch::LookAtMasters(const Nanoseconds now)
{
    const std::size_t active = ActiveManagers(now);
    if (active < 2U)
    {
        two_since_ = -1;
    }
    else if (two_since_ < 0)
    {
        two_since_ = now;
    }
    else if (now - heard_.back() > kSilence)
    {
        limit_ = Limit::kApart;
    }
    else if (now - two_since_ > plan_.masters_within)
    {
        Tell(Wrong::kTwoMasters);
    }
}

bool Watch::IsWaiting() const noexcept
{
    return two_since_ >= 0 || !coming_.empty() ||
           std::any_of(other_since_.begin(), other_since_.end(), [](const Nanoseconds since) { return since >= 0; });
}

bool Watch::HasSentTheSame(const Nanoseconds now) const
{
    const std::vector<RecordedFrame>& all = reference_->frames;
    const bool is_more = frames_.size() > all.size();
    const bool is_one_missing = frames_.size() < all.size() && all[frames_.size()].end <= now;
    return !is_more && !is_one_missing && std::equal(frames_.begin(), frames_.end(), all.begin(), IsSame);
}

Reference Watch::TakeReference()
{
    made_.frames = frames_;
    return std::move(made_);
}
} // namespace counterpoint::campaign::managed
