// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/judge/run.hpp"

#include "simulator/scenario/checks.hpp"
#include "simulator/scenario/names.hpp"
#include "simulator/scenario/reader.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace counterpoint::simulator
{
namespace
{
constexpr Nanoseconds kStep = kNanosecondsPerSecond / 10;
constexpr std::size_t kMostRecorded = 500000U;

std::string LineOf(const Source& source, const std::string& what, const std::string& expected)
{
    return cia306::PlaceText(source.file, source.place) + ": warning: " + what + ", expected " + expected;
}

Scenario Seeded(Scenario scenario, const std::optional<std::uint64_t> seed)
{
    scenario.seed = seed.value_or(scenario.seed);
    return scenario;
}

Scenario Cut(Scenario scenario, const std::optional<Nanoseconds> until)
{
    RequireHappening(scenario);
    scenario.duration = until.value_or(scenario.duration);
    RequirePossible(scenario);
    for (Expectation& expectation : scenario.expectations)
    {
        expectation.at = (expectation.at == kNever) ? scenario.duration : expectation.at;
    }
    return scenario;
}

/// The other faults that had an effect until then, in the order of these.
std::vector<std::size_t> FaultsBefore(const Journal& journal, const std::size_t fault, const Nanoseconds at)
{
    std::vector<std::size_t> others;
    for (const Event& event : journal.Events())
    {
        const bool is_other = event.kind == EventKind::kFault && event.at <= at && event.value != fault;
        if (is_other && std::find(others.begin(), others.end(), event.value) == others.end())
        {
            others.push_back(event.value);
        }
    }
    return others;
}

/// A run, the same one without one of its faults, and with that fault alone.
struct Compared
{
    const Journal& whole;
    const Journal& without;
    const Journal& alone;
    std::size_t fault;

    /// What the run without the fault has behind this instant may follow from faults that came later.
    [[nodiscard]] Nanoseconds NextEffect(const Nanoseconds at) const
    {
        for (const Event& event : without.Events())
        {
            const bool is_later = event.kind == EventKind::kFault && event.at > at;
            const Nanoseconds here = is_later ? whole.EffectOf(event.value) : 0;
            if (is_later && (here < 0 || here > at))
            {
                return event.at;
            }
        }
        return std::numeric_limits<Nanoseconds>::max();
    }
    /// Whether the fault has its effect without the others, too. One that shows only together with another is found
    /// with it.
    [[nodiscard]] bool ShowsAlone() const
    {
        return alone.EffectOf(fault) >= 0;
    }
};

bool IsClosedByAnother(const Compared& runs, const Expectation& expectation, const Nanoseconds from,
                       const Nanoseconds closed)
{
    const Nanoseconds without = ClosedAt(runs.without, expectation, from);
    const Nanoseconds alone = ClosedAt(runs.alone, expectation, from);
    const bool is_no_later = without >= 0 && without <= closed && alone != closed;
    const bool is_shifted = without >= 0 && without < runs.NextEffect(closed) && alone < 0 && runs.ShowsAlone();
    return is_no_later || is_shifted;
}

bool IsSame(const Detection& one, const Detection& other)
{
    return one.IsLike(other) && one.at == other.at;
}

template <typename Condition> bool IsAny(const std::vector<Detection>& detections, const Condition& condition)
{
    return std::any_of(detections.begin(), detections.end(), condition);
}

/// The detections of the whole run that this fault brought.
class OwnDetections
{
  public:
    OwnDetections(const Compared& runs, const Expectation& expectation, const Nanoseconds from)
        : runs_(runs), all_(DetectionsOf(runs.whole, expectation, from)),
          without_(DetectionsOf(runs.without, expectation, from)), alone_(DetectionsOf(runs.alone, expectation, from))
    {
    }

    /// The first one; nobody's: there is none.
    [[nodiscard]] Detection First() const
    {
        const auto own =
            std::find_if(all_.begin(), all_.end(), [this](const Detection& found) { return IsOwn(found); });
        return (own == all_.end()) ? Detection{} : *own;
    }

  private:
    [[nodiscard]] bool IsOwn(const Detection& found) const
    {
        const bool comes_alone = IsAny(alone_, [&found](const Detection& other) { return IsSame(other, found); });
        const bool is_no_later =
            IsAny(without_, [&found](const Detection& other) { return other.IsLike(found) && other.at <= found.at; });
        return comes_alone || (!is_no_later && !IsShifted(found));
    }
    /// Whether this fault, which alone never brings it, only changed when or by whom another one was found: without it
    /// there is one that the whole run has not.
    [[nodiscard]] bool IsShifted(const Detection& found) const
    {
        const Nanoseconds next = runs_.NextEffect(found.at);
        const auto is_like = [&found](const Detection& other) { return other.IsLike(found); };
        const auto is_missing = [this, &found, next](const Detection& other)
        {
            const bool is_partner = other.at < next && (other.IsLike(found) || alone_.empty());
            return is_partner && !IsAny(all_, [&other](const Detection& here) { return IsSame(here, other); });
        };
        return runs_.ShowsAlone() && !IsAny(alone_, is_like) && IsAny(without_, is_missing);
    }

    const Compared& runs_;
    std::vector<Detection> all_;
    std::vector<Detection> without_;
    std::vector<Detection> alone_;
};
} // namespace

Run::Run(Scenario scenario, const std::optional<Nanoseconds> until, const bool keeps_all, const MakeManaged& make)
    : scenario_(std::move(scenario)), until_(until), whole_(scenario_.duration), make_(make), journal_(keeps_all),
      found_(scenario_.expectations.size())
{
    scenario_ = Cut(std::move(scenario_), until);
    if (!scenario_.managers.empty() && !make)
    {
        const Source& source = scenario_.managers.front().source;
        throw YamlError(source.file, source.place, "a manager", "a scenario without managers");
    }
    network_ = std::make_unique<Network>(scenario_, journal_);
    managed_ = scenario_.managers.empty() ? nullptr : make(scenario_, journal_, *network_);
}

Run::Run(const std::string& file, const std::optional<std::uint64_t> seed, const std::optional<Nanoseconds> until,
         const bool keeps_all, const MakeManaged& make, const std::string& profile)
    : Run(Seeded(ReadScenario(file, profile), seed), until, keeps_all, make)
{
}

void Run::RunTo(const Nanoseconds now)
{
    std::vector<Nanoseconds> looks{now};
    for (const Expectation& expectation : scenario_.expectations)
    {
        if (IsOfNetwork(expectation.kind) && expectation.at <= now)
        {
            looks.push_back(expectation.at);
        }
    }
    std::sort(looks.begin(), looks.end());
    for (const Nanoseconds look : looks)
    {
        network_->RunUntil(look + kNanosecondsPerMicrosecond - 1); // Managers count whole ones.
        LookAt(look);
    }
}

/// What is expected of managers and whole devices is asked of them at its time.
void Run::LookAt(const Nanoseconds now)
{
    for (std::size_t index = 0U; index < scenario_.expectations.size(); ++index)
    {
        const Expectation& expectation = scenario_.expectations[index];
        if (IsOfNetwork(expectation.kind) && expectation.at == now && found_[index].empty())
        {
            found_[index] = IsOfManager(expectation.kind) ? managed_->Found(expectation) : FoundAtDevice(expectation);
        }
    }
}

std::string Run::FoundAtDevice(const Expectation& expectation)
{
    const Node& device = network_->At(expectation.node);
    const bool is_of_output = expectation.kind == ExpectationKind::kOutput;
    if (!device.HasSupply())
    {
        return is_of_output ? "closed" : "absent";
    }
    if (!is_of_output)
    {
        std::string word = Name(cia301::KernelState(device.State()));
        std::replace(word.begin(), word.end(), '_', '-'); // As managers tell it.
        return word;
    }
    const std::optional<SlotIndex> slot = device.Model().SlotOf(expectation.srdo);
    return (slot && ((device.Open() >> *slot) & 1U) != 0U) ? "open" : "closed";
}

void Run::Simulate(const std::function<void(Nanoseconds)>& progress)
{
    for (Nanoseconds now = 0; now < scenario_.duration;)
    {
        now = std::min(now + kStep, scenario_.duration);
        RunTo(now);
        const std::size_t recorded = journal_.Events().size() + journal_.Frames().size();
        if (journal_.KeepsAll() && recorded > kMostRecorded)
        {
            throw YamlError(scenario_.file, {}, "more than 500000 frames and events to record",
                            "a shorter run, or --quiet without output files");
        }
        if (progress)
        {
            progress(now);
        }
    }
    journal_.Sort();
    verdicts_ = Judge(scenario_, journal_, *network_, found_);
    FindOtherFinders();
    FindOtherClosers();
    without_.clear();
}

/// Where an output closed, in time or late, but closes no later without the fault, or where this fault alone closes
/// none, another one closed it, unless this one alone does so too. [SRS_SIM_068]
void Run::FindOtherClosers()
{
    for (ExpectationVerdict& verdict : verdicts_)
    {
        const bool is_closed = verdict.measurement && verdict.measurement->IsClosedByAFault();
        const std::string others =
            is_closed ? OthersBefore(verdict.measurement->fault, verdict.measurement->closed) : "";
        if (others.empty())
        {
            continue;
        }
        Measurement& measurement = *verdict.measurement;
        const Expectation& expectation = scenario_.expectations[verdict.expectation];
        const auto is_another = [this, &expectation, &measurement](const std::size_t fault)
        {
            const Compared runs{journal_, RecordWithout({fault}), RecordWithout(AllBut(fault)), fault};
            return IsClosedByAnother(runs, expectation, measurement.effect, measurement.closed);
        };
        // Where it is none of them, each delayed the other: then it is each one that alone closes it no later.
        const auto before = FaultsBefore(journal_, measurement.fault, measurement.closed);
        const Nanoseconds alone = ClosedAt(RecordWithout(AllBut(measurement.fault)), expectation, measurement.effect);
        const bool is_enough = alone >= 0 && alone <= measurement.closed;
        measurement.is_of_another =
            is_another(measurement.fault) && !(is_enough && std::all_of(before.begin(), before.end(), is_another));
        if (measurement.is_of_another)
        {
            verdict.holds = false;
            verdict.seen =
                "closed at " + MillisecondsText(measurement.closed) + " by another fault (" + others +
                "): without this one it closes at " +
                MillisecondsText(ClosedAt(RecordWithout({measurement.fault}), expectation, measurement.effect));
        }
    }
}

void Run::FindOtherFinders()
{
    for (ExpectationVerdict& verdict : verdicts_)
    {
        if (verdict.detection || verdict.measurement)
        {
            FindOtherFinder(verdict);
        }
    }
}

/// What comes no later without the fault is another one's detection, and so is what this fault only shifts: the next
/// one counts. [SRS_SIM_073]
void Run::FindOtherFinder(ExpectationVerdict& verdict)
{
    const Expectation& expectation = scenario_.expectations[verdict.expectation];
    Detection& detection = verdict.detection ? *verdict.detection : verdict.measurement->detection;
    const Nanoseconds from = verdict.detection ? verdict.effect : verdict.measurement->effect;
    const std::string others = (detection.at < 0) ? "" : OthersBefore(expectation.fault, detection.at);
    if (others.empty())
    {
        return;
    }
    const Compared runs{journal_, RecordWithout({expectation.fault}), RecordWithout(AllBut(expectation.fault)),
                        expectation.fault};
    const Detection own = OwnDetections(runs, expectation, from).First();
    if (IsSame(own, detection))
    {
        return;
    }
    const Detection first = detection;
    detection = own;
    if (verdict.detection)
    {
        const std::vector<Party>& parties = expectation.parties;
        verdict.holds = std::find(parties.begin(), parties.end(), detection.party) != parties.end();
        verdict.seen = DetectionText(detection) + "; " + DetectionText(first) + " at " + MillisecondsText(first.at) +
                       " found another fault (" + others + ")";
    }
}

/// The other faults that had an effect until then: "'a', 'b'".
std::string Run::OthersBefore(const std::size_t fault, const Nanoseconds at) const
{
    std::string names;
    for (const std::size_t other : FaultsBefore(journal_, fault, at))
    {
        names += (names.empty() ? "" : ", ") + runtime::Shown(scenario_.faults[other].name);
    }
    return names;
}

std::vector<std::size_t> Run::AllBut(const std::size_t fault) const
{
    std::vector<std::size_t> others(scenario_.faults.size());
    std::iota(others.begin(), others.end(), std::size_t{0U});
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(fault));
    return others;
}

/// What happens in a run that is the same but for these faults.
const Journal& Run::RecordWithout(const std::vector<std::size_t>& faults)
{
    std::unique_ptr<Run>& run = without_[faults];
    if (run == nullptr)
    {
        Scenario scenario = scenario_;
        scenario.duration = whole_;
        scenario.expectations.clear();
        for (const std::size_t fault : faults)
        {
            scenario.faults[fault].is_left_out = true;
            scenario.faults[fault].frames.count = 0U;
        }
        run = std::make_unique<Run>(std::move(scenario), until_, false, make_);
        run->Simulate(nullptr);
    }
    return run->Record();
}

const runtime::DeviceModel& Run::ModelOf(const NodeIndex node) const
{
    return network_->At(node).Model();
}

std::vector<std::string> Run::FaultsWithoutEffect() const
{
    std::vector<std::string> lines;
    for (std::size_t index = 0U; index < scenario_.faults.size(); ++index)
    {
        const FaultSetup& fault = scenario_.faults[index];
        if (journal_.EffectOf(index) < 0)
        {
            lines.push_back(
                LineOf(fault.source, "fault " + runtime::Shown(fault.name) + " never happened",
                       fault.is_optional ? "nothing else, it is optional" : "it within the run, or 'optional: true'"));
        }
    }
    return lines;
}

std::vector<std::string> Run::Findings() const
{
    std::vector<std::string> lines;
    for (const Happening& late : HappeningsFrom(scenario_, scenario_.duration))
    {
        lines.push_back(LineOf(late.source, late.what + " at " + MillisecondsText(late.at) + " does not happen",
                               "a time before the end of the run at " + MillisecondsText(scenario_.duration)));
    }
    for (const Happening& unheard : UnheardIn(scenario_))
    {
        if (unheard.at < scenario_.duration)
        {
            lines.push_back(LineOf(unheard.source,
                                   unheard.what + " at " + MillisecondsText(unheard.at) +
                                       " does nothing, the device has no supply then",
                                   "a time at which it has one"));
        }
    }
    if (managed_ != nullptr)
    {
        const std::vector<std::string> more = managed_->Warnings();
        lines.insert(lines.end(), more.begin(), more.end());
    }
    for (const auto& [fault, count] : network_->DroppedCopies())
    {
        const FaultSetup& setup = scenario_.faults[fault];
        lines.push_back(LineOf(setup.source,
                               std::to_string(count) + " copies of " + runtime::Shown(setup.name) + " dropped",
                               "at most 16 receptions of one frame"));
    }
    return lines;
}

bool Run::Holds() const noexcept
{
    return std::all_of(verdicts_.begin(), verdicts_.end(),
                       [](const ExpectationVerdict& verdict) { return verdict.holds; });
}

const Measurement* Run::FirstMeasurement() const noexcept
{
    for (const ExpectationVerdict& verdict : verdicts_)
    {
        if (verdict.measurement)
        {
            return &*verdict.measurement;
        }
    }
    return nullptr;
}

std::string Run::NodeName(const NodeIndex node) const
{
    const std::size_t nodes = scenario_.nodes.size();
    if (node < nodes)
    {
        return scenario_.nodes[node].name;
    }
    const std::vector<std::uint8_t> managers =
        (managed_ == nullptr) ? std::vector<std::uint8_t>{} : managed_->Managers();
    if (node - nodes < managers.size())
    {
        return "manager " + std::to_string(managers[node - nodes]);
    }
    return (node == kNoNode) ? "bus" : "somebody else";
}

} // namespace counterpoint::simulator
